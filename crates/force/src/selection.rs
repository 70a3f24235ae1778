//! Which side of a state the formulas of the loads are taken from.

use crate::State;
use crate::breaks::tolerance;
use crate::state::beside;

/// The formulas of one side of a state.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Selection {
    /// Sense of the motion, 1 or -1.
    pub(crate) sense: f64,
    /// 1: just after the state in the direction of motion; -1: just before.
    pub(crate) ahead: f64,
    /// Side of the speed: 1 above, -1 below, 0 as the tables define it.
    pub(crate) speed_side: f64,
    /// The input moves, so that a force against the motion has a direction.
    pub(crate) moves: bool,
    /// Whether a contact includes both of its ends.
    pub(crate) closed: bool,
}

impl Selection {
    /// The coordinate at which the formula of a law is chosen.
    #[inline(always)]
    pub(crate) fn coordinate(&self, state: &State, period: Option<f64>) -> f64 {
        // A position that should lie on a row may miss it by rounding.
        state.coordinate + self.ahead * self.sense * tolerance(state.coordinate, period)
    }

    /// The time at which the formula of a law is chosen.
    #[inline(always)]
    pub(crate) fn time(&self, state: &State) -> f64 {
        state.time + self.ahead * tolerance(state.time, None)
    }

    /// The speed at which the formula of a law is chosen.
    #[inline(always)]
    pub(crate) fn speed(&self, state: &State) -> f64 {
        if self.speed_side == 0.0 { state.speed } else { beside(state.speed, self.speed_side) }
    }
}
