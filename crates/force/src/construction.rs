//! The construction behind a result: named vectors in the order in which they are drawn.

use assur_group::plane::{cross, dot, minus, plus, scaled};
use assur_group::{Body, Wrench};
use assur_mechanism::{LinkId, Mechanism};
use assur_words::{Describe, Text, text};
use serde::Serialize;

use crate::LoadState;
use crate::loads::{Cause, Loads};

/// What a vector of a plan or a step of a construction represents.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum VectorKind {
    /// A load of the scene.
    Load,
    /// A weight.
    Weight,
    /// An inertia load.
    Inertia,
    /// A reaction in a pair to a body outside.
    Reaction,
    /// The reaction in an inner pair: drawn inside the polygon, no side of it.
    Inner,
    /// The balancing load.
    Balancing,
    /// The closing side of a polygon.
    Closing,
    /// A component of a force along a line.
    Part,
    /// A line of the construction.
    Line,
    /// A point, whose vector is zero: a step of a construction, but no vector of a plan.
    Point,
    /// From the pole to the image of a point.
    Absolute,
    /// Velocity or acceleration of one point of a link relative to another.
    Relative,
    /// Normal component, towards the other point.
    Normal,
    /// Tangential component.
    Tangential,
    /// Coriolis component.
    Coriolis,
}

impl Describe for VectorKind {
    fn describe(&self) -> Text {
        match self {
            Self::Load => text!("vector-load"),
            Self::Weight => text!("vector-weight"),
            Self::Inertia => text!("vector-inertia"),
            Self::Reaction => text!("vector-reaction"),
            Self::Inner => text!("vector-inner"),
            Self::Balancing => text!("vector-balancing"),
            Self::Closing => text!("vector-closing"),
            Self::Part => text!("vector-part"),
            Self::Line => text!("vector-line"),
            Self::Point => text!("vector-point"),
            Self::Absolute => text!("vector-absolute"),
            Self::Relative => text!("vector-relative"),
            Self::Normal => text!("vector-normal"),
            Self::Tangential => text!("vector-tangential"),
            Self::Coriolis => text!("vector-coriolis"),
        }
    }
}

/// Which drawing a step belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Drawing {
    /// The mechanism in its position; starts in m.
    Mechanism,
    /// The force polygon; starts in N from its first corner, which lies at [`Construction::corner`].
    Polygon,
    /// The turned velocity plan; starts in m per unit of the coordinate, from its pole.
    Lever,
}

/// One step of a construction.
#[derive(Debug, Clone, PartialEq)]
pub struct ConstructionStep {
    /// Short name: `F`, `R3`, or words.
    pub name: Text,
    /// The load that it draws; empty where the name says what it is.
    pub of: Text,
    /// What it draws.
    pub kind: VectorKind,
    /// Which drawing it belongs to.
    pub drawing: Drawing,
    /// Where it begins, in the unit of its drawing.
    pub start: [f64; 2],
    /// Forces laid off from the start up to where the step begins, N.
    pub after: [f64; 2],
    /// From start to end, in `unit`.
    pub vector: [f64; 2],
    /// Unit of the vector: `N`, `m`, `m/rad`.
    pub unit: &'static str,
    /// What this step does and why, in a sentence.
    pub note: Text,
}

/// How a method finds its result on paper.
#[derive(Debug, Clone, PartialEq)]
pub struct Construction {
    /// The method in a line.
    pub title: Text,
    /// Where the first corner of the force polygon lies in the drawing of the mechanism, m.
    pub corner: [f64; 2],
    /// The steps in order.
    pub steps: Vec<ConstructionStep>,
}

/// One load on one link, in the ground's frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Acting {
    /// Its cause.
    pub cause: Cause,
    /// The loaded link.
    pub link: LinkId,
    /// Force and moment about the origin of the link's frame.
    pub wrench: Wrench<f64>,
    /// Where the force acts, m; `None` for a moment alone. An inertia load acts at the center of mass.
    pub at: Option<[f64; 2]>,
}

impl Acting {
    /// Its moment about its point of action, N m: that of a load without a force, and of an inertia load.
    pub fn couple(&self, bodies: &[Body<f64>]) -> f64 {
        let body = &bodies[self.link];
        self.at.map_or(self.wrench.m, |at| {
            self.wrench.m - cross(minus(at, [body.x, body.y]), self.wrench.force())
        })
    }

    /// The normal force and the friction of a contact, N; `None` of any other load.
    pub fn parts(&self, mechanism: &Mechanism, bodies: &[Body<f64>]) -> Option<[[f64; 2]; 2]> {
        let (Cause::Load(id), Some(at)) = (self.cause, self.at) else { return None };
        let contact = mechanism.loads[id].kind.contact()?;
        // From K towards the center of the arc.
        let normal = scaled(1.0 / contact.radius, minus(bodies[self.link].point(contact.center.at), at));
        let across = scaled(dot(self.wrench.force(), normal), normal);
        Some([across, minus(self.wrench.force(), across)])
    }

    /// All loads as one wrench for each of so many links, about the origin of its frame.
    pub fn total<'a>(loads: impl IntoIterator<Item = &'a Self>, links: usize) -> Vec<Wrench<f64>> {
        let mut wrenches = vec![Wrench::ZERO; links];
        for load in loads {
            wrenches[load.link].add_at([0.0; 2], load.wrench.force(), load.wrench.m);
        }
        wrenches
    }
}

impl Loads {
    /// Each load of a state by itself: weights, the loads of the scene (a spring on both of its links), inertia loads.
    pub fn acting(&self, state: &LoadState, bodies: &[Body<f64>]) -> Vec<Acting> {
        let mut list = Vec::new();
        self.each_at(state, bodies, &mut |cause, link, wrench, arm| {
            let arm = match cause {
                Cause::Inertia(_) if wrench.force() != [0.0, 0.0] => {
                    let mass = self.masses.iter().find(|mass| mass.link == link);
                    mass.map(|mass| bodies[link].arm(mass.center))
                }
                _ => arm,
            };
            let at = arm.map(|arm| plus([bodies[link].x, bodies[link].y], arm));
            list.push(Acting { cause, link, wrench, at });
        });
        list
    }
}
