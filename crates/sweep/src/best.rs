//! The best point of a sweep: the one with the least or the greatest value of a column.

use assur_words::{list, name, text};

use crate::SweepError;
use crate::rows::{Columns, Rows, Status};

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
        let found = columns.names.iter().position(|own| *own == self.column);
        found.filter(|index| !columns.is_text(*index)).ok_or_else(|| {
            let known = columns.names.iter().enumerate().filter(|(index, _)| !columns.is_text(*index));
            let known: Vec<&str> = known.map(|(_, own)| own.as_str()).collect();
            let near = assur_scene::nearest(&self.column, known.iter().copied());
            let offered = near.map_or(known, |near| vec![near]);
            let columns = list(offered.into_iter().map(|own| name(own.to_owned())));
            SweepError::Request(text!("sweep-no-column", column = name(self.column.clone()), columns))
        })
    }

    /// The best of some rows: points that failed and cells without a number don't count, and of equal values the first does.
    pub fn of(&self, rows: &Rows, column: usize) -> Option<Judged> {
        let values =
            (0..rows.len()).filter(|row| rows.status(*row).is_some_and(|(status, _)| status == Status::Ok));
        let values = values
            .filter_map(|row| Some(Judged { point: rows.first + row, value: rows.number(row, column)? }));
        values.fold(None, |best, one| self.better(best, Some(one)))
    }

    /// The better of two points, the first of which comes earlier.
    pub fn better(&self, earlier: Option<Judged>, later: Option<Judged>) -> Option<Judged> {
        let (Some(one), Some(other)) = (earlier, later) else { return earlier.or(later) };
        let wins = if self.is_greatest { other.value > one.value } else { other.value < one.value };
        Some(if wins { other } else { one })
    }
}
