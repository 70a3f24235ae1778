//! How the input moves.

/// Motion of the input.
#[derive(Debug, Clone, PartialEq)]
pub enum Motion {
    /// Known speed and acceleration of the coordinate in every position.
    Prescribed {
        /// Speed with its sign (that of the input's direction applied), rad/s or m/s.
        speed: f64,
        /// Acceleration of the coordinate with its own sign, rad/s² or m/s².
        acceleration: f64,
    },
    /// The equation of motion from an initial state.
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
        /// (max + min) / 2 of the speed with its sign, rad/s or m/s.
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
    /// After this way of the coordinate, rad or m, positive.
    Way(f64),
    /// When it stands still for good.
    Rest,
    /// At the first reversal: the first instant of zero speed after the start.
    Turn,
}
