//! The checks of the numbers.

use std::convert::Infallible;
use std::ops::ControlFlow;

use crate::results::CheckRow;
use assur_check::{Subject, methods};
use assur_dynamics::{Steady, Transient};
use assur_force::State;
use assur_mechanism::{Motion, Solve};

use crate::{Course, Progress, Study};

/// States of a transient motion that are checked at most, equally spaced.
const MOST_STATES: usize = 96;

impl Study {
    /// Every check that applies to the scene; none where the plan leaves groups out.
    pub fn checks(&self) -> Vec<CheckRow> {
        match self.checks_watched(&mut |_| ControlFlow::<Infallible>::Continue(())) {
            ControlFlow::Continue(rows) => rows,
            ControlFlow::Break(never) => match never {},
        }
    }

    /// The same; `watch` is told how far it is, and may stop it.
    pub fn checks_watched<B>(
        &self,
        watch: &mut impl FnMut(Progress) -> ControlFlow<B>,
    ) -> ControlFlow<B, Vec<CheckRow>> {
        if self.plan.is_partial() {
            return ControlFlow::Continue(Vec::new());
        }
        let mut rows = self.position_checks(watch)?;
        match &self.course {
            Course::Prescribed => {}
            Course::Transient(found) => rows.extend(self.transient_checks(found)),
            Course::Steady(found) => rows.extend(self.steady_checks(found)),
        }
        ControlFlow::Continue(rows)
    }

    fn position_checks<B>(
        &self,
        watch: &mut impl FnMut(Progress) -> ControlFlow<B>,
    ) -> ControlFlow<B, Vec<CheckRow>> {
        let subject = Subject {
            linkage: &self.linkage,
            loads: self.loads.as_ref().filter(|_| self.plan.forces && self.no_motion.is_none()),
            states: self.checked_states(),
            methods: methods(&self.linkage, self.analyzer.map(|plugin| plugin.name)),
        };
        let found = subject.checks_watched(&mut |done, total| watch(Progress::Checks { done, total }))?;
        let rows = found.into_iter().map(|check| CheckRow {
            name: check.name.to_owned(),
            residual: check.residual,
            limit: check.limit,
            at: check.at,
            place: check.place,
            reason: check.reason.to_owned(),
            left_out: check.left_out,
            why_left_out: check.why_left_out.to_owned(),
            judged: check.judged,
            ok: check.ok,
        });
        ControlFlow::Continue(rows.collect())
    }

    /// The positions; in a transient motion states of the trajectory, which alone has speeds.
    fn checked_states(&self) -> Vec<State> {
        if !matches!(self.course, Course::Transient(_)) {
            let input = &self.linkage.mechanism.input;
            return (0..input.positions).map(|index| self.state(input.coordinate(index))).collect();
        }
        let states = self.states();
        let step = states.len().div_ceil(MOST_STATES).max(1);
        states.into_iter().step_by(step).filter(|state| self.is_regular(state)).collect()
    }

    fn is_regular(&self, state: &State) -> bool {
        let mut position = self.linkage.position();
        let solved = self.linkage.solve(state.coordinate, assur_group::Order::Place, &mut position);
        solved.is_ok() && !self.linkage.is_at_change_point(&position)
    }

    /// S stage 10: what the force analysis needs at the input is what drive and flywheel give there.
    fn drive_check(&self, given: impl Fn(&State) -> f64, limit: f64, reason: &str) -> Option<CheckRow> {
        let (Some(loads), Some(analyzer)) = (&self.loads, self.analyzer) else { return None };
        if self.linkage.mechanism.balance.is_some() {
            return None;
        }
        let names = crate::names::Names::of(&self.linkage.mechanism);
        let mut forces =
            crate::forces::Forces::new(&self.linkage, loads, analyzer, &self.plan.groups_carrying);
        let mut position = self.linkage.position();
        let mut compared = false;
        let (mut worst, mut at, mut largest) = (0.0_f64, None, 0.0_f64);
        for (index, state) in self.checked_states().iter().enumerate() {
            if self.linkage.solve(state.coordinate, assur_group::Order::Second, &mut position).is_err() {
                continue;
            }
            let Ok((_, balancing)) = forces.solve(state, &position, &self.plan.wanted, &names) else {
                continue;
            };
            let found = loads.reduced(state, &position.bodies);
            let inertia = found.inertia * state.acceleration;
            let centrifugal = 0.5 * found.inertia_derivative * state.speed * state.speed;
            let terms = [balancing, found.moment, inertia, centrifugal].map(f64::abs);
            largest = terms.into_iter().fold(largest, f64::max);
            let miss = (balancing - given(state)).abs();
            compared = true;
            // A miss that is no number must show, and a comparison with it would hide it.
            if miss > worst || miss.is_nan() {
                (worst, at) = (miss, Some(index));
            }
        }
        compared.then_some(())?;
        let scale = if largest > 0.0 { largest } else { 1.0 };
        Some(row("drive against force analysis", worst / scale, limit, at, "input link", reason))
    }

