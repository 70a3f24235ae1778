//! The rated data that a mechanical characteristic is built from: what is on the name plate.

use crate::RatedData;

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

/// Checks every value that is given.
pub(crate) fn validate(rated: &RatedData) -> Result<(), RatedDataError> {
    let named = [
        ("power (W)", rated.power),
        ("synchronous speed (rad/s)", rated.synchronous_speed),
        ("speed (rad/s)", rated.rated_speed),
        ("rotor inertia (kg*m^2)", rated.inertia.unwrap_or(1.0)),
    ];
    for (what, value) in named {
        if !(value > 0.0 && value.is_finite()) {
            return Err(RatedDataError::NotPositive { what, value });
        }
    }
    let RatedData { rated_speed, synchronous_speed, .. } = *rated;
    if rated_speed >= synchronous_speed {
        return Err(RatedDataError::NoSlip { rated_speed, synchronous_speed });
    }
    match rated.max_torque_ratio {
        Some(value) if !(value > 1.0 && value.is_finite()) => Err(RatedDataError::MaxTorqueRatio { value }),
        _ => Ok(()),
    }
}

/// Rated torque Mn = Pn / wn, N·m.
pub(crate) fn rated_torque(rated: &RatedData) -> f64 {
    rated.power / rated.rated_speed
}

/// Rated slip sn = (ws - wn) / ws.
pub(crate) fn rated_slip(rated: &RatedData) -> f64 {
    (rated.synchronous_speed - rated.rated_speed) / rated.synchronous_speed
}
