//! How many points failed.

use crate::Rows;

/// How many points failed, of those that were calculated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Tally {
    /// Points that were calculated.
    pub points: usize,
    /// Points without a solution.
    pub failures: usize,
    /// Number of the first of them.
    pub first: Option<usize>,
    /// Points whose scene can't be calculated at all.
    pub hopeless: usize,
}

impl Tally {
    /// Counts a row: the number of its point, and how its calculation ended.
    pub fn add(&mut self, point: usize, status: crate::Status) {
        self.points += 1;
        self.hopeless += usize::from(status.is_hopeless());
        if status != crate::Status::Ok {
            self.failures += 1;
            self.first.get_or_insert(point);
        }
    }

    /// Counts rows.
    pub fn of(rows: &Rows) -> Self {
        let mut tally = Self::default();
        let each = (0..rows.len()).filter_map(|row| Some((rows.first() + row, rows.status(row)?.0)));
        each.for_each(|(point, status)| tally.add(point, status));
        tally
    }

    /// Adds the points that follow.
    pub fn append(&mut self, next: Self) {
        self.points += next.points;
        self.failures += next.failures;
        self.first = self.first.or(next.first);
        self.hopeless += next.hopeless;
    }

    /// Whether no point could be calculated at all, so that the call is at fault.
    pub fn is_hopeless(&self) -> bool {
        self.points > 0 && self.hopeless == self.points
    }
}
