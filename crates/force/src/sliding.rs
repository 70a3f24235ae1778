//! The sense in which the arc of a contact slides along its line.

use assur_group::{Body, plane::dot};
use assur_kinematics::PositionError;
use assur_number::search::{bisect, try_newton_root};
use assur_number::{ROUNDING, elementary};

use crate::breaks::{Breaks, Interval};
use crate::grid::Span;

/// PF1 of the sliding above this part of its greatest size is so far from zero that its own sign is that of the interval.
const CLEAR: f64 = 1e-6;

/// The intervals of the coordinate in which an arc slides in one sense.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Sliding {
    breaks: Breaks,
    /// Greatest size of PF1.
    greatest: f64,
    /// Sign of PF1 of the sliding in each interval; 0 where the arc rolls throughout.
    signs: Vec<f64>,
}

/// How an arc slides at a coordinate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rate {
    /// PF1 of the arc's point K along the line, m/rad.
    pub(crate) first: f64,
    /// Its derivative with respect to the coordinate.
    pub(crate) slope: f64,
    /// Sum of the sizes of the terms of PF1.
    pub(crate) size: f64,
}

impl Rate {
    /// Of an arc about the point `center` of a body, with K at an angle that changes with the coordinate as its second number says.
    pub(crate) fn of(body: &Body<f64>, center: [f64; 2], radius: f64, [angle, turning]: [f64; 2]) -> Self {
        let (s, c) = elementary::sin_cos(angle);
        let [first, second] = body.motion(body.arm(center));
        let [own, turned] = [dot(first, [c, -s]), radius * body.w1];
        let slope = dot(second, [c, -s]) + radius * body.w2 - turning * dot(first, [s, c]);
        Self { first: own + turned, slope, size: own.abs() + turned.abs() }
    }
}

impl Sliding {
    /// Finds where the sliding turns; coordinates without a position of the mechanism are skipped.
    pub(crate) fn find(rate: &mut dyn FnMut(f64) -> Result<Rate, PositionError>, span: &Span) -> Self {
        let mut rates: Vec<_> =
            (0..=span.cells).map(|cell| (span.at(cell), rate(span.at(cell)).ok())).collect();
        let greatest =
            rates.iter().filter_map(|(_, rate)| *rate).fold(0.0, |most: f64, rate| most.max(rate.size));
        let gaps = to_the_limits(&mut rates, rate);
        let sign = |first: f64| if first.abs() <= ROUNDING * greatest { 0.0 } else { first.signum() };
        // Beyond a gap the sliding may have another sense.
        let mut turns = gaps;
        for cell in rates.windows(2) {
            let [(low, Some(a)), (high, Some(b))] = [cell[0], cell[1]] else { continue };
            let [before, after] = [sign(a.first), sign(b.first)];
            if before * after < 0.0 {
                turns.extend(root([low, high], rate, |rate| rate.first));
            } else if before * a.slope < 0.0 && after * b.slope > 0.0 {
                // It falls towards zero and grows again: it may turn twice.
                let Some(least) = root([low, high], rate, |rate| rate.slope) else { continue };
                if rate(least).is_ok_and(|rate| rate.first * before < 0.0) {
                    for ends in [[low, least], [least, high]] {
                        turns.extend(root(ends, rate, |rate| rate.first));
                    }
                }
            } else if after == 0.0 {
                turns.push(high);
            }
        }
        let breaks = Breaks::new(turns, span.period());
        let mut signs = vec![0.0; breaks.count()];
        let inside = (0..breaks.count()).map(|index| breaks.inside(index, span.ends()));
        let inside: Vec<_> = inside.map(|q| (q, rate(q).ok())).collect();
        // The middle of an interval counts only where no sample is in it.
        for (q, found) in rates.into_iter().chain(inside) {
            let known = &mut signs[breaks.interval(q).index];
            if let (Some(rate), true) = (found, *known == 0.0) {
                *known = sign(rate.first);
            }
        }
        if signs.iter().all(|sign| *sign == 0.0) {
            // What never moves has no turns either.
            return Self { breaks: Breaks::new(Vec::new(), span.period()), greatest, signs: vec![0.0] };
        }
        Self { breaks, greatest, signs }
    }

    /// The coordinates within an interval at which the sliding turns.
    pub(crate) fn turns(&self, [low, high]: [f64; 2]) -> Vec<f64> {
        let mut found = Vec::new();
        let mut at = low;
        loop {
            let next = self.breaks.interval(at).ends[1];
            if !(next < high && next > at) {
                return found;
            }
            found.push(next);
            at = next;
        }
    }

    /// Whether nothing slides at any coordinate.
    pub(crate) fn never_moves(&self) -> bool {
        self.signs.iter().all(|sign| *sign == 0.0)
    }

    /// The sign of PF1 of the sliding, given it at a coordinate or nearby, where the sign is that of the interval of `coordinate`.
    #[inline(always)]
    pub(crate) fn sign(&self, first: f64, coordinate: f64) -> f64 {
        let clear = first.abs() > CLEAR * self.greatest;
        if clear { first.signum() } else { self.at(coordinate).1 }
    }

    /// The interval that holds a coordinate, and the sign of PF1 of the sliding in it.
    #[inline(always)]
    pub(crate) fn at(&self, coordinate: f64) -> (Interval, f64) {
        let interval = self.breaks.interval(coordinate);
        (interval, self.signs[interval.index])
    }
}

/// Adds to the rates of ascending coordinates those at the limits of assembly between them, which are found by bisection; returns the
/// middle of each gap that begins after a position.
fn to_the_limits(
    rates: &mut Vec<(f64, Option<Rate>)>,
    rate: &mut dyn FnMut(f64) -> Result<Rate, PositionError>,
) -> Vec<f64> {
    let mut limits = Vec::new();
    for cell in rates.windows(2) {
        let [(low, a), (high, b)] = [cell[0], cell[1]];
        let [there, gone] = if a.is_some() { [low, high] } else { [high, low] };
        if a.is_some() != b.is_some() {
            let limit = bisect(there, gone, 0.0, |q| rate(q).is_ok())[0];
            limits.push((limit, rate(limit).ok()));
        }
    }
    let begins = limits.iter().map(|(limit, _)| *limit).filter(|limit| {
        let after = rates.iter().find(|(q, _)| q > limit);
        after.is_some_and(|(_, rate)| rate.is_none())
    });
    let middle = |begin: f64| {
        let end = limits.iter().map(|(limit, _)| *limit).find(|limit| *limit > begin);
        f64::midpoint(begin, end.unwrap_or(begin))
    };
    let gaps = begins.map(middle).collect();
    rates.extend(limits);
    rates.sort_by(|a, b| a.0.total_cmp(&b.0));
    gaps
}

/// Where a part of the rate changes its sign between two coordinates.
fn root(
    [low, high]: [f64; 2],
    rate: &mut dyn FnMut(f64) -> Result<Rate, PositionError>,
    part: fn(Rate) -> f64,
) -> Option<f64> {
    // A table of the angle may jump: with a slope of 0 the root finder bisects.
    try_newton_root(low, high, |q| rate(q).map(|rate| (part(rate), 0.0))).ok()
}
