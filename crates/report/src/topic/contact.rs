//! The side on which guides press, and the straight line that an arc envelopes.

use assur_book::{Cell, Column, Document, Table, row};
use assur_diagram::{Enveloping, EnvelopingPoint};
use assur_words::{Text, name, number, text};

use super::Source;
use super::units::{FORCE, LENGTH};

/// Sides of the guides, and enveloping.
pub fn contacts(source: &Source<'_>, page: &mut Document) {
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
    let heads = [
        Column::of(text!("head-guide")),
        Column::of(text!("head-after-position")),
        Column::short(Text::from(&source.analysis.input.link), source.units.coordinate),
        Column::short(text!("head-before"), FORCE),
        Column::short(text!("head-after"), FORCE),
        Column::of(text!("head-change")),
    ];
    let mut table = Table::list(Text::default(), heads);
    for (slide, changes) in &source.analysis.cycle.sign_changes {
        if changes.is_empty() {
            let none = || Cell::None;
            table.row([
                Text::from(slide).into(),
                none(),
                none(),
                none(),
                none(),
                text!("report-one-side").into(),
            ]);
        }
        for change in changes {
            let how = if change.jump { text!("report-jumps") } else { text!("report-passes-zero") };
            let after = number(change.after_index);
            table.row(row![Text::from(slide), after, change.coordinate, change.before, change.after, how]);
        }
    }
    page.table(table);
}

fn enveloping(source: &Source<'_>, found: &Enveloping, page: &mut Document) {
    let (coordinate, per) = (source.units.coordinate, source.units.length[1]);
    page.heading(text!("report-enveloping", contact = &found.contact));
    page.paragraph(text!(
        "report-enveloping-text",
        from = coordinate.show(found.interval[0]),
        to = coordinate.show(found.interval[1]),
        level = LENGTH.show(found.level),
        greatest = LENGTH.show(found.greatest),
        at = coordinate.show(found.greatest_at),
        way = LENGTH.show(found.way)
    ));
    let column =
        |head, unit, value: fn(&EnvelopingPoint) -> f64| Column::each(&found.path, head, unit, value);
    let key = column(Text::from(&source.analysis.input.link), coordinate, |point| point.coordinate);
    let columns = vec![
        column(name("x"), LENGTH, |point| point.lowest[0]),
        column(name("y"), LENGTH, |point| point.lowest[1]),
        column(text!("head-deviation"), LENGTH, |point| point.deviation),
        column(text!("head-sliding"), per, |point| point.sliding),
    ];
    page.table(Table::over(Text::default(), vec![key], columns));
}
