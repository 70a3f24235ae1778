//! The fixed bench: walks towards failure that need no scene of the user.

mod closed;
mod jet;
mod passing;
mod places;

use super::report::Stability;

/// Runs every walk of the bench.
pub fn bench() -> Stability {
    let mut rows = Vec::new();
    rows.extend(passing::rows());
    rows.extend(places::rows());
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
