//! The loads of a mechanism as flat data.

use std::sync::Arc;

use assur_integrator::Dependence;
use assur_mechanism::{GROUND, LinkId, LoadId, Mechanism, Name, Place, Spring, TimeLaw, VaryingInertia};
use assur_words::text;

use crate::{Frictions, breaks::Breaks, law::Law, sliding::Sliding};

/// The loads of a mechanism, compiled: indices and formulas, no names.
#[derive(Debug, Clone, PartialEq)]
pub struct Loads {
    pub(crate) masses: Vec<Mass>,
    pub(crate) gravity: [f64; 2],
    /// The loads of the scene that act on links, in its order.
    pub(crate) applied: Vec<Applied>,
    /// The dry friction of the pairs; `None` where all are ideal.
    pub(crate) frictions: Option<Arc<Frictions>>,
    /// Direction of the input where the speed is zero, +1 or -1.
    pub(crate) sense: f64,
    /// Length of a cycle of the input.
    pub(crate) period: Option<f64>,
    /// Over time the law of the only drive, whose coordinate and speed tables and formulas of loads are over.
    pub(crate) law: Option<TimeLaw>,
    /// PF1 of a point below this counts as zero, m/rad (m/m).
    pub(crate) standing: f64,
    /// J is the same at every coordinate, by structure.
    pub(crate) inertia_constant: bool,
    /// Number of links, the ground included.
    pub(crate) links: usize,
    /// The input link and, where it is pinned, the place of its pin.
    pub(crate) input: Option<(LinkId, Option<[f64; 2]>)>,
}

/// A link with mass or moment of inertia.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Mass {
    pub(crate) link: LinkId,
    /// Mass, kg.
    pub(crate) m: f64,
    pub(crate) center: [f64; 2],
    /// Moment of inertia about the center of mass, kg m², without one that varies.
    pub(crate) inertia: f64,
    /// The moment of inertia that varies with the coordinate.
    pub(crate) varying: Option<VaryingInertia>,
    /// The center of mass is the origin of the link's frame.
    pub(crate) at_origin: bool,
    /// Moment of inertia about the pin that joins the link to the ground, kg m², without one that varies; `None` without a pin.
    pub(crate) about_pin: Option<f64>,
}

impl Mass {
    pub(crate) fn all(mechanism: &Mechanism) -> Vec<Self> {
        let mut ground_pins = vec![None; mechanism.links.len()];
        for point in &mechanism.points {
            if point.places.iter().any(|place| place.link == GROUND) {
                point.places.iter().for_each(|place| ground_pins[place.link] = Some(place.at));
            }
        }
        let moving = mechanism.links.iter().enumerate().skip(1);
        let heavy = moving.filter(|(_, link)| link.is_heavy());
        let compiled = heavy.map(|(id, link)| Self {
            link: id,
            m: link.mass,
            center: link.center,
            inertia: link.inertia.constant(),
            varying: link.inertia.varying().cloned(),
            at_origin: link.center == [0.0, 0.0],
            about_pin: ground_pins[id].map(|[x, y]: [f64; 2]| {
                let arm = [link.center[0] - x, link.center[1] - y];
                link.inertia.constant() + link.mass * (arm[0] * arm[0] + arm[1] * arm[1])
            }),
        });
        compiled.collect()
    }
}

/// A load of the scene.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Applied {
    /// Its index in the mechanism.
    pub(crate) id: LoadId,
    /// The law of its size: of a force, a moment, the pressing force of a brake, a contact force. A spring has none.
    pub(crate) size: Law,
    pub(crate) action: Action,
}

/// Where and how a load acts.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Action {
    Force(PointForce),
    Moment(LinkId),
    Brake(Shoe),
    Spring(Spring),
    Contact(Box<ArcContact>),
}

/// A force at a point of a moving link.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PointForce {
    pub(crate) at: Place,
    pub(crate) along: Along,
    /// Where the point rests; needed for a force against its motion.
    pub(crate) rests: Breaks,
}

/// Direction of a force, with unit vectors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Along {
    Ground([f64; 2]),
    Link([f64; 2]),
    AgainstMotion,
}

#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Shoe {
    pub(crate) link: LinkId,
    /// The size of the mechanism, m: a link rests where a point at this distance does.
    pub(crate) reach: f64,
    /// Braking moment of a pressing force of 1 N, m.
    pub(crate) lever: f64,
    pub(crate) rests: Breaks,
}

/// An arc on a straight line.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ArcContact {
    pub(crate) center: Place,
    /// Radius of the arc, m.
    pub(crate) radius: f64,
    /// The law of the angle at which it touches, rad.
    pub(crate) angle: Law,
    /// Coefficient of friction, with its sign unless it is against the sliding.
    pub(crate) friction: f64,
    /// How the arc slides, where the friction is against that.
    pub(crate) sliding: Option<Sliding>,
    /// Interval of contact; `None`: always in contact.
    pub(crate) breaks: Breaks,
    /// Index of the interval of `breaks` in which there is contact.
    pub(crate) touching: usize,
}

