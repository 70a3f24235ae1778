//! The intervals of the coordinate between the places where a formula changes, repeated with the cycle or not.

use assur_number::ROUNDING;

/// Sorted places where a formula changes.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Breaks {
    points: Vec<f64>,
    period: Option<f64>,
}

/// One interval between two breaks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Interval {
    /// Which, of [`Breaks::count`].
    pub(crate) index: usize,
    /// Ends, infinite where there is no break.
    pub(crate) ends: [f64; 2],
    /// Its lower end in the cycle of the points.
    pub(crate) start: f64,
    /// Sum of the whole cycles: coordinate - shift is in the cycle of the points.
    pub(crate) shift: f64,
}

/// Distance up to which a coordinate (or a time) counts as lying on a place where a formula changes: rounding.
/// `period`: length of a cycle of the coordinate, if it has one.
pub fn tolerance(coordinate: f64, period: Option<f64>) -> f64 {
    ROUNDING * coordinate.abs().max(period.unwrap_or(1.0))
}

impl Breaks {
    /// Sorts the points; with a period, points a whole period or more after the first are dropped.
    pub(crate) fn new(mut points: Vec<f64>, period: Option<f64>) -> Self {
        points.sort_by(f64::total_cmp);
        points.dedup();
        if let (Some(period), Some(&first)) = (period, points.first()) {
            points.retain(|point| *point < first + period);
        }
        Self { points, period }
    }

    /// Number of different intervals.
    pub(crate) fn count(&self) -> usize {
        match self.period {
            Some(_) => self.points.len().max(1),
            None => self.points.len() + 1,
        }
    }

    /// The middle of the interval of this index; an end that it lacks is that of the span in which the breaks were looked for.
    pub(crate) fn inside(&self, index: usize, [from, to]: [f64; 2]) -> f64 {
        let first = if self.period.is_some() { index } else { index.wrapping_sub(1) };
        let after = if self.period.is_some() { index + 1 } else { index };
        let wrapped = || Some(self.points.first()? + self.period?);
        let low = self.points.get(first).copied().unwrap_or(from);
        f64::midpoint(low, self.points.get(after).copied().or_else(wrapped).unwrap_or(to))
    }

    /// Sum of the whole cycles between the cycle of the points and this coordinate.
    #[inline(always)]
    pub(crate) fn shift(&self, coordinate: f64) -> f64 {
        match (self.period, self.points.first()) {
            // Most coordinates are in the first cycle; the rest pays for division and floor.
            (Some(period), Some(first)) if !(*first..first + period).contains(&coordinate) => {
                ((coordinate - first) / period).floor() * period
            }
            _ => 0.0,
        }
    }

    /// The interval that holds a coordinate; a break belongs to the interval after it.
    #[inline(always)]
    pub(crate) fn interval(&self, coordinate: f64) -> Interval {
        let Some(&first) = self.points.first() else {
            let (start, end) = (f64::NEG_INFINITY, f64::INFINITY);
            return Interval { index: 0, ends: [start, end], start, shift: 0.0 };
        };
        let shift = self.shift(coordinate);
        let after = self.points.partition_point(|point| *point <= coordinate - shift);
        let at = |index: usize| self.points.get(index).map(|point| point + shift);
        let Some(period) = self.period else {
            let low = after.checked_sub(1).and_then(at).unwrap_or(f64::NEG_INFINITY);
            let ends = [low, at(after).unwrap_or(f64::INFINITY)];
            return Interval { index: after, ends, start: low, shift };
        };
        // Rounding of the shift may put the coordinate just before the first point.
        let index = after.saturating_sub(1);
        let ends = [self.points[index] + shift, at(index + 1).unwrap_or(first + period + shift)];
        Interval { index, ends, start: self.points[index], shift }
    }
}

/// Shrinks an interval to what it has in common with another.
pub(crate) fn cut(bounds: &mut [f64; 2], other: [f64; 2]) {
    bounds[0] = bounds[0].max(other[0]);
    bounds[1] = bounds[1].min(other[1]);
}
