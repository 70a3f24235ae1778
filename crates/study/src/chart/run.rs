//! A whole chart.

use std::ops::ControlFlow;

use assur_dynamics::DynamicsError;
use assur_force::{LoadError, Loads, RegistryError};
use assur_integrator::{AUTO, Dependence, EquationOfMotion, Request, Until, choose};
use assur_kinematics::{CompileError, Linkage, PositionError};
use assur_mechanism::Motion;
use assur_words::{Describe, Text, number, text};

use super::data::TOLERANCE;
use super::forces::{self, Loaded};
use super::friction::{self, FrictionMethods};
use super::motion::{self, Task};
use super::race::{Field, Judge};
use super::steady::{self, Cycle};
use super::work::Work;
use super::{ChartData, ChartOptions, Measurement, Progress, SettingValue, Stage, kinematics};

const SAMPLES_OF_A_CYCLE: usize = 48;

/// Longest run of an integrator in a quick chart, s.
const QUICK_RUN: f64 = 0.1;

/// Why a scene has no chart; the failure of one method is in its row.
#[derive(Clone)]
pub enum ChartError {
    /// The groups can't be built in another number type.
    Compile(CompileError),
    /// No position can be assembled.
    Position(PositionError),
    /// All positions lie next to change points.
    OnlyChangePoints,
    /// The loads can't be compiled.
    Load(LoadError),
    /// The equation of motion can't be set up.
    Dynamics(DynamicsError),
    /// No integrator finds the motion.
    NoMotion,
    /// No integrator or no analyzer is linked.
    Registry(RegistryError),
    /// The extended precision finds no solution.
    NoReference {
        /// The coordinate, rad or m.
        coordinate: f64,
    },
}

assur_words::errors!(
    ChartError;
    Compile(CompileError),
    Position(PositionError),
    Load(LoadError),
    Dynamics(DynamicsError),
    Registry(RegistryError),
);

impl Describe for ChartError {
    fn describe(&self) -> Text {
        match self {
            Self::Compile(error) => error.describe(),
            Self::Position(error) => error.describe(),
            Self::OnlyChangePoints => text!("chart-only-change-points"),
            Self::Load(error) => error.describe(),
            Self::Dynamics(error) => error.describe(),
            Self::NoMotion => text!("chart-no-motion"),
            Self::Registry(error) => error.describe(),
            Self::NoReference { coordinate } => {
                text!("chart-no-reference", coordinate = number(format_args!("{coordinate:.9}")))
            }
        }
    }
}

/// Measures every method of every stage that a mechanism has.
///
/// `clock` gives the time since some fixed instant, s, and never goes back. `progress` is called before each piece of work; when it breaks, the finished measurements are kept and
/// [`ChartData::complete`] is false.
pub fn chart(
    linkage: &Linkage,
    clock: &mut dyn FnMut() -> f64,
    options: ChartOptions,
    progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<ChartData, ChartError> {
    let start = clock();
    let mut charting = Charting {
        judge: Judge { clock, options, progress, start, stopped: false },
        data: ChartData { title: linkage.mechanism.title.clone(), ..ChartData::default() },
    };
    charting.positions(linkage)?;
    let Charting { judge, mut data } = charting;
    data.complete = !judge.stopped;
    mark(&mut data.rows);
    Ok(data)
}

struct Charting<'a> {
    judge: Judge<'a>,
    data: ChartData,
}

