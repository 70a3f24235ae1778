//! The work of the worker thread: reading, compiling, calculating.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::{Duration, Instant};

use assur_analysis::{Coverage, Options};
use assur_note::Form;
use assur_study::chart;
use assur_study::stability::stability;
use assur_words::{Describe, Text, number, text};

use super::state::{CalculationRequest, Cancel, Job, Measured, Outcome, Purpose, Report, Scene, Wanted};
use crate::progress::{clock, told};
use crate::session::{Session, Source};

/// Time between two updates of the progress.
const PAUSE: Duration = Duration::from_millis(150);

pub(crate) fn failed(job: &Job, text: Text) -> Report {
    match job {
        Job::Read(wanted) => Report::Read(wanted.clone(), Err(text)),
        Job::Note { path, .. } => Report::Noted(path.clone(), Err(text)),
        Job::Calculate(request) => Report::Calculated(request.number, Outcome::Failed(text)),
    }
}

pub(crate) fn run(job: &Job, tell: &dyn Fn(Report)) -> Report {
    match job {
        Job::Read(wanted) => {
            let scene = match wanted {
                Wanted::Open(source) => Session::open(source.clone()),
                Wanted::Compare(source, positions) => Session::open(source.clone()).map(|mut session| {
                    // Both scenes have a position at the same part of their way.
                    session.mechanism.input.positions = *positions;
                    session
                }),
                Wanted::Preview(name) => Session::open(Source::Shipped(name)),
                Wanted::Change(change) => {
                    let text = change.readable.to_string();
                    let source = change.source.clone();
                    match &change.session {
                        Some(session) => session.changed(text).map(|mut session| {
                            session.source = source;
                            session
                        }),
                        None => Session::read(source, text),
                    }
                }
            };
            let mut scene = scene.and_then(Scene::of).map(Box::new);
            // Forces and motion of a second scene are compared too.
            if let (Wanted::Compare(..), Ok(scene)) = (wanted, &mut scene) {
                let found = scene.session.found(&Options::default(), &mut assur_analysis::unwatched);
                if let Ok(found) = found {
                    scene.take(Box::new(found));
                }
            }
            Report::Read(wanted.clone(), scene)
        }
        Job::Note { session, options, path } => Report::Noted(path.clone(), note(session, options)),
        Job::Calculate(request) => {
            let tell = |outcome| tell(Report::Calculated(request.number, outcome));
            let count = |count| tell(Outcome::Count(count));
            let mut watch = Watch { cancel: &request.cancel, tell: &count, last: Instant::now() };
            let last = if request.purpose == Purpose::Measurement {
                Outcome::Measured(Box::new(measure(request, &mut watch)))
            } else {
                analyze(request, &mut watch, &tell)
            };
            Report::Calculated(request.number, last)
        }
    }
}

/// The explanatory note of a scene.
fn note(session: &Session, options: &Options) -> Result<String, Text> {
    let results = session.analyzed(options, true, &mut assur_analysis::unwatched)?;
    assur_note::write(&results, &session.note, Form::Html, "").map(|written| written.text)
}

/// Calculates a scene and reports the results, then checks them; results for a difference are not checked.
fn analyze(request: &CalculationRequest, watch: &mut Watch<'_>, tell: &dyn Fn(Outcome)) -> Outcome {
    let mut watch = |progress| watch.see(|| told(progress));
    let found = match request.session.found(&request.options, &mut watch) {
        Ok(found) => found,
        Err(error) => return Outcome::Failed(error.describe()),
    };
    let whole = Arc::clone(found.plans.calculation());
    let found = Outcome::Found(Box::new(found));
    if request.purpose == Purpose::Difference {
        return found;
    }
    tell(found);
    let checks = whole.checks(Coverage::Sample, &mut watch);
    Outcome::Checks(checks.unwrap_or_default())
}

/// Measures the methods; finished measurements are kept after a stop.
fn measure(request: &CalculationRequest, watch: &mut Watch<'_>) -> Measured {
    let session = &request.session;
    let mut see = |now: chart::Progress| {
        watch.see(|| {
            let [done, total] = [now.done, now.total].map(number);
            text!("measure-progress", stage = now.stage.heading(), done = done, total = total)
        })
    };
    let chart = match session.linkage() {
        Ok(linkage) => chart::chart(&linkage, &mut clock(), chart::ChartOptions::QUICK, &mut see)
            .map_err(|error| error.describe()),
        Err(error) => Err(error.describe()),
    };
    let stability = request.cancel.flow().is_continue().then(|| {
        stability(session.mechanism.clone(), &mut |done, total| {
            watch.see(|| text!("measure-stability", done = number(done), total = number(total)))
        })
        .continue_value()
    });
    Measured { chart, stability: stability.flatten().map(|found| found.map_err(|error| error.describe())) }
}

/// Watches a calculation: passes on its progress now and then, and stops it when requested.
struct Watch<'a> {
    cancel: &'a Cancel,
    tell: &'a dyn Fn(Text),
    last: Instant,
}

impl Watch<'_> {
    /// One piece of work, and how to express its progress.
    fn see(&mut self, count: impl FnOnce() -> Text) -> ControlFlow<()> {
        if self.last.elapsed() >= PAUSE {
            self.last = Instant::now();
            (self.tell)(count());
        }
        self.cancel.flow()
    }
}
