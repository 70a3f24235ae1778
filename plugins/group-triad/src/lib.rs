//! Class III, order 3 (a plate and three legs), and class IV, order 2 (a closed contour of four links with two outer pairs).
//!
//! ```text
//!        plate                 A leg is one link with an outer and an inner pair. It leaves the plate one condition,
//!       /  |  \                and with a given angle of the plate this is a circle, or a line, for its place:
//!    leg  leg  leg             three of them meet in a point where a trigonometric polynomial of the angle vanishes,
//!     |    |    |              of degree 3 at most.
//!     outer bodies
//! ```
//!
//! With r the way along the first leg, `u_k` the offsets of the others against it (turned with the plate), the conditions of two
//! legs subtracted from the first are linear, `m_k r = c_k`. So r = N / D with `D = m_1 × m_2`, and the closure is
//! N² - l² D² = 0, or a determinant of three lines where no leg has two pins. All coefficients follow from 16 samples; the
//! real zeros are isolated by exclusion with Taylor's formula (the module `trig`), so that none is missed, and each
//! is polished on the conditions of the legs themselves.
//!
//! Class IV, seen together with its frame, is the same five-link structure with another link fixed: the legs hold one ternary
//! link against the other, and the outer bodies are the third leg.
//!
//! PF1, PF2 and the reactions follow from one system of three equations (of two in class IV) in the freedoms of the ternary
//! links: each leg acts along one line.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod forces;
mod frame;
mod kernel;
mod leg;
mod locus;
mod matrix;
mod modes;
mod mover;
mod newton;
mod order;
mod trig;

#[cfg(test)]
mod tests;

use assur_group::PairSort::{Any, Pin, Slide};
use assur_group::{
    Assemblies, BuildError, Builders, ForceAngle, GroupFrame, GroupKind, GroupPlugin, Number, PairSort,
    Pattern, inventory,
};
use assur_words::text;

pub use kernel::Legged;

assur_words::resources!();

/// Any plate with three legs.
const TRIAD: Pattern = Pattern {
    links: 4,
    inner: &[([1, 0], Any), ([2, 0], Any), ([3, 0], Any)],
    outer: &[(1, Any), (2, Any), (3, Any)],
};

/// Any contour of four links, of which the first two have an outer pair.
const CONTOUR: Pattern = Pattern {
    links: 4,
    inner: &[([2, 0], Any), ([2, 1], Any), ([3, 0], Any), ([3, 1], Any)],
    outer: &[(0, Any), (1, Any)],
};

impl GroupKind for Legged<f64> {
    type Kernel<T: Number> = Legged<T>;

    fn build<T: Number>(frame: &GroupFrame) -> Result<Legged<T>, BuildError> {
        Legged::new(frame)
    }
}

/// Outer and inner pair of a leg.
type LegSort = [PairSort; 2];
const RR: LegSort = [Pin, Pin];
const PR: LegSort = [Slide, Pin];
const RP: LegSort = [Pin, Slide];
const PP: LegSort = [Slide, Slide];

/// Of the kinds of the repository, those with formulas of their own come before the last resort.
const RANK: u8 = 10;

macro_rules! kind {
    ($name:literal, $kind:literal, $most:literal, $pattern:expr, [$summary:literal, $ways:literal, $singular:literal, $source:literal]) => {
        inventory::submit! {
            GroupPlugin {
                name: $name,
                kind: $kind,
                number: 0,
                crate_name: env!("CARGO_PKG_NAME"),
                summary: text!($summary),
                pattern: Some($pattern),
                rank: RANK,
                ways: Assemblies { most: $most, varies: true, words: text!($ways) },
                iterates: true,
                singular: text!($singular),
                force_angle: ForceAngle::DEFAULT,
                source: text!($source),
                builders: Builders::near_in_lanes::<Legged<f64>>(),
            }
        }
    };
}

macro_rules! triad {
    ($name:literal, $kind:literal, $most:literal, [$one:ident, $two:ident, $three:ident]) => {
        kind! {
            $name, $kind, $most,
            Pattern {
                inner: &[([1, 0], $one[1]), ([2, 0], $two[1]), ([3, 0], $three[1])],
                outer: &[(1, $one[0]), (2, $two[0]), (3, $three[0])],
                ..TRIAD
            },
            ["group-triad", "group-triad.ways", "group-triad.singular", "group-triad.source"]
        }
    };
}

