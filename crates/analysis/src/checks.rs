//! The checks of the numbers.

use std::collections::BTreeMap;
use std::sync::Arc;

use assur_check::{Check, Chosen, Coverage, Finding, ForceResiduals, InputLoad, Residuals, Subject, methods};
use assur_dynamics::{InputDrive, Regime, Steady, Transient, section_margin};
use assur_force::{LoadState, Loads};
use assur_group::Order;
use assur_integrator::Sample;
use assur_kinematics::Linkage;
use assur_mechanism::{Motion, Solve, Torque};
use assur_words::text;

use crate::progress::{Stopped, Watch};
use crate::results::{Checks, Column, Owner, Quantity, Residual, Schema, Table};
use crate::{Calculation, InputMotion, Progress};

type LoadAtState<'a> = Box<dyn Fn(&LoadState) -> InputLoad + Sync + 'a>;

impl Calculation {
    /// Every check that applies to the scene, in the covered positions and samples of the motion, and the residuals of each
    /// of these; none where the plan leaves out groups.
    pub fn checks(&self, coverage: Coverage, watch: &mut Watch<'_>) -> Result<Checks, Stopped> {
        if self.plan.is_partial() || coverage == Coverage::None {
            return Ok(Checks::default());
        }
        let checked = Checked::of(self, coverage, watch)?;
        let mut of_motion = Vec::new();
        let (mut all, residuals) = match &self.motion {
            InputMotion::Prescribed => self.position_checks(&checked, watch),
            motion => rayon::in_place_scope(|scope| {
                scope.spawn(|_| {
                    of_motion = match motion {
                        InputMotion::Prescribed => Vec::new(),
                        InputMotion::Transient(found) => self.transient_checks(found),
                        InputMotion::Steady(found) => self.steady_checks(found),
                    }
                });
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
        let drive = self.input_load();
        let subject = Subject {
            linkage: &self.linkage,
            loads: self.loads.as_ref().filter(|_| self.plan.forces && self.no_motion.is_none()),
            positions: checked.positions.clone(),
            states: checked.states.clone(),
            state: &|number| checked.state(number),
            drive: drive.as_deref(),
            methods: methods(&self.linkage, self.analyzer.map(|plugin| plugin.name)),
        };
        let found = subject.checks(&mut |done, total| watch(Progress::Checks { done, total }));
        found.continue_value().ok_or(Stopped)
    }

    fn is_regular(&self, state: &LoadState) -> bool {
        let mut position = self.linkage.position();
        let solved = self.linkage.solve(state.coordinate, Order::Place, &mut position);
        solved.is_ok() && !self.linkage.is_at_change_point(&position)
    }

    /// Whether dry friction holds a motion at rest in a state: it is not determined there, nor are the reactions that depend on it.
    pub(crate) fn rests_by_friction(&self, state: &LoadState) -> bool {
        Loads::holds_at_rest(state) && !self.linkage.mechanism.frictions.is_empty()
    }

    /// Whether several loads hold a motion at rest in a state: reactions that depend on their shares are not determined.
    pub(crate) fn rests_by_shares(&self, state: &LoadState) -> bool {
        Loads::holds_at_rest(state) && self.may_share()
    }

    /// Whether several loads may hold a motion at rest where no dry friction does.
    pub(crate) fn may_share(&self) -> bool {
        let shared = self.loads.as_ref().is_some_and(Loads::may_share);
        shared && self.linkage.mechanism.frictions.is_empty()
    }

    /// Whether there may be samples of a motion at rest in which reactions are not determined.
    pub(crate) fn rests_leave_unknown(&self) -> bool {
        let may_be = !self.linkage.mechanism.frictions.is_empty() || self.may_share();
        matches!(self.motion, InputMotion::Transient(_)) && may_be
    }

    /// The load on the input by the motion that was found; `None` where it is prescribed.
    fn input_load(&self) -> Option<LoadAtState<'_>> {
        let loads = self.loads.as_ref()?;
        match &self.motion {
            InputMotion::Prescribed => None,
            InputMotion::Transient(found) => {
                let samples = &found.trajectory.samples;
                let span = |of: fn(&Sample) -> f64| {
                    samples.iter().map(|at| (of(at) - of(&samples[0])).abs()).fold(0.0, f64::max)
                };
                let accuracy =
                    [span(|at| at.coordinate), span(|at| at.time)].map(|span| self.tolerance() * span);
                let machine = assur_dynamics::equation(&self.linkage, loads).ok()?;
                let drive = machine.drive;
                Some(Box::new(move |state: &LoadState| {
                    let load = input_load(&drive, state, drive.torque(state), f64::EPSILON);
                    InputLoad { accuracy, ..load }
                }))
            }
            InputMotion::Steady(found) => {
                let regime = &found.regime;
                let accuracy = regime.error_of_moments + ROUNDING * greatest_moment(&self.linkage, regime);
                let of_speed = regime.effort.residual + f64::EPSILON;
                Some(Box::new(move |state: &LoadState| {
                    let driving = regime.state(state.coordinate).drive;
                    let load = input_load(&regime.drive(), state, driving, of_speed);
                    InputLoad { error: load.error + accuracy, ..load }
                }))
            }
        }
    }

    fn transient_checks(&self, found: &Transient) -> Vec<Check> {
        let mut rows = Vec::new();
        if found.energy.conservative {
            // The energy goes with the square of the speed.
            let steps = 4.0 * found.error_of_fixed_steps();
            let own = (100.0 * self.tolerance()).max(1e-10) + steps;
            let limit = own * found.energy.by_speed + found.energy.rounding;
            let change = Finding::of(text!("analysis-kinetic-and-potential"), found.energy.change, limit);
            rows.push(Check::of(text!("analysis-energy"), text!("analysis-energy.reason"), change));
        }
        rows.extend(self.work_check(found));
        rows
    }

    fn steady_checks(&self, found: &Steady) -> Vec<Check> {
        let regime = &found.regime;
        let mut rows = Vec::new();
        rows.extend(self.cycle_check(found));
        // Without iterations (the machine stalls in its first cycle from the mean speed) only the cycle in time is checked.
        if let Some(last) = regime.iterations.last() {
            let left = (last.residual / last.speed_end).abs();
            let left = Finding::of(text!("analysis-speed-over-cycle"), left, 1e-9);
            rows.push(Check::of(text!("analysis-periodicity"), text!("analysis-periodicity.reason"), left));
        }
        let Some(Motion::Steady { mean_speed, unevenness }) = self.linkage.mechanism.motion else {
            return rows;
        };
        let drive = self.linkage.mechanism.drive.as_ref();
        let wanted = |solve: Option<Solve>| matches!(solve, Some(Solve::Wanted));
        // A given ratio or moment determines the speed: whether it is the requested one is then no question of
        // numerical error.
        let fixed = matches!(drive.map(|drive| &drive.torque), Some(Torque::Constant(_)));
        if !fixed && (regime.figures.ratio.is_none() || wanted(drive.map(|drive| drive.ratio))) {
            let miss = ((regime.figures.mean_speed - mean_speed) / mean_speed).abs();
            let miss = Finding::of(assur_words::name("(max + min) / 2"), miss, 1e-9);
            rows.push(Check::of(text!("analysis-mean-speed"), text!("analysis-mean-speed.reason"), miss));
        }
        if let (Some(Solve::Given(wanted_unevenness)), true, false) =
            (unevenness, wanted(drive.and_then(|drive| drive.flywheel)), regime.flywheel_needless)
        {
            let miss = ((regime.figures.unevenness - wanted_unevenness) / wanted_unevenness).abs();
            let miss = Finding::of(text!("analysis-of-extremes"), miss, 1e-8);
            rows.push(Check::of(text!("analysis-unevenness"), text!("analysis-unevenness.reason"), miss));
        }
        rows.extend(found.motor.as_ref().filter(|_| unevenness == Some(Solve::Wanted)).map(|motor| {
            let margin = section_margin(regime, &motor.work.characteristic);
            // Without a flywheel the motor may stay well inside.
            let miss = if regime.flywheel_needless { (-margin).max(0.0) } else { margin.abs() };
            let miss = Finding::of(text!("analysis-stable-section"), miss, 1e-8);
            let reason = text!("analysis-unevenness-of-motor.reason");
            Check::of(text!("analysis-unevenness-of-motor"), reason, miss)
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
    trajectory: Option<Vec<LoadState>>,
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
    fn state(&self, number: usize) -> Option<LoadState> {
        if let Some(all) = &self.trajectory {
            let known = |state: &LoadState| {
                self.calculation.is_regular(state) && !self.calculation.rests_by_friction(state)
            };
            return all.get(number).copied().filter(known);
        }
        let input = &self.calculation.linkage.mechanism.input;
        Some(self.calculation.state(input.coordinate(number)))
    }
}

/// What a drive puts on the input in a state: its moment less that of its inertia. `of_speed`: relative accuracy of the
/// speed, on which a stiff drive depends strongly.
fn input_load(drive: &InputDrive, state: &LoadState, moment: f64, of_speed: f64) -> InputLoad {
    let of_inertia = drive.inertia * state.acceleration;
    let faster = LoadState { speed: state.speed * (1.0 + of_speed), ..*state };
    let rounding = 4.0 * f64::EPSILON * (moment.abs() + of_inertia.abs());
    InputLoad {
        value: moment - of_inertia,
        error: (drive.torque(&faster) - drive.torque(state)).abs() + rounding,
        accuracy: [0.0; 2],
    }
}

/// Rounding of the moments of a regime, which are interpolated between nine nodes, as part of the greatest.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The greatest moment of drive, loads and inertia over the cycle of a regime.
fn greatest_moment(linkage: &Linkage, regime: &Regime) -> f64 {
    /// A moment changes little between so many places.
    const PLACES: u8 = 64;
    let (input, unit) = (&linkage.mechanism.input, linkage.coordinate_unit());
    let step = input.sign() * input.period().unwrap_or(0.0) / f64::from(PLACES);
    let of = |place: u8| {
        let at = regime.state(input.from + f64::from(place) * step);
        let inertia = at.inertia + regime.drive_inertia;
        let centrifugal = inertia * at.speed * at.speed / unit;
        at.drive.abs() + at.load.abs() + (inertia * at.acceleration).abs() + centrifugal
    };
    (0..PLACES).map(of).fold(0.0, f64::max)
}

impl Calculation {
    /// The residuals as columns: those of positions, and those of the samples of a transient motion, whose forces are
    /// checked there.
    pub(crate) fn residual_tables(&self, found: &Residuals, forces_of_samples: bool) -> [Table; 2] {
        // A scene with `[output]` asks for something else.
        if !self.plan.all {
            return [Table::default(), Table::default()];
        }
        let (test_pf, forces) = (found.test_pf.as_slice(), found.forces.as_slice());
        if forces_of_samples {
            return [self.residual_table(test_pf, &[]), self.residual_table(&[], forces)];
        }
        [self.residual_table(test_pf, forces), Table::default()]
    }

    fn residual_table(&self, test_pf: &[(usize, f64)], forces: &[ForceResiduals]) -> Table {
        let mut schema = Schema::new(&self.linkage.mechanism);
        let column = |of, owner| Column::of(Quantity::Residual(of), owner);
        let groups = 0..self.linkage.structure.groups.len();
        if !test_pf.is_empty() {
            let section = schema.section();
            schema.add(section, [column(Residual::TestPf, Owner::Input)]);
        }
        if !forces.is_empty() {
            let section = schema.section();
            schema.add(section, groups.clone().map(|i| column(Residual::Equilibrium, Owner::Group(i))));
            let of_input = [Residual::Dynamics, Residual::Remainder, Residual::Global];
            schema.add(section, of_input.map(|of| column(of, Owner::Input)));
        }
        let mut rows: BTreeMap<usize, (Option<f64>, Option<&ForceResiduals>)> = BTreeMap::new();
        // A residual that is not finite fails its check; a table holds finite numbers only.
        for (number, residual) in test_pf.iter().filter(|(_, residual)| residual.is_finite()) {
            rows.entry(*number).or_default().0 = Some(*residual);
        }
        for found in forces {
            let mut all = found.groups.iter().chain([&found.dynamics, &found.remainder, &found.global]);
            if all.all(|residual| residual.is_finite()) {
                rows.entry(found.number).or_default().1 = Some(found);
            }
        }
        let mut table = Table::new(Arc::new(schema));
        for (number, (deviation, found)) in rows {
            let of_forces = groups.clone().map(|group| found.map(|found| found.groups[group]));
            let of_input = |found: &ForceResiduals| [found.dynamics, found.remainder, found.global];
            let of_input = (0..3).map(|index| found.map(|found| of_input(found)[index]));
            let of_forces = of_forces.chain(of_input).filter(|_| !forces.is_empty());
            table.push(number, (!test_pf.is_empty()).then_some(deviation).into_iter().chain(of_forces));
        }
        table
    }
}

#[cfg(test)]
mod tests;
