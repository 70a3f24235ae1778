//! Velocities and accelerations as arrows, per unit time if the positions move, else per unit speed of the coordinate; and the
//! contacts of a position: the point K, the normal force and the friction in it, and their sum.

use assur_analysis::results::{Column, Owner, Quantity};
use assur_figure::number::plain;
use assur_figure::{Ink, Item, Key, Sample, Sign, Stroke, round_length};
use assur_force::{Acting, Cause};
use assur_group::plane::{plus, scaled};
use assur_kinematics::Position;
use assur_mechanism::{GROUND, LoadId};
use assur_words::{Text, joined, name, quantity, text};

use crate::{Arrows, Found, Look, Results, Series};

/// Longest arrow of a motion, as part of the size of the drawing.
const LONGEST: f64 = 0.3;
/// Least part of the greater side of a drawing that counts as its smaller side.
const FLAT: f64 = 0.5;
/// Greatest force of a contact over the cycle, as part of the size of the drawing.
const LONGEST_FORCE: f64 = 0.25;
/// Longest arrow of the legend, as part of the longest one of the drawing.
const TOLD: f64 = 0.5;
/// First and second derivative with respect to time.
const RATES: [Quantity; 2] = [Quantity::Velocity, Quantity::Acceleration];
fn orders(look: &Look<'_>) -> &'static [u8] {
    match look.arrows {
        Arrows::None => &[],
        Arrows::Velocity => &[1],
        Arrows::Acceleration => &[2],
        Arrows::Both => &[1, 2],
    }
}

/// Velocities are full arrows, accelerations dashed ones: distinguished without color.
fn look_of(order: u8) -> (Stroke, Ink) {
    if order == 1 { (Stroke::Solid, Ink::Velocity) } else { (Stroke::Dashed, Ink::Acceleration) }
}

fn is_of_point(series: &Series, quantity: Quantity) -> bool {
    series.column.quantity == quantity && matches!(series.column.owner, Owner::Point(_))
}

/// The results, if the positions move.
fn moving(results: &Results) -> Option<&Found> {
    let moves = |found: &&Found| found.series.iter().any(|series| is_of_point(series, RATES[0]));
    results.found.as_deref().filter(moves)
}

/// What is drawn of an order of the points, in parts: v = PF1 w, a = PF2 w² + PF1 e; without a motion PF1, PF2.
fn series_of(results: &Results, order: u8) -> impl Iterator<Item = &Series> {
    let (all, quantity) = match moving(results) {
        Some(found) => (&found.series, RATES[usize::from(order) - 1]),
        None => (&results.series, Quantity::Transfer(order)),
    };
    all.iter().filter(move |series| is_of_point(series, quantity))
}

/// The arrows of all points that have them.
pub(crate) fn items(results: &Results, look: &Look<'_>, pose: &Position) -> Vec<Item> {
    let mut items = Vec::new();
    for &order in orders(look) {
        let Some(length) = length(results, order) else { continue };
        let (stroke, ink) = look_of(order);
        for (point, vector) in vectors(results, pose, look.position, order) {
            let from = results.linkage.point_motion(point, pose).pf0;
            items.push(Item::Arrow { from, to: plus(from, scaled(length, vector)), stroke, ink });
        }
    }
    items
}

fn vectors(results: &Results, pose: &Position, position: usize, order: u8) -> Vec<(usize, [f64; 2])> {
    let mechanism = &results.linkage.mechanism;
    let points = (0..mechanism.points.len()).filter(|id| mechanism.place_in(*id, GROUND).is_none());
    if moving(results).is_some() {
        let all: Vec<&Series> = series_of(results, order).collect();
        let of = |column| all.iter().find(|series| series.column == column)?.course.get(position);
        let rate = |id| {
            let [x, y] = Column::vector(RATES[usize::from(order) - 1], Owner::Point(id)).map(of);
            x.zip(y).map(|(x, y)| (id, [x, y]))
        };
        return points.filter_map(rate).collect();
    }
    let motion = |id| results.linkage.point_motion(id, pose);
    points.map(|id| (id, if order == 1 { motion(id).pf1 } else { motion(id).pf2 })).collect()
}

fn most(results: &Results, order: u8) -> f64 {
    series_of(results, order).map(|series| series.course.size()).fold(0.0, f64::max)
}

/// Length, m, of an arrow of size 1; equal in all positions, so that lengths can be compared.
fn length(results: &Results, order: u8) -> Option<f64> {
    let [width, height] = results.outline.bounds.size();
    let size = width.min(height).max(FLAT * width.max(height));
    let most = most(results, order);
    (most > 0.0).then(|| LONGEST * size / most)
}

/// The arrows that are drawn: what they are, the size of a round one with its unit, its length, m, its stroke and its ink.
pub fn scales(results: &Results, look: &Look<'_>) -> Vec<(Text, Text, f64, (Stroke, Ink))> {
    let scale = |&order: &u8| {
        let what = match (moving(results).is_some(), order) {
            (true, 1) => text!("arrow-velocity"),
            (true, _) => text!("arrow-acceleration"),
            (false, 1) => text!("arrow-first"),
            (false, _) => text!("arrow-second"),
        };
        let unit = series_of(results, order).next()?.unit;
        let round = round_length(TOLD * most(results, order) * unit.factor) / unit.factor;
        let size = quantity(plain(round * unit.factor), unit.name);
        Some((what, size, round * length(results, order)?, look_of(order)))
    };
    orders(look).iter().filter_map(scale).collect()
}

/// What the arrows are, with the length of a round value.
pub(crate) fn legend(results: &Results, look: &Look<'_>) -> Vec<Key> {
    let key = |(what, size, length, (stroke, ink))| Key {
        sample: Sample::Arrow(length, stroke, ink),
        text: text!("arrow-told", what = what, size = size),
    };
    // Of the arrows of contacts, the length of a round force.
    let round = round_length(TOLD * greatest_force(results));
    let contacts = length_of_force(results).map(|length| Key {
        sample: Sample::Arrow(round * length, Stroke::Solid, Ink::Second),
        text: text!("contact-forces", size = quantity(plain(round), "N")),
    });
    scales(results, look).into_iter().map(key).chain(contacts).collect()
}

fn is_contact(results: &Results, load: LoadId) -> bool {
    results.linkage.mechanism.loads[load].kind.contact().is_some()
}

fn acting(results: &Results, pose: &Position) -> Vec<Acting> {
    let Some(found) = &results.found else { return Vec::new() };
    let calculation = found.plans.calculation();
    let Some(loads) = calculation.loads.as_ref().filter(|_| calculation.positions_have_forces()) else {
        return Vec::new();
    };
    let mut all = loads.acting(&calculation.state(pose.coordinate), &pose.bodies);
    all.retain(|load| matches!(load.cause, Cause::Load(load) if is_contact(results, load)));
    all
}

/// K with its name, the normal force and the friction dashed, their sum full.
pub(crate) fn contacts(results: &Results, pose: &Position) -> Vec<Item> {
    let Some(length) = length_of_force(results) else { return Vec::new() };
    let all = acting(results, pose);
    let several = all.len() > 1;
    let mut items = Vec::new();
    for (number, load) in all.iter().enumerate() {
        let (Some(at), Some([normal, friction])) =
            (load.at, load.parts(&results.linkage.mechanism, &pose.bodies))
        else {
            continue;
        };
        let of = |symbol: Text| {
            let number = several.then(|| name((number + 1).to_string()));
            joined("", std::iter::once(symbol).chain(number))
        };
        let parts = [
            (normal, name("Fc"), Stroke::Dashed),
            (friction, text!("contact-friction"), Stroke::Dashed),
            (load.wrench.force(), name("F"), Stroke::Solid),
        ];
        // Without friction the sum is the normal force.
        let has_friction = friction[0].hypot(friction[1]) > 1e-12 * normal[0].hypot(normal[1]);
        for (force, symbol, stroke) in parts.into_iter().take(if has_friction { 3 } else { 1 }) {
            let to = plus(at, scaled(length, force));
            items.push(Item::Arrow { from: at, to, stroke, ink: Ink::Second });
            items.push(Item::name(to, of(symbol), Ink::Second));
        }
        items.push(Item::sign(at, Sign::Dot, Ink::Second));
        items.push(Item::name(at, of(name("K")), Ink::Title));
    }
    items
}

fn greatest_force(results: &Results) -> f64 {
    let is_of_contact = |column: Column| match column.owner {
        Owner::Load(load) => column.quantity == Quantity::Load && is_contact(results, load),
        _ => false,
    };
    let all = results.found.iter().flat_map(|found| &found.series);
    let of_contacts = all.filter(|series| is_of_contact(series.column));
    of_contacts.map(|series| series.course.size()).fold(0.0, f64::max)
}

/// Length, m, of an arrow of 1 N; equal in all positions, so that lengths can be compared.
fn length_of_force(results: &Results) -> Option<f64> {
    let [width, height] = results.outline.bounds.size();
    let most = greatest_force(results);
    (most > 0.0).then(|| LONGEST_FORCE * width.max(height) / most)
}
