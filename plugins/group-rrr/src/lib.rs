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

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod kernel;
mod working;

#[cfg(test)]
mod tests;

use assur_group::{ForceAngle, PairSort::Pin, Pattern};

pub use kernel::Rrr;

assur_words::resources!();

const PATTERN: Pattern = Pattern { links: 2, inner: &[([0, 1], Pin)], outer: &[(0, Pin), (1, Pin)] };

assur_group::dyad! {
    Rrr {
        name: "rrr", kind: "RRR", number: 1, pattern: PATTERN,
        ways: 2, text: "group-rrr", force_angle: ForceAngle::of_sine,
    }
}
