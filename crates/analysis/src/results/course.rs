//! The course of a motion over time, and how it was found.

use serde::Serialize;

use crate::results::{Derivatives, Named, PairReaction, Rates};

/// One instant of a motion.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Trajectory {
    /// Time, s.
    pub time: f64,
    /// Coordinate, rad or m.
    pub coordinate: f64,
    /// Its first derivative by time.
    pub speed: f64,
    /// Its second derivative by time.
    pub acceleration: f64,
    /// Angles of the links and their derivatives by the coordinate.
    pub links: Named<Derivatives>,
    /// Places of the named points.
    #[serde(skip_serializing_if = "Named::is_empty")]
    pub points: Named<Spot>,
    /// Displacements of the slides and their derivatives by the coordinate.
    #[serde(skip_serializing_if = "Named::is_empty")]
    pub slides: Named<Derivatives>,
    /// First derivatives by time.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub velocities: Option<Rates>,
    /// Second derivatives by time.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub accelerations: Option<Rates>,
    /// Reactions by pin or slide.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reactions: Option<Named<PairReaction>>,
    /// The moment (N m) or force (N) that the drive must apply.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub balancing: Option<f64>,
}

/// Place of a point.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Spot {
    /// Place, m, in the ground's frame.
    pub pf0: [f64; 2],
}

/// How a transient motion was found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Integration {
    /// Name of the integrator.
    pub method: String,
    /// D's case of the equation, 1 to 5 (D 3.21).
    pub case: u8,
    /// What inertia and moment depend on: `J(q), M(q, w)`.
    pub equation: String,
    /// Why this integrator.
    pub reason: String,
    /// Relative tolerance asked of it.
    pub tolerance: f64,
    /// Accepted steps (panels, for the energy form).
    pub steps: usize,
    /// Rejected steps, and steps redone to land on an event.
    pub rejected: usize,
    /// Evaluations of the equation.
    pub evaluations: usize,
    /// Jacobians of an implicit method.
    pub jacobians: usize,
    /// Smooth pieces entered.
    pub pieces: usize,
    /// Step times the largest eigenvalue at the end of a long run: near 3 or above, an explicit method is slow by stiffness.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stiffness: Option<f64>,
    /// The state in which the motion ended.
    pub end: Instant,
    /// What happened between, in order of time.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub events: Vec<EventRow>,
    /// Energies over the samples.
    pub energy: Energy,
}

/// A state of the motion.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Instant {
    /// Time, s.
    pub time: f64,
    /// Coordinate, rad or m.
    pub coordinate: f64,
    /// Speed, rad/s or m/s.
    pub speed: f64,
}

/// Something that happened on the way.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EventRow {
    /// `coordinate`, `speed`, `time` (a bound of a smooth piece), `reversal`, `rest`, `held`, `release`.
    pub kind: &'static str,
    /// When and where.
    #[serde(flatten)]
    pub at: Instant,
}

/// The balance of energy over a motion.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Energy {
    /// Whether nothing but weights and springs acts, so that the sum of energies must be constant.
    pub conservative: bool,
    /// Kinetic energy at the start, flywheel and rotor included, J.
    pub kinetic_start: f64,
    /// The same at the end, J.
    pub kinetic_end: f64,
    /// Potential energy of weights and springs at the start, J.
    pub potential_start: f64,
    /// The same at the end, J.
    pub potential_end: f64,
    /// Largest change of kinetic and potential energy over the largest kinetic energy: the drift where the machine is
    /// conservative, else the work of the other loads.
    pub change: f64,
}
