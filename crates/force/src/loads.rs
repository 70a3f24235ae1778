//! The loads of a mechanism as flat data.

use assur_integrator::Dependence;
use assur_mechanism::{Brake, GROUND, LinkId, Mechanism, Name, Place};
use assur_words::text;

use crate::breaks::Breaks;
use crate::law::Law;
use crate::sliding::Sliding;

/// The loads of a mechanism, compiled: indices and formulas, no names.
#[derive(Debug, Clone, PartialEq)]
pub struct Loads {
    pub(crate) masses: Vec<Mass>,
    pub(crate) gravity: [f64; 2],
    pub(crate) forces: Vec<PointForce>,
    pub(crate) moments: Vec<LinkMoment>,
    pub(crate) springs: Vec<SpringDamper>,
    pub(crate) contacts: Vec<ArcContact>,
    /// One for each force, then for each moment, then for the force of each contact, then for its angle.
    pub(crate) laws: Vec<Law>,
    /// Direction of the input where the speed is zero, +1 or -1.
    pub(crate) sense: f64,
    /// Length of a cycle of the input.
    pub(crate) period: Option<f64>,
    /// PF1 of a point below this counts as zero, m/rad (m/m).
    pub(crate) standing: f64,
    /// J is the same at every coordinate, by structure.
    pub(crate) inertia_constant: bool,
    /// The input link and, where it is pinned, the place of its pin.
    pub(crate) input: (LinkId, Option<[f64; 2]>),
}

/// A link with mass or moment of inertia.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Mass {
    pub(crate) link: LinkId,
    /// Mass, kg.
    pub(crate) m: f64,
    pub(crate) center: [f64; 2],
    /// Moment of inertia about the center of mass, kg m².
    pub(crate) inertia: f64,
    /// The center of mass is the origin of the link's frame.
    pub(crate) at_origin: bool,
    /// Moment of inertia about the pin that joins the link to the ground, kg m²; `None` without one.
    pub(crate) about_pin: Option<f64>,
}

impl Mass {
    /// The links that have one.
    pub(crate) fn all(mechanism: &Mechanism) -> Vec<Self> {
        let mut ground_pins = vec![None; mechanism.links.len()];
        for point in &mechanism.points {
            if point.places.iter().any(|place| place.link == GROUND) {
                point.places.iter().for_each(|place| ground_pins[place.link] = Some(place.at));
            }
        }
        let moving = mechanism.links.iter().enumerate().skip(1);
        let heavy = moving.filter(|(_, link)| link.mass > 0.0 || link.inertia > 0.0);
        let compiled = heavy.map(|(id, link)| Self {
            link: id,
            m: link.mass,
            center: link.center,
            inertia: link.inertia,
            at_origin: link.center == [0.0, 0.0],
            about_pin: ground_pins[id].map(|[x, y]: [f64; 2]| {
                let arm = [link.center[0] - x, link.center[1] - y];
                link.inertia + link.mass * (arm[0] * arm[0] + arm[1] * arm[1])
            }),
        });
        compiled.collect()
    }
}

/// A force at a point of a moving link.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PointForce {
    /// Index in the mechanism.
    pub(crate) id: usize,
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

/// A moment on a moving link.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LinkMoment {
    pub(crate) id: usize,
    pub(crate) link: LinkId,
    /// Of a brake: its shoe, and where the link rests.
    pub(crate) brake: Option<(Brake, Breaks)>,
}

/// A spring with a damper.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SpringDamper {
    pub(crate) id: usize,
    pub(crate) ends: [Place; 2],
    pub(crate) stiffness: f64,
    pub(crate) length: f64,
    pub(crate) damping: f64,
}

/// An arc on a straight line.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ArcContact {
    pub(crate) id: usize,
    pub(crate) center: Place,
    /// Radius of the arc, m.
    pub(crate) radius: f64,
    /// Coefficient of friction, with its sign unless it is against the sliding.
    pub(crate) friction: f64,
    /// How the arc slides, where the friction is against that.
    pub(crate) sliding: Option<Sliding>,
    /// Interval of contact; `None`: always in contact.
    pub(crate) breaks: Breaks,
    /// Index of the interval of `breaks` in which there is contact.
    pub(crate) touching: usize,
}

/// The cause of a load: one load of the scene, the weight of a link, or its inertia.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Cause {
    /// Weight of a link.
    Weight(LinkId),
    /// Inertia of a link.
    Inertia(LinkId),
    /// [`Mechanism::forces`] of this index.
    Force(usize),
    /// [`Mechanism::moments`] of this index.
    Moment(usize),
    /// [`Mechanism::springs`] of this index.
    Spring(usize),
    /// [`Mechanism::contacts`] of this index.
    Contact(usize),
}

impl Cause {
    /// The cause of all loads that count as one with this: the weights or the inertia loads of all links, as if of the ground.
    #[must_use]
    pub fn of_all(self) -> Self {
        match self {
            Self::Weight(_) => Self::Weight(GROUND),
            Self::Inertia(_) => Self::Inertia(GROUND),
            load => load,
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
            Self::Force(id) => mechanism.forces[id].name.clone(),
            Self::Moment(id) => mechanism.moments[id].name.clone(),
            Self::Spring(id) => mechanism.springs[id].name.clone(),
            Self::Contact(id) => mechanism.contacts[id].name.clone(),
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
            moment_on_speed: self.laws.iter().any(|law| law.used().speed) || self.damped(),
            moment_on_time: self.laws.iter().any(|law| law.used().time),
        }
    }

    fn damped(&self) -> bool {
        self.springs.iter().any(|spring| spring.damping != 0.0)
    }

    fn moment_on_coordinate(&self) -> bool {
        let heavy = self.gravity != [0.0, 0.0]
            && self.masses.iter().any(|mass| mass.m > 0.0 && !self.steady_point(mass.link, mass.center));
        let laws = self.laws.iter().any(|law| law.used().coordinate || law.used().place);
        let springs = self.springs.iter().any(|spring| spring.stiffness != 0.0 || spring.damping != 0.0);
        heavy
            || laws
            || springs
            || !self.contacts.is_empty()
            || self.forces.iter().any(|force| !self.steady_force(force))
            || self.moments.iter().any(|moment| moment.link != self.input.0)
    }

    /// Whether PF1 of a point is the same vector at every coordinate.
    fn steady_point(&self, link: LinkId, at: [f64; 2]) -> bool {
        match self.input {
            _ if link == GROUND => true,
            (input, Some(pin)) => link == input && at.map(f64::to_bits) == pin.map(f64::to_bits),
            (input, None) => link == input,
        }
    }

    fn steady_force(&self, force: &PointForce) -> bool {
        // On a pinned input link the arm of a force that turns with it is constant.
        let turns = matches!(force.along, Along::Link(_) | Along::AgainstMotion);
        self.steady_point(force.at.link, force.at.at) || force.at.link == self.input.0 && turns
    }
}
