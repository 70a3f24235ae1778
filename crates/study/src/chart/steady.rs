//! The steady regime, by shooting and by running until it settles; and the flywheel, by the methods of the textbooks and
//! exactly.

mod flywheel;
mod settling;

use std::hint::black_box;

use assur_dynamics::{
    CycleRequest, DriveRequest, Driven, Machine, Regime, Source, Survey, TorqueRequest, steady,
};
use assur_force::Loads;
use assur_integrator::{Dependence, Motion, MotionError, Piece, Reduced, Request, State, Until};
use assur_kinematics::Linkage;
use assur_mechanism::Motion as Asked;

use super::entry::{Contestant, Entry, Field, Verdict};
use super::motion::Task;
use super::{Options, Reference, Row, Setting, Stage, Unit};

pub(crate) use flywheel::field as flywheel_field;

/// Of a regime whose small changes die out more slowly than this over a cycle, nothing settles.
const NEVER_SETTLES: f64 = 1.0 - 1e-9;

/// The regime of a scene, and what is needed to find it anew.
pub(crate) struct Cycle<'a> {
    pub(crate) linkage: &'a Linkage,
    pub(crate) loads: &'a Loads,
    pub(crate) regime: Regime,
    request: CycleRequest,
}

impl<'a> Cycle<'a> {
    /// Finds the regime; `None` for a scene without one.
    ///
    /// # Errors
    ///
    /// Why it can't be found, in words.
    pub(crate) fn of(linkage: &'a Linkage, loads: &'a Loads) -> Option<Result<Self, String>> {
        let input = &linkage.mechanism.input;
        let Some(Asked::Steady { mean_speed, .. }) = linkage.mechanism.motion else { return None };
        let length = input.period()?;
        let request = CycleRequest { start: input.from, length, mean_speed, constant_inertia: 0.0 };
        let found = steady(linkage, loads).map_err(|error| error.to_string());
        Some(found.map(|found| Self { linkage, loads, regime: found.regime, request }))
    }

    /// One cycle of the regime as a motion in time.
    pub(crate) fn task(&self, samples: usize) -> Task<'a> {
        let speed = self.regime.state(self.request.start).speed;
        let initial = State { time: 0.0, coordinate: self.request.start, speed };
        let end = self.request.start + self.request.mean_speed.signum() * self.request.length;
        let motion = Driven::new(Machine::new(self.linkage, self.loads), self.regime.shaft());
        Task { motion, request: Request { samples, ..Request::new(initial, Until::Coordinate(end)) } }
    }

    /// The drive as it was found, so that only the regime is to be found again.
    fn drive(&self) -> DriveRequest {
        let shaft = self.regime.shaft();
        let torque = match shaft.source {
            Source::None => TorqueRequest::None,
            Source::Constant(_) => TorqueRequest::Balance,
            Source::Motor { characteristic, ratio, efficiency } => {
                TorqueRequest::Motor { characteristic, rotor: 0.0, ratio: Some(ratio), efficiency }
            }
        };
        DriveRequest { torque, flywheel: Some(shaft.inertia), flywheel_on_motor: false, unevenness: None }
    }

    fn machine(&self) -> Counted<Machine<'a>> {
        Counted { motion: Machine::new(self.linkage, self.loads), count: 0 }
    }
}

