//! A full turn without singular positions, proved over intervals of the coordinate.

use std::f64::consts::TAU;

use assur_group::Order;
use assur_mechanism::Mechanism;
use assur_number::{Intervals, Lanes, Real};
use assur_structure::Structure;

use crate::Chain;
use crate::samples::SUSPECT;

/// Into how many intervals the turn is divided; if one is not proved, all are divided further. Beyond these, following
/// the samples takes less time.
const INTERVALS: [usize; 3] = [8, 32, 128];

/// Whether the input turns, each needed group can be assembled in its way at every angle, and its determinant stays so far
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
    let Ok(mut chain) = Chain::<Intervals>::compile(mechanism, structure) else { return false };
    chain.limit_to(needed);
    // Groups that are not needed keep this.
    let mut health = vec![Intervals::ONE; ways.len()];
    let mut bodies = chain.bodies();
    INTERVALS.into_iter().any(|count| {
        let width = TAU / count as f64;
        (0..count).step_by(Lanes::WIDTH).all(|first| {
            let middle = |lane: usize| mechanism.input.from + width * ((first + lane) as f64 + 0.5);
            let angles = Intervals { middle: Lanes::of(middle), radius: Lanes::from_f64(0.5 * width) };
            chain.solve(angles, ways, Order::Place, &mut bodies, &mut health).is_ok()
                && health.iter().all(|health| health.abs().exceeds(SUSPECT))
        })
    })
}

#[cfg(test)]
mod tests;
