//! Size and mass of a flywheel, for comparing its two places: on the input shaft and on the motor shaft.
//!
//! Both shapes are a ring of outer diameter D, width b = β D and radial thickness t = τ D; the disc has τ = 1/2.
//! With d = D (1 - 2τ):
//!
//! ```text
//! J = π ρ b (D⁴ - d⁴) / 32 = π ρ β (1 - (1 - 2τ)⁴) D⁵ / 32
//! m = π ρ b (D² - d²) / 4  = π ρ β (1 - (1 - 2τ)²) D³ / 4
//! ```
//!
//! Hub and spokes of the rim flywheel are neglected: they add little inertia, and some mass.

use std::f64::consts::PI;

/// Density and the rim speed that it is customary not to exceed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlywheelMaterial {
    /// Name in words.
    pub name: &'static str,
    /// Density, kg/m³.
    pub density: f64,
    /// Admissible rim speed, m/s.
    pub admissible_rim_speed: f64,
}

/// Steel: 7850 kg/m³, customarily up to 100 m/s (hoop stress of a thin ring 79 N/mm²).
pub const STEEL: FlywheelMaterial =
    FlywheelMaterial { name: "steel", density: 7850.0, admissible_rim_speed: 100.0 };

/// Gray cast iron: 7200 kg/m³, customarily up to 35 m/s (hoop stress of a thin ring 9 N/mm²).
pub const CAST_IRON: FlywheelMaterial =
    FlywheelMaterial { name: "cast iron", density: 7200.0, admissible_rim_speed: 35.0 };

/// The form of the wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FlywheelShape {
    /// A full disc of constant width.
    Disc,
    /// A ring; hub and spokes are neglected.
    Rim {
        /// Radial thickness / outer diameter τ, greater than 0 and at most 1/2.
        thickness_ratio: f64,
    },
}

/// Form and proportions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlywheelProportions {
    /// The form.
    pub shape: FlywheelShape,
    /// Width / outer diameter β, greater than 0.
    pub width_ratio: f64,
}

impl FlywheelProportions {
    /// A disc a tenth as wide as its diameter.
    pub const DISC: Self = Self { shape: FlywheelShape::Disc, width_ratio: 0.1 };
    /// A rim a tenth of the diameter wide and a tenth thick.
    pub const RIM: Self = Self { shape: FlywheelShape::Rim { thickness_ratio: 0.1 }, width_ratio: 0.1 };

    /// Inner diameter / outer diameter, 1 - 2τ.
    fn bore_ratio(&self) -> f64 {
        match self.shape {
            FlywheelShape::Disc => 0.0,
            FlywheelShape::Rim { thickness_ratio } => 1.0 - 2.0 * thickness_ratio,
        }
    }
}

/// Why a flywheel has no size.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FlywheelError {
    /// The moment of inertia is negative or not a number.
    #[error("moment of inertia of the flywheel is {value} kg*m^2, must be finite and not negative")]
    Inertia {
        /// The value.
        value: f64,
    },
    /// A value that must be positive is not.
    #[error("{what} of the flywheel is {value}, must be finite, greater than 0 and at most {most}")]
    OutOfRange {
        /// Which value, in words.
        what: &'static str,
        /// The value.
        value: f64,
        /// Inclusive upper limit.
        most: f64,
    },
}

/// A flywheel of definite size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlywheelSize {
    /// Moment of inertia, kg·m².
    pub inertia: f64,
    /// Outer diameter D, m.
    pub diameter: f64,
    /// Width b, m.
    pub width: f64,
    /// Mass m, kg.
    pub mass: f64,
    /// What it is made of.
    pub material: FlywheelMaterial,
}

/// The rim speed against what is admissible.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RimSpeedCheck {
    /// Rim speed, m/s.
    pub rim_speed: f64,
    /// Admissible rim speed of the material, m/s.
    pub admissible: f64,
    /// Whether it is admissible.
    pub ok: bool,
}

