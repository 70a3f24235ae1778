//! What is done beside the screen: reading, compiling, calculating.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::Sender;
use std::thread;

use super::menu::SCENES;
use super::session::Event;
use super::study::{Source, Study};
use super::terminal::WORKER;
use super::text::{ENGLISH, fill};

/// What the worker is asked.
#[derive(Debug)]
pub(crate) enum Job {
    /// Read a scene (again).
    Open(Source),
    /// Compile a shipped scene for its picture.
    Preview(usize),
}

/// What the worker found.
#[derive(Debug)]
pub(crate) enum Report {
    /// A scene, or its faults.
    Opened(Result<Box<Study>, String>),
    /// A shipped scene by its number.
    Preview(usize, Result<Box<Study>, String>),
}

/// Starts a job; the report comes as an event.
pub(crate) fn start(job: Job, sender: Sender<Event>) {
    let beside = thread::Builder::new().name(WORKER.into()).spawn(move || {
        let report = catch_unwind(AssertUnwindSafe(|| run(&job))).unwrap_or_else(|panic| {
            let what = panic.downcast_ref::<String>().map_or("", String::as_str);
            let what = panic.downcast_ref::<&str>().copied().unwrap_or(what);
            Report::Opened(Err(fill(ENGLISH.worker_failed, &[&what])))
        });
        // Where nobody listens any more the program is leaving.
        let _ = sender.send(Event::Work(report));
    });
    drop(beside);
}

fn run(job: &Job) -> Report {
    match job {
        Job::Open(source) => Report::Opened(open(source.clone()).map(Box::new)),
        Job::Preview(index) => {
            let study = SCENES.get(*index).ok_or_else(String::new);
            let study = study.and_then(|(name, text)| Study::read(Source::Shipped(name), text));
            Report::Preview(*index, study.map(Box::new))
        }
    }
}

/// Reads a scene from where it is.
///
/// # Errors
///
/// The faults as text.
pub(crate) fn open(source: Source) -> Result<Study, String> {
    let text = match &source {
        Source::File(path) => std::fs::read_to_string(path)
            .map_err(|error| fill(ENGLISH.unreadable, &[&path.display(), &error]))?,
        Source::Shipped(name) => {
            SCENES.iter().find(|(known, _)| known == name).map(|(_, text)| (*text).to_owned()).unwrap_or_default()
        }
    };
    Study::read(source, &text)
}
