//! Speed against accuracy of every method, and how near the mechanism comes to a singular position: measured on request.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Instant;

use assur_kinematics::Linkage;
use assur_study::chart::{self, Clock, Options};
use assur_study::stability::stability_watched;

use super::running::{Cancel, PAUSE};
use super::state::{State, Wish};
use super::text::{ENGLISH, fill};
use super::theme::Role;
use super::work::Job;

/// What was measured of the open scene.
#[derive(Debug, Clone, Default)]
pub(crate) struct Accuracy {
    /// The report, a line each; empty before anything was measured.
    pub(crate) lines: Vec<String>,
    /// How far the measurement is; `None` while none runs.
    pub(crate) progress: Option<String>,
    cancel: Cancel,
}

/// What is to be measured.
#[derive(Debug, Clone)]
pub(crate) struct Measurement {
    pub(crate) generation: usize,
    linkage: Arc<Linkage>,
    cancel: Cancel,
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
    let cancel = Cancel::default();
    state.accuracy.cancel = cancel.clone();
    state.accuracy.progress = Some(state.texts.measuring.to_owned());
    let (generation, linkage, ascii) = (state.generation, Arc::clone(&study.linkage), state.look.ascii);
    state.wishes.push(Wish::Work(Job::Measure(Measurement { generation, linkage, cancel, ascii })));
}

/// Stops the measurement that runs; what was measured until then is shown.
pub(crate) fn stop(state: &mut State) {
    if state.accuracy.progress.is_some() {
        state.accuracy.cancel.stop();
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
        wanted.cancel.flow()
    });
    let mut text = match found {
        Ok(data) => chart::text(&data, wanted.ascii),
        Err(error) => format!("{error}\n"),
    };
    if let ControlFlow::Continue(found) = stability_of(wanted, progress) {
        text.push('\n');
        text.push_str(&found);
    }
    text.lines().map(str::to_owned).collect()
}

/// How near the mechanism comes to a singular position; nothing of a study that was stopped.
fn stability_of(wanted: &Measurement, progress: &dyn Fn(String)) -> ControlFlow<(), String> {
    wanted.cancel.flow()?;
    let mut told = Instant::now();
    let found = stability_watched(wanted.linkage.mechanism.clone(), &mut |done, total| {
        if told.elapsed() >= PAUSE {
            told = Instant::now();
            progress(fill(ENGLISH.count_stability, &[&done, &total]));
        }
        wanted.cancel.flow()
    })?;
    ControlFlow::Continue(found.map_or_else(|error| error.to_string(), |found| found.to_text()))
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
