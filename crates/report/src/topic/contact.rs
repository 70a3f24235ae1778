//! The side on which guides press, and the straight line that an arc envelopes.

use assur_book::{Column, Document, Table, Unit};
use assur_diagram::{Enveloping, EnvelopingPoint, SignChange};
use assur_words::{Text, name, number, text};

use super::Source;
use super::events::how_changed;

/// Sides of the guides, and enveloping.
pub(super) fn contacts(source: &Source<'_>, page: &mut Document) {
    let cycle = &source.analysis.cycle;
    if !cycle.sign_changes.is_empty() {
        sides(source, page);
    }
    for found in &cycle.enveloping {
        enveloping(source, found, page);
    }
}

/// Where the force of each guide changes its side.
fn sides(source: &Source<'_>, page: &mut Document) {
    page.heading(text!("report-sides"));
    page.paragraph(text!("report-sides-text"));
    let rows = source.analysis.cycle.sign_changes.iter().flat_map(|(slide, changes)| {
        let none = changes.is_empty().then_some(None);
        none.into_iter().chain(changes.iter().map(Some)).map(move |change| (slide, change))
    });
    let how = |change: Option<&SignChange>| match change {
        None => text!("report-one-side"),
        Some(change) => how_changed(change),
    };
    let coordinate = source.coordinate();
    let table = Table::each(Text::default(), rows)
        .column(text!("head-guide"), |(slide, _)| Text::from(*slide))
        .column(text!("head-after-position"), |(_, change)| change.map(|change| number(change.after_index)))
        .measured(source.coordinate_head(), coordinate, |(_, change)| Some((*change)?.coordinate))
        .measured(text!("head-before"), Unit::FORCE, |(_, change)| Some((*change)?.before))
        .measured(text!("head-after"), Unit::FORCE, |(_, change)| Some((*change)?.after))
        .column(text!("head-change"), |(_, change)| how(*change));
    page.table(table.table());
}

fn enveloping(source: &Source<'_>, found: &Enveloping, page: &mut Document) {
    let (coordinate, per) = (source.coordinate(), Unit::transfer(false, source.kind, 1));
    page.heading(text!("report-enveloping", contact = &found.contact));
    page.paragraph(text!(
        "report-enveloping-text",
        from = coordinate.show(found.interval[0]),
        to = coordinate.show(found.interval[1]),
        level = Unit::LENGTH.show(found.level),
        greatest = Unit::LENGTH.show(found.greatest),
        at = coordinate.show(found.greatest_at),
        way = Unit::LENGTH.show(found.way)
    ));
    let column = |head, unit, value: fn(&EnvelopingPoint) -> f64| {
        Column::numbers(head, unit, found.path.iter().map(|point| Some(value(point))))
    };
    let key = column(source.coordinate_head(), coordinate, |point| point.coordinate);
    let columns = vec![
        column(name("x"), Unit::LENGTH, |point| point.lowest[0]),
        column(name("y"), Unit::LENGTH, |point| point.lowest[1]),
        column(text!("head-deviation"), Unit::LENGTH, |point| point.deviation),
        column(text!("head-sliding"), per, |point| point.sliding),
    ];
    page.table(Table::over(Text::default(), vec![key], columns));
}
