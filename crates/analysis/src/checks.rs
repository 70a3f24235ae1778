//! The checks of the numbers.

use assur_check::{Check, Chosen, Coverage, Residuals, Subject, methods};
use assur_dynamics::{Steady, Transient, section_margin};
use assur_force::{Kinetostatics, Loads, Side, State, tolerance};
use assur_group::{Body, Order};
use assur_mechanism::{Motion, Solve, Torque};

use crate::progress::{Stopped, Watch};
use crate::results::Checks;
use crate::{Calculation, InputMotion, Progress};

impl Calculation {
    /// Every check that applies to the scene, in the covered positions and samples of the motion, and the residuals of each
    /// of these; none where the plan leaves out groups.
    ///
    /// # Errors
    ///
    /// [`Stopped`] where `watch` breaks.
    pub fn checks(&self, coverage: Coverage, watch: &mut Watch<'_>) -> Result<Checks, Stopped> {
        if self.plan.is_partial() || coverage == Coverage::None {
            return Ok(Checks::none());
        }
        let checked = Checked::of(self, coverage, watch)?;
        let mut of_motion = Vec::new();
        let (mut all, residuals) = match &self.motion {
            InputMotion::Prescribed => self.position_checks(&checked, watch),
            motion => rayon::in_place_scope(|scope| {
                scope.spawn(|_| of_motion = self.motion_checks(motion, &checked));
                self.position_checks(&checked, watch)
            }),
        }?;
        all.append(&mut of_motion);
        let [of_positions, of_trajectory] = self.residual_tables(&residuals, checked.trajectory.is_some());
        Ok(Checks { all, of_positions, of_trajectory })
    }

    fn position_checks(
        &self,
        checked: &Checked<'_>,
        watch: &mut Watch<'_>,
    ) -> Result<(Vec<Check>, Residuals), Stopped> {
        let subject = Subject {
            linkage: &self.linkage,
            loads: self.loads.as_ref().filter(|_| self.plan.forces && self.no_motion.is_none()),
            positions: checked.positions.clone(),
            states: checked.states.clone(),
            state: &|number| checked.state(number),
            methods: methods(&self.linkage, self.analyzer.map(|plugin| plugin.name)),
        };
        let found = subject.checks(&mut |done, total| watch(Progress::Checks { done, total }));
        found.continue_value().ok_or(Stopped)
    }

    fn motion_checks(&self, motion: &InputMotion, checked: &Checked<'_>) -> Vec<Check> {
        match motion {
            InputMotion::Prescribed => Vec::new(),
            InputMotion::Transient(found) => self.transient_checks(found, checked),
            InputMotion::Steady(found) => self.steady_checks(found, checked),
        }
    }

    fn is_regular(&self, state: &State) -> bool {
        let mut position = self.linkage.position();
        let solved = self.linkage.solve(state.coordinate, Order::Place, &mut position);
        solved.is_ok() && !self.linkage.is_at_change_point(&position)
    }

