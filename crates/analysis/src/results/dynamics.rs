//! Periodic regime, drive and flywheel.

use assur_dynamics::FlywheelByMethod;
use assur_motor::FlywheelSize;
use serde::Serialize;

use crate::results::{MotorWork, Named, PointReport, RegimeReport, RunnerUp};

/// What was found about the motion under loads and drive; what does not apply is absent.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Dynamics {
    /// Moment of inertia of the flywheel, without the rotor, kg m².
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flywheel: Option<f64>,
    /// Motor speed / input speed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ratio: Option<f64>,
    /// (max + min) / 2 of the input speed, rad/s or m/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mean_speed: Option<f64>,
    /// (max - min) / mean.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unevenness: Option<f64>,
    /// Least speed, rad/s or m/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speed_min: Option<f64>,
    /// Greatest speed, rad/s or m/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speed_max: Option<f64>,
    /// Where the speed is least, rad or m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub coordinate_at_min: Option<f64>,
    /// Where the speed is greatest, rad or m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub coordinate_at_max: Option<f64>,
    /// Excess work between the extremes, J.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub excess_work: Option<f64>,
    /// Artobolevsky's dynamic unevenness.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dynamic_unevenness: Option<f64>,
    /// Required power, W.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub required_power: Option<f64>,
    /// Constant driving moment found, N m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub torque: Option<f64>,
    /// The motor.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub motor: Option<MotorReport>,
    /// Flywheel by each method that applies, kg m².
    #[serde(skip_serializing_if = "Named::is_empty")]
    pub flywheel_by_method: Named<f64>,
    /// The same with formulas and differences from the exact one.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub flywheel_methods: Vec<FlywheelByMethod>,
    /// The two places of the flywheel.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub flywheel_places: Vec<FlywheelSize>,
    /// Course of the regime.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub regime: Option<RegimeReport>,
    /// The point of the input link to which loads and masses are reduced, too.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reduction_point: Option<PointReport>,
}

/// The motor that drives.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MotorReport {
    /// Designation; empty where the scene gives rated data.
    pub designation: String,
    /// Catalogue; absent where the scene gives rated data.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub catalogue: Option<String>,
    /// Rated power, W.
    pub power: f64,
    /// Synchronous speed, rad/s.
    pub synchronous_speed: f64,
    /// Rated speed, rad/s.
    pub rated_speed: f64,
    /// Breakdown torque / rated torque.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_torque_ratio: Option<f64>,
    /// Moment of inertia of the rotor, kg m².
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inertia: Option<f64>,
    /// Mass of the motor, kg.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mass: Option<f64>,
    /// Length, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub length: Option<f64>,
    /// Diameter of the housing, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub diameter: Option<f64>,
    /// How it works in the regime.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub work: Option<MotorWork>,
    /// Other motors that would do, the best first; only where it was chosen.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub runners_up: Vec<RunnerUp>,
    /// What to look at: values that the source does not print, limits that are near.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<String>,
}
