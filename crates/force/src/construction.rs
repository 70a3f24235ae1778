//! The construction behind a result: named vectors in the order in which they are drawn.

use assur_words::{Describe, Text, text};
use serde::Serialize;

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
    /// A part of a force along a line.
    Part,
    /// A line of the construction.
    Line,
    /// A point, whose vector is zero: a step of a construction, but no vector of a plan.
    Point,
    /// From the pole to the image of a point.
    Absolute,
    /// Velocity or acceleration of one point of a link relative to another.
    Relative,
    /// Normal part, towards the other point.
    Normal,
    /// Tangential part.
    Tangential,
    /// Coriolis part.
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
pub struct Step {
    /// Short name: `F`, `R3`, or words.
    pub name: Text,
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
    pub steps: Vec<Step>,
}

impl Construction {
    /// The step of this short name in English in a drawing.
    pub fn step(&self, drawing: Drawing, name: &str) -> Option<&Step> {
        self.steps.iter().find(|step| step.drawing == drawing && step.name.to_string() == name)
    }
}
