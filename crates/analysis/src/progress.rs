//! How far a calculation is.

use std::ops::ControlFlow;

/// Whoever asks for a calculation is told before each piece of it how far it is, and breaks to stop it.
pub type Watch<'a> = dyn FnMut(Progress) -> ControlFlow<()> + 'a;

/// A calculation was stopped by whoever watched it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("stopped on request")]
pub struct Stopped;

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

/// What is calculated at the moment, and how far it is.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Progress {
    /// A motion from an initial state is followed.
    Motion {
        /// Time that is reached, s.
        time: f64,
        /// Cycles (turns) that are done; 0 for an input without a cycle.
        cycles: usize,
    },
    /// A steady regime is searched.
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
