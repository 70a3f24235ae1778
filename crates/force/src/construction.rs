//! The construction behind a result: named vectors in the order in which they are drawn.

/// What a step draws.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StepKind {
    /// A point; its vector is zero.
    Point,
    /// A line from the start along the vector.
    Line,
    /// A force that is given.
    Load,
    /// A part of a force along a line.
    Part,
    /// The balancing force.
    Balancing,
    /// The vector that closes a polygon.
    Closing,
    /// A reaction.
    Reaction,
    /// A vector of a turned velocity plan.
    Velocity,
}

impl StepKind {
    /// The word for this kind in reports.
    pub fn word(self) -> &'static str {
        match self {
            Self::Point => "point",
            Self::Line => "line",
            Self::Load => "load",
            Self::Part => "part",
            Self::Balancing => "balancing",
            Self::Closing => "closing",
            Self::Reaction => "reaction",
            Self::Velocity => "velocity",
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
    /// Short name: `F`, `R3`.
    pub name: String,
    /// What it draws.
    pub kind: StepKind,
    /// Which drawing it belongs to.
    pub drawing: Drawing,
    /// Where it begins, in the unit of its drawing.
    pub start: [f64; 2],
    /// From start to end, in `unit`.
    pub vector: [f64; 2],
    /// Unit of the vector: `N`, `m`, `m/rad`.
    pub unit: &'static str,
    /// What this step does and why, in a sentence.
    pub note: String,
}

/// How a method finds its result on paper.
#[derive(Debug, Clone, PartialEq)]
pub struct Construction {
    /// The method in a line.
    pub title: String,
    /// Where the first corner of the force polygon lies in the drawing of the mechanism, m.
    pub corner: [f64; 2],
    /// The steps in order.
    pub steps: Vec<Step>,
}

impl Construction {
    /// The step of this name in a drawing.
    pub fn step(&self, drawing: Drawing, name: &str) -> Option<&Step> {
        self.steps.iter().find(|step| step.drawing == drawing && step.name == name)
    }
}
