//! Links and groups over intervals of the coordinate, and what they prove: a full turn without singular positions.

use std::f64::consts::TAU;

use assur_group::{Body, Order};
use assur_mechanism::Mechanism;
use assur_number::{Intervals, Lanes, Real};
use assur_structure::Structure;

use crate::{Chain, Linkage, samples::SUSPECT};

/// Into how many intervals a way of the coordinate is divided; if one is not proved, all are divided further. Beyond these, following
/// the samples takes less time.
const INTERVALS: [u32; 3] = [8, 32, 128];

/// A chain over intervals of the coordinate, in one mode of each group: what it shows of an interval holds, but for rounding, for
/// every coordinate in it.
#[derive(Debug)]
pub struct Enclosures {
    chain: Chain<Intervals>,
    ways: Vec<u8>,
    bodies: Vec<Body<Intervals>>,
    health: Vec<Intervals>,
}

impl Enclosures {
    /// `None` where a kind of group can't be solved over intervals.
    pub(crate) fn of(
        mechanism: &Mechanism,
        structure: &Structure,
        needed: &[bool],
        ways: &[u8],
    ) -> Option<Self> {
        // Laws over time are not enclosed.
        let mut chain =
            Chain::compile(mechanism, structure).ok().filter(|_| !mechanism.input.kind().is_time())?;
        chain.needed = needed.to_vec();
        // Groups that are not needed keep this.
        let health = vec![Intervals::ONE; ways.len()];
        Some(Self { bodies: chain.bodies(), chain, ways: ways.to_vec(), health })
    }

    /// Whether something holds in all of `count` equal intervals (a multiple of eight) between two coordinates. `holds` judges
    /// eight of them by their links and the determinants of their groups; where a group can't be solved it does not hold.
    pub fn all(
        &mut self,
        [from, to]: [f64; 2],
        count: u32,
        order: Order,
        mut holds: impl FnMut(&[Body<Intervals>], &[Intervals]) -> bool,
    ) -> bool {
        let Self { chain, ways, bodies, health } = self;
        let width = (to - from) / f64::from(count);
        (0..count).step_by(Lanes::WIDTH).all(|first| {
            let middle = |lane: usize| from + width * (f64::from(first) + lane as f64 + 0.5);
            let radius = Lanes::from_f64(0.5 * width.abs());
            let coordinates = Intervals { middle: Lanes::of(middle), radius };
            chain.solve(coordinates, ways, order, bodies, health).is_ok() && holds(bodies, health)
        })
    }

    /// Whether the closed forms prove that the determinants of some groups stay above a limit between two coordinates.
    pub(crate) fn keep_clear(&mut self, ends: [f64; 2], limit: f64, has: impl Fn(usize) -> bool) -> bool {
        INTERVALS.into_iter().any(|count| {
            self.all(ends, count, Order::Place, |_, health| {
                health.iter().enumerate().all(|(group, found)| !has(group) || found.abs().exceeds(limit))
            })
        })
    }
}

/// Whether the input turns, each needed group can be assembled in its mode at every angle, and its determinant stays so far
/// from zero that following its samples finds no event. It is proved by the closed forms over intervals of the angle; `false`
/// where they don't prove it, or a kind has none.
pub(crate) fn turns_regularly(
    mechanism: &Mechanism,
    structure: &Structure,
    needed: &[bool],
    ways: &[u8],
) -> bool {
    let from = mechanism.input.from;
    let turn = || Enclosures::of(mechanism, structure, needed, ways);
    mechanism.input.is_angle()
        && turn().is_some_and(|mut turn| turn.keep_clear([from, from + TAU], SUSPECT, |_| true))
}

impl Linkage {
    /// The links over intervals of the coordinate; `None` where a group changes its mode, or can't be solved over intervals.
    pub fn enclosures(&self) -> Option<Enclosures> {
        let ways = self.ways.are_constant().then(|| self.ways.at(self.mechanism.input.from))?;
        Enclosures::of(&self.mechanism, &self.structure, &self.chain.needed, ways)
    }
}

#[cfg(test)]
mod tests;
