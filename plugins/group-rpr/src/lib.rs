//! Type 3: two links with outer pins that slide on each other (RPR).
//!
//! ```text
//!   A      A, B  outer pins (given), D = A - B
//!   |\     t, n  direction and normal of the guide, carried by link 2
//! e |  \   n D = e is fixed by the links; t D = s = ± sqrt(D² - e²)
//!   B---   t = D / (s + i e)
//! ```
//!
//! w = n D' / s for both links, s' = t D' + e w, w' = (n D'' - 2 s' w + e w²) / s.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod kernel;
mod working;

#[cfg(test)]
mod tests;

use assur_group::PairSort::{Pin, Slide};
use assur_group::{ForceAngle, Pattern};
use assur_words::Text;

pub use kernel::Rpr;

assur_words::resources!();

const PATTERN: Pattern = Pattern { links: 2, inner: &[([0, 1], Slide)], outer: &[(0, Pin), (1, Pin)] };

/// The pressure angle between the line of the pins and the guide, with its words.
const fn pressure_angle(words: Text) -> ForceAngle {
    ForceAngle { words, of: kernel::pressure_angle, is_pressure: true }
}

assur_group::dyad! {
    Rpr {
        name: "rpr", kind: "RPR", number: 3, pattern: PATTERN,
        ways: 2, text: "group-rpr", force_angle: pressure_angle,
    }
}
