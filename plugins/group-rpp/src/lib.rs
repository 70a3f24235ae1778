//! Type 5: a link with an outer pin slides on a link that slides on the other outer body (RPP).
//!
//! All angles are those of the second outer body g. A is the outer pin, P the point of link 2 on the guide of g (with
//! t2, n2), and t1, n1 belong to the guide between the links: n1 (P - A) = k, n2 (P - O) = h. Hence P - A = (b1 t2 -
//! b2 t1) / D with D = t1 x t2. Relative to g, A moves with v and a, and P with (n1 v / D) t2 and (n1 a / D) t2.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod kernel;
mod working;

#[cfg(test)]
mod tests;

use assur_group::PairSort::{Pin, Slide};
use assur_group::{ForceAngle, Pattern};

pub use kernel::Rpp;

assur_words::resources!();

const PATTERN: Pattern = Pattern { links: 2, inner: &[([0, 1], Slide)], outer: &[(0, Pin), (1, Slide)] };

assur_group::dyad! {
    Rpp {
        name: "rpp", kind: "RPP", number: 5, pattern: PATTERN,
        ways: 1, text: "group-rpp", force_angle: ForceAngle::of_sine,
    }
}
