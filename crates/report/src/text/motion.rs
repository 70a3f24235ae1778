//! Positions, transfer functions, velocities and accelerations; nearness of the groups to singular positions.

use assur_analysis::results::{Named, PositionResult};
use assur_mechanism::GROUND;

use super::Source;
use super::layout::{Column, Page};
use super::units::{MOVING, TURNING, Unit};

/// A column of a table over the positions: its head (`*` stands for the name of the element), its unit, and the value
/// of the i-th element in a position.
type Part = (&'static str, Unit, fn(&PositionResult, usize) -> Option<f64>);

/// A column of one quantity over the positions.
pub(super) fn column(
    source: &Source<'_>,
    head: impl Into<String>,
    unit: Unit,
    value: impl Fn(&PositionResult) -> Option<f64>,
) -> Column {
    Column::of(&source.analysis.positions, head, unit, value)
}

/// Number and coordinate of the positions.
pub(super) fn keys(source: &Source<'_>) -> [Column; 2] {
    let numbers = source.analysis.positions.iter().map(|position| position.index.to_string());
    let coordinate = column(source, &source.analysis.input.link, source.units.coordinate, |position| {
        Some(position.coordinate)
    });
    [Column::texts("No.", numbers.collect()), coordinate]
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

/// 1 / determinant of the groups.
pub(super) fn condition(source: &Source<'_>, page: &mut Page) {
    let Some(first) = source.analysis.positions.first().filter(|first| !first.condition.is_empty()) else {
        return;
    };
    page.section("Condition of the groups");
    page.paragraph(
        "1 / (dimensionless determinant): 1 is the best there is; errors of PF1 grow with it, those of PF2 with its square; \
         infinite at a singular position.",
    );
    let unit = Unit { name: "", factor: 1.0 };
    let groups = first.condition.iter().map(|(name, _)| {
        let head = format!("group {}", name.parse::<usize>().unwrap_or_default() + 1);
        vec![column(source, head, unit, |p| p.condition.get(name).copied())]
    });
    page.table("Groups", &keys(source), groups.collect());
}

/// All names by index.
fn all<T>(named: &Named<T>) -> Vec<(usize, &str)> {
    named.iter().map(|(name, _)| name).enumerate().collect()
}

/// Points of a position that move: those of the ground are listed among the dimensions.
fn moving<'a, T>(source: &Source<'_>, points: &'a Named<T>) -> Vec<(usize, &'a str)> {
    let fixed = |name: &str| {
        let id = source.mechanism.point(name);
        id.is_some_and(|id| source.mechanism.place_in(id, GROUND).is_some())
    };
    all(points).into_iter().filter(|(_, name)| !fixed(name)).collect()
}

/// The `i`-th value of a list.
fn at<T>(named: &Named<T>, i: usize) -> Option<&T> {
    named.0.get(i).map(|(_, value)| value)
}

/// A group of columns for each named thing.
fn groups(source: &Source<'_>, named: Vec<(usize, &str)>, parts: &[Part]) -> Vec<Vec<Column>> {
    let of = |(i, name): (usize, &str)| {
        let part = |(head, unit, value): &Part| {
            column(source, head.replace('*', name), *unit, |p: &PositionResult| value(p, i))
        };
        parts.iter().map(part).collect()
    };
    named.into_iter().map(of).collect()
}

fn positions(source: &Source<'_>, first: &PositionResult, page: &mut Page) {
    let (keys, angle, length) = (keys(source), source.units.angle[0], source.units.length[0]);
    page.section("Positions");
    let parts: [Part; 2] = [
        ("* x", length, |p, i| Some(at(&p.points, i)?.pf0[0])),
        ("* y", length, |p, i| Some(at(&p.points, i)?.pf0[1])),
    ];
    page.table("Points", &keys, groups(source, moving(source, &first.points), &parts));
    let parts: [Part; 1] = [("*", angle, |p, i| Some(at(&p.links, i)?.pf0))];
    page.table("Angles of the links", &keys, groups(source, all(&first.links), &parts));
    let parts: [Part; 1] = [("*", length, |p, i| Some(at(&p.slides, i)?.pf0))];
    page.table("Displacements of the slides", &keys, groups(source, all(&first.slides), &parts));
}

fn transfer(source: &Source<'_>, first: &PositionResult, page: &mut Page) {
    let (keys, angle, length) = (keys(source), source.units.angle, source.units.length);
    page.section("Transfer functions (derivatives by the input coordinate)");
    let parts: [Part; 2] = [
        ("* PF1", angle[1], |p, i| Some(at(&p.links, i)?.pf1)),
        ("PF2", angle[2], |p, i| Some(at(&p.links, i)?.pf2)),
    ];
    page.table("Links", &keys, groups(source, all(&first.links), &parts));
    let parts: [Part; 4] = [
        ("* PF1 x", length[1], |p, i| Some(at(&p.points, i)?.pf1[0])),
        ("PF1 y", length[1], |p, i| Some(at(&p.points, i)?.pf1[1])),
        ("PF2 x", length[2], |p, i| Some(at(&p.points, i)?.pf2[0])),
        ("PF2 y", length[2], |p, i| Some(at(&p.points, i)?.pf2[1])),
    ];
    page.table("Points", &keys, groups(source, moving(source, &first.points), &parts));
    let parts: [Part; 2] = [
        ("* PF1", length[1], |p, i| Some(at(&p.slides, i)?.pf1)),
        ("PF2", length[2], |p, i| Some(at(&p.slides, i)?.pf2)),
    ];
    page.table("Slides", &keys, groups(source, all(&first.slides), &parts));
}

fn rates(source: &Source<'_>, first: &PositionResult, page: &mut Page) {
    let keys = keys(source);
    page.section("Velocities and accelerations");
    let of_input = vec![
        column(source, "speed", source.units.rates[0], |p| p.speed),
        column(source, "acceleration", source.units.rates[1], |p| p.acceleration),
    ];
    page.table("Input", &keys, vec![of_input]);
    let Some(velocities) = &first.velocities else { return };
    let parts: [Part; 2] = [
        ("* w", TURNING[0], |p, i| at(&p.velocities.as_ref()?.links, i).copied()),
        ("e", TURNING[1], |p, i| at(&p.accelerations.as_ref()?.links, i).copied()),
    ];
    let caption = "Angular velocities (w) and accelerations (e) of the links";
    page.table(caption, &keys, groups(source, all(&velocities.links), &parts));
    let parts: [Part; 6] = [
        ("* vx", MOVING[0], |p, i| Some(velocity(p, i)?[0])),
        ("vy", MOVING[0], |p, i| Some(velocity(p, i)?[1])),
        ("v", MOVING[0], |p, i| velocity(p, i).map(|[x, y]| x.hypot(y))),
        ("ax", MOVING[1], |p, i| Some(acceleration(p, i)?[0])),
        ("ay", MOVING[1], |p, i| Some(acceleration(p, i)?[1])),
        ("a", MOVING[1], |p, i| acceleration(p, i).map(|[x, y]| x.hypot(y))),
    ];
    page.table("Points", &keys, groups(source, moving(source, &velocities.points), &parts));
    let parts: [Part; 2] = [
        ("* v", MOVING[0], |p, i| at(&p.velocities.as_ref()?.slides, i).copied()),
        ("a", MOVING[1], |p, i| at(&p.accelerations.as_ref()?.slides, i).copied()),
    ];
    page.table("Slides, relative", &keys, groups(source, all(&velocities.slides), &parts));
}

fn velocity(position: &PositionResult, i: usize) -> Option<[f64; 2]> {
    at(&position.velocities.as_ref()?.points, i).copied()
}

fn acceleration(position: &PositionResult, i: usize) -> Option<[f64; 2]> {
    at(&position.accelerations.as_ref()?.points, i).copied()
}
