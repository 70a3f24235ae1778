//! The state of motion at which loads are evaluated.

use assur_formula::{Used, Variable, Variables};
use assur_group::Number;
use assur_mechanism::{Mechanism, Motion, TimeLaw, passage};
use assur_number::Lanes;

use crate::breaks::tolerance;

/// Where the mechanism is and how it moves.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LoadState {
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
    /// In a motion that a drive made: its load on the input along the coordinate, that of its inertia included, N m (N). Of several
    /// reactions with dry friction, those belong to the motion whose balancing load this is.
    pub drive: Option<f64>,
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

/// The nearest speed that counts as above (side 1) or below (-1) a row of a table, or rest; for a greater side, one so
/// many times as far.
#[inline]
pub fn beside(speed: f64, side: f64) -> f64 {
    speed + side * (2.0 * f64::EPSILON * speed.abs()).max(f64::MIN_POSITIVE)
}

impl LoadState {
    /// The state as tables and formulas of loads see it that are over the coordinate of a drive: by its law over time.
    pub(crate) fn of_drive(&self, law: &TimeLaw) -> Self {
        let [coordinate, speed, turning] = law.at(self.time);
        // Only where it rests does its acceleration say where it goes.
        let acceleration = if speed == 0.0 { turning } else { 0.0 };
        Self { coordinate, speed, acceleration, ..*self }
    }

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
                Self { coordinate, speed, acceleration, time, ..Self::default() }
            }
            _ => Self { coordinate, ..Self::default() },
        }
    }
}

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
    pub(crate) fn coordinate(&self, state: &LoadState, period: Option<f64>) -> f64 {
        // A position that should lie on a row may miss it by rounding.
        state.coordinate + self.ahead * self.sense * tolerance(state.coordinate, period)
    }

    /// The time at which the formula of a law is chosen.
    #[inline(always)]
    pub(crate) fn time(&self, state: &LoadState) -> f64 {
        state.time + self.ahead * tolerance(state.time, None)
    }

    /// The variables just ahead of a state, or just before it, as the side demands; `distance`: in the least that counts.
    /// What depends on one of them has its own least distance, what mixes them goes along the motion. The place of a point
    /// is not among them.
    pub(crate) fn ahead(
        &self,
        state: &LoadState,
        period: Option<f64>,
        used: Used,
        distance: f64,
    ) -> Variables {
        let LoadState { coordinate, speed, time, .. } = *state;
        let near = Variables { coordinate, speed, time, place: f64::NAN };
        let [way, delay] =
            [tolerance(coordinate, period), tolerance(time, None)].map(|least| distance * least);
        match used.only() {
            Some(Variable::Coordinate) => {
                Variables { coordinate: coordinate + self.ahead * self.sense * way, ..near }
            }
            Some(Variable::Time) => Variables { time: time + self.ahead * delay, ..near },
            Some(Variable::Speed) => {
                let side = self.speed_side;
                let speed = if side == 0.0 { speed } else { beside(speed, side * distance) };
                Variables { speed, ..near }
            }
            Some(Variable::Place) | None => {
                // Both stay within their own least distances; at rest time has none.
                let in_time = (self.rate(state).abs() + 0.5 * state.acceleration.abs() * delay) * delay;
                let way = if in_time > 0.0 { way.min(in_time) } else { way };
                let way = self.ahead * self.sense * way;
                let after = self.after(state, way);
                let (speed, time) = (speed + state.acceleration * after, time + after);
                Variables { coordinate: coordinate + way, speed, time, ..near }
            }
        }
    }

    /// The variables just ahead of a state of a motion that is calculated, or just before it: the time passes, and the motion goes
    /// on at the acceleration of the state, but keeps the sense that its speed has. `distance`: in the least that counts.
    pub(crate) fn later(&self, state: &LoadState, period: Option<f64>, distance: f64) -> Variables {
        let speed = self.speed(state);
        let [way, delay] = [tolerance(state.coordinate, period), tolerance(state.time, None)];
        // Neither coordinate nor time goes further than its own least distance.
        let after = self.ahead * distance * (way / speed.abs()).min(delay);
        let gained = state.acceleration * after;
        let turns = speed != 0.0 && (speed > 0.0) != (speed + gained > 0.0);
        let gained = if turns { 0.0 } else { gained };
        Variables {
            coordinate: state.coordinate + after * (speed + 0.5 * gained),
            speed: speed + gained,
            time: state.time + after,
            place: f64::NAN,
        }
    }

    /// The speed at which the coordinate changes with time: the speed of a state may be that of all positions, whose times
    /// follow from speed and acceleration at the first of them.
    fn rate(&self, state: &LoadState) -> f64 {
        let passing = state.speed + state.acceleration * state.time;
        if self.closed && passing * self.sense > 0.0 { passing } else { state.speed }
    }

    /// The time in which the motion of a state goes a way along the coordinate; to the turning point where it never does.
    fn after(&self, state: &LoadState, way: f64) -> f64 {
        let (rate, acceleration) = (self.rate(state), state.acceleration);
        let turn = if acceleration == 0.0 { 0.0 } else { -rate / acceleration };
        let after = passage(way, rate, acceleration).unwrap_or(turn);
        // From rest the same way leads to a motion that begins and from one that ended.
        if rate == 0.0 { self.ahead * after.abs() } else { after }
    }

    /// The variables where the motion of a state passes another coordinate, at the speed of the state. The place of a point
    /// is not among them.
    pub(crate) fn passing(&self, state: &LoadState, coordinate: f64) -> Variables {
        let after = self.after(state, coordinate - state.coordinate);
        Variables { coordinate, speed: state.speed, time: state.time + after, place: f64::NAN }
    }

    /// The speed at which the formula of a law is chosen.
    #[inline(always)]
    pub(crate) fn speed(&self, state: &LoadState) -> f64 {
        if self.speed_side == 0.0 { state.speed } else { beside(state.speed, self.speed_side) }
    }
}

/// A number in which loads are evaluated: `f64` for one state, lanes for several states side by side.
///
/// The formulas run over all lanes at once. Which formula of a table, stroke or contact applies, and the number that it
/// gives, is found lane by lane in `f64`, so that a lane gets the bits that its state gets alone.
pub trait LoadNumber: Number {
    /// The states, one for each lane.
    type States;

    /// The state of a lane.
    fn state(states: &Self::States, lane: usize) -> &LoadState;

    /// The number in a lane.
    fn lane(self, lane: usize) -> f64;

    /// A number from its lanes.
    fn of_lanes(number: impl FnMut(usize) -> f64) -> Self;
}

impl LoadNumber for f64 {
    type States = LoadState;

    #[inline(always)]
    fn state(states: &LoadState, _: usize) -> &LoadState {
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
    type States = [LoadState; Self::WIDTH];

    #[inline(always)]
    fn state(states: &[LoadState; Self::WIDTH], lane: usize) -> &LoadState {
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
