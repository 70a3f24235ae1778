//! The reaction of a pair with dry friction as the textbooks draw it: that of a pin touches the circle of friction, that of a slide
//! leans against the sliding by the angle of friction.

use std::f64::consts::TAU;

use assur_analysis::results::{Column, Owner, Quantity};
use assur_figure::{Bounds, Frame, Ink, Item, Panel, Point, Sign, Stroke};
use assur_mechanism::{PairId, Surfaces};
use assur_words::{name, quantity, text};

use crate::number::digits;
use crate::screen::state::{Found, Reaction, Scene};

/// Straight pieces of a circle.
const PIECES: usize = 48;
/// Length of the force beside a circle, and half the side of the drawing, in radii of the circle.
const FORCE: f64 = 2.5;
const ROOM: f64 = 3.0;
/// Friction that is greater by this part than one pressing force gives is that of two.
const ROUNDING: f64 = 1e-9;
/// Half the length of a guide that is drawn, in lengths of the force.
const GUIDE: f64 = 0.5;

/// The drawing of a reaction in a position; `None` where its pair has no friction, or no force.
pub(crate) fn panel(scene: &Scene, found: &Found, position: usize, reaction: &Reaction) -> Option<Panel> {
    let (pair, link) = reaction.of.as_ref()?;
    let mechanism = &scene.linkage.mechanism;
    let friction = mechanism.frictions.iter().find(|friction| friction.pair == pair.id)?;
    let value = |index: usize| found.series[index].course.get(position).filter(|value| value.is_finite());
    let [x, y, _] = reaction.series[..] else { return None };
    let force = [value(x)?, value(y)?];
    let size = force[0].hypot(force[1]);
    if friction.coefficient <= 0.0 || size <= 0.0 {
        return None;
    }
    let row = found.analysis.positions.row_of(position)?;
    let found = |quantity, owner| found.analysis.positions.get(row, Column::of(quantity, owner));
    match (pair.id, friction.surfaces) {
        (PairId::Pin(_), Surfaces::Journal { radius, owner }) if radius > 0.0 => {
            let moment = if mechanism.friction_links(friction).len() > 1 {
                found(Quantity::FrictionMoment, Owner::PairOn(pair.id, link.id))?
            } else {
                // On the journal itself it has the other sign, as the force has.
                let sign = if link.id == owner { -1.0 } else { 1.0 };
                sign * found(Quantity::FrictionMoment, Owner::Pair(pair.id))?
            };
            let direction = [force[0] / size, force[1] / size];
            Some(circle(reaction, friction.coefficient * radius, direction, moment / size))
        }
        (PairId::Slide(id), _) => {
            let slide = &mechanism.slides[id];
            let (s, c) = slide.angle.sin_cos();
            let along = scene.pose(position, 0.0)?.bodies[slide.on].turned([c, s]);
            let share = found(Quantity::FrictionForce, Owner::Pair(pair.id))?;
            Some(cone(reaction, friction.coefficient.atan(), force, along, share))
        }
        (PairId::Pin(_), _) => None,
    }
}

/// A circle about the center of a pin, and the force: its moment about the center is the friction. `lever`: that moment by the
/// force, m.
fn circle(reaction: &Reaction, radius: f64, [x, y]: Point, lever: f64) -> Panel {
    let foot = [lever * y, -lever * x];
    let along = |length: f64| [foot[0] + length * radius * x, foot[1] + length * radius * y];
    let points = (0..=PIECES).map(|piece| {
        let (s, c) = (TAU * piece as f64 / PIECES as f64).sin_cos();
        [radius * c, radius * s]
    });
    let items = vec![
        Item::line(points.collect::<Vec<_>>(), Stroke::Dashed, Ink::Third),
        Item::line(vec![along(-ROOM), along(ROOM)], Stroke::Dotted, Ink::Trace),
        Item::sign([0.0; 2], Sign::Ring, Ink::Title),
        Item::Arrow { from: foot, to: along(FORCE), stroke: Stroke::Solid, ink: Ink::First },
        Item::name(along(FORCE), name("R"), Ink::Title),
    ];
    let bounds = Bounds { low: [-ROOM * radius; 2], high: [ROOM * radius; 2] };
    let frame = Frame::Plane { bounds, unit: "mm".into(), factor: 1e3, scale: ("l", "m".into()) };
    let radius = quantity(digits(1e3 * radius, 4), "mm");
    let title = text!("friction-circle", reaction = &reaction.name, radius = radius);
    Panel { title, frame, items }
}

/// The force of a slide with its part across the guide, between the lines that lean from that by the angle of friction.
fn cone(reaction: &Reaction, angle: f64, force: Point, along: Point, share: f64) -> Panel {
    let size = force[0].hypot(force[1]);
    let times = |length: f64, [x, y]: Point| [length * x, length * y];
    let pressing = force[1] * along[0] - force[0] * along[1];
    let normal = times(pressing.signum(), [-along[1], along[0]]);
    let leaning = |angle: f64| {
        let (s, c) = angle.sin_cos();
        vec![[0.0; 2], times(size, [c * normal[0] - s * normal[1], s * normal[0] + c * normal[1]])]
    };
    let across = times(pressing.abs(), normal);
    let arrow = |to, stroke, ink| Item::Arrow { from: [0.0; 2], to, stroke, ink };
    let items = vec![
        Item::line(
            vec![times(-GUIDE * size, along), times(GUIDE * size, along)],
            Stroke::Dashed,
            Ink::Ground,
        ),
        Item::line(leaning(angle), Stroke::Dotted, Ink::Trace),
        Item::line(leaning(-angle), Stroke::Dotted, Ink::Trace),
        arrow(across, Stroke::Solid, Ink::Second),
        Item::name(across, name("N"), Ink::Title),
        arrow(force, Stroke::Solid, Ink::First),
        Item::name(force, name("R"), Ink::Title),
    ];
    let bounds = Bounds::around(items.iter().flat_map(Item::points));
    let frame = Frame::Plane { bounds, unit: "N".into(), factor: 1.0, scale: ("F", "N".into()) };
    // Two opposite pressing forces rub more than their sum.
    let is_pressed_on_both_ends = share.abs() > (1.0 + ROUNDING) * angle.tan() * pressing.abs();
    let (name, angle) = (reaction.name.clone(), quantity(digits(angle.to_degrees(), 4), "deg"));
    let title = if is_pressed_on_both_ends {
        text!("friction-cone-of-ends", reaction = name, angle = angle)
    } else {
        text!("friction-cone", reaction = name, angle = angle)
    };
    Panel { title, frame, items }
}
