//! How far a calculation is.

/// What is calculated at the moment, and how far it is.
///
/// Whoever asked for a calculation is told before each piece of it, and stops it by breaking. What nobody watches is not counted.
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
    /// The course over time is written down.
    Instants {
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
