//! The reduction to the input link: the mechanism, its plan of velocities, the link with the reduced force and mass at its point
//! (E fig. 1), and the disc that stands for the machine (D fig. 3.17).

use assur_diagram::velocity_plan;
use assur_figure::{Bounds, Ink, Item, Panel, Point, Scale, Sign, Stroke};
use assur_force::LoadState;
use assur_kinematics::Position;
use assur_mechanism::{InputPair, PointId, ReductionPoint};
use assur_words::{Text, measured, name, text};

use crate::{Found, Look, Results, ViewPart, mechanism, plans, plots};

/// Radius of the arc of a moment, in radii.
const ARC: f64 = 1.2;
/// Positions or instants that are looked at for the greatest moment.
const LOOKED_AT: usize = 96;

/// What is reduced in a position or at an instant, to the input link and to its farthest point.
struct Reduced {
    name: Text,
    radius: f64,
    pin: Point,
    tip: Point,
    /// PF1 of the point.
    along: Point,
    moment: f64,
    /// The greatest size of the moment over the cycle.
    most: f64,
    /// Reduced moment of inertia, with that of flywheel and rotor.
    inertia: f64,
    has_shaft: bool,
    pose: Position,
    state: LoadState,
}

impl Reduced {
    /// Of a mechanism whose input link turns, where its loads are known.
    fn of(results: &Results, look: &Look<'_>, found: &Found) -> Option<Self> {
        let (linkage, calculation) = (&results.linkage, found.plans.calculation());
        let point = ReductionPoint::farthest(&linkage.mechanism)?;
        let InputPair::Pin(pin) = linkage.mechanism.input.first().pair else { return None };
        let loads = calculation.loads.as_ref()?;
        let place = |number| results.moving(number, 0.0);
        let count = results.positions();
        let all = (0..count).step_by(count.div_ceil(LOOKED_AT).max(1)).filter_map(place);
        let moments = all.map(|(pose, state)| loads.reduced(&state, &pose.bodies).moment.abs());
        let most = moments.fold(0.0, f64::max);
        let (pose, state) = place(look.position)?;
        let motion = |id: PointId| linkage.point_motion(id, &pose);
        let reduced = loads.reduced(&state, &pose.bodies);
        let shaft = calculation.drive_in(&state).map_or(0.0, |[_, shaft]| shaft);
        let (pin, tip) = (motion(pin).pf0, motion(point.point.id));
        Some(Self {
            name: Text::from(&point.point),
            radius: point.radius,
            pin,
            tip: tip.pf0,
            along: tip.pf1,
            moment: reduced.moment,
            most: most.max(reduced.moment.abs()),
            inertia: reduced.inertia + shaft,
            has_shaft: shaft > 0.0,
            pose,
            state,
        })
    }

    fn panel(&self, title: Text, items: Vec<Item>) -> Panel {
        let title = if self.has_shaft { text!("reduction-with-flywheel", told = title) } else { title };
        Panel { title, ..around(items) }
    }

    /// A place in polar coordinates around the pin, in radii.
    fn polar(&self, radius: f64, angle: f64) -> Point {
        let (s, c) = angle.sin_cos();
        [self.pin[0] + radius * self.radius * c, self.pin[1] + radius * self.radius * s]
    }

    /// The link with the reduced force and mass at its point (E fig. 1c). The greatest force of the cycle is as long as the radius.
    fn link(&self) -> Panel {
        let length = if self.most > 0.0 { self.moment / self.most } else { 0.0 };
        let to = [0, 1].map(|axis| self.tip[axis] + length * self.along[axis]);
        let mut items = vec![
            Item::line(vec![self.pin, self.tip], Stroke::Solid, Ink::First),
            Item::sign(self.pin, Sign::Bearing, Ink::Ground),
            Item::sign(self.tip, Sign::Dot, Ink::First),
            Item::Arrow { from: self.tip, to, stroke: Stroke::Solid, ink: Ink::Second },
            Item::name(self.tip, self.name.clone(), Ink::Title),
        ];
        items.extend((length != 0.0).then(|| Item::name(to, name("F"), Ink::Title)));
        let force = measured(self.moment / self.radius, 5, "N");
        let mass = measured(self.inertia / (self.radius * self.radius), 5, "kg");
        self.panel(text!("regime-reduced", point = &self.name, force = force, mass = mass), items)
    }

    /// The disc with the reduced inertia and the reduced moment in its sense (D fig. 3.17).
    fn model(&self) -> Panel {
        let angle = (self.tip[1] - self.pin[1]).atan2(self.tip[0] - self.pin[0]);
        let mut items = vec![
            Item::circle(self.pin, self.radius, Stroke::Thick, Ink::First),
            Item::line([self.pin, self.polar(1.0, angle)], Stroke::Dashed, Ink::First),
            Item::sign(self.pin, Sign::Bearing, Ink::Ground),
        ];
        if self.moment != 0.0 {
            let (arc, middle) = plots::moment(self.pin, ARC * self.radius, angle, self.moment, Ink::Second);
            items.extend(arc);
            items.push(Item::name(middle, name("M"), Ink::Title));
        }
        let moment = measured(self.moment, 5, "N m");
        let inertia = measured(self.inertia, 5, "kg m2");
        self.panel(text!("reduction-model", moment = moment, inertia = inertia), items)
    }
}

/// A plane of what is drawn in it.
fn around(items: Vec<Item>) -> Panel {
    Panel::plane(Bounds::around(items.iter().flat_map(Item::points)), Scale::of("l", "m"), items)
}

/// The link of reduction; `None` where nothing is reduced, or the input slides.
pub(crate) fn link(results: &Results, look: &Look<'_>, found: &Found) -> Option<Panel> {
    Reduced::of(results, look, found).map(|reduced| reduced.link())
}

/// The mechanism, its plan of velocities, the link of reduction, and the disc.
pub(crate) fn panels(results: &Results, look: &Look<'_>, found: &Found) -> Vec<Panel> {
    let Some(reduced) = Reduced::of(results, look, found) else { return Vec::new() };
    let items = mechanism::drawing(results, &[]).items(&reduced.pose);
    let mechanism = Panel { title: text!("reduction-mechanism"), ..around(items) };
    let moves = reduced.state.speed != 0.0 || reduced.state.acceleration != 0.0;
    let plan = velocity_plan(&results.linkage, &reduced.pose, moves.then_some(&reduced.state));
    let velocities = Panel { title: plan.title.clone(), ..plans::panel_of_plan(ViewPart::Velocities, &plan) };
    vec![mechanism, velocities, reduced.link(), reduced.model()]
}
