//! Type 4: two links that slide on outer bodies and share a pin (PRP).
//!
//! Both angles are those of the outer bodies. The inner pin C is on a parallel to each guide, at the height h above
//! the origin O of its carrier: n1 (C - O1) = h1, n2 (C - O2) = h2. With b1, b2 for the right-hand sides and D = t1 x
//! t2, the sine of the angle between the guides, C = (b1 t2 - b2 t1) / D. The derivatives follow from the
//! corresponding equations for the velocities and accelerations of the carriers' points that coincide with C, with
//! the Coriolis terms 2 w t (C' - V).

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod kernel;
mod working;

#[cfg(test)]
mod tests;

use assur_group::PairSort::{Pin, Slide};
use assur_group::{ForceAngle, Pattern};

pub use kernel::Prp;

assur_words::resources!();

const PATTERN: Pattern = Pattern { links: 2, inner: &[([0, 1], Pin)], outer: &[(0, Slide), (1, Slide)] };

assur_group::dyad! {
    Prp {
        name: "prp", kind: "PRP", number: 4, pattern: PATTERN,
        ways: 1, text: "group-prp", force_angle: ForceAngle::of_sine,
    }
}
