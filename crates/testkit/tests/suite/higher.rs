//! Kinds of higher classes that have nothing but their pattern.

use assur_group::PairSort::{Any, Pin};
use assur_group::{Pattern, inventory};
use assur_testkit::iterated;

/// A ternary link on three binary ones.
const TRIAD: Pattern = Pattern {
    links: 4,
    inner: &[([0, 1], Pin), ([0, 2], Pin), ([0, 3], Pin)],
    outer: &[(1, Pin), (2, Pin), (3, Pin)],
};

inventory::submit! { iterated("triad", TRIAD) }

inventory::submit! {
    iterated("triad-with-slides", Pattern {
        inner: &[([0, 1], Any), ([0, 2], Any), ([0, 3], Any)],
        outer: &[(1, Any), (2, Any), (3, Any)],
        ..TRIAD
    })
}

// Two ternary links on each other, with two binary ones each: class III, order 4.
inventory::submit! {
    iterated("two-ternaries", Pattern {
        links: 6,
        inner: &[([0, 1], Pin), ([0, 2], Pin), ([0, 3], Pin), ([1, 4], Pin), ([1, 5], Pin)],
        outer: &[(2, Pin), (3, Pin), (4, Pin), (5, Pin)],
    })
}

// A closed contour of four links, two of them on outer bodies: class IV, order 2.
inventory::submit! {
    iterated("contour-of-four", Pattern {
        links: 4,
        inner: &[([0, 1], Pin), ([1, 2], Pin), ([2, 3], Pin), ([3, 0], Pin)],
        outer: &[(0, Pin), (2, Pin)],
    })
}

// Patterns that are no Assur group.

// A chain of four: links 0 and 1 are a dyad, links 2 and 3 another one on it.
inventory::submit! {
    iterated("two-dyads", Pattern {
        links: 4,
        inner: &[([0, 1], Pin), ([1, 2], Pin), ([2, 3], Pin)],
        outer: &[(0, Pin), (1, Pin), (3, Pin)],
    })
}

inventory::submit! {
    iterated("held-twice", Pattern { inner: &[([0, 1], Pin)], outer: &[(0, Pin), (0, Pin)], links: 2 })
}

inventory::submit! { iterated("link-out-of-range", Pattern { inner: &[([0, 1], Pin), ([0, 7], Pin)], ..TRIAD }) }

inventory::submit! { iterated("pair-missing", Pattern { outer: &[(1, Pin), (2, Pin)], ..TRIAD }) }

inventory::submit! {
    iterated("three-links", Pattern { inner: &[([0, 1], Pin), ([1, 2], Pin)], outer: &[(0, Pin), (2, Pin)], links: 3 })
}
