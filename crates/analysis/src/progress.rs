//! Progress of a calculation.

use std::ops::ControlFlow;

use assur_words::{Describe, Text, text};

/// Called before each piece of a calculation with its progress; breaks to stop it.
pub type Watch<'a> = dyn FnMut(Progress) -> ControlFlow<()> + 'a;

/// The watcher stopped the calculation.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Stopped;

assur_words::errors!(Stopped);

impl Describe for Stopped {
    fn describe(&self) -> Text {
        text!("analysis-stopped")
    }
}

/// Lets a calculation run to its end.
///
/// # Examples
///
/// ```no_run
/// # fn f(found: &assur_analysis::Calculation) -> Result<(), assur_analysis::Stopped> {
/// let analysis = found.analyze(&mut assur_analysis::unwatched)?;
/// # Ok(()) }
/// ```
pub fn unwatched(_: Progress) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

pub(crate) fn step(watch: &mut Watch<'_>, progress: Progress) -> Result<(), Stopped> {
    if watch(progress).is_break() { Err(Stopped) } else { Ok(()) }
}

/// The piece of the calculation in work, and its progress.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Progress {
    /// The motion from an initial state is integrated.
    Motion {
        /// Time reached, s.
        time: f64,
        /// Cycles (turns) that are done; 0 for an input without a cycle.
        cycles: usize,
    },
    /// The steady regime is sought.
    Regime {
        /// How many times the equation of motion was evaluated.
        evaluations: usize,
    },
    /// The positions are calculated.
    Positions {
        /// How many are done.
        done: usize,
        /// How many there are.
        total: usize,
    },
    /// The positions are calculated again, and written.
    Writing {
        /// How many are done.
        done: usize,
        /// How many there are.
        total: usize,
    },
    /// The samples of a motion are calculated.
    Samples {
        /// How many are done.
        done: usize,
        /// How many there are.
        total: usize,
    },
    /// The numbers are checked.
    Checks {
        /// How many pieces of work are done.
        done: usize,
        /// How many there are.
        total: usize,
    },
}
