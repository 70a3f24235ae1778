//! An analysis that runs beside: how far it is, and the sign that stops it.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use assur_analysis::Progress;

use super::number::plain;
use super::state::State;
use super::text::{ENGLISH, fill};

/// Time between two counts that are shown.
pub(crate) const PAUSE: Duration = Duration::from_millis(150);

/// A sign that is seen by the worker.
#[derive(Debug, Clone, Default)]
pub(crate) struct Cancel(Arc<AtomicBool>);

impl Cancel {
    pub(crate) fn stop(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    pub(crate) fn is_stopped(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    /// What a calculation is answered that asks whether to go on.
    pub(crate) fn flow(&self) -> ControlFlow<()> {
        if self.is_stopped() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

/// An analysis that runs.
#[derive(Debug, Clone)]
pub(crate) struct Running {
    /// Of the request; an answer to another one is dropped.
    pub(crate) number: usize,
    /// Whether it is only compared with the main one.
    pub(crate) other: bool,
    /// How far it is; empty at the start.
    pub(crate) count: String,
    pub(crate) cancel: Cancel,
}

impl Running {
    /// That it runs, how far it is, and the key that stops it.
    pub(crate) fn words(&self, state: &State) -> String {
        let key = state.keys.first("close");
        match self.count.as_str() {
            "" => fill(state.texts.calculating, &[&key]),
            count => fill(state.texts.calculating_count, &[&count, &key]),
        }
    }
}

/// Watches a calculation: passes a count on now and then, and stops it when asked.
pub(crate) struct Watch<'a> {
    cancel: &'a Cancel,
    tell: &'a dyn Fn(String),
    last: Instant,
}

impl<'a> Watch<'a> {
    pub(crate) fn new(cancel: &'a Cancel, tell: &'a dyn Fn(String)) -> Self {
        Self { cancel, tell, last: Instant::now() }
    }

    /// One piece of work.
    pub(crate) fn see(&mut self, progress: Progress) -> ControlFlow<()> {
        if self.last.elapsed() >= PAUSE {
            self.last = Instant::now();
            (self.tell)(words(progress));
        }
        self.cancel.flow()
    }
}

/// How far it is, in words.
fn words(progress: Progress) -> String {
    let t = &ENGLISH;
    match progress {
        Progress::Motion { time, cycles } => fill(t.count_motion, &[&(cycles + 1), &plain(time)]),
        Progress::Regime { evaluations } => fill(t.count_regime, &[&evaluations]),
        Progress::Positions { done, total } => fill(t.count_positions, &[&done, &total]),
        Progress::Samples { done, total } => fill(t.count_instants, &[&done, &total]),
        Progress::Checks { done, total } => fill(t.count_checks, &[&done, &total]),
        _ => String::new(),
    }
}
