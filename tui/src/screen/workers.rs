//! The threads of the worker: one for each kind of job.
//!
//! However often something is asked for, one job of a kind runs and the newest one waits; those between are no longer
//! needed.

#[cfg(test)]
mod tests;

use std::collections::HashMap;
use std::mem::{Discriminant, discriminant};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::{Arc, Mutex};
use std::thread;

use assur_words::{name, text};

use super::state::{Job, Purpose, Report, Wanted};
use super::terminal::WORKER;
use super::work;
use crate::lock;

/// Jobs of one kind replace each other.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
enum Kind {
    Read(Discriminant<Wanted>),
    /// The note of another file is another one.
    Note(PathBuf),
    Calculate(Purpose),
}

impl Kind {
    fn of(job: &Job) -> Self {
        match job {
            Job::Read(wanted) => Self::Read(discriminant(wanted)),
            Job::Note { path, .. } => Self::Note(path.clone()),
            Job::Calculate(request) => Self::Calculate(request.purpose),
        }
    }
}

/// The kinds of which a job runs, each with the job that follows it.
type Busy = HashMap<Kind, Option<Job>>;

pub(crate) struct Workers {
    tell: Arc<dyn Fn(Report) + Send + Sync>,
    busy: Arc<Mutex<Busy>>,
}

impl Workers {
    /// None yet; all reports are passed to `tell`.
    pub(crate) fn new(tell: impl Fn(Report) + Send + Sync + 'static) -> Self {
        Self { tell: Arc::new(tell), busy: Arc::default() }
    }

    /// Starts a job, at once or after the present one of its kind.
    pub(crate) fn start(&self, job: Job) {
        let kind = Kind::of(&job);
        let mut busy = lock(&self.busy);
        if let Some(next) = busy.get_mut(&kind) {
            *next = Some(job);
            return;
        }
        let (tell, all, own) = (Arc::clone(&self.tell), Arc::clone(&self.busy), kind.clone());
        let thread = thread::Builder::new().name(WORKER.into()).spawn(move || {
            let mut job = Some(job);
            while let Some(present) = job {
                perform(&present, &*tell);
                job = following(&all, &own);
            }
        });
        if thread.is_ok() {
            busy.insert(kind, None);
        }
    }
}

/// The job that follows one of this kind; without one, the kind is no longer busy.
fn following(busy: &Mutex<Busy>, kind: &Kind) -> Option<Job> {
    let mut busy = lock(busy);
    let next = busy.get_mut(kind)?.take();
    if next.is_none() {
        busy.remove(kind);
    }
    next
}

/// Performs a job; a panic is reported as its failure.
fn perform(job: &Job, tell: &dyn Fn(Report)) {
    let report = catch_unwind(AssertUnwindSafe(|| work::run(job, tell))).unwrap_or_else(|panic| {
        let what = panic.downcast_ref::<String>().map_or("", String::as_str);
        let what = panic.downcast_ref::<&str>().copied().unwrap_or(what);
        work::failed(job, text!("say-panic", what = name(what.to_owned())))
    });
    tell(report);
}
