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
use assur_group::{Assemblies, Builders, ClosedKind, ForceAngle, GroupPlugin, Number, Pattern, inventory};
use assur_words::text;

pub use kernel::Rrp;

assur_words::resources!();

const PATTERN: Pattern = Pattern { links: 2, inner: &[([0, 1], Pin)], outer: &[(0, Pin), (1, Slide)] };

impl ClosedKind for Rrp<f64> {
    type Form<T: Number> = Rrp<T>;
}

inventory::submit! {
    GroupPlugin {
        name: "rrp",
        kind: "RRP",
        number: 2,
        crate_name: env!("CARGO_PKG_NAME"),
        summary: text!("group-rrp"),
        pattern: Some(PATTERN),
        rank: 10,
        ways: Assemblies { most: 2, varies: false, words: text!("group-rrp.ways") },
        iterates: false,
        singular: text!("group-rrp.singular"),
        force_angle: ForceAngle::of_cosine(text!("group-rrp.angle")),
        source: text!("group-rrp.source"),
        builders: Builders::in_lanes::<Rrp<f64>>(),
    }
}
