//! The clock of this machine; progress of a long calculation, in words and as a line on standard error.

use std::fmt;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use assur_analysis::Progress;
use assur_words::{Language, Text, number, quantity, text};
use indicatif::{HumanCount, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};

use crate::number::plain;

/// A calculation that ends sooner shows no line.
const PATIENCE: Duration = Duration::from_secs(1);
/// Between two texts of the line at least: a calculation may report a million times.
const TEXTS: Duration = Duration::from_millis(100);
const UNCOUNTED: &str = "{msg} ({since})";
const COUNTED: &str = "{msg} {wide_bar} {counted}";

/// Progress of an analysis: what is done, and how much of how much where it can be counted.
fn counted(progress: Progress) -> (Text, Option<[usize; 2]>) {
    match progress {
        Progress::Motion { time, cycles } => {
            let (turn, time) = (number(cycles.saturating_add(1)), quantity(plain(time), "s"));
            (text!("progress-turn", turn, time), None)
        }
        Progress::Regime { evaluations } => (text!("progress-regime", count = number(evaluations)), None),
        Progress::Positions { done, total } => (text!("progress-position"), Some([done, total])),
        Progress::Writing { done, total } => (text!("progress-writing"), Some([done, total])),
        Progress::Samples { done, total } => (text!("progress-instant"), Some([done, total])),
        Progress::Checks { done, total } => (text!("progress-checks"), Some([done, total])),
    }
}

pub(crate) fn told(progress: Progress) -> Text {
    match counted(progress) {
        (what, Some([done, total])) => {
            text!("progress-of", what, done = number(done), total = number(total))
        }
        (what, None) => what,
    }
}

/// A line on standard error that shows the progress of a calculation, with its rate and the time left where it can be
/// counted; none if standard error is no terminal. Dropping it removes the line.
pub(crate) struct ProgressLine {
    bar: ProgressBar,
    since: Instant,
    language: &'static Language,
}

impl ProgressLine {
    pub(crate) fn new(language: &'static Language) -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden())
            .with_message(text!("progress-calculating").render(language))
            .with_style(style(UNCOUNTED, language));
        let line = bar.clone();
        std::thread::spawn(move || {
            std::thread::sleep(PATIENCE);
            if !line.is_finished() {
                line.set_draw_target(ProgressDrawTarget::stderr());
                // The time on the line advances even while a calculation reports nothing.
                line.enable_steady_tick(PATIENCE);
            }
        });
        Self { bar, since: Instant::now(), language }
    }

    /// Updates the progress: `done` of `total` of something.
    pub(crate) fn count(&self, what: &Text, done: usize, total: usize) {
        let (what, total) = (what.render(self.language), total as u64);
        if self.bar.length() != Some(total) || self.bar.message() != what {
            self.bar.set_style(style(COUNTED, self.language));
            self.bar.set_message(what);
            self.bar.set_length(total);
            self.bar.set_position(done as u64);
            // What is done from the beginning has no rate.
            self.bar.reset_eta();
            return;
        }
        self.bar.set_position(done as u64);
    }

    pub(crate) fn watch(&self) -> impl FnMut(Progress) -> ControlFlow<()> + '_ {
        let mut next = PATIENCE;
        move |progress| {
            let is_due = || self.since.elapsed() >= next;
            match progress {
                Progress::Motion { .. } | Progress::Regime { .. } if !is_due() => {}
                _ => match counted(progress) {
                    (what, Some([done, total])) => self.count(&what, done, total),
                    (what, None) => {
                        self.bar.set_style(style(UNCOUNTED, self.language));
                        self.bar.set_message(what.render(self.language));
                        next = self.since.elapsed() + TEXTS;
                    }
                },
            }
            ControlFlow::Continue(())
        }
    }
}

fn style(template: &str, language: &'static Language) -> ProgressStyle {
    let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_spinner());
    let counted = move |state: &ProgressState, out: &mut dyn fmt::Write| {
        let [done, all] = [state.pos(), state.len().unwrap_or(0)].map(|count| number(HumanCount(count)));
        let rate = quantity(plain(state.per_sec()), "1/s");
        let line = text!("progress-counted", done, all, rate, left = lasting(state.eta()));
        let _ = out.write_str(&line.render(language));
    };
    let since = move |state: &ProgressState, out: &mut dyn fmt::Write| {
        let _ = out.write_str(&lasting(state.elapsed()).render(language));
    };
    style.with_key("counted", counted).with_key("since", since)
}

/// A time in whole seconds, or in minutes.
fn lasting(time: Duration) -> Text {
    let seconds = time.as_secs();
    if seconds < 120 { quantity(seconds, "s") } else { quantity(seconds / 60, "min") }
}

impl Drop for ProgressLine {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

/// A clock, s.
pub(crate) fn clock() -> impl FnMut() -> f64 {
    let start = Instant::now();
    move || start.elapsed().as_secs_f64()
}
