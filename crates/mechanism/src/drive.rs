//! Motor, reducer and flywheel.

/// The drive of the input link.
#[derive(Debug, Clone, PartialEq)]
pub struct Drive {
    /// Source of the driving torque.
    pub torque: Torque,
    /// Motor speed / input speed.
    pub ratio: Solve,
    /// Efficiency of the reducer, (0, 1].
    pub efficiency: f64,
    /// Moment of inertia of the flywheel, kg m², on the shaft of `flywheel_on`; `None`: no flywheel.
    pub flywheel: Option<Solve>,
    /// The shaft that carries the flywheel.
    pub flywheel_on: FlywheelPlace,
}

/// A number that is given or to be found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Solve {
    /// Given.
    Given(f64),
    /// To be found.
    Wanted,
}

/// Source of the driving torque.
#[derive(Debug, Clone, PartialEq)]
pub enum Torque {
    /// No motor and no constant moment: the loads of the scene alone.
    None,
    /// The constant moment on the input link that makes the work of a cycle zero.
    Balance,
    /// A constant moment on the input link, N m, positive along the direction of the input.
    Constant(f64),
    /// An asynchronous motor.
    Motor {
        /// The motor.
        motor: Motor,
        /// Catalogue to choose from; `None`: all of them.
        catalogue: Option<String>,
        /// Greatest admissible speed of the motor, rad/s.
        max_speed: Option<f64>,
        /// Its mechanical characteristic.
        characteristic: Characteristic,
    },
}

/// An asynchronous motor.
#[derive(Debug, Clone, PartialEq)]
pub enum Motor {
    /// The smallest motor of the catalogue with sufficient power and admissible speed.
    Auto,
    /// A designation of a catalogue.
    Designation(String),
    /// Its rated data.
    Rated(RatedMotor),
}

/// Rated data of a motor.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct RatedMotor {
    /// Rated power, W.
    pub power: f64,
    /// Synchronous speed, rad/s.
    pub synchronous_speed: f64,
    /// Rated speed, rad/s.
    pub rated_speed: f64,
    /// Breakdown torque / rated torque.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_torque_ratio: Option<f64>,
    /// Moment of inertia of the rotor, kg m²; `None`: neglected.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inertia: Option<f64>,
}

/// Form of the mechanical characteristic.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Characteristic {
    /// Kloss's formula.
    Kloss,
    /// The straight line through synchronous speed and rated point.
    Linear,
}

/// The shaft that carries the flywheel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FlywheelPlace {
    /// The input link.
    Crank,
    /// The motor's shaft.
    Motor,
}
