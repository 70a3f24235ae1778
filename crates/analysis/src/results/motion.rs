//! A motion over time, and how it was found.

use assur_dynamics::Holding;
use assur_integrator::{Event, State, Statistics};
use assur_kinematics::ScalarMotion;
use serde::Serialize;

use crate::results::{Named, PairReaction, Rates};

/// One instant of a motion.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct MotionSample {
    /// Time, s.
    pub time: f64,
    /// Coordinate, rad or m.
    pub coordinate: f64,
    /// Its first derivative by time.
    pub speed: f64,
    /// Its second derivative by time.
    pub acceleration: f64,
    /// Angles of the links and their derivatives by the coordinate.
    pub links: Named<ScalarMotion>,
    /// The named points.
    #[serde(skip_serializing_if = "Named::is_empty")]
    pub points: Named<PointPosition>,
    /// Displacements of the slides and their derivatives by the coordinate.
    #[serde(skip_serializing_if = "Named::is_empty")]
    pub slides: Named<ScalarMotion>,
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
    /// The load that holds the motion at rest or at its speed, if there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub holding: Option<Holding>,
}

/// Where a point is.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct PointPosition {
    /// Position, m, in the ground's frame.
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
    /// Requested relative tolerance.
    pub tolerance: f64,
    /// Cost of the solution.
    #[serde(flatten)]
    pub statistics: Statistics,
    /// The state in which the motion ended.
    pub end: State,
    /// What happened between, in order of time.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub events: Vec<Event>,
    /// Energies at both ends.
    pub energy: Energy,
}

/// The balance of energy over a motion.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Energy {
    /// Whether nothing but weights and springs acts, so that the sum of energies must be constant.
    pub conservative: bool,
    /// Kinetic energy at the start, flywheel and rotor included, J.
    pub kinetic_start: f64,
    /// Kinetic energy at the end, flywheel and rotor included, J.
    pub kinetic_end: f64,
    /// Potential energy of weights and springs at the start, J.
    pub potential_start: f64,
    /// Potential energy of weights and springs at the end, J.
    pub potential_end: f64,
    /// Largest change of the sum of kinetic and potential energy, divided by the largest kinetic energy: the drift of
    /// the solution where the machine is conservative, else the work of the other loads.
    pub change: f64,
}
