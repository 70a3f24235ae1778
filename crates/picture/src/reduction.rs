//! The reduction to the input link: the mechanism, its plan of velocities, the link with the reduced force and mass at its point
//! (E fig. 1), and the disc that stands for the machine (D fig. 3.17).

use std::f64::consts::FRAC_PI_2;

use assur_analysis::results::{Column, Owner, Quantity};
use assur_figure::number::digits;
use assur_figure::{Bounds, Frame, Ink, Item, Panel, Point, Sign, Stroke};
use assur_mechanism::{InputPair, PointId, ReductionPoint};
use assur_words::{Text, name, quantity, text};

use crate::{Found, Look, Results, ViewPart, mechanism, plans, plots};

/// Half the side of a picture, in radii of the point of reduction.
const ROOM: f64 = 1.5;
/// Straight pieces of an arc.
const PIECES: usize = 48;
/// Radius of the arc of a moment, in radii.
const ARC: f64 = 1.2;
/// What is reduced in a position, to the input link and to its farthest point.
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
}

impl Reduced {
    /// Of a mechanism whose input link turns, where its reduction is calculated.
    fn of(results: &Results, look: &Look<'_>, found: &Found) -> Option<Self> {
        let (table, _) = found.rows();
        let (point, row) =
            (ReductionPoint::farthest(&results.linkage.mechanism)?, table.row_of(look.position)?);
        let InputPair::Pin(pin) = results.linkage.mechanism.input.pair else { return None };
        let pose = results.pose(look.position, 0.0)?;
        let motion = |id: PointId| results.linkage.point_motion(id, &pose);
        let of = |quantity| table.schema().find(Column::of(quantity, Owner::Input));
        let moments = of(Quantity::ReducedMoment)?;
        let shaft = found.analysis.dynamics.as_ref().map_or(0.0, |found| found.regime.found.drive_inertia);
        let tip = motion(point.point.id);
        Some(Self {
            name: Text::from(&point.point),
            radius: point.radius,
            pin: motion(pin).pf0,
            tip: tip.pf0,
            along: tip.pf1,
            moment: table.at(row, moments)?,
            most: table.each(moments).flatten().fold(0.0_f64, |most, moment| most.max(moment.abs())),
            inertia: table.at(row, of(Quantity::ReducedInertia)?)? + shaft,
            has_shaft: shaft > 0.0,
        })
    }

    fn panel(&self, title: Text, items: Vec<Item>) -> Panel {
        let corner = |side: f64| self.pin.map(|at| at + side * ROOM * self.radius);
        let bounds = Bounds { low: corner(-1.0), high: corner(1.0) };
        let frame = Frame::Plane { bounds, unit: "m".into(), factor: 1.0, scale: ("l", "m".into()) };
        let title = if self.has_shaft { text!("reduction-with-flywheel", told = title) } else { title };
        Panel { title, frame, items }
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
        let force = quantity(digits(self.moment / self.radius, 5), "N");
        let mass = quantity(digits(self.inertia / (self.radius * self.radius), 5), "kg");
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
            let at = |part: f64| self.polar(ARC, angle + self.moment.signum() * FRAC_PI_2 * part);
            let arc: Vec<Point> = (0..=PIECES).map(|piece| at(piece as f64 / PIECES as f64)).collect();
            items.push(Item::name(at(0.5), name("M"), Ink::Title));
            items.push(plots::head_of(&arc, Ink::Second));
            items.push(Item::line(arc, Stroke::Solid, Ink::Second));
        }
        let moment = quantity(digits(self.moment, 5), "N m");
        let inertia = quantity(digits(self.inertia, 5), "kg m2");
        self.panel(text!("reduction-model", moment = moment, inertia = inertia), items)
    }
}

/// The link of reduction; `None` where nothing is reduced, or the input slides.
pub(crate) fn link(results: &Results, look: &Look<'_>, found: &Found) -> Option<Panel> {
    Reduced::of(results, look, found).map(|reduced| reduced.link())
}

/// The mechanism, its plan of velocities, the link of reduction, and the disc.
pub(crate) fn panels(results: &Results, look: &Look<'_>, found: &Found) -> Vec<Panel> {
    let Some(reduced) = Reduced::of(results, look, found) else { return Vec::new() };
    let pose = results.pose(look.position, 0.0);
    let items = pose.map_or_else(Vec::new, |pose| mechanism::drawing(results, &[]).items(&pose));
    let mechanism = Panel { title: text!("reduction-mechanism"), ..mechanism::plane(results, items) };
    let velocities = found.plans.at(look.position).sheet.as_ref().ok().map(|sheet| {
        let plan = &sheet.velocities;
        Panel { title: plan.title.clone(), ..plans::panel_of_plan(ViewPart::Velocities, plan) }
    });
    [Some(mechanism), velocities, Some(reduced.link()), Some(reduced.model())].into_iter().flatten().collect()
}