impl Charting<'_> {
    fn stage(&mut self, stage: Stage, field: Field<'_>) {
        self.data.reference.insert(stage, field.reference.how.clone());
        self.data.reference_error.insert(stage, field.reference.error);
        self.data.rows.extend(self.judge.race(stage, field));
    }

    fn positions(&mut self, linkage: &Linkage) -> Result<(), ChartError> {
        let work = Work::new(linkage)?;
        if !linkage.groups().is_empty() {
            self.stage(Stage::Kinematics, kinematics::field(&work, self.judge.options)?);
        }
        let loads = Loads::compile(linkage)?;
        let loaded = Loaded::new(&work, &loads)?;
        if !loaded.is_idle() {
            self.stage(Stage::Forces, forces::field(&loaded)?);
            if let Some(methods) = FrictionMethods::new(&loaded, &loads)? {
                self.stage(Stage::Friction, friction::field(&methods)?);
            }
        }
        self.motion(linkage, &loads)
    }

    /// Motion, flywheel and steady regime, as far as the scene defines them.
    fn motion(&mut self, linkage: &Linkage, loads: &Loads) -> Result<(), ChartError> {
        let options = self.judge.options;
        if let Some(Motion::Transient { .. }) = linkage.mechanism.motion {
            let mut motion = assur_dynamics::equation(linkage, loads)?;
            let request = assur_dynamics::request(&linkage.mechanism, &mut motion)?;
            let task = Task { motion, request };
            return match self.integrators(&task) {
                // A motion that never rests for good ends at its first turning point, as in the analysis.
                Err(ChartError::NoMotion) if request.until == Until::Rest => {
                    let request = Request { until: Until::Turn, ..request };
                    self.integrators(&Task { request, ..task })
                }
                found => found,
            };
        }
        match Cycle::of(linkage, loads) {
            None => {}
            Some(Err(why)) => self.stage(Stage::Steady, steady::unfound(why)),
            Some(Ok(cycle)) => {
                self.integrators(&cycle.task(SAMPLES_OF_A_CYCLE))?;
                if let Some(field) = steady::flywheel_field(&cycle) {
                    self.stage(Stage::Flywheel, field);
                }
                self.stage(Stage::Steady, steady::field(&cycle, options));
            }
        }
        Ok(())
    }

    /// Number of steps of four evaluations within a run of a quick chart.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "small and positive")]
    fn steps_in_time(&mut self, task: &Task<'_>) -> usize {
        const EVALUATIONS: u32 = 200;
        let mut motion = task.motion.clone();
        let before = (self.judge.clock)();
        for _ in 0..EVALUATIONS {
            // A failure here is reported in the rows of the methods.
            let _ = std::hint::black_box(motion.reduced(&task.request.initial));
        }
        let one = ((self.judge.clock)() - before) / f64::from(EVALUATIONS);
        (QUICK_RUN / (4.0 * one)).clamp(500.0, 1e6) as usize
    }

    fn integrators(&mut self, task: &Task<'_>) -> Result<(), ChartError> {
        let mut options = self.judge.options;
        if options.quick {
            options.max_steps = options.max_steps.min(self.steps_in_time(task));
        }
        let field = motion::field(task, options)?;
        self.stage(Stage::Motion, field);
        mark_choice(&mut self.data.rows, task.motion.dependence());
        Ok(())
    }
}

/// Indices of the points that no other one beats. A point is its time, the noise of that, and its error; times that differ by no
/// more than both noises are equal, so that all that are equally fast and exact share the front.
pub(crate) fn front(points: &[[f64; 3]]) -> Vec<usize> {
    let beats = |[time, noise, error]: [f64; 3], other: [f64; 3]| {
        let (gained, noise) = (other[0] - time, noise + other[1]);
        error < other[2] && gained >= -noise || error <= other[2] && gained > noise
    };
    let is_beaten = |own: &usize| points.iter().any(|other| beats(*other, points[*own]));
    (0..points.len()).filter(|own| !is_beaten(own)).collect()
}

pub(crate) fn mark(rows: &mut [Measurement]) {
    for stage in Stage::ALL {
        let mut known: Vec<&mut Measurement> = rows
            .iter_mut()
            .filter(|row| row.stage == stage && row.whole() && row.point().is_some())
            .collect();
        let point =
            |row: &&mut Measurement| [row.seconds, row.noise, row.error].map(Option::unwrap_or_default);
        let points: Vec<[f64; 3]> = known.iter().map(point).collect();
        for index in front(&points) {
            known[index].front = true;
        }
    }
}

/// Marks the rows that `auto` would choose for their tolerance; a method without one is chosen for every tolerance.
pub(super) fn mark_choice(rows: &mut [Measurement], dependence: Dependence) {
    for row in rows.iter_mut().filter(|row| row.stage == Stage::Motion) {
        let tolerance = match row.setting.get(TOLERANCE) {
            Some(SettingValue::Number(tolerance)) => tolerance,
            None if row.setting.0.is_empty() => f64::EPSILON,
            _ => continue,
        };
        row.auto = choose(AUTO, &dependence, tolerance)
            .is_ok_and(|choice| choice.first.integrator.name == row.method);
    }
}
