//! How a motion over time was found.

use assur_integrator::{Event, State, Statistics};
use serde::Serialize;

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
