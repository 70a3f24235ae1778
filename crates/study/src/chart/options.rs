//! Options of a chart.

/// A clock that the caller provides.
pub trait Clock {
    /// Time since some fixed instant, s; never goes back.
    fn seconds(&mut self) -> f64;
}

/// How thorough the measurement is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Every second setting, few repetitions, at most [`limit`](Self::limit) in all.
    pub quick: bool,
    /// Time for repetitions in one stage, s.
    pub stage_seconds: f64,
    /// Most repetitions of one row.
    pub rounds: usize,
    /// Time after which no further row is begun, s.
    pub limit: f64,
    /// Most steps of an integrator; if one needs more, its row has the reason.
    pub max_steps: usize,
}

impl Options {
    /// The thorough chart: tens of seconds.
    pub const THOROUGH: Self =
        Self { quick: false, stage_seconds: 12.0, rounds: 31, limit: f64::INFINITY, max_steps: 1_000_000 };

    /// The quick chart: within five seconds.
    pub const QUICK: Self =
        Self { quick: true, stage_seconds: 0.6, rounds: 7, limit: 3.0, max_steps: 40_000 };

    /// Decimal exponents from `first` down to `last`; the quick chart takes every second.
    pub(crate) fn decades(self, first: i32, last: i32) -> impl Iterator<Item = f64> {
        let step = if self.quick { 2 } else { 1 };
        (last..=first).rev().step_by(step).map(|exponent| 10.0_f64.powi(exponent))
    }
}

impl Default for Options {
    fn default() -> Self {
        Self::THOROUGH
    }
}

/// Progress of a chart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// The stage in work.
    pub stage: super::Stage,
    /// Pieces of work done in it.
    pub done: usize,
    /// Pieces of work in it.
    pub total: usize,
}
