//! Why there is no motion to report.

use assur_integrator::{IntegrationError, MotionError};
use assur_motor::{CatalogueError, LookupError, RatedDataError, SelectionError};

/// What went wrong, where, and what to do.
#[derive(Debug, Clone, thiserror::Error)]
#[non_exhaustive]
pub enum DynamicsError {
    /// The scene defines no such motion.
    #[error("the scene has no motion of kind \"{0}\"")]
    NoMotion(&'static str),
    /// The machine has no cycle.
    #[error("a steady regime needs a cycle of the input; give `input.cycle`")]
    NoCycle,
    /// The machine is not the same again after a cycle.
    #[error(
        "the machine does not repeat with its cycle: the reduced {what} is {:.6e} at coordinate {:.6} and {:.6e} at {:.6}; \
         give `input.cycle` whole turns, and loads that are the same after a cycle", values[0], coordinates[0], values[1], coordinates[1]
    )]
    NotRepeating {
        /// Inertia, its derivative, or moment.
        what: &'static str,
        /// Coordinates a cycle apart, rad or m.
        coordinates: [f64; 2],
        /// The values there, kg m² (kg), per unit of the coordinate, or N m (N).
        values: [f64; 2],
    },
    /// Loads over time don't repeat with the cycle.
    #[error(
        "a load follows a table over time, which does not repeat with the cycle: there is no steady regime"
    )]
    OverTime,
    /// A key that a transient motion can't have.
    #[error("{0} needs a motion of kind \"steady\": give a number")]
    SteadyOnly(&'static str),
    /// The mechanism has no such position, or its equation no value.
    #[error("the equation of motion has no value at coordinate {coordinate:.9}: {source}")]
    Equation {
        /// Coordinate, rad or m.
        coordinate: f64,
        /// Why.
        source: MotionError,
    },
    /// Nothing has inertia.
    #[error(
        "the reduced inertia with flywheel and rotor is {inertia:e} at coordinate {coordinate:.9}: it must be positive; \
         give some link a mass, or a flywheel"
    )]
    NoInertia {
        /// Coordinate, rad or m.
        coordinate: f64,
        /// Inertia, kg m².
        inertia: f64,
    },
    /// The speed falls to zero in the cycle (coordinate, rad or m).
    #[error(
        "the machine comes to rest at coordinate {0:.6}: the drive is too weak there; take a stronger motor or a \
         larger flywheel"
    )]
    Stalled(f64),
    /// The speed stays at a jump of a moment over speed (coordinate, rad or m).
    #[error(
        "the speed is held at coordinate {0:.6} by a jump in a table over speed; join its rows by a steep line"
    )]
    Held(f64),
    /// The moment is not linear in the speed on a smooth piece (coordinate, rad or m).
    #[error(
        "the moment of the loads at coordinate {0:.6} is not linear in the speed between two jumps or kinks: this \
         method needs that"
    )]
    NotLinear(f64),
    /// The collocation fails (coordinate, rad or m).
    #[error("the speed can't be followed at coordinate {0:.6}: the moments change too steeply")]
    NoPath(f64),
    /// The work of a cycle is not zero and nothing restores the speed.
    #[error(
        "there is no steady regime: the work of a cycle is {work:.6e} J and nothing depends on the speed (a cycle begins \
         with {energy:.6e} J); use `torque = \"balance\"`, a motor or a load over speed"
    )]
    NoRegime {
        /// Work of a cycle, J.
        work: f64,
        /// Kinetic energy at the start, J.
        energy: f64,
    },
    /// The loads alone determine a mean speed other than the requested one.
    #[error(
        "the requested mean speed of {wanted:.6} can't be met: without a drive the loads alone fix it, at {found:.6}; give a drive \
         (`torque = \"balance\"` or a motor), or that speed"
    )]
    OtherSpeed {
        /// Wanted mean speed, rad/s or m/s.
        wanted: f64,
        /// Mean speed of the regime, rad/s or m/s.
        found: f64,
    },
    /// The iteration does not close the cycle.
    #[error(
        "no steady regime after {cycles} cycles: the relative change over a cycle still is {residual:.3e}"
    )]
    NotPeriodic {
        /// Cycles.
        cycles: usize,
        /// Remaining change of the speed over a cycle.
        residual: f64,
    },
    /// No flywheel and ratio are found.
    #[error(
        "no ratio and flywheel give the requested regime: after {trials} trials the mean speed misses by {:.3e} % and the \
         unevenness by {:.3e} %; give one of them", 100.0 * mean_miss, 100.0 * unevenness_miss
    )]
    NotTuned {
        /// Trials.
        trials: usize,
        /// Relative miss of the mean speed.
        mean_miss: f64,
        /// Relative miss of the unevenness.
        unevenness_miss: f64,
    },
    /// No ratio lets the motor carry the mean load.
    #[error(
        "the motor is too weak for every ratio: the mean resistance needs {needed:.3} W, the motor gives at most {most:.3} W"
    )]
    TooWeak {
        /// Needed on the motor shaft, W.
        needed: f64,
        /// Most on the stable branch, W.
        most: f64,
    },
    /// The motor is off the stable section of its characteristic even at a constant speed.
    #[error(
        "the motor stays on the stable section of its characteristic, {low:.3} to {high:.3} rad/s, at no unevenness: at constant \
         speed it turns with {speed:.3} rad/s; use `ratio = \"solve\"` or another motor"
    )]
    OffSection {
        /// Its mean speed, rad/s.
        speed: f64,
        /// Speed of the breakdown torque, rad/s.
        low: f64,
        /// Synchronous speed, rad/s.
        high: f64,
    },
    /// The drive has no motor.
    #[error("the scene has no motor; give [drive] a `motor`, such as \"auto\"")]
    NoMotor,
    /// The machine drives its drive: no motor is needed (work of the loads over a cycle, J).
    #[error(
        "the loads do {0:.6e} J of work in a cycle: the machine needs no motor, and no power to choose one by; give a motor"
    )]
    NoLoad(f64),
    /// The integrator failed.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
    /// The motor's data define no characteristic.
    #[error("motor: {0}")]
    Rated(#[from] RatedDataError),
    /// No such motor.
    #[error(transparent)]
    Lookup(#[from] LookupError),
    /// The catalogues can't be read.
    #[error(transparent)]
    Catalogue(#[from] CatalogueError),
    /// No motor can be chosen.
    #[error(transparent)]
    Selection(#[from] SelectionError),
}

impl DynamicsError {
    /// The key of the scene that the error concerns, step by step; the motion where it concerns the machine as a whole.
    pub fn key(&self) -> &'static [&'static str] {
        match self {
            Self::Integration(IntegrationError::NotReached { .. }) => &["motion", "until"],
            Self::Integration(IntegrationError::Registry(_)) => &["motion", "integrator"],
            Self::OtherSpeed { .. } => &["motion", "mean_speed"],
            Self::NoCycle => &["input"],
            Self::NotRepeating { .. } => &["input", "cycle"],
            Self::SteadyOnly(_) | Self::Stalled(_) | Self::NotTuned { .. } => &["drive"],
            Self::TooWeak { .. }
            | Self::OffSection { .. }
            | Self::NoMotor
            | Self::NoLoad(_)
            | Self::Rated(_)
            | Self::Lookup(_)
            | Self::Selection(_) => &["drive", "motor"],
            _ => &["motion"],
        }
    }
}
