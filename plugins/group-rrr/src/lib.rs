//! Type 1: two links and three pins (RRR).
//!
//! ```text
//!        C         A, B   outer pins (given), d = B - A
//!   l1 /   \ l2    C      inner pin: C = A + alpha d + beta d turned by 90 degrees
//!     A     B      alpha = (d² + l1² - l2²) / 2d²,  beta = ± sqrt(((l1+l2)² - d²)(d² - (l1-l2)²)) / 2d²
//! ```
//!
//! With r1 = C - A, r2 = C - B and D = r1 x r2, the derivatives are w1 = V r2 / D, w2 = V r1 / D. V is B' - A' for
//! the first order, and B'' - A'' + w1² r1 - w2² r2 for the second.

mod kernel;
mod working;

#[cfg(test)]
mod tests;

use assur_group::PairSort::Pin;
use assur_group::{Builders, ClosedKind, ForceAngle, GroupPlugin, Number, Pattern, Ways, inventory};

pub use kernel::Rrr;

assur_words::resources!();

const PATTERN: Pattern = Pattern { links: 2, inner: &[([0, 1], Pin)], outer: &[(0, Pin), (1, Pin)] };

/// The kind RRR.
#[derive(Debug, Clone, Copy)]
pub struct RrrKind;

impl ClosedKind for RrrKind {
    type Form<T: Number> = Rrr<T>;
}

inventory::submit! {
    GroupPlugin {
        name: "rrr",
        kind: "RRR",
        number: 1,
        crate_name: env!("CARGO_PKG_NAME"),
        summary: "two links, three pins",
        pattern: PATTERN,
        ways: Ways { most: 2, varies: false, words: "0: the inner pin left of the line from the outer pin of the first link to that of the second; 1: right" },
        iterates: false,
        singular: "the links in one line, stretched or folded: sin(phi2 - phi1) = 0",
        force_angle: ForceAngle::of_sine("transmission angle between the links"),
        source: "S stage 2; theory of two circles",
        builders: Builders::in_lanes::<RrrKind>(),
    }
}
