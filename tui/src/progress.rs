//! Progress of a long calculation, in words and as a line on standard error.

use std::ops::ControlFlow;
use std::time::Duration;

use assur_analysis::Progress;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::number::plain;

/// A calculation that ends sooner shows no line.
const PATIENCE: Duration = Duration::from_secs(1);

/// Progress of an analysis.
pub(crate) fn words(progress: Progress) -> String {
    match progress {
        Progress::Motion { time, cycles } => format!("turn {}, t = {} s", cycles + 1, plain(time)),
        Progress::Regime { evaluations } => format!("steady regime, {evaluations} evaluations"),
        Progress::Positions { done, total } => format!("position {done} of {total}"),
        Progress::Writing { done, total } => format!("writing position {done} of {total}"),
        Progress::Samples { done, total } => format!("instant {done} of {total} of the motion"),
        Progress::Checks { done, total } => format!("checks, {done} of {total}"),
        _ => String::new(),
    }
}

/// A line on standard error that shows the progress of a calculation; none if standard error is no terminal. Dropping
/// it removes the line.
pub(crate) struct ProgressLine(ProgressBar);

impl ProgressLine {
    /// Words, and the time that has passed.
    pub(crate) fn new() -> Self {
        Self::with(None, "{msg} ({elapsed})")
    }

    /// A bar that fills up to a total, with the rate and the time left; `done` are there from the beginning.
    pub(crate) fn counting(done: usize, total: usize) -> Self {
        let line =
            Self::with(Some(total as u64), "{wide_bar} {human_pos} of {human_len}, {per_sec}, {eta} left");
        line.0.set_position(done as u64);
        line.0.reset_eta();
        line
    }

    fn with(total: Option<u64>, template: &'static str) -> Self {
        let bar =
            ProgressBar::with_draw_target(total, ProgressDrawTarget::hidden()).with_message("calculating");
        let line = bar.clone();
        std::thread::spawn(move || {
            std::thread::sleep(PATIENCE);
            if !line.is_finished() {
                let style = ProgressStyle::with_template(template);
                line.set_style(style.unwrap_or_else(|_| ProgressStyle::default_spinner()));
                line.set_draw_target(ProgressDrawTarget::stderr());
                // The time on the line advances even while a calculation reports nothing.
                line.enable_steady_tick(PATIENCE);
            }
        });
        Self(bar)
    }

    /// Updates the progress.
    pub(crate) fn show(&self, text: impl FnOnce() -> String) {
        if self.0.elapsed() >= PATIENCE {
            self.0.set_message(text());
        }
    }

    /// How far it is.
    pub(crate) fn count(&self, done: usize) {
        self.0.set_position(done as u64);
    }

    /// For an analysis that is never stopped.
    pub(crate) fn watch(&self) -> impl FnMut(Progress) -> ControlFlow<()> + '_ {
        |progress| {
            self.show(|| words(progress));
            ControlFlow::Continue(())
        }
    }
}

impl Drop for ProgressLine {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