    /// S stage 10: the load at the input from the force analysis against that of drive and flywheel. `least`: a moment
    /// (force) below which nothing is resolved.
    fn drive_check(
        &self,
        checked: &Checked<'_>,
        given: impl Fn(&State) -> f64,
        least: f64,
        limit: f64,
        reason: &'static str,
    ) -> Option<Check> {
        let loads = self.loads.as_ref()?;
        if self.linkage.mechanism.balance.is_some() {
            return None;
        }
        let (linkage, carrying) = (&self.linkage, &self.plan.groups_carrying);
        let mut forces = Kinetostatics::new(linkage, loads, self.analyzer?.instance, carrying);
        let mut position = linkage.position();
        let mut compared = false;
        let (mut worst, mut at, mut largest) = ([0.0_f64; 2], None, least);
        let mut phase = loads.phase();
        for (index, state) in checked.states.iter().filter_map(|index| Some((index, checked.state(index)?))) {
            let state = &state;
            if linkage.solve(state.coordinate, Order::Second, &mut position).is_err()
                || forces.solve(state, &position).is_err()
            {
                continue;
            }
            let (balancing, bodies) = (forces.reactions.balancing, &position.bodies);
            // In a steady turn without loads all terms vanish; the rounding is that of J w².
            let inertia = loads.reduced(state, bodies).inertia;
            let steady = inertia * state.speed * state.speed / self.linkage.coordinate_unit();
            largest = largest.max(balancing.abs() + terms(loads, state, bodies)).max(steady);
            // On a steep line the load is known only as well as the coordinate.
            loads.enter(state, &mut phase);
            let rounding = tolerance(state.coordinate, self.linkage.mechanism.input.period());
            let [before, after] = [-rounding, rounding].map(|shift| {
                let beside = State { coordinate: state.coordinate + shift, ..*state };
                loads.reduced_in_phase(&phase, &beside, bodies).moment
            });
            let (miss, unsure) = ((balancing - given(state)).abs(), (after - before).abs());
            compared = true;
            // A residual that is NaN must show, and a comparison with it would hide it.
            if miss - unsure > worst[0] - worst[1] || miss.is_nan() {
                (worst, at) = ([miss, unsure], Some(index));
            }
        }
        compared.then_some(())?;
        let scale = if largest > 0.0 { largest } else { 1.0 };
        let [residual, limit] = [worst[0] / scale, limit + worst[1] / scale];
        let check = Check::of("drive against force analysis", residual, limit, "input link", reason);
        Some(Check { at, sample: checked.states.share(), ..check })
    }

    fn transient_checks(&self, found: &Transient, checked: &Checked<'_>) -> Vec<Check> {
        let mut rows = Vec::new();
        let tolerance = match self.linkage.mechanism.motion {
            Some(Motion::Transient { tolerance, .. }) => tolerance,
            _ => 0.0,
        };
        if found.energy.conservative {
            let reason = "a hundred times the tolerance of the integration (four times the error of fixed steps), whose errors add up over the motion, and what the rounding \
                 of the coordinate makes of the potential energy";
            // The energy goes with the square of the speed.
            let steps = 4.0 * found.error_of_fixed_steps();
            let limit = (100.0 * tolerance).max(1e-10) + found.energy.rounding + steps;
            rows.push(Check::of("energy", found.energy.change, limit, "kinetic and potential", reason));
        }
        let Some(Ok(machine)) =
            self.loads.as_ref().map(|loads| assur_dynamics::equation(&self.linkage, loads))
        else {
            return rows;
        };
        let given =
            |state: &State| machine.drive().torque(state) - machine.drive().inertia * state.acceleration;
        let reason = "the acceleration follows from the same moments: rounding, magnified by the condition of the groups";
        rows.extend(self.drive_check(checked, given, 0.0, 1e-9, reason));
        rows.extend(self.work_check(found));
        rows
    }

