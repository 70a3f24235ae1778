//! The triad: six pairs of any sort, three of them between the links.

use assur_group::PairSort::Any;
use assur_group::{Builders, ForceAngle, GroupPlugin, Iterated, Pattern, Ways, inventory};

inventory::submit! {
    GroupPlugin {
        name: "triad",
        kind: "triad",
        number: 0,
        crate_name: env!("CARGO_PKG_NAME"),
        summary: "a link with three inner pairs, and three links on outer bodies",
        // Link 0 has the three inner pairs; links 1 to 3 have one outer pair each.
        pattern: Pattern {
            links: 4,
            inner: &[([0, 1], Any), ([0, 2], Any), ([0, 3], Any)],
            outer: &[(1, Any), (2, Any), (3, Any)],
        },
        ways: Ways { most: 1, varies: false, words: "the one near the places of [assembly]" },
        iterates: true,
        singular: "with pins alone: the lines of the three outer links through one point, or parallel",
        force_angle: ForceAngle::DEFAULT,
        source: "Newton's method on the constraints of the pairs",
        builders: Builders::of::<Iterated>(),
    }
}
