//! Any group, whatever its class, order and count of links: the last resort.
//!
//! Newton's method with shortened steps on the constraints of all pairs, from the places in `[assembly]`, then from position to
//! position. The first root is certified by the theorem of Newton and Kantorovich: a true assembly, alone in its
//! neighborhood; it need not be the nearest one. From ten links on the matrices are sparse. Other assemblies are not listed.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

use assur_group::{Assemblies, Builders, ForceAngle, GroupPlugin, Iterated, inventory};
use assur_words::text;

#[cfg(test)]
mod tests;

assur_words::resources!();

inventory::submit! {
    GroupPlugin {
        name: "any",
        kind: "any",
        number: 0,
        crate_name: env!("CARGO_PKG_NAME"),
        summary: text!("group-any"),
        pattern: None,
        rank: 200,
        ways: Assemblies { most: 1, varies: true, words: text!("group-any.ways") },
        iterates: true,
        singular: text!("group-any.singular"),
        force_angle: ForceAngle::DEFAULT,
        source: text!("group-any.source"),
        builders: Builders::of::<Iterated>(),
    }
}
