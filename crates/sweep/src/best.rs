//! The best point of a sweep: the one with the least or the greatest value of a column.

use assur_words::text;

use crate::SweepError;
use crate::rows::{Columns, ReadRow, Rows, Status};

/// Which point is the best.
///
/// # Examples
///
/// ```
/// use assur_sweep::Best;
///
/// assert!(Best::parse("least:balancing_rms_Nm").is_ok());
/// assert!(Best::parse("balancing_rms_Nm").is_err());
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Best {
    is_greatest: bool,
    column: String,
}

/// A point with its value in the column by which points are judged.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Judged {
    /// Number of the point.
    pub point: usize,
    /// Its value, SI.
    pub value: f64,
}

impl Best {
    /// Reads `least:COLUMN` or `greatest:COLUMN`.
    pub fn parse(text: &str) -> Result<Self, SweepError> {
        match text.split_once(':') {
            Some(("least", column)) => Ok(Self { is_greatest: false, column: column.to_owned() }),
            Some(("greatest", column)) => Ok(Self { is_greatest: true, column: column.to_owned() }),
            _ => Err(SweepError::vary(text, text!("sweep-write-best"))),
        }
    }

    /// The name of its column.
    pub fn column(&self) -> &str {
        &self.column
    }

    /// The index of its column.
    ///
    /// # Errors
    ///
    /// No column of numbers has the name; the message has the nearest names.
    pub fn find(&self, columns: &Columns) -> Result<usize, SweepError> {
        columns.find(&self.column)
    }

    /// The best of some rows that are written: points that failed and cells without a number don't count, and of equal values the first
    /// does.
    pub fn of(&self, rows: &Rows, column: usize) -> Option<Judged> {
        let judged = rows.written().filter_map(|row| {
            let (status, _) = rows.status(row)?;
            let read = ReadRow { point: rows.first + row, status, value: rows.number(row, column) };
            Self::judged(&read)
        });
        judged.fold(None, |best, one| self.better(best, Some(one)))
    }

    /// A row that was written earlier, with its value; `None` where it does not count.
    pub fn judged(row: &ReadRow) -> Option<Judged> {
        let value = row.value.filter(|_| row.status == Status::Ok)?;
        Some(Judged { point: row.point, value })
    }

    /// The better of two points, the first of which comes earlier.
    pub fn better(&self, earlier: Option<Judged>, later: Option<Judged>) -> Option<Judged> {
        let (Some(one), Some(other)) = (earlier, later) else { return earlier.or(later) };
        let wins = if self.is_greatest { other.value > one.value } else { other.value < one.value };
        Some(if wins { other } else { one })
    }
}
