//! The mechanism at closely spaced coordinates over its cycle.

use assur_group::Order;
use assur_kinematics::{Linkage, Position, PositionError};
use assur_mechanism::Range;

/// Intervals between sampled coordinates: two dead points of one quantity are rarely nearer than half a degree.
const INTERVALS: usize = 720;

/// Part of an interval by which the samples of a closed cycle are shifted, so that dead points in symmetric positions lie
/// between samples.
const SHIFT: f64 = 0.381_966;

/// Difference of poses, in typical lengths, below which the mechanism has returned to its first position.
const RETURNED: f64 = 1e-9;

/// The sampled cycle of a mechanism.
#[derive(Debug)]
pub(crate) struct Cycle<'a> {
    pub(crate) linkage: &'a Linkage,
    /// Increasing coordinates; those of a closed cycle cover it once, the last repeats the first.
    pub(crate) samples: Vec<Position>,
    /// Length of the cycle if the mechanism has returned at its end.
    pub(crate) period: Option<f64>,
}

impl<'a> Cycle<'a> {
    /// Solves the mechanism over the cycle (or range) of its scene.
    pub(crate) fn of(linkage: &'a Linkage) -> Result<Self, PositionError> {
        let input = &linkage.mechanism.input;
        let (end, length) = match input.range {
            Range::Cycle(length) => (input.from + input.sign() * length, length),
            Range::To(to) => (to, (to - input.from).abs()),
        };
        let at = |coordinate: f64| {
            let mut position = linkage.position();
            linkage.solve(coordinate, Order::Second, &mut position).map(|()| position)
        };
        let cyclic = matches!(input.range, Range::Cycle(_)) && returned(&at(input.from)?, &at(end)?, linkage);
        let step = length / INTERVALS as f64;
        let start = input.from.min(end) + if cyclic { SHIFT * step } else { 0.0 };
        let samples = (0..=INTERVALS).map(|i| at(start + step * i as f64)).collect::<Result<_, _>>()?;
        Ok(Self { linkage, samples, period: cyclic.then_some(length) })
    }

    /// A coordinate moved by whole cycles to where the scene counts its positions from; rounding before the first
    /// position is taken away.
    pub(crate) fn inside(&self, coordinate: f64) -> f64 {
        let Some(period) = self.period else { return coordinate };
        let input = &self.linkage.mechanism.input;
        let way = (input.sign() * (coordinate - input.from)).rem_euclid(period);
        let rounding = 8.0 * f64::EPSILON * (period + input.from.abs());
        if way < rounding || period - way < rounding { input.from } else { input.from + input.sign() * way }
    }
}

fn returned(first: &Position, last: &Position, linkage: &Linkage) -> bool {
    let scale = linkage.structure.scale;
    first.bodies.iter().zip(&last.bodies).all(|(a, b)| {
        let apart = ((a.x - b.x).hypot(a.y - b.y) / scale).max((a.c - b.c).hypot(a.s - b.s));
        apart <= RETURNED
    })
}
