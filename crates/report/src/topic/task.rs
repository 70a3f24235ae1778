//! The mechanism as it is given: dimensions and masses.

use assur_book::{Cell, Column, Document, Table, Unit, link_name, row};
use assur_mechanism::{Inertia, Link, VaryingInertia};
use assur_words::{joined, name, text};

use super::Source;
use super::units::{ANGLE, INERTIA, KILOGRAM, LENGTH};

/// Points, slides, masses.
pub fn dimensions(source: &Source<'_>, page: &mut Document) {
    points(source, page);
    slides(source, page);
    masses(source, page);
}

/// A column of lengths.
fn mm(head: &'static str) -> Column {
    Column::short(name(head), LENGTH)
}

fn points(source: &Source<'_>, page: &mut Document) {
    let heads = [Column::of(text!("head-link")), Column::of(text!("head-point")), mm("x"), mm("y")];
    let mut table = Table::list(text!("report-points"), heads);
    for (id, link) in source.mechanism.links.iter().enumerate() {
        for (point_id, point) in source.mechanism.points.iter().enumerate() {
            if let Some([x, y]) = source.mechanism.place_in(point_id, id) {
                table.row(row![&link.name, &point.name, x, y]);
            }
        }
    }
    page.table(table);
}

fn slides(source: &Source<'_>, page: &mut Document) {
    let degrees = |head| Column::short(head, ANGLE);
    let heads = [
        Column::of(text!("head-slide")),
        Column::short(text!("head-point-x"), LENGTH),
        mm("y"),
        Column::of(text!("head-on")),
        Column::short(text!("head-through-x"), LENGTH),
        mm("y"),
        degrees(text!("head-angle")),
        degrees(text!("head-tilt")),
    ];
    let mut table = Table::list(text!("report-slides"), heads);
    for slide in &source.mechanism.slides {
        let ([x, y], [through_x, through_y]) = (slide.point, slide.through);
        let on = link_name(source.mechanism, slide.on);
        table.row(row![&slide.name, x, y, on, through_x, through_y, slide.angle, slide.tilt]);
    }
    page.table(table);
}

/// A moment of inertia: a number, or the formula by which it varies, in SI.
fn inertia_given(inertia: &Inertia) -> Cell {
    let Some(VaryingInertia { formula, factor }) = inertia.varying() else {
        return inertia.constant().into();
    };
    let formula = name(formula.text().to_owned());
    if factor.total_cmp(&1.0).is_eq() {
        return formula.into();
    }
    let formula = joined("", [name("("), formula, name(")")]);
    joined(" · ", [Unit::NONE.number(*factor), formula]).into()
}

fn masses(source: &Source<'_>, page: &mut Document) {
    let heavy = |link: &&Link| link.is_heavy();
    let row = |link: &Link| {
        let [x, y] = link.center;
        row![&link.name, link.mass, x, y, inertia_given(&link.inertia)]
    };
    let heads = [
        Column::of(text!("head-link")),
        Column::short(text!("head-mass"), KILOGRAM),
        Column::short(text!("head-center-x"), LENGTH),
        mm("y"),
        Column::short(text!("head-inertia"), INERTIA),
    ];
    let heavy = source.mechanism.links.iter().skip(1).filter(heavy);
    let table = Table::list(text!("report-masses"), heads).rows(heavy.map(row));
    if table.is_empty() {
        return page.paragraph(text!("report-massless"));
    }
    page.table(table);
}
