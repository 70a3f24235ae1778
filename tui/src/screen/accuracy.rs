//! Speed against accuracy of every method, and how near the mechanism comes to a singular position: measured on request.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use assur_kinematics::Linkage;
use assur_study::chart::{self, Clock, Options};
use assur_study::stability::stability;

use super::state::{State, Wish};
use super::text::fill;
use super::theme::Role;
use super::work::Job;

/// What was measured of the open scene.
#[derive(Debug, Clone, Default)]
pub(crate) struct Accuracy {
    /// The report, a line each; empty before anything was measured.
    pub(crate) lines: Vec<String>,
    /// How far the measurement is; `None` while none runs.
    pub(crate) progress: Option<String>,
    /// Tells the worker to stop.
    cancel: Arc<AtomicBool>,
}

/// What is to be measured.
#[derive(Debug, Clone)]
pub(crate) struct Measurement {
    pub(crate) generation: usize,
    linkage: Arc<Linkage>,
    cancel: Arc<AtomicBool>,
    ascii: bool,
}

struct SystemClock(Instant);

impl Clock for SystemClock {
    fn seconds(&mut self) -> f64 {
        self.0.elapsed().as_secs_f64()
    }
}

/// Starts a measurement, or stops the one that runs.
pub(crate) fn measure(state: &mut State) {
    if state.accuracy.progress.is_some() {
        return stop(state);
    }
    let Some(study) = &state.study else { return };
    let cancel = Arc::new(AtomicBool::new(false));
    state.accuracy.cancel = Arc::clone(&cancel);
    state.accuracy.progress = Some(state.texts.calculating.to_owned());
    let (generation, linkage, ascii) = (state.generation, Arc::clone(&study.linkage), state.look.ascii);
    state.wishes.push(Wish::Work(Job::Measure(Measurement { generation, linkage, cancel, ascii })));
}

/// Stops the measurement that runs; what was measured until then is shown.
pub(crate) fn stop(state: &mut State) {
    if state.accuracy.progress.is_some() {
        state.accuracy.cancel.store(true, Ordering::Relaxed);
        state.say(Role::Plain, state.texts.stopping);
    }
}

/// Scrolls the report.
pub(crate) fn scroll(state: &mut State, by: isize) {
    let last = state.accuracy.lines.len().saturating_sub(1);
    state.chosen.line = state.chosen.line.saturating_add_signed(by).min(last);
}

/// Measures; `progress` is told how far it is.
pub(crate) fn run(wanted: &Measurement, progress: &dyn Fn(String)) -> Vec<String> {
    let mut clock = SystemClock(Instant::now());
    let mut told = 0.0;
    let found = chart::chart(&wanted.linkage, &mut clock, Options::QUICK, &mut |now| {
        // Four counts a second are enough to see that it goes on.
        let count = (now.done * 1000).checked_div(now.total).unwrap_or(0) as f64;
        if (count - told).abs() >= 50.0 {
            told = count;
            progress(format!("{}: {} / {}", now.stage.heading(), now.done, now.total));
        }
        if wanted.cancel.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    let mut text = match found {
        Ok(data) => chart::text(&data, wanted.ascii),
        Err(error) => format!("{error}\n"),
    };
    if !wanted.cancel.load(Ordering::Relaxed) {
        text.push('\n');
        match stability(wanted.linkage.mechanism.clone()) {
            Ok(found) => text.push_str(&found.to_text()),
            Err(error) => text.push_str(&error.to_string()),
        }
    }
    text.lines().map(str::to_owned).collect()
}

impl State {
    /// Takes a count of a measurement; tells whether the frame may differ.
    pub(crate) fn take_progress(&mut self, generation: usize, count: String) -> bool {
        let fits = generation == self.generation && self.accuracy.progress.is_some();
        if fits {
            self.accuracy.progress = Some(count);
        }
        fits
    }

    /// Takes what was measured, unless it belongs to a scene opened before.
    pub(crate) fn take_measured(&mut self, generation: usize, lines: Result<Vec<String>, String>) -> bool {
        if generation != self.generation {
            return false;
        }
        self.accuracy.progress = None;
        match lines {
            Ok(lines) => self.accuracy.lines = lines,
            Err(text) => self.say(Role::Bad, fill(self.texts.no_analysis, &[&text])),
        }
        true
    }
}
