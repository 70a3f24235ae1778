//! Type 2: a rod with two pins, and a link that slides on the other outer body (RRP).
//!
//! ```text
//!      C ------ t    A   outer pin (given); t, n  direction and normal of the guide, turned with its carrier g
//!  l1 /              C   inner pin, on a parallel to the guide at the height h over the origin O of g
//!    A               C = A + delta n + sigma t,  delta = n (O - A) + h,  sigma = ± sqrt((l1 - delta)(l1 + delta))
//! ```
//!
//! w1 = n (V - A') / sigma, where V is the velocity of the point of g that coincides with C. The second order adds
//! the Coriolis term 2 w t (C' - V) and the centripetal term w1² delta.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod kernel;
mod working;

#[cfg(test)]
mod tests;

use assur_group::PairSort::{Pin, Slide};
use assur_group::{ForceAngle, Pattern};

pub use kernel::Rrp;

assur_words::resources!();

const PATTERN: Pattern = Pattern { links: 2, inner: &[([0, 1], Pin)], outer: &[(0, Pin), (1, Slide)] };

assur_group::dyad! {
    Rrp {
        name: "rrp", kind: "RRP", number: 2, pattern: PATTERN,
        ways: 2, text: "group-rrp", force_angle: ForceAngle::of_cosine,
    }
}
