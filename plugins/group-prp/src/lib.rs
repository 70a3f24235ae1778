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
use assur_group::{Assemblies, Builders, ClosedKind, ForceAngle, GroupPlugin, Number, Pattern, inventory};
use assur_words::text;

pub use kernel::Prp;

assur_words::resources!();

const PATTERN: Pattern = Pattern { links: 2, inner: &[([0, 1], Pin)], outer: &[(0, Slide), (1, Slide)] };

impl ClosedKind for Prp<f64> {
    type Form<T: Number> = Prp<T>;
}

inventory::submit! {
    GroupPlugin {
        name: "prp",
        kind: "PRP",
        number: 4,
        crate_name: env!("CARGO_PKG_NAME"),
        summary: text!("group-prp"),
        pattern: Some(PATTERN),
        rank: 10,
        ways: Assemblies { most: 1, varies: false, words: text!("group-prp.ways") },
        iterates: false,
        singular: text!("group-prp.singular"),
        force_angle: ForceAngle::of_sine(text!("group-prp.angle")),
        source: text!("group-prp.source"),
        builders: Builders::in_lanes::<Prp<f64>>(),
    }
}
