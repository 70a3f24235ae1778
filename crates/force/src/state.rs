//! The state of motion at which loads are evaluated.

use assur_mechanism::{Mechanism, Motion, passage};

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
    /// Which formulas apply if the state is on a jump.
    pub side: Side,
}

/// Which formulas of the loads apply at a state on a jump. The choice is common to all loads, and the acceleration of
/// the state belongs to that side, too.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Side {
    /// A position of a prescribed motion, or of none: the formulas after the jump in the direction of motion. A contact
    /// includes both of its ends.
    #[default]
    Prescribed,
    /// Just after the state in the direction of motion.
    After,
    /// Just before the state: the end of a motion.
    Before,
    /// The motion is held at its speed, because the formulas of either side drive it back: at rest by dry friction, at
    /// a speed by a jump of a table. The load takes the value between both sides that holds the speed.
    Held {
        /// Share of the formulas just above the speed, 0 to 1; the rest is of those just below.
        upper: f64,
    },
}

/// The nearest speed that counts as above (side 1) or below (-1) a row of a table, or rest.
#[inline]
pub fn beside(speed: f64, side: f64) -> f64 {
    speed + side * (2.0 * f64::EPSILON * speed.abs()).max(f64::MIN_POSITIVE)
}

impl State {
    /// The state of a prescribed motion; for any other motion, or none, the state of rest at time 0.
    ///
    /// The time is that of the [`passage`] from the first position. A coordinate that is never passed has the time of the
    /// turning point before it (0 without any motion).
    pub fn prescribed(mechanism: &Mechanism, coordinate: f64) -> Self {
        match mechanism.motion {
            Some(Motion::Prescribed { speed, acceleration }) => {
                let turn = || if acceleration == 0.0 { 0.0 } else { -speed / acceleration };
                let way = coordinate - mechanism.input.from;
                let time = passage(way, speed, acceleration).unwrap_or_else(turn);
                Self { coordinate, speed, acceleration, time, side: Side::Prescribed }
            }
            _ => Self { coordinate, ..Self::default() },
        }
    }
}
