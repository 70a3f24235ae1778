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
use assur_group::{Assemblies, Builders, ClosedKind, ForceAngle, GroupPlugin, Number, Pattern, inventory};
use assur_words::text;

pub use kernel::Rpr;

assur_words::resources!();

const PATTERN: Pattern = Pattern { links: 2, inner: &[([0, 1], Slide)], outer: &[(0, Pin), (1, Pin)] };

impl ClosedKind for Rpr<f64> {
    type Form<T: Number> = Rpr<T>;
}

inventory::submit! {
    GroupPlugin {
        name: "rpr",
        kind: "RPR",
        number: 3,
        crate_name: env!("CARGO_PKG_NAME"),
        summary: text!("group-rpr"),
        pattern: Some(PATTERN),
        rank: 10,
        ways: Assemblies { most: 2, varies: false, words: text!("group-rpr.ways") },
        iterates: false,
        singular: text!("group-rpr.singular"),
        force_angle: ForceAngle {
            words: text!("group-rpr.angle"),
            of: kernel::pressure_angle,
            is_pressure: true,
        },
        source: text!("group-rpr.source"),
        builders: Builders::in_lanes::<Rpr<f64>>(),
    }
}
