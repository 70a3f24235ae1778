//! The rated data that a mechanical characteristic is built from.

/// What is on the name plate, as far as the mechanical characteristic needs it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RatedData {
    /// Rated shaft power Pn, W.
    pub power: f64,
    /// Synchronous speed ws, rad/s.
    pub synchronous_speed: f64,
    /// Rated speed wn, rad/s; between zero and the synchronous speed.
    pub rated_speed: f64,
    /// Breakdown torque / rated torque, above 1. Needed for Kloss's formula.
    pub max_torque_ratio: Option<f64>,
    /// Moment of inertia of the rotor, kg·m²; `None`: not modelled.
    pub inertia: Option<f64>,
}

/// Why rated data cannot be those of an asynchronous motor.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RatedDataError {
    /// A value that must be finite and positive is not.
    #[error("rated {what} of the motor is {value}, must be finite and greater than 0")]
    NotPositive {
        /// Which value, in words with its unit.
        what: &'static str,
        /// The value.
        value: f64,
    },
    /// An asynchronous motor runs below its synchronous speed.
    #[error(
        "rated speed {rated_speed} rad/s exceeds or equals the synchronous speed {synchronous_speed} rad/s \
         (by {} rad/s): an asynchronous motor needs a slip; check both speeds", rated_speed - synchronous_speed
    )]
    NoSlip {
        /// Rated speed, rad/s.
        rated_speed: f64,
        /// Synchronous speed, rad/s.
        synchronous_speed: f64,
    },
    /// Kloss's formula has no solution.
    #[error(
        "breakdown torque / rated torque is {value}, must be finite and greater than 1 (usual: 1.7 to 4)"
    )]
    MaxTorqueRatio {
        /// The value.
        value: f64,
    },
    /// Kloss's formula needs the breakdown torque.
    #[error(
        "the breakdown torque of the motor is not known: give max_torque_ratio, or take the linear characteristic"
    )]
    NoMaxTorqueRatio,
}

impl RatedData {
    /// Checks every value that is given.
    ///
    /// # Errors
    ///
    /// [`RatedDataError`] with the value that cannot be.
    pub fn validate(&self) -> Result<(), RatedDataError> {
        let inertia = self.inertia.unwrap_or(1.0);
        let named = [
            ("power (W)", self.power),
            ("synchronous speed (rad/s)", self.synchronous_speed),
            ("speed (rad/s)", self.rated_speed),
            ("rotor inertia (kg*m^2)", inertia),
        ];
        for (what, value) in named {
            if !(value > 0.0 && value.is_finite()) {
                return Err(RatedDataError::NotPositive { what, value });
            }
        }
        let Self { rated_speed, synchronous_speed, .. } = *self;
        if rated_speed >= synchronous_speed {
            return Err(RatedDataError::NoSlip { rated_speed, synchronous_speed });
        }
        match self.max_torque_ratio {
            Some(value) if !(value > 1.0 && value.is_finite()) => {
                Err(RatedDataError::MaxTorqueRatio { value })
            }
            _ => Ok(()),
        }
    }

    /// Rated torque Mn = Pn / wn, N·m.
    pub fn torque(&self) -> f64 {
        self.power / self.rated_speed
    }

    /// Rated slip sn = (ws - wn) / ws.
    pub fn slip(&self) -> f64 {
        (self.synchronous_speed - self.rated_speed) / self.synchronous_speed
    }
}