impl FlywheelSize {
    /// The flywheel of that moment of inertia (kg·m²); zero gives a wheel of no size.
    ///
    /// # Errors
    ///
    /// [`FlywheelError`] with the value that cannot be.
    pub fn new(
        inertia: f64,
        proportions: &FlywheelProportions,
        material: FlywheelMaterial,
    ) -> Result<Self, FlywheelError> {
        validate(inertia, proportions, material)?;
        let (beta, bore) = (proportions.width_ratio, proportions.bore_ratio());
        let solid = PI * material.density * beta;
        // J = π ρ β (1 - (1 - 2τ)⁴) D⁵ / 32
        let diameter = (32.0 * inertia / (solid * (1.0 - bore.powi(4)))).powf(0.2);
        let mass = solid * (1.0 - bore * bore) * diameter.powi(3) / 4.0;
        Ok(Self { inertia, diameter, width: beta * diameter, mass, material })
    }

    /// Speed of the rim, m/s, at the angular speed `angular_speed` (rad/s).
    pub fn rim_speed(&self, angular_speed: f64) -> f64 {
        angular_speed.abs() * self.diameter / 2.0
    }

    /// Hoop stress ρ v² of a thin ring at that angular speed (rad/s), Pa: an estimate.
    pub fn hoop_stress(&self, angular_speed: f64) -> f64 {
        self.material.density * self.rim_speed(angular_speed).powi(2)
    }

    /// The rim speed at the greatest angular speed (rad/s) against the admissible one.
    pub fn check_rim_speed(&self, angular_speed: f64) -> RimSpeedCheck {
        let (rim_speed, admissible) = (self.rim_speed(angular_speed), self.material.admissible_rim_speed);
        RimSpeedCheck { rim_speed, admissible, ok: rim_speed <= admissible }
    }
}

/// The same flywheel effect on either side of the reducer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlywheelPlaces {
    /// On the input shaft of the mechanism: J.
    pub on_input: FlywheelSize,
    /// On the motor shaft: J / u².
    pub on_motor: FlywheelSize,
    /// Its rim speed at the greatest speed of the input shaft.
    pub on_input_rim: RimSpeedCheck,
    /// Its rim speed at the same time.
    pub on_motor_rim: RimSpeedCheck,
}

impl FlywheelPlaces {
    /// Compares the places for the moment of inertia `inertia` (kg·m², reduced to the input shaft), the gear
    /// ratio `ratio` (motor speed / input speed) and the greatest input speed `input_speed` (rad/s).
    ///
    /// # Errors
    ///
    /// As [`FlywheelSize::new`], and if the ratio is not positive.
    pub fn compare(
        inertia: f64,
        ratio: f64,
        input_speed: f64,
        proportions: &FlywheelProportions,
        material: FlywheelMaterial,
    ) -> Result<Self, FlywheelError> {
        in_range("gear ratio to the motor shaft", ratio, f64::MAX)?;
        let on_input = FlywheelSize::new(inertia, proportions, material)?;
        let on_motor = FlywheelSize::new(inertia / (ratio * ratio), proportions, material)?;
        Ok(Self {
            on_input,
            on_motor,
            on_input_rim: on_input.check_rim_speed(input_speed),
            on_motor_rim: on_motor.check_rim_speed(ratio * input_speed),
        })
    }
}

fn validate(
    inertia: f64,
    proportions: &FlywheelProportions,
    material: FlywheelMaterial,
) -> Result<(), FlywheelError> {
    if !(inertia >= 0.0 && inertia.is_finite()) {
        return Err(FlywheelError::Inertia { value: inertia });
    }
    in_range("width / diameter", proportions.width_ratio, f64::MAX)?;
    if let FlywheelShape::Rim { thickness_ratio } = proportions.shape {
        in_range("rim thickness / diameter", thickness_ratio, 0.5)?;
    }
    in_range("density (kg/m^3)", material.density, f64::MAX)?;
    in_range("admissible rim speed (m/s)", material.admissible_rim_speed, f64::MAX)
}

fn in_range(what: &'static str, value: f64, most: f64) -> Result<(), FlywheelError> {
    if value > 0.0 && value <= most { Ok(()) } else { Err(FlywheelError::OutOfRange { what, value, most }) }
}
