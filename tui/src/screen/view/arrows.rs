//! Velocities and accelerations as arrows: per unit time if the positions move, else per unit speed of the coordinate.

use assur_analysis::results::Owner;
use assur_figure::{Ink, Item, Key, Sample, Stroke, round_length};
use assur_kinematics::Position;
use assur_mechanism::GROUND;
use assur_words::{Text, quantity, text};

use crate::number::plain;
use crate::screen::state::{Arrows, Scene, State};

/// Longest arrow, as part of the size of the drawing.
const LONGEST: f64 = 0.3;
/// Least part of the greater side of a drawing that counts as its smaller side.
const FLAT: f64 = 0.5;
/// Longest arrow of the legend, as part of the longest one of the drawing.
const TOLD: f64 = 0.5;

/// The orders of derivatives to draw.
fn orders(state: &State) -> &'static [usize] {
    match state.arrows {
        Arrows::None => &[],
        Arrows::Velocity => &[1],
        Arrows::Acceleration => &[2],
        Arrows::Both => &[1, 2],
    }
}

/// Velocities are full arrows, accelerations dashed ones: distinguished without color.
fn look_of(order: usize) -> (Stroke, Ink) {
    if order == 1 { (Stroke::Solid, Ink::Velocity) } else { (Stroke::Dashed, Ink::Acceleration) }
}

/// Whether the positions move.
fn moves(scene: &Scene) -> Option<[f64; 2]> {
    scene.found.as_ref().and_then(|found| found.fastest)
}

/// The arrows of all points that have them.
pub(super) fn items(state: &State, scene: &Scene, pose: &Position, position: usize) -> Vec<Item> {
    let mut items = Vec::new();
    for &order in orders(state) {
        let Some(length) = length(scene, order) else { continue };
        let (stroke, ink) = look_of(order);
        for (point, vector) in vectors(scene, pose, position, order) {
            let from = scene.linkage.point_motion(point, pose).pf0;
            let to = [0, 1].map(|axis| from[axis] + length * vector[axis]);
            items.push(Item::Arrow { from, to, stroke, ink });
        }
    }
    items
}

/// The vector of each point in a position: v = PF1 w, a = PF2 w² + PF1 e; without a motion PF1, PF2.
fn vectors(scene: &Scene, pose: &Position, position: usize, order: usize) -> Vec<(usize, [f64; 2])> {
    let mechanism = &scene.linkage.mechanism;
    let moving = |id: &usize| mechanism.points[*id].places.iter().all(|place| place.link != GROUND);
    if let Some(found) = scene.found.as_ref().filter(|found| found.fastest.is_some()) {
        return found.rates(position, order).into_iter().filter(|(id, _)| moving(id)).collect();
    }
    let all = (0..mechanism.points.len()).filter(moving);
    all.map(|id| {
        let motion = scene.linkage.point_motion(id, pose);
        (id, if order == 1 { motion.pf1 } else { motion.pf2 })
    })
    .collect()
}

/// The greatest size of a vector over all positions.
fn most(scene: &Scene, order: usize) -> f64 {
    match moves(scene) {
        Some(fastest) => fastest[order - 1],
        None => scene
            .transfers
            .iter()
            .filter(|transfer| matches!(transfer.owner, Owner::Point(_)))
            .map(|transfer| scene.series[transfer.orders[order]].course.size())
            .fold(0.0, f64::max),
    }
}

/// Length, m, of an arrow of size 1; equal in all positions, so that lengths can be compared.
fn length(scene: &Scene, order: usize) -> Option<f64> {
    let [width, height] = scene.outline.bounds.size();
    let size = width.min(height).max(FLAT * width.max(height));
    let most = most(scene, order);
    (most > 0.0).then(|| LONGEST * size / most)
}

/// What the arrows of an order are, their unit, and how many of it the SI unit has.
fn told(scene: &Scene, order: usize) -> (Text, String, f64) {
    let what = match (moves(scene).is_some(), order) {
        (true, 1) => return (text!("arrow-velocity"), "m/s".to_owned(), 1.0),
        (true, _) => return (text!("arrow-acceleration"), "m/s2".to_owned(), 1.0),
        (false, 1) => text!("arrow-first"),
        (false, _) => text!("arrow-second"),
    };
    let mut points = scene.transfers.iter().filter(|transfer| matches!(transfer.owner, Owner::Point(_)));
    let series = points.next().map(|transfer| &scene.series[transfer.orders[order]]);
    series.map_or((what.clone(), String::new(), 1.0), |series| (what, series.unit.clone(), series.factor))
}

/// The arrows that are drawn: what they are, the size of a round one with its unit, its length, m, and its ink.
pub(super) fn scales(state: &State, scene: &Scene) -> Vec<(Text, Text, f64, Ink)> {
    let scale = |order: &usize| {
        let (what, unit, factor) = told(scene, *order);
        let round = round_length(TOLD * most(scene, *order) * factor) / factor;
        Some((what, quantity(plain(round * factor), unit), round * length(scene, *order)?, look_of(*order).1))
    };
    orders(state).iter().filter_map(scale).collect()
}

/// What the arrows are, with the length of a round value.
pub(super) fn legend(state: &State, scene: &Scene) -> Vec<Key> {
    let stroke = |ink| if ink == Ink::Velocity { Stroke::Solid } else { Stroke::Dashed };
    let key = |(what, size, length, ink)| Key {
        sample: Sample::Arrow(length, stroke(ink), ink),
        text: text!("arrow-told", what = what, size = size),
    };
    scales(state, scene).into_iter().map(key).collect()
}
