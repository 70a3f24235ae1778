//! Size and mass of a flywheel, for comparing its two places: on the input shaft and on the motor shaft.
//!
//! The wheel is a full steel disc of diameter D and width b = D/10:
//!
//! ```text
//! J = π ρ b D⁴ / 32,  m = π ρ b D² / 4
//! ```

use std::f64::consts::PI;

use assur_number::elementary;
use assur_words::{Text, text};
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
        let diameter = elementary::powf(32.0 * inertia / solid, 0.2);
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

/// Admissible unevenness (max - min)/mean of the speed of a kind of machine.
#[derive(Debug, Clone, PartialEq)]
pub struct UsualUnevenness {
    /// The kind of machine.
    pub machine: Text,
    /// Least and greatest usual value.
    pub range: [f64; 2],
}

/// Where [`USUAL_UNEVENNESS`] is printed.
pub const USUAL_SOURCE: &str = "R. S. Khurmi, J. K. Gupta: A Textbook of Machine Design, table 22.2";

/// The usual unevenness by kind of machine, the least uniform ones first; from [`USUAL_SOURCE`].
pub static USUAL_UNEVENNESS: [UsualUnevenness; 11] = {
    const fn usual(machine: Text, least: f64, greatest: f64) -> UsualUnevenness {
        UsualUnevenness { machine, range: [least, greatest] }
    }
    [
        usual(text!("motor-usual-crushing"), 0.2, 0.2),
        usual(text!("motor-usual-hammering"), 0.2, 0.2),
        usual(text!("motor-usual-presses"), 0.10, 0.15),
        usual(text!("motor-usual-pumps"), 0.03, 0.05),
        usual(text!("motor-usual-tools"), 0.03, 0.03),
        usual(text!("motor-usual-belt"), 0.03, 0.03),
        usual(text!("motor-usual-paper"), 0.025, 0.025),
        usual(text!("motor-usual-rolling"), 0.025, 0.025),
        usual(text!("motor-usual-gears"), 0.02, 0.02),
        usual(text!("motor-usual-electrical"), 0.003, 0.003),
        usual(text!("motor-usual-electrical-direct"), 0.002, 0.002),
    ]
};
