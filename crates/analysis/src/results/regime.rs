//! The steady regime in detail: course, iteration, flywheels, motor at work.

use assur_dynamics::{Effort, Trial, Turn};
use serde::Serialize;

/// Course of the regime, and how it was found.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct RegimeReport {
    /// Mean of the resisting moment over the cycle, reduced to the input, N m, against the motion.
    pub mean_resistance: f64,
    /// Work of the resistance over a cycle, J.
    pub resistance_work: f64,
    /// Time of a cycle, s.
    pub cycle_time: f64,
    /// What a small change of the speed is multiplied by over a cycle; below 1 the regime is stable.
    pub multiplier: f64,
    /// Flywheel and rotor reduced to the input, kg m².
    pub shaft_inertia: f64,
    /// The wanted unevenness is met without a flywheel.
    pub flywheel_needless: bool,
    /// What the search cost, and how exact it is.
    #[serde(flatten)]
    pub effort: Effort,
    /// Iteration to the periodic regime from the mean speed (S fig. 10).
    pub iteration: Vec<Turn>,
    /// Trials of ratio and flywheel (S stage 6).
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub trials: Vec<Trial>,
    /// Over a cycle: speeds, moments and inertia (S figs. 8, 9, 12); the end of the cycle is the last row.
    pub course: Vec<CourseRow>,
}

/// The regime at one coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CourseRow {
    /// Coordinate, rad or m.
    pub coordinate: f64,
    /// Speed in the regime.
    pub speed: f64,
    /// Speed in the first turn from the mean speed; absent where the machine stalls in it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub first_turn: Option<f64>,
    /// Moment of the drive on the input, N m.
    pub drive: f64,
    /// Reduced moment of the loads, N m.
    pub load: f64,
    /// Reduced inertia without flywheel and rotor, kg m².
    pub inertia: f64,
    /// Its derivative by the coordinate.
    pub inertia_derivative: f64,
}

/// The point to which loads and masses are reduced beside the input link (E eqs. 4-6).
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PointReport {
    /// Its name.
    pub name: String,
    /// |PF1| of the point: force = moment / radius, mass = inertia / radius².
    pub radius: f64,
}

/// How the motor works in the regime; speeds and torques of its own shaft.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MotorWork {
    /// `kloss` or `linear`.
    pub characteristic: &'static str,
    /// Rated torque, N m.
    pub rated_torque: f64,
    /// Breakdown torque, N m, where it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub breakdown_torque: Option<f64>,
    /// Least and greatest speed, rad/s: the working section.
    pub speed: [f64; 2],
    /// Least and greatest torque, N m.
    pub torque: [f64; 2],
    /// Root mean square torque over a cycle, N m.
    pub rms_torque: f64,
    /// Greatest torque of the load at rest, N m.
    pub starting_load: f64,
    /// The characteristic: speed, torque.
    pub curve: Vec<[f64; 2]>,
    /// The working section: speed, torque.
    pub working_section: Vec<[f64; 2]>,
}

/// Another motor that would do.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RunnerUp {
    /// Designation.
    pub designation: String,
    /// Catalogue.
    pub catalogue: String,
    /// Rated power, W.
    pub power: f64,
    /// Rated speed, rad/s.
    pub rated_speed: f64,
    /// Ratio that it would need.
    pub ratio: f64,
    /// Mass, kg.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mass: Option<f64>,
}
