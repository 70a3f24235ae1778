//! How a regime was found, and the flywheel by other methods.

use assur_words::Text;
use serde::Serialize;

/// One cycle of the iteration to the periodic regime (S fig. 10).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Iteration {
    /// Number of the cycle, from 1.
    pub number: usize,
    /// Speed at its start, rad/s, signed.
    pub speed_start: f64,
    /// Speed at its end, rad/s, signed.
    pub speed_end: f64,
    /// End less start, rad/s: zero for the periodic regime.
    pub residual: f64,
}

/// One trial of ratio and flywheel, with its periodic regime (S stage 6).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Trial {
    /// Number of the trial, from 1.
    pub number: usize,
    /// Gear ratio; `None` without a motor.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ratio: Option<f64>,
    /// Flywheel on its own shaft, kg m².
    pub flywheel: f64,
    /// Mean speed, rad/s, signed.
    pub mean_speed: f64,
    /// Unevenness.
    pub unevenness: f64,
}

/// A flywheel by one method.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FlywheelByMethod {
    /// Name: `excess-work`, `excess-work-less-inertia`, `mertsalov`, `wittenbauer`, `exact`.
    pub method: &'static str,
    /// Formula and source.
    pub formula: Text,
    /// Moment of inertia on the flywheel's own shaft, without the rotor, kg m²; negative where the method finds that the
    /// machine has more inertia than needed.
    pub flywheel: f64,
    /// (this - exact)/exact; `None` where the exact flywheel is zero.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub difference: Option<f64>,
}

/// How the regime was found, and the cost.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Effort {
    /// Cycles run.
    pub cycles: usize,
    /// Evaluations of the mechanism.
    pub evaluations: usize,
    /// Panels of order 15 over the cycle.
    pub panels: usize,
    /// Largest residual of the equation between the nodes, part of the kinetic energy.
    pub residual: f64,
}

/// The steady regime at one coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RegimeState {
    /// Time since the start of the cycle, s.
    pub time: f64,
    /// Speed, rad/s, signed.
    pub speed: f64,
    /// Acceleration, rad/s², signed.
    pub acceleration: f64,
    /// Moment of the drive on the input link, N m, along the coordinate.
    pub drive: f64,
    /// Reduced moment of the loads, N m, along the coordinate.
    pub load: f64,
    /// Reduced inertia of the machine, without flywheel and rotor, kg m².
    pub inertia: f64,
    /// Its derivative with respect to the coordinate, kg m²/rad.
    pub inertia_derivative: f64,
}
