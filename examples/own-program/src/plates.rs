//! Two ternary links on each other: nine pairs of any sort, five of them between the links.

use assur_group::PairSort::Any;
use assur_group::{Assemblies, Builders, ForceAngle, GroupPlugin, Iterated, Pattern, inventory};
use assur_words::text;

inventory::submit! {
    GroupPlugin {
        name: "two-plates",
        kind: "two plates",
        number: 0,
        crate_name: env!("CARGO_PKG_NAME"),
        summary: text!("own-plates"),
        // Links 0 and 1 have three inner pairs; links 2 to 5 have one outer pair each.
        pattern: Some(Pattern {
            links: 6,
            inner: &[([0, 1], Any), ([0, 2], Any), ([0, 3], Any), ([1, 4], Any), ([1, 5], Any)],
            outer: &[(2, Any), (3, Any), (4, Any), (5, Any)],
        }),
        // Before the last resort, which would take it too.
        rank: 5,
        ways: Assemblies { most: 1, varies: true, words: text!("own-plates.ways") },
        iterates: true,
        singular: text!("own-plates.singular"),
        force_angle: ForceAngle::DEFAULT,
        source: text!("own-plates.source"),
        builders: Builders::of::<Iterated>(),
    }
}
