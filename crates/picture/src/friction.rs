//! The reaction of a pair with dry friction as the textbooks draw it.

use assur_analysis::results::{Column, Owner, Part, Quantity};
use assur_diagram::{friction_circle, friction_cone};
use assur_figure::number::digits;
use assur_figure::{Bounds, Ink, Item, Panel, Point, Scale, Sign, Stroke};
use assur_group::Order;
use assur_mechanism::{PairId, Surfaces};
use assur_words::{Text, name, quantity, text};

use crate::{Found, Reaction};

/// Length of the force beside a circle, and half the side of the drawing, in radii of the circle.
const FORCE: f64 = 2.5;
const ROOM: f64 = 3.0;
/// Half the length of a guide that is drawn, in lengths of the force.
const GUIDE: f64 = 0.5;

/// The reaction of a pair with friction in a position, as the textbooks draw it; `None` without friction or force.
pub fn beside_friction(found: &Found, position: usize, reaction: &Reaction) -> Option<Panel> {
    let ((pair, link), reaction) = (reaction.of.as_ref()?, &reaction.name);
    let (pair, link, mechanism) = (pair.id, link.id, &found.linkage.mechanism);
    let friction = mechanism.frictions.iter().find(|friction| friction.pair == pair)?;
    let (table, _) = found.rows();
    let row = table.row_of(position)?;
    let value = |quantity, owner| table.get(row, Column::of(quantity, owner));
    let whole = Column::of(Quantity::Force, Owner::PairOn(pair, link));
    let part = |part| table.get(row, whole.part(part)).filter(|value| value.is_finite());
    let force = [part(Part::X)?, part(Part::Y)?];
    Some(match (pair, friction.surfaces) {
        (PairId::Pin(_), Surfaces::Journal { owner, .. }) => {
            let moment = if mechanism.friction_links(friction).len() > 1 {
                value(Quantity::FrictionMoment, Owner::PairOn(pair, link))?
            } else {
                // On the journal itself it has the other sign, as the force has.
                let sign = if link == owner { -1.0 } else { 1.0 };
                sign * value(Quantity::FrictionMoment, Owner::Pair(pair))?
            };
            let (radius, lever) = friction_circle(friction, force, moment)?;
            circle(reaction, radius, force, lever)
        }
        (PairId::Slide(id), _) => {
            let (slide, mut pose) = (&mechanism.slides[id], found.linkage.position());
            found.linkage.solve_index(position, Order::Second, &mut pose).ok()?;
            let (s, c) = slide.angle.sin_cos();
            let along = pose.bodies[slide.on].turned([c, s]);
            let share = value(Quantity::FrictionForce, Owner::Pair(pair))?;
            let (angle, normal, on_both_ends) = friction_cone(friction, force, along, share)?;
            let told = quantity(digits(angle.to_degrees(), 4), "deg");
            let title = if on_both_ends { "friction-cone-of-ends" } else { "friction-cone" };
            cone(text!(title, reaction, angle = told), angle, force, (along, normal))
        }
        (PairId::Pin(_), _) => return None,
    })
}

/// A circle about the center of a pin, and the force at the distance `lever` from it.
fn circle(reaction: &Text, radius: f64, force: Point, lever: f64) -> Panel {
    let size = force[0].hypot(force[1]);
    let [x, y] = [force[0] / size, force[1] / size];
    let foot = [lever * y, -lever * x];
    let along = |length: f64| [foot[0] + length * radius * x, foot[1] + length * radius * y];
    let items = vec![
        Item::circle([0.0; 2], radius, Stroke::Dashed, Ink::Third),
        Item::line(vec![along(-ROOM), along(ROOM)], Stroke::Dotted, Ink::Trace),
        Item::sign([0.0; 2], Sign::Ring, Ink::Title),
        Item::Arrow { from: foot, to: along(FORCE), stroke: Stroke::Solid, ink: Ink::First },
        Item::name(along(FORCE), name("R"), Ink::Title),
    ];
    let bounds = Bounds { low: [-ROOM * radius; 2], high: [ROOM * radius; 2] };
    let radius = quantity(digits(1e3 * radius, 4), "mm");
    let title = text!("friction-circle", reaction = reaction, radius = radius);
    Panel { title, ..Panel::plane(bounds, Scale::of("l", "m"), items) }
}

/// The force of a slide with its part across the guide, between the lines that lean from that by the angle of friction.
fn cone(title: Text, angle: f64, force: Point, (along, pressing): (Point, f64)) -> Panel {
    let size = force[0].hypot(force[1]);
    let times = |length: f64, [x, y]: Point| [length * x, length * y];
    let normal = times(pressing.signum(), [-along[1], along[0]]);
    let leaning = |angle: f64| {
        let (s, c) = angle.sin_cos();
        vec![[0.0; 2], times(size, [c * normal[0] - s * normal[1], s * normal[0] + c * normal[1]])]
    };
    let (across, guide) =
        (times(pressing.abs(), normal), [-GUIDE, GUIDE].map(|end| times(end * size, along)));
    let arrow = |to, stroke, ink| Item::Arrow { from: [0.0; 2], to, stroke, ink };
    let items = vec![
        Item::line(guide, Stroke::Dashed, Ink::Ground),
        Item::line(leaning(angle), Stroke::Dotted, Ink::Trace),
        Item::line(leaning(-angle), Stroke::Dotted, Ink::Trace),
        arrow(across, Stroke::Solid, Ink::Second),
        Item::name(across, name("N"), Ink::Title),
        arrow(force, Stroke::Solid, Ink::First),
        Item::name(force, name("R"), Ink::Title),
    ];
    let bounds = Bounds::around(items.iter().flat_map(Item::points));
    Panel { title, ..Panel::plane(bounds, Scale::of("F", "N"), items) }
}
