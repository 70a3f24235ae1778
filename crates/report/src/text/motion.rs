//! Positions, transfer functions, velocities and accelerations.

use super::Source;
use super::layout::{Cells, Column, Page};
use super::units::{MOVING, TURNING, Unit};
use assur_analysis::results::PositionResult;

/// A column of one quantity over the positions.
pub(super) fn column(
    source: &Source<'_>,
    head: impl Into<String>,
    unit: Unit,
    value: impl Fn(&PositionResult) -> Option<f64>,
) -> Column {
    let values: Vec<_> = source
        .analysis
        .positions
        .iter()
        .map(|position| value(position).map(|value| value * unit.factor))
        .collect();
    Column { head: head.into(), unit: unit.name.to_owned(), cells: Cells::Numbers(values) }
}

/// Number and coordinate of the positions.
pub(super) fn keys(source: &Source<'_>) -> [Column; 2] {
    let numbers = source.analysis.positions.iter().map(|position| position.index.to_string());
    let number =
        Column { head: "No.".to_owned(), unit: String::new(), cells: Cells::Text(numbers.collect()) };
    let coordinate = column(source, &source.analysis.input.link, source.units.coordinate, |position| {
        Some(position.coordinate)
    });
    [number, coordinate]
}

pub(super) fn write(source: &Source<'_>, page: &mut Page) {
    let Some(first) = source.analysis.positions.first() else { return };
    if !(first.links.is_empty() && first.points.is_empty() && first.slides.is_empty()) {
        positions(source, first, page);
        transfer(source, first, page);
    }
    if first.speed.is_some() {
        rates(source, first, page);
    }
}

/// Points of a position that move, by index: those of the ground stand among the dimensions.
fn moving<'a, T>(
    source: &Source<'_>,
    points: &'a assur_analysis::results::Named<T>,
) -> Vec<(usize, &'a str)> {
    let fixed = |name: &str| {
        let id = source.mechanism.point(name);
        id.is_some_and(|id| source.mechanism.place_in(id, assur_mechanism::GROUND).is_some())
    };
    points.iter().map(|(name, _)| name).enumerate().filter(|(_, name)| !fixed(name)).collect()
}

/// The `i`-th of a list of names and values.
fn at<T>(named: &assur_analysis::results::Named<T>, i: usize) -> Option<&T> {
    named.0.get(i).map(|(_, value)| value)
}

fn positions(source: &Source<'_>, first: &PositionResult, page: &mut Page) {
    let (keys, units) = (keys(source), &source.units);
    page.section("Positions");
    let of_points = moving(source, &first.points).into_iter().map(|(i, name)| {
        let axis = |axis: usize| move |p: &PositionResult| at(&p.points, i).map(|motion| motion.pf0[axis]);
        vec![
            column(source, format!("{name} x"), units.length[0], axis(0)),
            column(source, format!("{name} y"), units.length[0], axis(1)),
        ]
    });
    table(page, "Points", &keys, of_points.collect());
    let of_links = first.links.iter().enumerate().map(|(i, (name, _))| {
        vec![column(source, name, units.angle[0], move |p| at(&p.links, i).map(|motion| motion.pf0))]
    });
    table(page, "Angles of the links", &keys, of_links.collect());
    let of_slides = first.slides.iter().enumerate().map(|(i, (name, _))| {
        vec![column(source, name, units.length[0], move |p| at(&p.slides, i).map(|motion| motion.pf0))]
    });
    table(page, "Displacements of the slides", &keys, of_slides.collect());
}

fn table(page: &mut Page, caption: &str, keys: &[Column], groups: Vec<Vec<Column>>) {
    if !groups.is_empty() {
        page.caption(caption);
        page.table(keys, groups);
    }
}

