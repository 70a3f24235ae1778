//! Speed against accuracy of every method, and how near the mechanism comes to a singular position: measured on request.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Instant;

use assur_kinematics::Linkage;
use assur_study::chart::{self, ChartData, Clock, Options};
use assur_study::stability::{Stability, stability};

use super::running::{Cancel, PAUSE};
use super::state::{State, Wish};
use super::text::{ENGLISH, fill};
use super::theme::Role;
use super::view::accuracy as view;
use super::work::Job;

/// What was measured of the open scene.
#[derive(Debug, Clone, Default)]
pub(crate) struct Accuracy {
    /// What was found; `None` before anything was measured.
    pub(crate) measured: Option<Box<Measured>>,
    /// How far the measurement is; `None` while none runs.
    pub(crate) progress: Option<String>,
    cancel: Cancel,
}

/// Columns by which the labels of the last decade go beyond a scatter.
const BEYOND: usize = 3;

/// The findings of a measurement.
#[derive(Debug, Clone)]
pub(crate) struct Measured {
    /// Speed against accuracy, or why there is none.
    pub(crate) chart: Result<ChartData, String>,
    /// `None` where the measurement was stopped before.
    pub(crate) stability: Option<Result<Stability, String>>,
}

impl Measured {
    /// The report in so many columns: what follows from it, speed against accuracy, stability.
    pub(crate) fn text(&self, ascii: bool, width: usize) -> String {
        let chart = match &self.chart {
            Ok(data) => chart::text(data, ascii, width.saturating_sub(BEYOND)),
            Err(error) => format!("{error}\n"),
        };
        match &self.stability {
            None => chart,
            Some(Err(error)) => format!("{chart}\n{error}\n"),
            Some(Ok(found)) => format!("{}\n{chart}\n{}", found.conclusion_text(), found.to_text()),
        }
    }
}

/// What is to be measured.
#[derive(Debug, Clone)]
pub(crate) struct Measurement {
    pub(crate) generation: usize,
    linkage: Arc<Linkage>,
    cancel: Cancel,
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
    let (generation, linkage) = (state.generation, Arc::clone(&study.linkage));
    state.wishes.push(Wish::Work(Job::Measure(Measurement { generation, linkage, cancel })));
}

/// Stops the measurement that runs; what was measured until then is shown.
pub(crate) fn stop(state: &mut State) {
    if state.accuracy.progress.is_some() {
        state.accuracy.cancel.stop();
        state.say(Role::Plain, state.texts.stopping);
    }
}

/// Scrolls the report by so many lines, as far as it goes.
pub(crate) fn scroll(state: &mut State, by: isize) {
    let last = view::last_line(state);
    state.chosen.line = state.chosen.line.min(last).saturating_add_signed(by).min(last);
}

/// Scrolls the report by a page; a line stays, to read on from.
pub(crate) fn page(state: &mut State, sense: isize) {
    let page = isize::from(i16::try_from(view::page(state)).unwrap_or(i16::MAX));
    scroll(state, sense * (page - 1).max(1));
}

/// Scrolls to the end of the report.
pub(crate) fn end(state: &mut State) {
    state.chosen.line = view::last_line(state);
}

/// Measures; `progress` is told how far it is.
pub(crate) fn run(wanted: &Measurement, progress: &dyn Fn(String)) -> Measured {
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
    Measured {
        chart: found.map_err(|error| error.to_string()),
        stability: stability_of(wanted, progress).continue_value(),
    }
}

/// How near the mechanism comes to a singular position; nothing of a study that was stopped.
fn stability_of(
    wanted: &Measurement,
    progress: &dyn Fn(String),
) -> ControlFlow<(), Result<Stability, String>> {
    wanted.cancel.flow()?;
    let mut told = Instant::now();
    let found = stability(wanted.linkage.mechanism.clone(), &mut |done, total| {
        if told.elapsed() >= PAUSE {
            told = Instant::now();
            progress(fill(ENGLISH.count_stability, &[&done, &total]));
        }
        wanted.cancel.flow()
    })?;
    ControlFlow::Continue(found.map_err(|error| error.to_string()))
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
    pub(crate) fn take_measured(
        &mut self,
        generation: usize,
        measured: Result<Box<Measured>, String>,
    ) -> bool {
        if generation != self.generation {
            return false;
        }
        self.accuracy.progress = None;
        match measured {
            Ok(measured) => {
                self.accuracy.measured = Some(measured);
                self.chosen.line = 0;
            }
            Err(text) => self.say(Role::Bad, fill(self.texts.no_analysis, &[&text])),
        }
        true
    }
}
