//! On the edge of a piece: the end of the motion, or the next piece; and inside a piece where the equation has a kink: where a force
//! whose magnitude gives friction changes its sign.

use assur_number::search::try_bisect;

use super::{Aim, Drive, NEAR_END, OVERSHOOT, Plan};
use crate::event_location::Side;
use crate::run::CREEPS;
use crate::{Dense, EventKind, IntegrationError, MotionError, Node, State, Stepper, Until};

/// Events without progress of time after which the pieces count as contradictory.
const MAX_STALLS: usize = 50;

impl<S: Stepper> Drive<'_, S> {
    /// A step aimed at a bound that ended a little before it: the remainder is uniformly accelerated.
    pub(super) fn meet_if_at(&mut self, side: Side, h: f64) -> Result<(), IntegrationError> {
        /// Part of the step. The error of the parabola is its cube.
        const NEAR: f64 = 1e-5;
        let node = self.run.node;
        match self.bounds.time_to(side, &node).filter(|dt| *dt <= NEAR * h) {
            Some(dt) => self.meet(side, node.advanced(dt)),
            None if self.bounds.snap(side, node.state) == node.state => self.meet(side, node.state),
            None => Ok(()),
        }
    }

    /// At a bound of time: the end, or the next piece.
    pub(super) fn meet_time(&mut self) -> Result<(), IntegrationError> {
        if self.run.node.state.time >= self.run.request.latest() {
            self.run.finished = true;
            return self.run.time_is_over();
        }
        self.run.event(EventKind::Time);
        self.enter_next(false)
    }

    /// At a bound of coordinate or speed: the end, or the next piece.
    pub(super) fn meet(&mut self, side: Side, state: State) -> Result<(), IntegrationError> {
        let state = self.bounds.snap(side, state);
        let before = self.run.node.state;
        self.arrive(state, state.time <= before.time)?;
        let in_speed = matches!(side, Side::SpeedLow | Side::SpeedHigh);
        if self.bounds.is_goal(side) {
            self.run.finish()?;
            return if in_speed { self.check_stop(&self.run.node, before.speed) } else { Ok(()) };
        }
        if !in_speed {
            self.run.event(EventKind::Coordinate);
        } else if state.speed != 0.0 {
            self.run.event(EventKind::Speed);
        }
        self.go_on(in_speed, before.speed)
    }

    /// At a change that no bound describes, between two places of a step: beyond it, in the next piece.
    pub(super) fn meet_change(
        &mut self,
        plan: Plan,
        error: f64,
        dense: &Dense,
        [before, after]: [f64; 2],
    ) -> Result<(), IntegrationError> {
        /// Part of a step below which a cut makes no progress.
        const NO_PROGRESS: f64 = 1e-9;
        let stalled = after <= NO_PROGRESS;
        if !stalled && after < NEAR_END && !S::PARABOLIC {
            self.run.equation.cost.rejected += 1;
            self.redo = Some((after * OVERSHOOT * plan.h, Aim::Switch));
            return Ok(());
        }
        self.propose(&Plan { aim: Some(Aim::Switch), ..plan }, error);
        let (mut state, last) = (dense.at(after), dense.at(before).speed);
        // Friction by formula changes where the motion stops.
        let stops = last * state.speed <= 0.0;
        if stops {
            state.speed = 0.0;
        }
        self.run.record(*dense, state.time);
        self.arrive(state, stalled)?;
        self.run.event(EventKind::Switch);
        self.go_on(stops, last)
    }

    /// Takes the state at the end of a piece.
    fn arrive(&mut self, state: State, stalled: bool) -> Result<(), IntegrationError> {
        self.stalls = if stalled { self.stalls + 1 } else { 0 };
        if self.stalls > MAX_STALLS {
            return Err(IntegrationError::EmptyPiece { at: state });
        }
        self.run.equation.cost.steps += usize::from(!stalled);
        self.scale.extend(&state);
        self.run.node.state = state;
        Ok(())
    }

    /// In the next piece, after a speed with the sign of `before`.
    fn go_on(&mut self, at_speed_bound: bool, before: f64) -> Result<(), IntegrationError> {
        let state = self.run.node.state;
        self.enter_next(at_speed_bound)?;
        if at_speed_bound && state.speed == 0.0 && self.run.node.acceleration * before < 0.0 {
            self.run.reversal(state, before)?;
        }
        Ok(())
    }

    /// At a turning point that the steps have found: the acceleration must be able to reverse the motion. Where a speed
    /// only decays, errors of the steps may carry it through zero.
    fn check_stop(&self, at: &Node, speed: f64) -> Result<(), IntegrationError> {
        /// The greatest part of the largest speed that the acceleration must be able to change in the time since the
        /// start.
        const MOST: f64 = 0.01;
        let Node { state, acceleration } = *at;
        let request = self.run.request;
        let change = -acceleration * speed.signum() * (state.time - request.initial.time);
        if change > (100.0 * request.tolerance).min(MOST) * self.scale.fastest() {
            return Ok(());
        }
        Err(self.run.not_reached(CREEPS))
    }

    /// Checks a turning point inside a step by [`check_stop`](Self::check_stop), unless the motion ends at a given
    /// time.
    pub(super) fn check_turning(&mut self, state: &State) -> Result<(), IntegrationError> {
        if let Until::Time(_) = self.run.request.until {
            return Ok(());
        }
        let acceleration = self.run.equation.acceleration(state).map_err(|source| self.run.failed(source))?;
        self.check_stop(&Node { state: *state, acceleration }, self.run.node.state.speed)
    }

    /// After a step: an error if the speed stays below the tolerance, since such a motion approaches rest without
    /// reaching it.
    pub(super) fn check_creeping(&mut self) -> Result<(), IntegrationError> {
        /// From this many slow steps, and this much slow time relative to the time before, the motion counts as creeping.
        const STEPS: usize = 1000;
        const TIMES: f64 = 10.0;
        const LEAST: usize = 10;
        let (state, request) = (self.run.node.state, self.run.request);
        let fast = state.speed.abs() > request.tolerance * self.scale.fastest();
        if fast || matches!(request.until, Until::Time(_)) {
            self.slow = (0, state.time);
            return Ok(());
        }
        self.slow.0 += 1;
        let (steps, since) = self.slow;
        let long = state.time - since > TIMES * (since - request.initial.time);
        if steps >= STEPS || (steps >= LEAST && long) {
            return Err(self.run.not_reached(CREEPS));
        }
        Ok(())
    }

    fn enter_next(&mut self, at_speed_bound: bool) -> Result<(), IntegrationError> {
        if self.run.enter_next(at_speed_bound)? {
            self.update_bounds();
            return self.note_bends();
        }
        self.stick()
    }

    /// The kinks at the present state, where there are any.
    pub(super) fn note_bends(&mut self) -> Result<(), IntegrationError> {
        if self.run.equation.dependence().moment_on_acceleration {
            let found = self.run.equation.bends(&self.run.node.state);
            self.bends[0] = found.map_err(|source| self.run.failed(source))?;
        }
        Ok(())
    }

    /// Whether a step has to be repeated up to a kink inside it; then it is planned.
    pub(super) fn bends_within(&mut self, plan: &Plan, to: &Node) -> Result<bool, IntegrationError> {
        if self.bends[0].is_empty() || S::PARABOLIC {
            return Ok(false);
        }
        let Ok(after) = self.run.equation.bends(&to.state) else { return Ok(false) };
        let size = after.iter().chain(&self.bends[0]).fold(0.0_f64, |most, bend| most.max(bend.abs()));
        let turns = |(before, after): (&f64, &f64)| before * after < 0.0 && before.abs() > LANDED * size;
        let changed = self.bends[0].iter().zip(&after).position(turns);
        let Some(which) = changed.filter(|_| plan.aim != Some(Aim::Bend)) else {
            self.bends[1] = after;
            return Ok(false);
        };
        let dense = self.dense(to)?;
        let found = self.bend_in(&dense, which);
        let theta = found.map_err(|source| self.run.failed(source))?;
        self.run.equation.cost.rejected += 1;
        self.redo = Some((theta * plan.h, Aim::Bend));
        Ok(true)
    }

    /// The part of a step after which a number changes its sign.
    fn bend_in(&mut self, dense: &Dense, which: usize) -> Result<f64, MotionError> {
        let before = self.bends[0][which];
        let [_, after] = try_bisect(0.0, 1.0, WIDTH, |theta| {
            Ok(self.run.equation.bends(&dense.at(theta))?[which] * before > 0.0)
        })?;
        Ok(after)
    }
}

/// A number below this part of the greatest is where it changes its sign: a step has landed there.
const LANDED: f64 = 1e-7;

/// Width of the part of a step to which a change of sign is found.
const WIDTH: f64 = 1e-12;
