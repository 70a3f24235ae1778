//! The steady regime, by shooting and by repeating cycles until the speed settles; and the flywheel, by the methods of
//! the textbooks and exactly.

mod flywheel;
mod settling;

use assur_dynamics::{
    CycleRequest, DriveRequest, Machine, Regime, RegimeSolver, TorqueRequest, TorqueSource, steady,
};
use assur_force::Loads;
use assur_integrator::{Request, State, Until};
use assur_kinematics::Linkage;
use assur_mechanism::Motion;
use assur_words::{Describe, Text, text};

use super::data::TOLERANCE;
use super::motion::Task;
use super::race::{Entry, Field, Verdict};
use super::{ChartOptions, Measurement, Reference, Setting, Stage};

pub(crate) use flywheel::field as flywheel_field;

/// Multiplier of small changes over a cycle above which the speed does not settle in reasonable time.
const NEVER_SETTLES: f64 = 1.0 - 1e-9;

/// The regime of a scene, and the data needed to find it again.
pub(crate) struct Cycle<'a> {
    pub(crate) linkage: &'a Linkage,
    pub(crate) loads: &'a Loads,
    pub(crate) regime: Regime,
    request: CycleRequest,
}

impl<'a> Cycle<'a> {
    /// Finds the regime; `None` for a scene without one.
    pub(crate) fn of(linkage: &'a Linkage, loads: &'a Loads) -> Option<Result<Self, Text>> {
        let input = &linkage.mechanism.input;
        let Some(Motion::Steady { mean_speed, .. }) = linkage.mechanism.motion else { return None };
        let length = input.period()?;
        let request = CycleRequest { start: input.from, length, mean_speed, constant_inertia: 0.0 };
        let found = steady(linkage, loads, None).map_err(|error| error.describe());
        Some(found.map(|found| Self { linkage, loads, regime: found.regime, request }))
    }

    /// One cycle of the regime as a motion in time.
    pub(crate) fn task(&self, samples: usize) -> Task<'a> {
        let speed = self.regime.state(self.request.start).speed;
        let initial = State { time: 0.0, coordinate: self.request.start, speed };
        let end = self.request.start + self.request.mean_speed.signum() * self.request.length;
        let motion = Machine::new(self.linkage, self.loads).with_drive(self.regime.drive());
        Task { motion, request: Request { samples, ..Request::new(initial, Until::Coordinate(end)) } }
    }

    /// The drive with its found parameters, so that only the regime is to be found again.
    fn drive(&self) -> DriveRequest {
        let drive = self.regime.drive();
        let torque = match drive.source {
            TorqueSource::None => TorqueRequest::None,
            TorqueSource::Constant(_) => TorqueRequest::Balance,
            TorqueSource::Motor { characteristic, ratio, efficiency } => {
                TorqueRequest::Motor { characteristic, rotor: 0.0, ratio: Some(ratio), efficiency }
            }
        };
        DriveRequest { torque, flywheel: Some(drive.inertia), flywheel_on_motor: false, unevenness: None }
    }

    fn machine(&self) -> Machine<'a> {
        Machine::new(self.linkage, self.loads).in_regime(&self.regime)
    }
}

pub(crate) fn field<'a>(cycle: &'a Cycle<'a>, options: ChartOptions) -> Field<'a> {
    let row = |method: &str, setting| Measurement::new(Stage::Steady, method, setting);
    let judges = settling::Judges::find(cycle);
    let (by_shooting, in_time) = (judges.shooting, judges.in_time);
    let shooting = move |_| Verdict::of_number(shooting(cycle), in_time);
    let mut entries = vec![Entry::run(row("shooting", Setting::default()), shooting)];
    let settle_in_time = format!("settle-{}", judges.method.map_or("in-time", |method| method.name));
    if cycle.regime.multiplier >= NEVER_SETTLES {
        let refused = |method| Entry::refused(row(method, Setting::default()), text!("chart-never-settles"));
        entries.extend(["settle", &settle_in_time].map(refused));
        return Field { reference: judges.reference, entries };
    }
    let setting = |tolerance| Setting::number(TOLERANCE, tolerance);
    entries.extend(options.decades(-3, -13).map(|tolerance| {
        let run = move |_| Verdict::of_number(settle(cycle, tolerance), in_time);
        Entry::run(row("settle", setting(tolerance)), run)
    }));
    if let Some(method) = judges.method {
        entries.extend(options.decades(-3, -13).map(|tolerance| {
            let run = settling::InTime { cycle, method, tolerance, options };
            let run = move |_| Verdict::of_number(run.solve(), by_shooting);
            Entry::run(row(&settle_in_time, setting(tolerance)), run)
        }));
    }
    Field { reference: judges.reference, entries }
}

/// Speed at the start of the cycle by shooting on collocation panels, with ratio and flywheel given; and evaluations.
fn shooting(cycle: &Cycle<'_>) -> Result<(f64, usize), Text> {
    let mut machine = cycle.machine();
    let mut solver = RegimeSolver::new(&mut machine, cycle.request).map_err(|error| error.describe())?;
    let regime = solver.solve(&cycle.drive()).map_err(|error| error.describe())?;
    Ok((regime.state(cycle.request.start).speed, regime.effort.evaluations))
}

/// Most cycles until a regime must have settled.
const MOST_CYCLES: usize = 10_000;

/// Repeats cycles on the same panels, from the mean speed, until the change is less than the tolerance; returns the
/// speed at the start, and evaluations.
fn settle(cycle: &Cycle<'_>, tolerance: f64) -> Result<(f64, usize), Text> {
    let mut machine = cycle.machine();
    let mut solver = RegimeSolver::new(&mut machine, cycle.request).map_err(|error| error.describe())?;
    let iterations =
        solver.settle(&cycle.regime, tolerance, MOST_CYCLES).map_err(|error| error.describe())?;
    Ok((iterations.last().map_or(f64::NAN, |last| last.speed_end), solver.evaluations()))
}

/// Why a stage of a steady scene has no figures.
pub(crate) fn unfound(why: Text) -> Field<'static> {
    let row = Measurement::new(Stage::Steady, "shooting", Setting::default());
    let reference = Reference { how: text!("chart-reference-none"), error: 0.0 };
    Field { reference, entries: vec![Entry::refused(row, why)] }
}
