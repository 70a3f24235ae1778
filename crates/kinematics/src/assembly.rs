//! The way of each group as a function of the coordinate.

use std::f64::consts::TAU;

/// Where a mechanism can be assembled around its first position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Least coordinate, rad or m.
    pub low: f64,
    /// Greatest coordinate, rad or m.
    pub high: f64,
    /// Whether it turns fully: `low` and `high` are then one period apart and mean nothing else.
    pub full: bool,
}

impl Range {
    /// An angle within the turn that begins at the lower end; one that is the lower end but for rounding stays there.
    pub(crate) fn place(&self, angle: f64) -> f64 {
        /// Rounding of an end, rad.
        const HAIR: f64 = 1e-9;
        if self.high - self.low >= TAU {
            return angle;
        }
        let place = self.low + (angle - self.low).rem_euclid(TAU);
        if place > self.low + TAU - HAIR { place - TAU } else { place }
    }
}

/// The way of each group at every coordinate: the first ones, and where they change.
#[derive(Debug, Clone, PartialEq)]
pub struct Ways {
    /// Start of the walked interval.
    pub(crate) low: f64,
    /// Its length where the motion is periodic: the ways repeat with it.
    pub(crate) period: Option<f64>,
    /// Coordinates (increasing, from `low`) and groups where two ways meet.
    pub(crate) changes: Vec<(f64, usize)>,
    /// Ways before, between and after the changes: one row more than changes.
    pub(crate) rows: Vec<Vec<u8>>,
}

impl Ways {
    /// The ways at a coordinate.
    #[inline]
    pub fn at(&self, coordinate: f64) -> &[u8] {
        if self.changes.is_empty() {
            return &self.rows[0];
        }
        let place = match self.period {
            Some(period) => self.low + (coordinate - self.low).rem_euclid(period),
            None => coordinate,
        };
        &self.rows[self.changes.partition_point(|change| change.0 <= place)]
    }

    /// From one coordinate to another, less the whole periods between them: rad or m.
    pub(crate) fn offset(&self, from: f64, to: f64) -> f64 {
        let apart = to - from;
        self.period.map_or(apart, |period| apart - period * (apart / period).round())
    }

    /// Coordinates at which two ways of a group meet within the walked interval, with the group.
    pub fn changes(&self) -> &[(f64, usize)] {
        &self.changes
    }

    /// The ways of a mechanism that is the same at the coordinate `from`, but in which the ways of some groups don't meet.
    #[must_use]
    pub fn without(&self, from: f64, gone: impl Fn(usize) -> bool) -> Self {
        let changes: Vec<_> = self.changes.iter().copied().filter(|change| !gone(change.1)).collect();
        let mut row = self.at(from).to_vec();
        let before = changes.partition_point(|change| change.0 <= from);
        for (_, group) in &changes[..before] {
            row[*group] = 1 - row[*group];
        }
        Self { low: self.low, period: self.period, rows: rows_of(&row, &changes), changes }
    }
}

/// Ways in each interval between changes, `first` before all of them.
pub(crate) fn rows_of(first: &[u8], changes: &[(f64, usize)]) -> Vec<Vec<u8>> {
    let mut rows = vec![first.to_vec()];
    for (_, group) in changes {
        let mut row = rows[rows.len() - 1].clone();
        row[*group] = 1 - row[*group];
        rows.push(row);
    }
    rows
}