/// All that can find the regime.
pub(crate) fn field<'a>(cycle: &'a Cycle<'a>, options: Options) -> Field<'a> {
    let row = |method: &str, setting| Row::new(Stage::Steady, Unit::Run, method, setting);
    let multiplier = cycle.regime.multiplier;
    let judges = settling::Judges::find(cycle);
    let mut entries =
        vec![Entry::new(row("shooting", Setting::default()), 1, Shooting { cycle, truth: judges.in_time })];
    if multiplier >= NEVER_SETTLES {
        let why = "nothing restores the speed (what a change is multiplied by over a cycle is 1), so that it never settles";
        entries.push(Entry::refused(row("settle", Setting::default()), why));
        entries.push(Entry::refused(row("settle-dop853", Setting::default()), why));
    } else {
        for tolerance in options.decades(-3, -13) {
            let setting = Setting::number("tolerance", tolerance);
            entries.push(Entry::new(
                row("settle", setting),
                1,
                Settle { cycle, tolerance, truth: judges.in_time },
            ));
        }
        for tolerance in options.decades(-3, -13) {
            let setting = Setting::number("tolerance", tolerance);
            let run = settling::InTime { cycle, tolerance, truth: judges.shooting, options };
            entries.push(Entry::new(row("settle-dop853", setting), 1, run));
        }
    }
    Field { reference: judges.reference, entries }
}

/// Shooting on collocation panels, with ratio and flywheel given.
struct Shooting<'a> {
    cycle: &'a Cycle<'a>,
    /// Speed at the start of the cycle.
    truth: f64,
}

impl Shooting<'_> {
    fn solve(&self) -> Result<(f64, usize), String> {
        let mut machine = self.cycle.machine();
        let words = |error: assur_dynamics::DynamicsError| error.to_string();
        let mut survey = Survey::new(&mut machine, self.cycle.request).map_err(words)?;
        let regime = survey.solve(&self.cycle.drive()).map_err(words)?;
        drop(survey);
        Ok((regime.state(self.cycle.request.start).speed, machine.count))
    }
}

impl Contestant for Shooting<'_> {
    fn run(&mut self) {
        let _ = black_box(self.solve());
    }

    fn judge(&mut self) -> Verdict {
        verdict(self.solve(), self.truth)
    }
}

/// Cycle after cycle on the same panels, from the mean speed.
struct Settle<'a> {
    cycle: &'a Cycle<'a>,
    tolerance: f64,
    truth: f64,
}

/// Most cycles until a regime must have settled.
const MOST_CYCLES: usize = 10_000;

impl Settle<'_> {
    fn solve(&self) -> Result<(f64, usize), String> {
        let mut machine = self.cycle.machine();
        let words = |error: assur_dynamics::DynamicsError| error.to_string();
        let mut survey = Survey::new(&mut machine, self.cycle.request).map_err(words)?;
        let turns = survey.settle(&self.cycle.regime, self.tolerance, MOST_CYCLES).map_err(words)?;
        drop(survey);
        let speed = turns.last().map_or(f64::NAN, |turn| turn.speed_end);
        Ok((speed, machine.count))
    }
}

impl Contestant for Settle<'_> {
    fn run(&mut self) {
        let _ = black_box(self.solve());
    }

    fn judge(&mut self) -> Verdict {
        verdict(self.solve(), self.truth)
    }
}

fn verdict(solved: Result<(f64, usize), String>, truth: f64) -> Verdict {
    match solved {
        Ok((speed, count)) => {
            let error = ((speed - truth) / truth).abs();
            Verdict { evaluations: Some(count as u64), error: Some(error), failure: None }
        }
        Err(why) => Verdict::failed(&why),
    }
}

/// An equation of motion that counts how often it is asked.
#[derive(Debug)]
struct Counted<M> {
    motion: M,
    count: usize,
}

impl<M: Motion> Motion for Counted<M> {
    fn dependence(&self) -> Dependence {
        self.motion.dependence()
    }

    fn enter(&mut self, state: &State) -> Result<Piece, MotionError> {
        self.motion.enter(state)
    }

    fn reduced(&mut self, state: &State) -> Result<Reduced, MotionError> {
        self.count += 1;
        self.motion.reduced(state)
    }
}

/// Why a stage of a steady scene has no figures.
pub(crate) fn unfound(why: &str) -> Field<'static> {
    let row = Row::new(Stage::Steady, Unit::Run, "shooting", Setting::default());
    let reference = Reference { how: "none: no regime was found".to_owned(), error: 0.0 };
    Field { reference, entries: vec![Entry::refused(row, why)] }
}
