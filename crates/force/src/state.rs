//! The state of motion at which loads are evaluated.

use assur_mechanism::{Mechanism, Motion};

/// Where the mechanism is and how it moves.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct State {
    /// Input coordinate q, rad (m for a sliding input).
    pub coordinate: f64,
    /// dq/dt with its sign, rad/s (m/s); 0 without a motion.
    pub speed: f64,
    /// d²q/dt² with its sign, rad/s² (m/s²); 0 without a motion.
    pub acceleration: f64,
    /// Time, s.
    pub time: f64,
}

impl State {
    /// The state of a prescribed motion; at rest, at time 0, for any other and without a motion.
    ///
    /// The time is counted from the first position with the constant speed that is prescribed for every position.
    pub fn prescribed(mechanism: &Mechanism, coordinate: f64) -> Self {
        match mechanism.motion {
            Some(Motion::Prescribed { speed, acceleration }) => {
                let moved = coordinate - mechanism.input.from;
                let time = if speed == 0.0 { 0.0 } else { moved / speed };
                Self { coordinate, speed, acceleration, time }
            }
            _ => Self { coordinate, ..Self::default() },
        }
    }
}
