//! How many points ended how.

use strum::{EnumCount, VariantArray};

use crate::rows::{ReadRow, Rows, Status};

/// How many points ended how, of those that were calculated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Tally {
    /// By status.
    counts: [usize; Status::COUNT],
    /// Points that an earlier run left out, without a word of how they ended.
    pub unknown: usize,
    /// Points whose rows are written.
    pub written: usize,
    /// Number of the first point without a solution.
    pub first_failure: Option<usize>,
}

impl Tally {
    /// Counts a point.
    fn add(&mut self, point: usize, status: Status, written: bool) {
        self.counts[status as usize] += 1;
        self.written += usize::from(written);
        if status != Status::Ok {
            self.first_failure.get_or_insert(point);
        }
    }

    /// Counts a row that an earlier run wrote, and the points that it left out before; `next`: the first of them.
    pub fn add_read(&mut self, next: usize, row: &ReadRow) {
        self.unknown += row.point.saturating_sub(next);
        self.add(row.point, row.status, true);
    }

    /// Counts points.
    pub fn of(rows: &Rows) -> Self {
        let mut tally = Self::default();
        let mut written = rows.written().peekable();
        for row in 0..rows.len() {
            let is_written = written.next_if_eq(&row).is_some();
            if let Some((status, _)) = rows.status(row) {
                tally.add(rows.first + row, status, is_written);
            }
        }
        tally
    }

    /// Adds the points that follow.
    pub fn append(&mut self, next: &Self) {
        self.counts.iter_mut().zip(next.counts).for_each(|(count, more)| *count += more);
        self.unknown += next.unknown;
        self.written += next.written;
        self.first_failure = self.first_failure.or(next.first_failure);
    }

    /// How many points ended so.
    pub fn count(&self, status: Status) -> usize {
        self.counts[status as usize]
    }

    /// How many points there are.
    pub fn points(&self) -> usize {
        self.counts.iter().sum::<usize>() + self.unknown
    }

    /// Points without a solution.
    pub fn failures(&self) -> usize {
        self.points() - self.unknown - self.count(Status::Ok)
    }

    /// Whether no point could be calculated at all, so that the call is at fault.
    pub fn is_hopeless(&self) -> bool {
        let hopeless = Status::VARIANTS.iter().filter(|status| status.is_hopeless());
        self.points() > 0 && hopeless.map(|status| self.count(*status)).sum::<usize>() == self.points()
    }

    /// The numbers in one line, which [`parse`](Self::parse) reads.
    pub fn line(&self) -> String {
        let first = self.first_failure.map_or_else(|| "-".to_owned(), |first| first.to_string());
        let numbers = self.counts.into_iter().chain([self.unknown, self.written]);
        numbers.map(|number| number.to_string()).chain([first]).collect::<Vec<_>>().join(" ")
    }

    /// Reads the numbers of a line; `None` of any other text.
    pub fn parse(line: &str) -> Option<Self> {
        let (numbers, first) = line.rsplit_once(' ')?;
        let numbers: Vec<usize> =
            numbers.split(' ').map(|number| number.parse().ok()).collect::<Option<_>>()?;
        let (counts, rest) = numbers.split_first_chunk()?;
        let [unknown, written] = rest.try_into().ok()?;
        let first_failure = if first == "-" { None } else { Some(first.parse().ok()?) };
        Some(Self { counts: *counts, unknown, written, first_failure })
    }
}
