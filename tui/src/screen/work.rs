//! What is done beside the screen: reading, compiling, calculating.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::mpsc::Sender;
use std::thread;

use assur_analysis::results::Check;
use assur_kinematics::Linkage;
use assur_mechanism::Mechanism;

use super::accuracy::{self, Measured, Measurement};
use super::found::Found;
use super::menu::SCENES;
use super::plans::Planner;
use super::running::{Cancel, Watch};
use super::session::Event;
use super::study::{Source, Study};
use super::terminal::WORKER;
use super::text::{ENGLISH, fill};
use super::whatif::Change;

/// What the worker is asked.
#[derive(Debug)]
pub(crate) enum Job {
    /// Read a scene (again).
    Open(Source),
    /// Read a second scene, to be compared.
    Compare(Source),
    /// Compile a shipped scene for its picture.
    Preview(usize),
    /// Read the open scene with other numbers in it.
    Change(Change),
    /// Calculate all that a scene asks for.
    Analyze(Request),
    /// Measure the methods.
    Measure(Measurement),
}

/// Which analysis.
#[derive(Debug, Clone)]
pub(crate) struct Request {
    /// An answer to another one than the last is dropped.
    pub(crate) number: usize,
    pub(crate) linkage: Arc<Linkage>,
    pub(crate) analyzer: Option<String>,
    pub(crate) integrator: Option<String>,
    /// Whether it is only compared with the main one.
    pub(crate) other: bool,
    pub(crate) cancel: Cancel,
}

/// What the worker found.
#[derive(Debug)]
pub(crate) enum Report {
    /// A scene, or its faults.
    Opened(Result<Box<Study>, String>),
    /// The open scene with other numbers, or why that is none.
    Changed(Change, Result<Box<Study>, String>),
    /// A second scene, or its faults.
    Compared(Result<Box<Study>, String>),
    /// A shipped scene by its number.
    Preview(usize, Result<Box<Study>, String>),
    /// How far a measurement is.
    Progress { generation: usize, count: String },
    /// What was measured.
    Measured { generation: usize, measured: Result<Box<Measured>, String> },
    /// An analysis, or why there is none.
    Analyzed { number: usize, found: Result<Box<Found>, String> },
    /// The checks of an analysis that was given before.
    Checked { number: usize, checks: Vec<Check> },
    /// How far an analysis is.
    Counted { number: usize, count: String },
}

/// Starts a job; the report comes as an event.
pub(crate) fn start(job: Job, sender: Sender<Event>) {
    let beside = thread::Builder::new().name(WORKER.into()).spawn(move || {
        let report =
            catch_unwind(AssertUnwindSafe(|| run(&job, &|report| drop(sender.send(Event::Work(report))))))
                .unwrap_or_else(|panic| {
                    let what = panic.downcast_ref::<String>().map_or("", String::as_str);
                    let what = panic.downcast_ref::<&str>().copied().unwrap_or(what);
                    failed(&job, fill(ENGLISH.worker_failed, &[&what]))
                });
        // Where nobody listens any more the program is leaving.
        let _ = sender.send(Event::Work(report));
    });
    drop(beside);
}

fn failed(job: &Job, text: String) -> Report {
    match job {
        Job::Open(_) => Report::Opened(Err(text)),
        Job::Change(change) => Report::Changed(change.clone(), Err(text)),
        Job::Compare(_) => Report::Compared(Err(text)),
        Job::Preview(index) => Report::Preview(*index, Err(text)),
        Job::Measure(wanted) => Report::Measured { generation: wanted.generation, measured: Err(text) },
        Job::Analyze(request) => Report::Analyzed { number: request.number, found: Err(text) },
    }
}

/// Does a job; what it reports on the way goes to `tell`.
pub(crate) fn run(job: &Job, tell: &dyn Fn(Report)) -> Report {
    match job {
        Job::Open(source) => Report::Opened(open(source.clone()).map(Box::new)),
        Job::Change(change) => {
            let study = Study::read(change.source.clone(), &change.text);
            Report::Changed(change.clone(), study.map(Box::new))
        }
        Job::Compare(source) => Report::Compared(open(source.clone()).map(Box::new)),
        Job::Preview(index) => {
            let study = SCENES.get(*index).ok_or_else(String::new);
            let study = study.and_then(|(name, text)| Study::read(Source::Shipped(name), text));
            Report::Preview(*index, study.map(Box::new))
        }
        Job::Measure(wanted) => {
            let generation = wanted.generation;
            let measured = accuracy::run(wanted, &|count| tell(Report::Progress { generation, count }));
            Report::Measured { generation, measured: Ok(Box::new(measured)) }
        }
        Job::Analyze(request) => analyze(request, tell),
    }
}

/// Calculates a scene and gives what was found, then checks it; one that is only compared is not checked.
fn analyze(request: &Request, tell: &dyn Fn(Report)) -> Report {
    use assur_analysis::{Calculation, Options};
    let (mechanism, number) = (&request.linkage.mechanism, request.number);
    let options = Options { analyzer: request.analyzer.clone(), integrator: request.integrator.clone() };
    let count = |count| tell(Report::Counted { number, count });
    let mut watch = Watch::new(&request.cancel, &count);
    let mut watch = |progress| watch.see(progress);
    let failed = |text: String| Report::Analyzed { number, found: Err(text) };
    let study = match Calculation::of(mechanism.clone(), &options, &mut watch) {
        Ok(study) => study,
        Err(error) => return failed(error.to_string()),
    };
    let analysis = match study.analyze(&mut watch) {
        Ok(analysis) => analysis,
        Err(stopped) => return failed(stopped.to_string()),
    };
    let analyzer = study.analyzer.map_or("", |plugin| plugin.name).to_owned();
    // The whole mechanism is checked and has plans, whatever the scene asks for.
    let whole = mechanism.output.as_ref().and_then(|_| {
        let whole = Mechanism { output: None, ..mechanism.clone() };
        Calculation::of(whole, &options, &mut watch).ok()
    });
    let whole = Arc::new(whole.unwrap_or(study));
    let planner = Planner::new(Arc::clone(&whole));
    let found = Box::new(Found::of(analyzer, analysis, planner, mechanism.input.positions));
    let report = Report::Analyzed { number, found: Ok(found) };
    if request.other {
        return report;
    }
    tell(report);
    let checks = whole.checks(&mut watch);
    Report::Checked { number, checks: checks.unwrap_or_default() }
}

/// Reads a scene from where it is.
///
/// # Errors
///
/// The faults as text.
pub(crate) fn open(source: Source) -> Result<Study, String> {
    let text = match &source {
        Source::File(path) => crate::cli::text_of(path).map_err(|fault| fault.to_string())?,
        Source::Shipped(name) => SCENES
            .iter()
            .find(|(known, _)| known == name)
            .map(|(_, text)| (*text).to_owned())
            .unwrap_or_default(),
    };
    Study::read(source, &text)
}