fn transfer(source: &Source<'_>, first: &PositionResult, page: &mut Page) {
    let (keys, units) = (keys(source), &source.units);
    page.section("Transfer functions (derivatives by the input coordinate)");
    let of_links = first.links.iter().enumerate().map(|(i, (name, _))| {
        vec![
            column(source, format!("{name} PF1"), units.angle[1], move |p| {
                at(&p.links, i).map(|motion| motion.pf1)
            }),
            column(source, "PF2", units.angle[2], move |p| at(&p.links, i).map(|motion| motion.pf2)),
        ]
    });
    table(page, "Links", &keys, of_links.collect());
    let of_points = moving(source, &first.points).into_iter().map(|(i, name)| {
        let pf1 = |axis: usize| move |p: &PositionResult| at(&p.points, i).map(|motion| motion.pf1[axis]);
        let pf2 = |axis: usize| move |p: &PositionResult| at(&p.points, i).map(|motion| motion.pf2[axis]);
        vec![
            column(source, format!("{name} PF1 x"), units.length[1], pf1(0)),
            column(source, "PF1 y", units.length[1], pf1(1)),
            column(source, "PF2 x", units.length[2], pf2(0)),
            column(source, "PF2 y", units.length[2], pf2(1)),
        ]
    });
    table(page, "Points", &keys, of_points.collect());
    let of_slides = first.slides.iter().enumerate().map(|(i, (name, _))| {
        vec![
            column(source, format!("{name} PF1"), units.length[1], move |p| {
                at(&p.slides, i).map(|motion| motion.pf1)
            }),
            column(source, "PF2", units.length[2], move |p| at(&p.slides, i).map(|motion| motion.pf2)),
        ]
    });
    table(page, "Slides", &keys, of_slides.collect());
}

fn rates(source: &Source<'_>, first: &PositionResult, page: &mut Page) {
    let keys = keys(source);
    page.section("Velocities and accelerations");
    let of_input = vec![
        column(source, "speed", source.units.rates[0], |p| p.speed),
        column(source, "acceleration", source.units.rates[1], |p| p.acceleration),
    ];
    table(page, "Input", &keys, vec![of_input]);
    let Some(velocities) = &first.velocities else { return };
    table(
        page,
        "Angular velocities (w) and accelerations (e) of the links",
        &keys,
        links(source, velocities),
    );
    table(page, "Points", &keys, points(source, velocities));
    table(page, "Slides, relative", &keys, slides(source, velocities));
}

fn links(source: &Source<'_>, velocities: &assur_analysis::results::Rates) -> Vec<Vec<Column>> {
    let each = velocities.links.iter().enumerate().map(|(i, (name, _))| {
        let w = move |p: &PositionResult| at(&p.velocities.as_ref()?.links, i).copied();
        let e = move |p: &PositionResult| at(&p.accelerations.as_ref()?.links, i).copied();
        vec![column(source, format!("{name} w"), TURNING[0], w), column(source, "e", TURNING[1], e)]
    });
    each.collect()
}

fn points(source: &Source<'_>, velocities: &assur_analysis::results::Rates) -> Vec<Vec<Column>> {
    let each = moving(source, &velocities.points).into_iter().map(|(i, name)| {
        let v = move |p: &PositionResult| at(&p.velocities.as_ref()?.points, i).copied();
        let a = move |p: &PositionResult| at(&p.accelerations.as_ref()?.points, i).copied();
        vec![
            column(source, format!("{name} vx"), MOVING[0], move |p| v(p).map(|v| v[0])),
            column(source, "vy", MOVING[0], move |p| v(p).map(|v| v[1])),
            column(source, "v", MOVING[0], move |p| v(p).map(|v| v[0].hypot(v[1]))),
            column(source, "ax", MOVING[1], move |p| a(p).map(|a| a[0])),
            column(source, "ay", MOVING[1], move |p| a(p).map(|a| a[1])),
            column(source, "a", MOVING[1], move |p| a(p).map(|a| a[0].hypot(a[1]))),
        ]
    });
    each.collect()
}

fn slides(source: &Source<'_>, velocities: &assur_analysis::results::Rates) -> Vec<Vec<Column>> {
    let each = velocities.slides.iter().enumerate().map(|(i, (name, _))| {
        let v = move |p: &PositionResult| at(&p.velocities.as_ref()?.slides, i).copied();
        let a = move |p: &PositionResult| at(&p.accelerations.as_ref()?.slides, i).copied();
        vec![column(source, format!("{name} v"), MOVING[0], v), column(source, "a", MOVING[1], a)]
    });
    each.collect()
}
