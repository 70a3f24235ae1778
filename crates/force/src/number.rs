//! The numbers in which loads and reactions are evaluated: one state, or several side by side.

use assur_group::Number;
use assur_number::Lanes;

use crate::State;

/// A number in which loads are evaluated: `f64` for one state, lanes for several states side by side.
///
/// The formulas run over all lanes at once. Which formula of a table, stroke or contact applies, and the number that it
/// gives, is found lane by lane in `f64`, so that a lane gets the bits that its state gets alone.
pub trait LoadNumber: Number {
    /// The states, one for each lane.
    type States;

    /// The state of a lane.
    fn state(states: &Self::States, lane: usize) -> &State;

    /// The number in a lane.
    fn lane(self, lane: usize) -> f64;

    /// A number from its lanes.
    fn of_lanes(number: impl FnMut(usize) -> f64) -> Self;
}

impl LoadNumber for f64 {
    type States = State;

    #[inline(always)]
    fn state(states: &State, _: usize) -> &State {
        states
    }

    #[inline(always)]
    fn lane(self, _: usize) -> f64 {
        self
    }

    #[inline(always)]
    fn of_lanes(mut number: impl FnMut(usize) -> f64) -> f64 {
        number(0)
    }
}

impl LoadNumber for Lanes {
    type States = [State; Self::WIDTH];

    #[inline(always)]
    fn state(states: &[State; Self::WIDTH], lane: usize) -> &State {
        &states[lane]
    }

    #[inline(always)]
    fn lane(self, lane: usize) -> f64 {
        self.0[lane]
    }

    #[inline(always)]
    fn of_lanes(mut number: impl FnMut(usize) -> f64) -> Self {
        // A plain loop is inlined, and so keeps the instructions of its caller.
        let mut all = [0.0; Self::WIDTH];
        for (lane, one) in all.iter_mut().enumerate() {
            *one = number(lane);
        }
        Self(all)
    }
}
