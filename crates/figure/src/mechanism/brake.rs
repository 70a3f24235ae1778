//! Block brakes on a disc that turns about the ground: the disc, the shoe on it, the lever with its force (D fig. 3.19).

use std::f64::consts::TAU;

use assur_mechanism::{Brake, GROUND, Mechanism, Value};
use assur_words::{joined, name, quantity};

use super::ARC;
use crate::model::{Ink, Item, Point, Sign, Stroke};
use crate::number::plain;

/// Height of the lever above the disc and length of the arrow of its force, as parts of the radius.
const ABOVE: f64 = 0.25;
const ARROW: f64 = 0.6;

/// Everything that is drawn of the brakes; it does not move.
pub fn brakes(mechanism: &Mechanism) -> Vec<Item> {
    let brakes = mechanism.loads.iter().filter_map(|load| load.kind.brake());
    brakes.filter_map(|brake| Some(drawn(brake, center(mechanism, brake)?))).flatten().collect()
}

/// The pin of the disc on the ground.
fn center(mechanism: &Mechanism, brake: &Brake) -> Option<Point> {
    let mut pins = (0..mechanism.points.len()).filter(|id| mechanism.place_in(*id, brake.link).is_some());
    pins.find_map(|id| mechanism.place_in(id, GROUND))
}

/// The shoe presses down on the top of the disc; the lever has its pin one radius to the left of it, and the force at the end of
/// its ratio.
fn drawn(brake: &Brake, center: Point) -> Vec<Item> {
    let radius = brake.radius;
    let at = |x: f64, y: f64| [center[0] + x * radius, center[1] + y * radius];
    let circle = (0..=ARC).map(|step| {
        let (s, c) = (TAU * step as f64 / ARC as f64).sin_cos();
        at(c, s)
    });
    let (height, end) = (1.0 + ABOVE, brake.lever.max(1.0) - 1.0);
    let force = at(end, height + ARROW);
    let told = match brake.force {
        Value::Constant(size) => joined(" = ", [name("P"), quantity(plain(size), "N")]),
        _ => name("P"),
    };
    vec![
        Item::line(circle.collect::<Vec<_>>(), Stroke::Solid, Ink::Link(brake.link)),
        Item::line([at(0.0, 1.0), at(0.0, height)], Stroke::Thick, Ink::Text),
        Item::line([at(-1.0, height), at(end.max(0.0), height)], Stroke::Thick, Ink::Text),
        Item::sign(at(-1.0, height), Sign::Bearing, Ink::Ground),
        Item::sign(at(0.0, 1.0 + 0.3 * ABOVE), Sign::Block, Ink::Text),
        Item::Arrow { from: force, to: at(end, height), stroke: Stroke::Solid, ink: Ink::Second },
        Item::name(force, told, Ink::Second),
    ]
}
