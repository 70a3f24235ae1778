//! A full turn without singular positions, proved over intervals of the coordinate.

use std::f64::consts::TAU;

use assur_group::Order;
use assur_mechanism::Mechanism;
use assur_number::Real;
use assur_structure::Structure;

use crate::Enclosures;
use crate::samples::SUSPECT;

/// Into how many intervals the turn is divided; if one is not proved, all are divided further. Beyond these, following
/// the samples takes less time.
pub(crate) const INTERVALS: [u32; 3] = [8, 32, 128];

/// Whether the input turns, each needed group can be assembled in its mode at every angle, and its determinant stays so far
/// from zero that following its samples finds no event. It is proved by the closed forms over intervals of the angle; `false`
/// where they don't prove it, or a kind has none.
pub(crate) fn turns_regularly(
    mechanism: &Mechanism,
    structure: &Structure,
    needed: &[bool],
    ways: &[u8],
) -> bool {
    if !mechanism.input.is_angle() {
        return false;
    }
    let from = mechanism.input.from;
    let Some(mut turn) = Enclosures::of(mechanism, structure, needed, ways) else { return false };
    INTERVALS.into_iter().any(|count| {
        turn.all([from, from + TAU], count, Order::Place, |_, health| {
            health.iter().all(|health| health.abs().exceeds(SUSPECT))
        })
    })
}

#[cfg(test)]
mod tests;
