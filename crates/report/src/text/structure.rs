//! The section on structure.

use assur_mechanism::Link;
use assur_structure::roman;

use super::Source;
use super::layout::Page;

pub(super) fn write(source: &Source<'_>, page: &mut Page) {
    let (structure, mechanism) = (&source.analysis.structure, source.mechanism);
    page.section("Structure");
    let names: Vec<_> = mechanism.links.iter().skip(1).map(|link| link.name.as_str()).collect();
    page.paragraph(&format!(
        "Moving links: {} ({}), input link {}",
        names.len(),
        names.join(", "),
        source.analysis.input.link
    ));
    page.paragraph(&format!(
        "Mobility by Chebyshev's formula: W = 3*{} - 2*{} = {}",
        structure.moving_links, structure.pairs, structure.mobility
    ));
    if let Some(found) = structure.mobility_by_rank {
        page.paragraph(&format!("Mobility by the rank of the constraints in the first position: {found}"));
    }
    if let Some(note) = &structure.note {
        page.paragraph(&format!("Note: {note}"));
    }
    page.paragraph(&format!("Formula: {}", structure.formula));
    page.paragraph(&format!("Class of the mechanism: {}", roman(structure.class)));
    pairs(source, page);
    groups(source, page);
}

fn pairs(source: &Source<'_>, page: &mut Page) {
    let name =
        |link: usize| -> &str { source.mechanism.links.get(link).map_or("", |link: &Link| &link.name) };
    let mut rows = Vec::new();
    for pin in source.mechanism.points.iter().filter(|point| point.is_pin()) {
        let links: Vec<_> = pin.places.iter().map(|place| name(place.link)).collect();
        let sort = if links.len() > 2 { "R, multiple joint" } else { "R" };
        rows.push(vec![
            pin.name.to_string(),
            sort.to_owned(),
            links.join(", "),
            (links.len() - 1).to_string(),
        ]);
    }
    for slide in &source.mechanism.slides {
        let links = format!("{}, {}", name(slide.link), name(slide.on));
        rows.push(vec![slide.name.to_string(), "P".to_owned(), links, "1".to_owned()]);
    }
    page.caption("Pairs (R: turning, P: sliding)");
    page.rows(&["pair", "sort", "links", "count"], &rows);
}

fn groups(source: &Source<'_>, page: &mut Page) {
    let groups = &source.analysis.structure.groups;
    if groups.is_empty() {
        return;
    }
    let mut rows = Vec::new();
    for (index, group) in groups.iter().enumerate() {
        rows.push(vec![
            (index + 1).to_string(),
            group.kind.clone(),
            roman(group.class).to_owned(),
            if group.number > 0 { group.number.to_string() } else { "-".to_owned() },
            group.order.to_string(),
            group.links.join(", "),
            group.inner.join(", "),
            group.outer.join(", "),
            group.way.to_string(),
            group.ways.to_string(),
        ]);
    }
    page.caption("Assur groups in solving order (way: the assembly in the first position, counted from 0)");
    let head = ["group", "kind", "class", "type", "order", "links", "inner", "outer", "way", "ways"];
    page.rows(&head, &rows);
}
