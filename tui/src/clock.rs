//! The clock of this machine, for measurements of time.

use std::time::Instant;

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