macro_rules! contour {
    ($name:literal, $kind:literal, $most:literal, $around:ident, [$one:ident, $two:ident]) => {
        kind! {
            $name, $kind, $most,
            Pattern {
                inner: &[([2, 0], $one[0]), ([2, 1], $one[1]), ([3, 0], $two[0]), ([3, 1], $two[1])],
                outer: &[(0, $around[0]), (1, $around[1])],
                ..CONTOUR
            },
            ["group-contour", "group-contour.ways", "group-contour.singular", "group-contour.source"]
        }
    };
}

triad!("rr-rr-rr", "RR-RR-RR", 6, [RR, RR, RR]);
triad!("rr-rr-pr", "RR-RR-PR", 6, [RR, RR, PR]);
triad!("rr-rr-rp", "RR-RR-RP", 6, [RR, RR, RP]);
triad!("rr-rr-pp", "RR-RR-PP", 2, [RR, RR, PP]);
triad!("rr-pr-pr", "RR-PR-PR", 4, [RR, PR, PR]);
triad!("rr-pr-rp", "RR-PR-RP", 6, [RR, PR, RP]);
triad!("rr-pr-pp", "RR-PR-PP", 2, [RR, PR, PP]);
triad!("rr-rp-rp", "RR-RP-RP", 4, [RR, RP, RP]);
triad!("rr-rp-pp", "RR-RP-PP", 2, [RR, RP, PP]);
triad!("pr-pr-pr", "PR-PR-PR", 2, [PR, PR, PR]);
triad!("pr-pr-rp", "PR-PR-RP", 4, [PR, PR, RP]);
triad!("pr-pr-pp", "PR-PR-PP", 1, [PR, PR, PP]);
triad!("pr-rp-rp", "PR-RP-RP", 4, [PR, RP, RP]);
triad!("pr-rp-pp", "PR-RP-PP", 1, [PR, RP, PP]);
triad!("rp-rp-rp", "RP-RP-RP", 2, [RP, RP, RP]);
triad!("rp-rp-pp", "RP-RP-PP", 1, [RP, RP, PP]);

// The legs in the order RR, PR, RP, PP. Which ternary link is held is a matter of the view: PR and RP change places with it, and
// of the two names the one that comes first in this order is taken. The name of an entry says the outer pairs too.
contour!("rr-rr-rr/iv:rr", "RR-RR-RR/IV", 6, RR, [RR, RR]);
contour!("rr-rr-pr/iv:rr", "RR-RR-PR/IV", 6, RR, [RR, PR]);
contour!("rr-rr-pp/iv:rr", "RR-RR-PP/IV", 2, RR, [RR, PP]);
contour!("rr-pr-pr/iv:rr", "RR-PR-PR/IV", 4, RR, [PR, PR]);
contour!("rr-pr-rp/iv:rr", "RR-PR-RP/IV", 6, RR, [PR, RP]);
contour!("rr-pr-pp/iv:rr", "RR-PR-PP/IV", 2, RR, [PR, PP]);
contour!("rr-rr-pr/iv:pr", "RR-RR-PR/IV", 6, PR, [RR, RR]);
contour!("rr-pr-pr/iv:pr", "RR-PR-PR/IV", 4, PR, [RR, PR]);
contour!("rr-pr-rp/iv:pr", "RR-PR-RP/IV", 6, PR, [RR, RP]);
contour!("rr-pr-pp/iv:pr", "RR-PR-PP/IV", 2, PR, [RR, PP]);
contour!("pr-pr-pr/iv:pr", "PR-PR-PR/IV", 2, PR, [PR, PR]);
contour!("pr-pr-rp/iv:pr", "PR-PR-RP/IV", 4, PR, [PR, RP]);
contour!("pr-pr-pp/iv:pr", "PR-PR-PP/IV", 1, PR, [PR, PP]);
contour!("pr-pr-rp/iv:rp", "PR-PR-RP/IV", 4, RP, [PR, PR]);
contour!("pr-rp-pp/iv:pr", "PR-RP-PP/IV", 1, PR, [RP, PP]);
contour!("rr-rr-pp/iv:pp", "RR-RR-PP/IV", 2, PP, [RR, RR]);
contour!("rr-pr-pp/iv:pp", "RR-PR-PP/IV", 2, PP, [RR, PR]);
contour!("pr-pr-pp/iv:pp", "PR-PR-PP/IV", 1, PP, [PR, PR]);
contour!("pr-rp-pp/iv:pp", "PR-RP-PP/IV", 1, PP, [PR, RP]);
