//! The fixed bench: walks towards failure that need no scene of the user.

mod closed;
mod jet;
mod passing;

use super::report::Stability;

/// Runs every walk of the bench.
pub fn bench() -> Stability {
    let mut rows = Vec::new();
    rows.extend(passing::rows());
    Stability {
        title: "Bench: where methods fail".to_owned(),
        angular: true,
        groups: Vec::new(),
        lengths: Vec::new(),
        rows,
        failure: None,
    }
}
