//! The fixed bench: walks towards failure that need no scene of the user.

mod closed;
mod jet;
mod machines;
mod motion;
mod passing;
mod places;

use super::report::Stability;

/// Turns of a motion without a moment, whose energy must not drift.
const MOST_TURNS: f64 = 1e4;

/// Runs every walk of the bench.
pub fn bench() -> Stability {
    bench_of(MOST_TURNS)
}

/// With motions of so many turns at most.
pub(crate) fn bench_of(most_turns: f64) -> Stability {
    let mut rows = Vec::new();
    rows.extend(passing::rows());
    rows.extend(places::rows());
    rows.extend(motion::rows(most_turns));
    rows.extend(machines::rows());
    Stability {
        title: "Bench: where methods fail".to_owned(),
        angular: true,
        groups: Vec::new(),
        lengths: Vec::new(),
        rows,
        failure: None,
    }
}

/// Every mechanism of the bench by its name.
#[cfg(test)]
pub(crate) fn names() -> Vec<&'static str> {
    let known = closed::KNOWN.iter().map(|known| known.name);
    known.chain(places::approaches().iter().map(|approach| approach.name)).collect()
}
