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

impl Solve {
    /// The number, if it is given.
    pub fn value(self) -> Option<f64> {
        if let Self::Given(number) = self { Some(number) } else { None }
    }

    /// The number, given from now on.
    pub fn given(&mut self) -> Option<&mut f64> {
        if let Self::Wanted = self {
            *self = Self::Given(0.0);
        }
        if let Self::Given(number) = self { Some(number) } else { None }
    }
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
        motor: MotorChoice,
        /// Catalogue to choose from; `None`: all of them.
        catalogue: Option<String>,
        /// Greatest admissible speed of the motor, rad/s.
        max_speed: Option<f64>,
        /// Its mechanical characteristic.
        characteristic: CharacteristicKind,
    },
}

/// An asynchronous motor.
#[derive(Debug, Clone, PartialEq)]
pub enum MotorChoice {
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
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum CharacteristicKind {
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

/// Motion of the input.
#[derive(Debug, Clone, PartialEq)]
pub enum Motion {
    /// Speed and acceleration of the coordinate that are the same in every position.
    Prescribed {
        /// Speed of the coordinate with its sign (the input's direction is applied), rad/s or m/s.
        speed: f64,
        /// Acceleration of the coordinate with its sign (the input's direction is applied), rad/s² or m/s².
        acceleration: f64,
    },
    /// The motion follows from the equation of motion and an initial state.
    Transient {
        /// Initial speed with its sign, rad/s or m/s.
        speed: f64,
        /// When it ends.
        until: Until,
        /// Equally spaced output instants after the first.
        samples: usize,
        /// `auto` or the name of a registered integrator.
        integrator: String,
        /// Relative tolerance.
        tolerance: f64,
        /// Length of the steps, for a method with a fixed step; `None`: the method's own.
        step: Option<StepLength>,
        /// The most steps that are taken, rejected ones included; `None`: the integrator's own bound.
        max_steps: Option<usize>,
    },
    /// The periodic regime.
    Steady {
        /// Mean speed (max + min) / 2 with its sign, rad/s or m/s.
        mean_speed: f64,
        /// delta = (max - min) / mean; wanted: the greatest for which the motor stays on the stable section of its
        /// characteristic; `None` where the flywheel is given.
        unevenness: Option<Solve>,
    },
}

/// Time (s, from the first position) at which a motion with this speed in the first position and this constant
/// acceleration passes a coordinate in the direction of its speed; `way`: its displacement from the first position.
///
/// It is negative for a coordinate that was passed before, and `None` for one that is never passed.
pub fn passage(way: f64, speed: f64, acceleration: f64) -> Option<f64> {
    if way == 0.0 {
        return Some(0.0);
    }
    let square = speed * speed + 2.0 * acceleration * way;
    // Of the two roots of way = speed t + acceleration t²/2, the one with the speed of this sign.
    let leads = if speed == 0.0 { acceleration } else { speed };
    let sum = speed + square.sqrt().copysign(leads);
    (square >= 0.0 && sum != 0.0).then(|| 2.0 * way / sum)
}

/// Length of the steps of a method with a fixed step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StepLength {
    /// s.
    Time(f64),
    /// Displacement of the coordinate, rad or m.
    Way(f64),
}

/// End of a transient motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Until {
    /// After this time, s.
    Time(f64),
    /// After this displacement of the coordinate, rad or m, positive.
    Way(f64),
    /// When the mechanism comes to rest and stays at rest.
    Rest,
    /// At the first reversal: the first instant of zero speed after the start.
    Turn,
}
