//! After many turns of the crank everything is as in the first, within the rounding of the coordinate.

use std::f64::consts::TAU;

use assur_kinematics::Linkage;

use super::Law;
use crate::stability::row::Comparison;
use crate::stability::target::Target;
use crate::stability::walk::Walk;

pub(super) static LAW: Law = Law {
    section: "Many turns",
    along: "whole turns between the coordinate and that of the reference",
    expected: "as along the cycle, 16 eps (1 + |q|) (groups / product of determinants)^k and its factors, with q \
               after those turns: what the rounding of q costs",
};

/// Whole cycles also where the mechanism needs two or four turns to repeat.
const TURNS: [f64; 6] = [4.0, 40.0, 400.0, 4000.0, 10_000.0, 1_000_000.0];

/// Rows for a mechanism that turns fully; none for another one.
pub(crate) fn rows(linkage: &Linkage, walk: &Walk<'_>, q: f64) -> Vec<Comparison> {
    let mut rows = Vec::new();
    if !linkage.kind().is_angle() || linkage.range.is_none_or(|range| !range.full) {
        return rows;
    }
    let target = Target {
        coordinate: q,
        sides: Vec::new(),
        reach: 0.0,
        groups: (0..linkage.structure.groups.len()).collect(),
        words: assur_words::name("turns away"),
    };
    for turns in TURNS {
        walk.stop(&target, (q + turns * TAU, q), turns, &mut rows);
    }
    rows
}
