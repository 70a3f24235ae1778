//! The triad: six pairs of any sort, three of them between the links.

use assur_group::PairSort::Any;
use assur_group::{Builders, ForceAngle, GroupPlugin, Iterated, Pattern, Ways, inventory};
use assur_words::text;

inventory::submit! {
    GroupPlugin {
        name: "triad",
        kind: "triad",
        number: 0,
        crate_name: env!("CARGO_PKG_NAME"),
        summary: text!("own-triad"),
        // Link 0 has the three inner pairs; links 1 to 3 have one outer pair each.
        pattern: Pattern {
            links: 4,
            inner: &[([0, 1], Any), ([0, 2], Any), ([0, 3], Any)],
            outer: &[(1, Any), (2, Any), (3, Any)],
        },
        ways: Ways { most: 1, varies: false, words: text!("own-triad.ways") },
        iterates: true,
        singular: text!("own-triad.singular"),
        force_angle: ForceAngle::DEFAULT,
        source: text!("own-triad.source"),
        builders: Builders::of::<Iterated>(),
    }
}
