//! The work of the worker thread: reading, compiling, calculating.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::{Duration, Instant};

use assur_analysis::results::Checks;
use assur_analysis::{Calculation, Coverage, Options};
use assur_fixtures::SCENES;
use assur_mechanism::Mechanism;
use assur_study::chart;
use assur_study::stability::stability;
use assur_words::{Describe, Text, name, number, text};

use super::state::{Cancel, Found, Job, Measured, Planner, Purpose, Report, Request, Scene, Source, Wanted};
use crate::files;
use crate::progress::{SystemClock, told};

/// Time between two updates of the progress.
const PAUSE: Duration = Duration::from_millis(150);

/// The report of a job that failed.
pub(crate) fn failed(job: &Job, text: Text) -> Report {
    match job {
        Job::Read(wanted) => Report::Read(wanted.clone(), Err(text)),
        Job::Note { path, .. } => Report::Noted(path.clone(), Err(text)),
        Job::Calculate(Request { number, purpose: Purpose::Measurement, .. }) => {
            Report::Measured { number: *number, measured: Err(text) }
        }
        Job::Calculate(Request { number, .. }) => Report::Analyzed { number: *number, found: Err(text) },
    }
}

/// Performs a job; its reports are passed to `tell`.
pub(crate) fn run(job: &Job, tell: &dyn Fn(Report)) -> Report {
    match job {
        Job::Read(wanted) => {
            let scene = match wanted {
                Wanted::Open(source) | Wanted::Compare(source) => open(source.clone()),
                Wanted::Preview(index) => {
                    open(Source::Shipped(SCENES.get(*index).map_or("", |(name, _)| name)))
                }
                Wanted::Change(change) => Scene::read(change.source.clone(), &change.text),
            };
            Report::Read(wanted.clone(), scene.map(Box::new))
        }
        Job::Note { write, name, text, methods, path } => {
            Report::Noted(path.clone(), write(name, text, methods.clone()))
        }
        Job::Calculate(request) => {
            let number = request.number;
            let mut watch = Watch {
                cancel: &request.cancel,
                tell: &|count| tell(Report::Counted { number, count }),
                last: Instant::now(),
            };
            if request.purpose == Purpose::Measurement {
                Report::Measured { number, measured: Ok(Box::new(measure(request, &mut watch))) }
            } else {
                analyze(request, &mut watch, tell)
            }
        }
    }
}

/// Reads a scene from its source.
///
/// # Errors
///
/// The errors as text.
pub(crate) fn open(source: Source) -> Result<Scene, Text> {
    let text = match &source {
        Source::File(path) => files::read(path).map_err(|error| error.describe())?,
        Source::Shipped(name) => {
            let scene = SCENES.iter().find(|(known, _)| known == name);
            scene.map(|(_, text)| (*text).to_owned()).unwrap_or_default()
        }
    };
    Scene::read(source, &text)
}

/// Calculates a scene and reports the results, then checks them; results for a difference are not checked.
fn analyze(request: &Request, watch: &mut Watch<'_>, tell: &dyn Fn(Report)) -> Report {
    let (mechanism, number) = (&request.linkage.mechanism, request.number);
    let options = Options { analyzer: request.analyzer.clone(), integrator: request.integrator.clone() };
    let mut watch = |progress| watch.see(|| told(progress));
    let failed = |text: Text| Report::Analyzed { number, found: Err(text) };
    let calculation = match Calculation::of(mechanism.clone(), &options, &mut watch) {
        Ok(calculation) => calculation,
        Err(error) => return failed(error.describe()),
    };
    let analysis = match calculation.analyze(&mut watch) {
        Ok(analysis) => analysis,
        Err(stopped) => return failed(stopped.describe()),
    };
    let analyzer = calculation.analyzer.map_or("", |plugin| plugin.name).to_owned();
    let ending = calculation.ending(&analysis.positions);
    // The whole mechanism is checked and has plans, whatever results the scene requests.
    let whole = mechanism.output.as_ref().and_then(|_| {
        let whole = Mechanism { output: None, ..mechanism.clone() };
        Calculation::of(whole, &options, &mut watch).ok()
    });
    let whole = Arc::new(whole.unwrap_or(calculation));
    let planner = Planner::new(Arc::clone(&whole));
    let found = Box::new(Found::of(analyzer, analysis, ending, planner));
    let report = Report::Analyzed { number, found: Ok(found) };
    if request.purpose == Purpose::Difference {
        return report;
    }
    tell(report);
    let checks = whole.checks(Coverage::Sample, &mut watch);
    Report::Checked { number, checks: checks.unwrap_or_else(|_| Checks::none()) }
}

/// Measures the methods; finished measurements are kept after a stop.
fn measure(request: &Request, watch: &mut Watch<'_>) -> Measured {
    let (linkage, mut clock) = (&request.linkage, SystemClock::default());
    let chart = chart::chart(linkage, &mut clock, chart::Options::QUICK, &mut |now| {
        watch.see(|| {
            let [done, total] = [now.done, now.total].map(number);
            text!("measure-progress", stage = name(now.stage.heading()), done = done, total = total)
        })
    });
    let stability = request.cancel.flow().is_continue().then(|| {
        stability(linkage.mechanism.clone(), &mut |done, total| {
            watch.see(|| text!("measure-stability", done = number(done), total = number(total)))
        })
        .continue_value()
    });
    Measured {
        chart: chart.map_err(|error| error.to_string()),
        stability: stability.flatten().map(|found| found.map_err(|error| error.to_string())),
    }
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