    fn steady_checks(&self, found: &Steady, checked: &Checked<'_>) -> Vec<Check> {
        let regime = &found.regime;
        let mut rows = Vec::new();
        let reason = "the equation of motion is met between the nodes to 2e-13 of the energy; its acceleration to some more";
        let given =
            |state: &State| regime.state(state.coordinate).drive - regime.drive_inertia * state.acceleration;
        // Moments come from the kinetic energy over the cycle: work and energy are equal.
        let start = regime.state(self.linkage.mechanism.input.from);
        let least = 0.5 * (start.inertia + regime.drive_inertia) * start.speed * start.speed;
        rows.extend(self.drive_check(checked, given, least, 1e-8, reason));
        rows.extend(self.cycle_check(found));
        let reason = "the cycle closes to the rounding of its energy";
        // Without iterations (the machine stalls in its first cycle from the mean speed) only the cycle in time is checked.
        if let Some(last) = regime.iterations.last() {
            let left = (last.residual / last.speed_end).abs();
            rows.push(Check::of("periodicity", left, 1e-9, "speed over a cycle", reason));
        }
        let Some(Motion::Steady { mean_speed, unevenness }) = self.linkage.mechanism.motion else {
            return rows;
        };
        let drive = self.linkage.mechanism.drive.as_ref();
        let wanted = |solve: Option<Solve>| matches!(solve, Some(Solve::Wanted));
        // A given ratio or moment determines the speed: whether it is the requested one is then no question of
        // numerical error.
        let fixed = matches!(drive.map(|drive| &drive.torque), Some(Torque::Constant(_)));
        if !fixed && (regime.ratio.is_none() || wanted(drive.map(|drive| drive.ratio))) {
            let miss = ((regime.mean_speed - mean_speed) / mean_speed).abs();
            rows.push(Check::of("mean speed", miss, 1e-9, "(max + min) / 2", "the search ends below 1e-10"));
        }
        if let (Some(Solve::Given(wanted_unevenness)), true, false) =
            (unevenness, wanted(drive.and_then(|drive| drive.flywheel)), regime.flywheel_needless)
        {
            let miss = ((regime.unevenness - wanted_unevenness) / wanted_unevenness).abs();
            rows.push(Check::of(
                "unevenness",
                miss,
                1e-8,
                "(max - min) / mean",
                "the search ends below 1e-10 of the speed",
            ));
        }
        rows.extend(found.motor.as_ref().filter(|_| unevenness == Some(Solve::Wanted)).map(|motor| {
            let margin = section_margin(regime, &motor.motor.characteristic);
            // Without a flywheel the motor may stay well inside.
            let miss = if regime.flywheel_needless { (-margin).max(0.0) } else { margin.abs() };
            let reason = "the least or the greatest speed of the motor against the end of its section, in parts of the section";
            Check::of("unevenness of the motor", miss, 1e-8, "stable section of its characteristic", reason)
        }));
        rows
    }
}

/// The positions and states that are checked.
struct Checked<'a> {
    calculation: &'a Calculation,
    positions: Chosen,
    states: Chosen,
    /// The samples of a transient motion, of which only some have forces; otherwise the states are those of the
    /// positions.
    trajectory: Option<Vec<State>>,
}

impl<'a> Checked<'a> {
    fn of(calculation: &'a Calculation, coverage: Coverage, watch: &mut Watch<'_>) -> Result<Self, Stopped> {
        let transient = matches!(calculation.motion, InputMotion::Transient(_));
        let trajectory = transient.then(|| calculation.states());
        let counts = [calculation.linkage.mechanism.input.positions, trajectory.as_ref().map_or(0, Vec::len)];
        let sampled = counts.iter().any(|count| coverage.is_sample(*count));
        let notable: &[Vec<usize>; 2] =
            if sampled { calculation.notable(watch)? } else { &Default::default() };
        let [positions, samples] = [0, 1].map(|k| coverage.choose(counts[k], &notable[k]));
        let states = if transient { samples } else { positions.clone() };
        Ok(Self { calculation, positions, states, trajectory })
    }

    /// A state by its number; `None` for a sample of a transient motion in which forces are not determined.
    fn state(&self, number: usize) -> Option<State> {
        if let Some(all) = &self.trajectory {
            return all.get(number).copied().filter(|state| self.calculation.is_regular(state));
        }
        let input = &self.calculation.linkage.mechanism.input;
        Some(self.calculation.state(input.coordinate(number)))
    }
}

/// Sum of the sizes of the virtual powers of all loads per speed of the input, which may cancel in their sum.
fn terms(loads: &Loads, state: &State, bodies: &[Body<f64>]) -> f64 {
    let mut sum = 0.0;
    loads.by_cause(state, bodies, &mut |_, link, load| {
        let body = &bodies[link];
        sum += (load.fx * body.x1).abs() + (load.fy * body.y1).abs() + (load.m * body.w1).abs();
    });
    if matches!(state.side, Side::Held { .. }) {
        // Each load is a mean of its values on both sides, which may cancel as well.
        let side = |upper| loads.reduced(&State { side: Side::Held { upper }, ..*state }, bodies).moment;
        sum += f64::abs(side(0.0)) + f64::abs(side(1.0));
    }
    sum
}
