//! How the input moves.

/// Motion of the input.
#[derive(Debug, Clone, PartialEq)]
pub enum Motion {
    /// Speed and acceleration of the coordinate that are the same in every position.
    Prescribed {
        /// Signed speed (the input's direction is applied), rad/s or m/s.
        speed: f64,
        /// Signed acceleration of the coordinate, rad/s² or m/s².
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
    },
    /// The periodic regime.
    Steady {
        /// Mean speed (max + min) / 2 with its sign, rad/s or m/s.
        mean_speed: f64,
        /// delta = (max - min) / mean; `None` where the flywheel is given.
        unevenness: Option<f64>,
    },
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