    fn transient_checks(&self, found: &Transient) -> Vec<CheckRow> {
        let mut rows = Vec::new();
        let tolerance = match self.linkage.mechanism.motion {
            Some(Motion::Transient { tolerance, .. }) => tolerance,
            _ => 0.0,
        };
        if found.energy.conservative {
            let reason =
                "a hundred times the tolerance of the integration: its errors add up over the motion";
            let limit = (100.0 * tolerance).max(1e-10);
            rows.push(row("energy", found.energy.change, limit, None, "kinetic and potential", reason));
        }
        let Some(Ok(machine)) =
            self.loads.as_ref().map(|loads| assur_dynamics::equation(&self.linkage, loads))
        else {
            return rows;
        };
        let given = |state: &State| machine.torque(state.speed) - found.shaft.inertia * state.acceleration;
        let reason = "the acceleration follows from the same moments: rounding, magnified by the condition of the groups";
        rows.extend(self.drive_check(given, 1e-9, reason));
        rows.extend(self.work_check(found));
        rows
    }

    fn steady_checks(&self, found: &Steady) -> Vec<CheckRow> {
        let regime = &found.regime;
        let mut rows = Vec::new();
        let reason = "the equation of motion is met between the nodes to 2e-13 of the energy; its acceleration to some more";
        let given =
            |state: &State| regime.state(state.coordinate).drive - regime.shaft_inertia * state.acceleration;
        rows.extend(self.drive_check(given, 1e-8, reason));
        rows.extend(self.cycle_check(found));
        let reason = "the cycle closes to the rounding of its energy";
        // Without turns (the machine stalls in its first one from the mean speed) the cycle in time alone is told.
        if let Some(turn) = regime.turns.last() {
            let left = (turn.residual / turn.speed_end).abs();
            rows.push(row("periodicity", left, 1e-9, None, "speed over a cycle", reason));
        }
        let Some(Motion::Steady { mean_speed, unevenness }) = self.linkage.mechanism.motion else {
            return rows;
        };
        let drive = self.linkage.mechanism.drive.as_ref();
        let wanted = |solve: Option<Solve>| matches!(solve, Some(Solve::Wanted));
        if regime.ratio.is_none() || wanted(drive.map(|drive| drive.ratio)) {
            let miss = ((regime.mean_speed - mean_speed) / mean_speed).abs();
            rows.push(row("mean speed", miss, 1e-9, None, "(max + min) / 2", "the search ends below 1e-10"));
        }
        if let (Some(wanted_unevenness), true, false) =
            (unevenness, wanted(drive.and_then(|drive| drive.flywheel)), regime.flywheel_needless)
        {
            let miss = ((regime.unevenness - wanted_unevenness) / wanted_unevenness).abs();
            rows.push(row(
                "unevenness",
                miss,
                1e-8,
                None,
                "(max - min) / mean",
                "the search ends below 1e-10 of the speed",
            ));
        }
        rows
    }
}

pub(crate) fn row(
    name: &str,
    residual: f64,
    limit: f64,
    at: Option<usize>,
    place: &str,
    reason: &str,
) -> CheckRow {
    CheckRow {
        name: name.to_owned(),
        residual,
        limit,
        at,
        place: place.to_owned(),
        reason: reason.to_owned(),
        left_out: 0,
        why_left_out: String::new(),
        judged: true,
        ok: residual <= limit,
    }
}