impl Applied {
    pub(crate) fn laws(&self) -> impl Iterator<Item = &Law> {
        let angle = if let Action::Contact(contact) = &self.action { Some(&contact.angle) } else { None };
        [&self.size].into_iter().chain(angle)
    }

    /// Where the point or link rests against whose motion it acts.
    pub(crate) fn rests(&self) -> Option<&Breaks> {
        match &self.action {
            Action::Force(PointForce { along: Along::AgainstMotion, rests, .. })
            | Action::Brake(Shoe { rests, .. }) => Some(rests),
            Action::Force(_) | Action::Moment(_) | Action::Spring(_) | Action::Contact(_) => None,
        }
    }

    fn depends_on_speed(&self) -> bool {
        let damped = matches!(&self.action, Action::Spring(spring) if spring.damping != 0.0);
        damped || self.laws().any(|law| law.used().speed)
    }

    /// Whether a motion meets changes on its way that depend on the coordinate alone, as those of a place and a coordinate that do not
    /// repeat together.
    fn is_met_without_motion(&self) -> bool {
        self.laws().any(|law| law.is_met() && !law.used().speed && !law.used().time)
    }

    pub(crate) fn spring(&self) -> Option<&Spring> {
        if let Action::Spring(spring) = &self.action { Some(spring) } else { None }
    }

    /// Whether it depends on the sign of the speed: it is against the motion, has friction against its sliding, or goes
    /// along a stroke.
    pub(crate) fn turns_with_speed(&self) -> bool {
        let slides = matches!(&self.action, Action::Contact(contact) if contact.sliding.is_some());
        slides || self.rests().is_some() || self.laws().any(|law| matches!(law, Law::Stroke(_)))
    }
}

/// The cause of a load: one load of the scene, the weight of a link, or its inertia.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Cause {
    /// Weight of a link.
    Weight(LinkId),
    /// Inertia of a link.
    Inertia(LinkId),
    /// [`Mechanism::loads`] of this index.
    Load(LoadId),
}

impl Cause {
    /// The cause of all loads that count as one with this: the weights or the inertia loads of all links, as if of the ground.
    #[must_use]
    pub fn of_all(self) -> Self {
        match self {
            Self::Weight(_) => Self::Weight(GROUND),
            Self::Inertia(_) => Self::Inertia(GROUND),
            Self::Load(load) => Self::Load(load),
        }
    }

    /// Name for reports.
    pub fn name(self, mechanism: &Mechanism) -> Name {
        let of = |link: LinkId| &mechanism.links[link].name;
        match self {
            Self::Weight(GROUND) => text!("force-weight").into(),
            Self::Inertia(GROUND) => text!("force-inertia").into(),
            Self::Weight(link) => text!("force-weight-of", link = of(link)).into(),
            Self::Inertia(link) => text!("force-inertia-of", link = of(link)).into(),
            Self::Load(id) => mechanism.loads[id].name.clone(),
        }
    }
}

impl Loads {
    /// What the coefficients of the equation of motion depend on: `false` is certain, `true` means that nothing in the structure
    /// excludes it.
    pub fn dependence(&self) -> Dependence {
        Dependence {
            inertia_constant: self.inertia_constant,
            moment_on_coordinate: self.moment_on_coordinate(),
            // What is met on the way has no bound of the coordinate, on which methods along the coordinate alone rely.
            moment_on_speed: self
                .applied
                .iter()
                .any(|load| load.depends_on_speed() || load.is_met_without_motion()),
            moment_on_time: self.applied.iter().any(|load| load.laws().any(|law| law.used().time)),
            moment_on_acceleration: false,
            moment_switches: self.applied.iter().flat_map(Applied::laws).any(Law::is_met),
        }
    }

    fn moment_on_coordinate(&self) -> bool {
        let heavy = self.gravity != [0.0, 0.0]
            && self.masses.iter().any(|mass| mass.m > 0.0 && !self.steady_point(mass.link, mass.center));
        let varies = |load: &Applied| {
            let by_law = load.laws().any(|law| law.used().coordinate || law.used().place);
            by_law
                || match &load.action {
                    Action::Force(force) => !self.steady_force(force),
                    Action::Moment(link) | Action::Brake(Shoe { link, .. }) => {
                        Some(*link) != self.input.map(|input| input.0)
                    }
                    Action::Spring(spring) => spring.stiffness != 0.0 || spring.damping != 0.0,
                    Action::Contact(_) => true,
                }
        };
        heavy || self.applied.iter().any(varies)
    }

    /// Whether PF1 of a point is the same vector at every coordinate.
    fn steady_point(&self, link: LinkId, at: [f64; 2]) -> bool {
        match self.input {
            _ if link == GROUND => true,
            None => false,
            Some((input, Some(pin))) => link == input && at.map(f64::to_bits) == pin.map(f64::to_bits),
            Some((input, None)) => link == input,
        }
    }

    fn steady_force(&self, force: &PointForce) -> bool {
        // On a pinned input link the arm of a force that turns with it is constant.
        let turns = matches!(force.along, Along::Link(_) | Along::AgainstMotion);
        self.steady_point(force.at.link, force.at.at)
            || Some(force.at.link) == self.input.map(|input| input.0) && turns
    }
}
