//! Why there is no motion to report.

use assur_integrator::{IntegrationError, MotionError};
use assur_mechanism::Key;
use assur_motor::MotorError;
use assur_words::{Describe, Text, name, number, quantity, text};

/// What went wrong, where, and what to do.
#[derive(Clone)]
pub enum DynamicsError {
    /// The scene defines no such motion.
    NoMotion(&'static str),
    /// The machine has no cycle.
    NoCycle,
    /// The machine is not the same again after a cycle.
    NotRepeating {
        /// Inertia, its derivative, or moment.
        what: Text,
        /// Coordinates a cycle apart, rad or m.
        coordinates: [f64; 2],
        /// The values there, kg m² (kg), per unit of the coordinate, or N m (N).
        values: [f64; 2],
    },
    /// Loads over time don't repeat with the cycle.
    OverTime,
    /// A key that a transient motion can't have.
    SteadyOnly(&'static str),
    /// The mechanism has no such position, or its equation no value.
    Equation {
        /// Coordinate, rad or m.
        coordinate: f64,
        /// Why.
        source: MotionError,
    },
    /// Nothing has inertia.
    NoInertia {
        /// Coordinate, rad or m.
        coordinate: f64,
        /// Inertia, kg m².
        inertia: f64,
    },
    /// The speed falls to zero in the cycle (coordinate, rad or m).
    Stalled(f64),
    /// The speed stays at a jump of a moment over speed (coordinate, rad or m).
    Held(f64),
    /// The moment is not linear in the speed on a smooth piece (coordinate, rad or m).
    NotLinear(f64),
    /// The collocation fails (coordinate, rad or m).
    NoPath(f64),
    /// The work of a cycle is not zero and nothing restores the speed.
    NoRegime {
        /// Work of a cycle, J.
        work: f64,
        /// Kinetic energy at the start, J.
        energy: f64,
    },
    /// The loads alone determine a mean speed other than the requested one.
    OtherSpeed {
        /// Wanted mean speed, rad/s or m/s.
        wanted: f64,
        /// Mean speed of the regime, rad/s or m/s.
        found: f64,
    },
    /// The iteration does not close the cycle.
    NotPeriodic {
        /// Cycles.
        cycles: usize,
        /// Remaining change of the speed over a cycle.
        residual: f64,
    },
    /// No flywheel and ratio are found.
    NotTuned {
        /// Trials.
        trials: usize,
        /// Relative miss of the mean speed.
        mean_miss: f64,
        /// Relative miss of the unevenness.
        unevenness_miss: f64,
    },
    /// No ratio lets the motor carry the mean load.
    TooWeak {
        /// Needed on the motor shaft, W.
        needed: f64,
        /// Most on the stable branch, W.
        most: f64,
    },
    /// The motor is off the stable section of its characteristic even at a constant speed.
    OffSection {
        /// Its mean speed, rad/s.
        speed: f64,
        /// Speed of the breakdown torque, rad/s.
        low: f64,
        /// Synchronous speed, rad/s.
        high: f64,
    },
    /// The drive has no motor.
    NoMotor,
    /// The machine drives its drive: no motor is needed (work of the loads over a cycle, J).
    NoLoad(f64),
    /// The integrator failed.
    Integration(IntegrationError),
    /// The motor's data define no characteristic.
    Rated(MotorError),
    /// No such motor, or no such catalogue.
    Motor(MotorError),
    /// No motor can be chosen.
    Selection(MotorError),
}

assur_words::errors!(DynamicsError; Integration(IntegrationError), Motor(MotorError));

/// A number with so many decimals.
fn rounded(value: f64, decimals: usize) -> Text {
    number(format_args!("{value:.decimals$}"))
}

/// A number that tells a size.
fn brief(value: f64) -> Text {
    number(format_args!("{value:.3e}"))
}

/// A number in scientific notation.
fn scientific(value: f64) -> String {
    format!("{value:.6e}")
}

/// Two values that should be one.
fn not_repeating(what: &Text, coordinates: [f64; 2], values: [f64; 2]) -> Text {
    let [before, after] = values.map(|value| number(scientific(value)));
    let [from, to] = coordinates.map(|coordinate| rounded(coordinate, 6));
    text!("dynamics-not-repeating", what, before, from, after, to)
}

impl Describe for DynamicsError {
    fn describe(&self) -> Text {
        match self {
            Self::NoMotion(kind) => text!("dynamics-no-motion", kind = name(*kind)),
            Self::NoCycle => text!("dynamics-no-cycle"),
            Self::NotRepeating { what, coordinates, values } => not_repeating(what, *coordinates, *values),
            Self::OverTime => text!("dynamics-over-time"),
            Self::SteadyOnly(key) => text!("dynamics-steady-only", key = name(*key)),
            Self::Equation { coordinate, source } => {
                text!("dynamics-no-value", coordinate = rounded(*coordinate, 9), cause = source.describe())
            }
            Self::NoInertia { coordinate, inertia } => text!(
                "dynamics-no-inertia",
                inertia = number(format_args!("{inertia:e}")),
                coordinate = rounded(*coordinate, 9)
            ),
            Self::Stalled(coordinate) => text!("dynamics-stalled", coordinate = rounded(*coordinate, 6)),
            Self::Held(coordinate) => text!("dynamics-held", coordinate = rounded(*coordinate, 6)),
            Self::NotLinear(coordinate) => text!("dynamics-not-linear", coordinate = rounded(*coordinate, 6)),
            Self::NoPath(coordinate) => text!("dynamics-no-path", coordinate = rounded(*coordinate, 6)),
            Self::NoRegime { work, energy } => text!(
                "dynamics-no-regime",
                work = quantity(scientific(*work), "J"),
                energy = quantity(scientific(*energy), "J")
            ),
            Self::OtherSpeed { wanted, found } => {
                text!("dynamics-other-speed", wanted = rounded(*wanted, 6), found = rounded(*found, 6))
            }
            Self::NotPeriodic { cycles, residual } => {
                text!("dynamics-not-periodic", cycles = *cycles, residual = brief(*residual))
            }
            Self::NotTuned { trials, mean_miss, unevenness_miss } => text!(
                "dynamics-not-tuned",
                trials = *trials,
                mean = brief(100.0 * mean_miss),
                unevenness = brief(100.0 * unevenness_miss)
            ),
            Self::TooWeak { needed, most } => text!(
                "dynamics-too-weak",
                needed = quantity(format_args!("{needed:.3}"), "W"),
                most = quantity(format_args!("{most:.3}"), "W")
            ),
            Self::OffSection { speed, low, high } => text!(
                "dynamics-off-section",
                low = rounded(*low, 3),
                high = rounded(*high, 3),
                speed = rounded(*speed, 3)
            ),
            Self::NoMotor => text!("dynamics-no-motor"),
            Self::NoLoad(work) => text!("dynamics-no-load", work = quantity(scientific(*work), "J")),
            Self::Integration(error) => error.describe(),
            Self::Rated(error) => text!("dynamics-rated", cause = error.describe()),
            Self::Motor(error) | Self::Selection(error) => error.describe(),
        }
    }
}

impl DynamicsError {
    /// The key of the scene that the error concerns; the motion where it concerns the machine as a whole.
    pub fn key(&self) -> Key {
        match self {
            Self::Integration(IntegrationError::NotReached { .. }) => Key::of("motion").at("until"),
            Self::Integration(IntegrationError::Registry(_)) => Key::of("motion").at("integrator"),
            Self::OtherSpeed { .. } => Key::of("motion").at("mean_speed"),
            Self::NoCycle => Key::of("input"),
            Self::NotRepeating { .. } => Key::of("input").at("cycle"),
            Self::SteadyOnly(_) | Self::Stalled(_) | Self::NotTuned { .. } => Key::of("drive"),
            Self::TooWeak { .. }
            | Self::OffSection { .. }
            | Self::NoMotor
            | Self::NoLoad(_)
            | Self::Rated(_)
            | Self::Motor(_)
            | Self::Selection(_) => Key::of("drive").at("motor"),
            _ => Key::of("motion"),
        }
    }
}
