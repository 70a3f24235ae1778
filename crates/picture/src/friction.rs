//! The reaction of a pair with dry friction as the textbooks draw it.

use assur_analysis::results::{Column, Owner, Part, Quantity, Schema};
use assur_book::catalogue;
use assur_diagram::{friction_circle, friction_cone};
use assur_figure::number::digits;
use assur_figure::{Bounds, Ink, Item, Panel, Point, Scale, Sign, Stroke};
use assur_group::Order;
use assur_mechanism::{Friction, LinkId, PairId, Surfaces};
use assur_words::{Text, joined, name, quantity, text};

use crate::{Found, Reaction, Results};

/// Length of the force beside a circle, and half the side of the drawing, in radii of the circle.
const FORCE: f64 = 2.5;
const ROOM: f64 = 3.0;
/// Half the length of a guide that is drawn, in lengths of the force.
const GUIDE: f64 = 0.5;

/// The dry friction of a pair on one of its links.
#[derive(Debug, Clone)]
pub(crate) struct Rubbing {
    /// The pair, and the link on which it acts, then the other one.
    pub(crate) pair: PairId,
    pub(crate) links: [LinkId; 2],
    /// `M_f,A` of a pin, `F_f,A` of a slide.
    pub(crate) symbol: Text,
    /// What it is.
    pub(crate) told: Text,
    /// Of a pin the moment on the link, N m, counter-clockwise; of a slide the force along the guide on the sliding link, N.
    pub(crate) size: f64,
}

/// The dry friction in the pairs of some links in a position, of each pair on the first of these links; empty where it is not determined.
pub(crate) fn rubbing(results: &Results, position: usize, links: &[LinkId]) -> Vec<Rubbing> {
    let Some(found) = results.found.as_deref() else { return Vec::new() };
    let (table, _) = found.rows();
    let Some(row) = table.row_of(position) else { return Vec::new() };
    let mechanism = &found.linkage.mechanism;
    let schema = Schema::new(mechanism);
    let of_bearing = |friction: &Friction, [link, on]: [LinkId; 2], several: bool| {
        let pair = friction.pair;
        let (letter, quantity) = match pair {
            PairId::Pin(_) => ("M", Quantity::FrictionMoment),
            PairId::Slide(_) => ("F", Quantity::FrictionForce),
        };
        let owner = if several { Owner::PairOn(pair, link) } else { Owner::Pair(pair) };
        let value = table.get(row, Column::of(quantity, owner)).filter(|value| value.is_finite())?;
        // On the journal itself it has the other sign; of a slide the force is told on the sliding link.
        let is_own = links.contains(&link) || matches!(pair, PairId::Slide(_));
        let (links, size) = if is_own { ([link, on], value) } else { ([on, link], -value) };
        let of = catalogue::owner(&schema, Column::of(Quantity::Force, Owner::PairOn(pair, links[0])));
        let named = match pair {
            PairId::Pin(id) => Text::from(&mechanism.points[id].name),
            PairId::Slide(id) => Text::from(&mechanism.slides[id].name),
        };
        let further = several.then(|| name(link.to_string()));
        let index = joined(",", [text!("index-of-friction"), named].into_iter().chain(further));
        let told = match pair {
            PairId::Pin(_) => text!("acting-friction", of),
            PairId::Slide(_) => text!("acting-friction-of-slide", of),
        };
        Some(Rubbing { pair, links, symbol: name(letter).below(index), told, size })
    };
    let of_pair = |friction: &Friction| {
        let bearings = mechanism.friction_links(friction);
        let several = bearings.len() > 1;
        let own = bearings.into_iter().filter(|pair| pair.iter().any(|link| links.contains(link)));
        own.filter_map(|pair| of_bearing(friction, pair, several)).collect::<Vec<_>>()
    };
    mechanism.frictions.iter().flat_map(of_pair).collect()
}

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
