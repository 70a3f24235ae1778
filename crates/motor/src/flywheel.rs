//! Size and mass of a flywheel, for comparing its two places: on the input shaft and on the motor shaft.
//!
//! The wheel is a full steel disc of diameter D and width b = D/10:
//!
//! ```text
//! J = π ρ b D⁴ / 32,  m = π ρ b D² / 4
//! ```

use std::f64::consts::PI;

use serde::Serialize;

/// Density of steel, kg/m³.
const DENSITY: f64 = 7850.0;
/// Customary limit of the rim speed of steel wheels, m/s: hoop stress ρ v² = 79 N/mm² in a thin ring.
const ADMISSIBLE_RIM_SPEED: f64 = 100.0;
/// Width / diameter.
const WIDTH_RATIO: f64 = 0.1;

/// A disc flywheel on one of the two shafts, with its rim speed at the greatest speed of the regime.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FlywheelSize {
    /// The shaft that carries it: `input` or `motor`.
    pub shaft: &'static str,
    /// Moment of inertia on its own shaft, kg·m².
    pub inertia: f64,
    /// Diameter D, m.
    pub diameter: f64,
    /// Width b, m.
    pub width: f64,
    /// Mass, kg.
    pub mass: f64,
    /// What it is made of.
    pub material: &'static str,
    /// Rim speed, m/s.
    pub rim_speed: f64,
    /// Admissible rim speed, m/s.
    pub admissible_rim_speed: f64,
    /// Whether the rim speed is admissible.
    pub ok: bool,
}

impl FlywheelSize {
    fn new(shaft: &'static str, inertia: f64, angular_speed: f64) -> Self {
        let solid = PI * DENSITY * WIDTH_RATIO;
        let diameter = (32.0 * inertia / solid).powf(0.2);
        let rim_speed = angular_speed.abs() * diameter / 2.0;
        Self {
            shaft,
            inertia,
            diameter,
            width: WIDTH_RATIO * diameter,
            mass: solid * diameter.powi(3) / 4.0,
            material: "steel",
            rim_speed,
            admissible_rim_speed: ADMISSIBLE_RIM_SPEED,
            ok: rim_speed <= ADMISSIBLE_RIM_SPEED,
        }
    }
}

/// Sizes of the flywheel on the input shaft (J) and on the motor shaft (J / u²).
///
/// `inertia`: moment of inertia J reduced to the input shaft, kg·m², not negative; `ratio`: u = motor speed / input speed,
/// positive; `input_speed`: greatest speed of the input shaft, rad/s.
pub fn flywheel_sizes(inertia: f64, ratio: f64, input_speed: f64) -> [FlywheelSize; 2] {
    [
        FlywheelSize::new("input", inertia, input_speed),
        FlywheelSize::new("motor", inertia / (ratio * ratio), ratio * input_speed),
    ]
}
