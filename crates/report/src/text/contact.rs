//! The side on which guides press, and the straight line that an arc envelopes.

use assur_diagram::{Enveloping, EnvelopingPoint};

use super::Source;
use super::layout::{Column, Page};
use super::number::single;
use super::units::{LENGTH, Unit};

pub(super) fn write(source: &Source<'_>, page: &mut Page) {
    let cycle = &source.analysis.cycle;
    if !cycle.sign_changes.is_empty() {
        sides(source, page);
    }
    for found in &cycle.enveloping {
        enveloping(source, found, page);
    }
}

/// Where the force of each guide changes its side.
fn sides(source: &Source<'_>, page: &mut Page) {
    page.section("Sides of the guides");
    page.paragraph("Where the force of a guide on its sliding link changes its side.");
    let coordinate = source.units.coordinate;
    let mut rows = Vec::new();
    for (slide, changes) in &source.analysis.cycle.sign_changes {
        if changes.is_empty() {
            rows.push([slide, "-", "-", "-", "-", "stays on one side"].map(str::to_owned).to_vec());
        }
        rows.extend(changes.iter().map(|change| {
            let mut cells = vec![slide.to_owned(), change.after_index.to_string()];
            cells.extend([change.coordinate * coordinate.factor, change.before, change.after].map(single));
            cells.push(if change.jump { "jumps" } else { "" }.to_owned());
            cells
        }));
    }
    let at = format!("{}, {}", source.analysis.input.link, coordinate.name);
    page.rows(&["guide", "after position", &at, "before, N", "after, N", ""], &rows);
}

fn enveloping(source: &Source<'_>, found: &Enveloping, page: &mut Page) {
    let (coordinate, [length, per, _]) = (source.units.coordinate, source.units.length);
    let at = |q: f64| format!("{} {}", single(q * coordinate.factor), coordinate.name);
    let long = |value: f64| format!("{} {}", single(value * length.factor), length.name);
    page.section(&format!("Enveloping by {}", found.contact));
    page.paragraph(&format!(
        "Path of the lowest point of the arc from {} to {}. The line from which it deviates least lies at y = {}; the greatest \
         deviation is {}, at {}; the point goes {} along the line. Sliding is the speed of the arc along the line per unit \
         speed of the input; 0 where it rolls.",
        at(found.interval[0]),
        at(found.interval[1]),
        long(found.level),
        long(found.greatest),
        at(found.greatest_at),
        long(found.way),
    ));
    let column = |head: &str, unit: Unit, value: fn(&EnvelopingPoint) -> f64| {
        Column::of(&found.path, head, unit, |point| Some(value(point)))
    };
    let keys = [column(&source.analysis.input.link, coordinate, |point| point.coordinate)];
    let columns = vec![
        column("x", LENGTH, |point| point.lowest[0]),
        column("y", LENGTH, |point| point.lowest[1]),
        column("deviation", LENGTH, |point| point.deviation),
        column("sliding", per, |point| point.sliding),
    ];
    page.table("", &keys, vec![columns]);
}
