//! The turned velocity plan with the forces on it.

use assur_force::{Construction, Drawing, Step, UnitBalance, VectorKind};
use assur_group::plane::{opposite, perp, scaled};
use assur_group::{Body, Wrench};
use assur_kinematics::{Linkage, Position};
use assur_mechanism::{Balance, InputPair};
use assur_words::{Text, name, quantity, text};

/// A moment is shown as the arm of the force on its link up to this many typical lengths.
const FAR: f64 = 1e2;

/// The lever: images of the points turned clockwise by a right angle, then each link's load in the image of its point.
pub(crate) fn draw(
    linkage: &Linkage,
    position: &Position,
    loads: &[Wrench<f64>],
    balancing: f64,
) -> Construction {
    let mut steps = images(linkage, position);
    for (link, load) in loads.iter().enumerate().skip(1) {
        let of = &linkage.mechanism.links[link].name;
        let words = [name(format!("F({of})")), text!("force-lever-loads", link = of)];
        steps.extend(on_lever(linkage, &position.bodies[link], load, VectorKind::Load, words));
    }
    steps.extend(balance(linkage, position, balancing));
    let title = text!("force-lever-title");
    Construction { title, corner: [0.0; 2], steps }
}

fn unit(linkage: &Linkage) -> &'static str {
    if linkage.angular() { "m/rad" } else { "m/m" }
}

/// PF1 turned clockwise: the moment about the pole of a force there is its power.
fn turned(first: [f64; 2]) -> [f64; 2] {
    opposite(perp(first))
}

fn images(linkage: &Linkage, position: &Position) -> Vec<Step> {
    let points = linkage.mechanism.points.iter().enumerate();
    points
        .map(|(id, point)| Step {
            name: Text::from(&point.name),
            kind: VectorKind::Absolute,
            drawing: Drawing::Lever,
            start: [0.0; 2],
            vector: turned(linkage.point_motion(id, position).pf1),
            unit: unit(linkage),
            note: text!("force-lever-image", point = &point.name),
        })
        .collect()
}

/// The load of a link as a force in the image of a point of its line of action, or as a couple if there is no such
/// point.
fn on_lever(
    linkage: &Linkage,
    body: &Body<f64>,
    load: &Wrench<f64>,
    kind: VectorKind,
    [name, what]: [Text; 2],
) -> Vec<Step> {
    let force = load.force();
    let square = force[0] * force[0] + force[1] * force[1];
    let (mut arm, mut couple) = ([0.0; 2], load.m);
    if load.m.abs() <= FAR * linkage.structure.scale * square.sqrt() && square > 0.0 {
        (arm, couple) = (scaled(-load.m / square, perp(force)), 0.0);
    }
    let step = |name: Text, start, vector, note| Step {
        name,
        kind,
        drawing: Drawing::Lever,
        start,
        vector,
        unit: "N",
        note,
    };
    let mut steps = Vec::new();
    if square > 0.0 {
        let note = text!("force-lever-on-line", what = &what);
        steps.push(step(name.clone(), turned(body.first(arm)), force, note));
    }
    if couple != 0.0 && body.w1 != 0.0 {
        // A couple of two forces across a unit vector of the link: their images are w1 apart.
        let [start, end] = [[0.0; 2], [1.0, 0.0]].map(|arm| turned(body.first(arm)));
        let moment = quantity(format_args!("{couple:.6e}"), "N m");
        let named = |number: usize| text!("force-lever-couple", name = &name, number = number);
        let note = text!("force-lever-first", couple = &moment, what = &what);
        steps.push(step(named(1), start, [0.0, -couple], note));
        let note = text!("force-lever-second", couple = moment, what = what);
        steps.push(step(named(2), end, [0.0, couple], note));
    }
    steps
}

/// The balancing load where it acts.
fn balance(linkage: &Linkage, position: &Position, size: f64) -> Vec<Step> {
    let (mechanism, bodies) = (&linkage.mechanism, &position.bodies);
    let kind = VectorKind::Balancing;
    let Some(unit) = UnitBalance::of(mechanism) else {
        let body = &bodies[mechanism.input.link];
        let load = match mechanism.input.pair {
            InputPair::Pin(_) => Wrench { fx: 0.0, fy: 0.0, m: size },
            // The origin of a sliding input moves by the unit vector along the coordinate.
            InputPair::Slide(_) => Wrench { fx: size * body.x1, fy: size * body.y1, m: 0.0 },
        };
        let words = [text!("force-lever-balance"), text!("force-lever-balancing-load")];
        return on_lever(linkage, body, &load, kind, words);
    };
    let Wrench { fx, fy, m } = unit.wrench(bodies);
    let load = Wrench { fx: size * fx, fy: size * fy, m: size * m };
    let what = match mechanism.balance {
        Some(Balance::Force { .. }) => text!("force-lever-balancing-force"),
        _ => text!("force-lever-balancing-moment"),
    };
    on_lever(linkage, &bodies[unit.link], &load, kind, [text!("force-lever-balance"), what])
}
