//! Kinds of higher classes that have nothing but their pattern.

use assur_group::PairSort::{Any, Pin};
use assur_group::{Builders, ForceAngle, GroupPlugin, Iterated, Pattern, Ways, inventory};

const fn entry(name: &'static str, pattern: Pattern) -> GroupPlugin {
    GroupPlugin {
        name,
        kind: name,
        number: 0,
        crate_name: env!("CARGO_PKG_NAME"),
        summary: "a group of a higher class",
        pattern,
        ways: Ways { most: 1, varies: false, words: "the one near the start" },
        iterates: true,
        singular: "where its determinant is 0",
        force_angle: ForceAngle::DEFAULT,
        source: "a test",
        builders: Builders::of::<Iterated>(),
    }
}

/// A ternary link on three binary ones.
const TRIAD: Pattern = Pattern {
    links: 4,
    inner: &[([0, 1], Pin), ([0, 2], Pin), ([0, 3], Pin)],
    outer: &[(1, Pin), (2, Pin), (3, Pin)],
};

inventory::submit! { entry("triad", TRIAD) }

inventory::submit! {
    entry("triad-with-slides", Pattern {
        inner: &[([0, 1], Any), ([0, 2], Any), ([0, 3], Any)],
        outer: &[(1, Any), (2, Any), (3, Any)],
        ..TRIAD
    })
}

// Two ternary links on each other, with two binary ones each: class III, order 4.
inventory::submit! {
    entry("two-ternaries", Pattern {
        links: 6,
        inner: &[([0, 1], Pin), ([0, 2], Pin), ([0, 3], Pin), ([1, 4], Pin), ([1, 5], Pin)],
        outer: &[(2, Pin), (3, Pin), (4, Pin), (5, Pin)],
    })
}

// A closed contour of four links, two of them on outer bodies: class IV, order 2.
inventory::submit! {
    entry("contour-of-four", Pattern {
        links: 4,
        inner: &[([0, 1], Pin), ([1, 2], Pin), ([2, 3], Pin), ([3, 0], Pin)],
        outer: &[(0, Pin), (2, Pin)],
    })
}

// Patterns that are no Assur group.

// A chain of four: links 0 and 1 are a dyad, links 2 and 3 another one on it.
inventory::submit! {
    entry("two-dyads", Pattern {
        links: 4,
        inner: &[([0, 1], Pin), ([1, 2], Pin), ([2, 3], Pin)],
        outer: &[(0, Pin), (1, Pin), (3, Pin)],
    })
}

inventory::submit! {
    entry("held-twice", Pattern { inner: &[([0, 1], Pin)], outer: &[(0, Pin), (0, Pin)], links: 2 })
}

inventory::submit! { entry("link-out-of-range", Pattern { inner: &[([0, 1], Pin), ([0, 7], Pin)], ..TRIAD }) }

inventory::submit! { entry("pair-missing", Pattern { outer: &[(1, Pin), (2, Pin)], ..TRIAD }) }

inventory::submit! {
    entry("three-links", Pattern { inner: &[([0, 1], Pin), ([1, 2], Pin)], outer: &[(0, Pin), (2, Pin)], links: 3 })
}
