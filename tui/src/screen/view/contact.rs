//! The contacts of a position: the point K, the normal force and the friction in it, and their sum.

use assur_analysis::results::{Column, Owner, Quantity};
use assur_book::Course;
use assur_figure::{Ink, Item, Key, Sample, Sign, Stroke, round_length};
use assur_force::{Acting, Cause};
use assur_group::plane::{plus, scaled};
use assur_kinematics::Position;
use assur_mechanism::LoadId;
use assur_words::{Text, joined, name, quantity, text};

use crate::number::plain;
use crate::screen::state::Scene;

/// Greatest force over the cycle, as part of the size of the drawing.
const LONGEST: f64 = 0.25;

/// Whether a load of the scene is a contact.
fn is_contact(scene: &Scene, load: LoadId) -> bool {
    scene.linkage.mechanism.loads[load].kind.contact().is_some()
}

/// The contacts that act in a pose.
fn acting(scene: &Scene, pose: &Position) -> Vec<Acting> {
    let Some(found) = &scene.found else { return Vec::new() };
    let calculation = found.plans.calculation();
    let Some(loads) = calculation.loads.as_ref().filter(|_| calculation.positions_have_forces()) else {
        return Vec::new();
    };
    let mut all = loads.acting(&calculation.state(pose.coordinate), &pose.bodies);
    all.retain(|load| matches!(load.cause, Cause::Load(load) if is_contact(scene, load)));
    all
}

/// K with its name, the normal force and the friction dashed, their sum full.
pub(super) fn items(scene: &Scene, pose: &Position) -> Vec<Item> {
    let Some(length) = length(scene) else { return Vec::new() };
    let all = acting(scene, pose);
    let several = all.len() > 1;
    let mut items = Vec::new();
    for (number, load) in all.iter().enumerate() {
        let (Some(at), Some([normal, friction])) =
            (load.at, load.parts(&scene.linkage.mechanism, &pose.bodies))
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

/// Greatest force of a contact over the cycle, N.
fn most(scene: &Scene) -> f64 {
    let Some(found) = &scene.found else { return 0.0 };
    let positions = &found.analysis.positions;
    let of_contact =
        (0..scene.linkage.mechanism.loads.len()).filter(|load| is_contact(scene, *load)).map(Owner::Load);
    let size =
        |owner| Course::of(positions, None, Column::COORDINATE, Column::of(Quantity::Load, owner)).size();
    of_contact.map(size).fold(0.0, f64::max)
}

/// Length, m, of an arrow of 1 N; equal in all positions, so that lengths can be compared.
fn length(scene: &Scene) -> Option<f64> {
    let [width, height] = scene.outline.bounds.size();
    let most = most(scene);
    (most > 0.0).then(|| LONGEST * width.max(height) / most)
}

/// What the arrows are, with the length of a round force.
pub(super) fn legend(scene: &Scene) -> Option<Key> {
    let round = round_length(0.5 * most(scene));
    let sample = Sample::Arrow(round * length(scene)?, Stroke::Solid, Ink::Second);
    let size = quantity(plain(round), "N");
    Some(Key { sample, text: text!("contact-forces", size = size) })
}
