//! The clock of this machine; progress of a long calculation, in words and as a line on standard error.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use assur_analysis::Progress;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::number::plain;

/// A calculation that ends sooner shows no line.
const PATIENCE: Duration = Duration::from_secs(1);
/// The line of work that can't be counted.
const UNCOUNTED: &str = "{msg} ({elapsed})";
/// The line of work that is counted.
const COUNTED: &str = "{msg} {wide_bar} {human_pos} of {human_len}, {per_sec}, {eta} left";

/// Progress of an analysis: what is done, and how much of how much where it can be counted.
fn counted(progress: Progress) -> (String, Option<[usize; 2]>) {
    match progress {
        Progress::Motion { time, cycles } => {
            (format!("turn {}, t = {} s", cycles.saturating_add(1), plain(time)), None)
        }
        Progress::Regime { evaluations } => (format!("steady regime, {evaluations} evaluations"), None),
        Progress::Positions { done, total } => ("position".to_owned(), Some([done, total])),
        Progress::Writing { done, total } => ("writing position".to_owned(), Some([done, total])),
        Progress::Samples { done, total } => ("instant of the motion".to_owned(), Some([done, total])),
        Progress::Checks { done, total } => ("checks".to_owned(), Some([done, total])),
        _ => (String::new(), None),
    }
}

/// Progress of an analysis in words.
pub(crate) fn words(progress: Progress) -> String {
    match counted(progress) {
        (what, Some([done, total])) => format!("{what} {done} of {total}"),
        (what, None) => what,
    }
}

/// A line on standard error that shows the progress of a calculation, with its rate and the time left where it can be
/// counted; none if standard error is no terminal. Dropping it removes the line.
pub(crate) struct ProgressLine {
    bar: ProgressBar,
    since: Instant,
}

impl ProgressLine {
    pub(crate) fn new() -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden())
            .with_message("calculating")
            .with_style(style(UNCOUNTED));
        let line = bar.clone();
        std::thread::spawn(move || {
            std::thread::sleep(PATIENCE);
            if !line.is_finished() {
                line.set_draw_target(ProgressDrawTarget::stderr());
                // The time on the line advances even while a calculation reports nothing.
                line.enable_steady_tick(PATIENCE);
            }
        });
        Self { bar, since: Instant::now() }
    }

    /// Updates the progress: `done` of `total` of something.
    pub(crate) fn count(&self, what: &str, done: usize, total: usize) {
        let total = total as u64;
        if self.bar.length() != Some(total) || self.bar.message() != what {
            self.bar.set_style(style(COUNTED));
            self.bar.set_message(what.to_owned());
            self.bar.set_length(total);
            self.bar.set_position(done as u64);
            // What is done from the beginning has no rate.
            self.bar.reset_eta();
            return;
        }
        self.bar.set_position(done as u64);
    }

    /// For an analysis that is never stopped.
    pub(crate) fn watch(&self) -> impl FnMut(Progress) -> ControlFlow<()> + '_ {
        |progress| {
            match counted(progress) {
                (what, Some([done, total])) => self.count(&what, done, total),
                (what, None) if self.since.elapsed() >= PATIENCE => {
                    self.bar.set_style(style(UNCOUNTED));
                    self.bar.set_message(what);
                }
                _ => {}
            }
            ControlFlow::Continue(())
        }
    }
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_spinner())
}

impl Drop for ProgressLine {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

/// Seconds since it was made.
pub(crate) struct SystemClock(Instant);

impl Default for SystemClock {
    fn default() -> Self {
        Self(Instant::now())
    }
}

impl assur_study::chart::Clock for SystemClock {
    fn seconds(&mut self) -> f64 {
        self.0.elapsed().as_secs_f64()
    }
}
