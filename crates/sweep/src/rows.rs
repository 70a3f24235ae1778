//! Rows of a sweep.

use std::sync::Arc;

use assur_report::csv::{CsvCell, CsvError, rows};
use assur_words::{Describe, Text, list, name, text};
use strum::{EnumCount, EnumString, IntoStaticStr, VariantArray};

use crate::axis::{Axis, word};
use crate::column::{ROW, STATUS};
use crate::{Sweep, SweepError};

/// How the calculation of a point ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, EnumCount, EnumString, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "lowercase")]
pub enum Status {
    /// Everything that the scene requests was found.
    Ok,
    /// A position can't be assembled.
    #[strum(serialize = "no assembly")]
    NoAssembly,
    /// A position is singular, or the motion has no solution.
    #[strum(serialize = "no solution")]
    NoSolution,
    /// The scene as a whole can't be calculated.
    Error,
    /// The reader of scenes refuses the values.
    Refused,
}

impl Status {
    /// The word for it in the table.
    pub fn text(self) -> &'static str {
        self.into()
    }

    /// Whether the scene with these values can't be calculated at all: if that holds for every point, the call is at fault.
    pub fn is_hopeless(self) -> bool {
        matches!(self, Self::Error | Self::Refused)
    }
}

impl Describe for Status {
    fn describe(&self) -> Text {
        match self {
            Self::Ok => text!("sweep-status-ok"),
            Self::NoAssembly => text!("sweep-status-no-assembly"),
            Self::NoSolution => text!("sweep-status-no-solution"),
            Self::Error => text!("sweep-status-error"),
            Self::Refused => text!("sweep-status-refused"),
        }
    }
}

/// The columns of a sweep: the number of the point, parameters, status, message, failed positions, values, and the motor where there
/// is one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Columns {
    /// Their names.
    pub names: Vec<String>,
    /// Of each parameter the texts that are its values; `None` of numbers.
    parameters: Vec<Option<Arc<[String]>>>,
    has_motor: bool,
}

impl Columns {
    pub(crate) fn new(axes: &[Axis], values: Vec<String>, has_motor: bool) -> Self {
        let parameters = axes.iter().map(|axis| axis.column.clone());
        let outcome = [STATUS, "message", "failed_positions"].map(str::to_owned);
        let motor = has_motor.then(|| "motor".to_owned());
        let names =
            std::iter::once(ROW.to_owned()).chain(parameters).chain(outcome).chain(values).chain(motor);
        let parameters = axes.iter().map(|axis| axis.words().cloned()).collect();
        Self { names: assur_report::csv::unique(names), parameters, has_motor }
    }

    /// The index of the column `status`.
    pub fn status(&self) -> usize {
        1 + self.parameters.len()
    }

    /// The index of the column of a value.
    pub(crate) fn of_value(&self, value: usize) -> usize {
        self.status() + 3 + value
    }

    /// The index of a column of numbers.
    ///
    /// # Errors
    ///
    /// No column of numbers has the name; the message has the nearest names.
    pub(crate) fn find(&self, column: &str) -> Result<usize, SweepError> {
        let found = self.names.iter().position(|own| own == column);
        found.filter(|index| !self.is_text(*index)).ok_or_else(|| {
            let known = self.names.iter().enumerate().filter(|(index, _)| !self.is_text(*index));
            let known: Vec<&str> = known.map(|(_, own)| own.as_str()).collect();
            let near = assur_scene::nearest(column, known.iter().copied());
            let offered = near.map_or(known, |near| vec![near]);
            let columns = shown(&offered);
            SweepError::Request(text!("sweep-no-column", column = name(column.to_owned()), columns))
        })
    }

    /// Whether a column holds texts; otherwise numbers.
    pub fn is_text(&self, column: usize) -> bool {
        let has_words = |parameter: usize| self.parameters.get(parameter).is_some_and(Option::is_some);
        [self.status(), self.status() + 1].contains(&column)
            || self.is_motor(column)
            || column.checked_sub(1).is_some_and(has_words)
    }

    /// Whether a column holds whole numbers, which every row has: that of the points.
    pub fn is_whole(&self, column: usize) -> bool {
        column == 0
    }

    fn is_motor(&self, column: usize) -> bool {
        self.has_motor && column + 1 == self.names.len()
    }
}

/// Why a point has no values.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Failure {
    pub(crate) status: Status,
    /// The first failure.
    pub(crate) message: Text,
    /// Positions without a solution; `None` where none was tried.
    pub(crate) failed: Option<usize>,
}

/// The texts of a row, empty where there is none.
#[derive(Debug, Clone, PartialEq)]
struct Outcome {
    status: Status,
    /// The first failure in words: tables are in English, and a cell has one line.
    message: String,
    /// Designation of the motor.
    motor: String,
    /// Whether the row is written: it holds the conditions of the sweep.
    written: bool,
}

/// Rows of successive points of a sweep; some of them may be left out by its conditions.
#[derive(Debug, Clone, PartialEq)]
pub struct Rows {
    /// The columns.
    pub columns: Arc<Columns>,
    /// Number of the point of the first row.
    pub first: usize,
    /// The numbers of all columns but the first, one row after the other; NaN is an empty cell.
    numbers: Vec<f64>,
    outcomes: Vec<Outcome>,
}

impl Rows {
    /// No rows yet; `first`: number of the first point.
    pub(crate) fn new(columns: &Arc<Columns>, first: usize, capacity: usize) -> Self {
        let numbers = Vec::with_capacity(capacity * width(columns));
        Self { columns: Arc::clone(columns), first, numbers, outcomes: Vec::with_capacity(capacity) }
    }

    /// Adds a row with its values and the designation of its motor, or why it has none; missing values are empty cells.
    pub(crate) fn push(
        &mut self,
        parameters: &[f64],
        values: &[f64],
        ended: Result<Option<String>, Failure>,
    ) {
        let (outcome, failed) = match ended {
            Ok(motor) => {
                let motor = motor.unwrap_or_default();
                (Outcome { status: Status::Ok, message: String::new(), motor, written: true }, Some(0))
            }
            Err(Failure { status, message, failed }) => {
                let message = message.to_string().split_whitespace().collect::<Vec<_>>().join(" ");
                (Outcome { status, message, motor: String::new(), written: true }, failed)
            }
        };
        self.numbers.extend_from_slice(parameters);
        // Status and message are texts.
        self.numbers.extend([0.0, 0.0, failed.map_or(f64::NAN, |count| count as f64)]);
        self.numbers.extend_from_slice(values);
        self.outcomes.push(outcome);
        self.numbers.resize(self.outcomes.len() * width(&self.columns), f64::NAN);
    }

    /// Leaves the last row out of what is written.
    pub(crate) fn leave_out(&mut self) {
        self.outcomes.iter_mut().next_back().into_iter().for_each(|last| last.written = false);
    }

    /// Adds the rows of the points that follow.
    pub fn append(&mut self, mut next: Self) {
        self.numbers.append(&mut next.numbers);
        self.outcomes.append(&mut next.outcomes);
    }

    /// Removes the rows from `at` on and returns them.
    #[must_use]
    pub fn split_off(&mut self, at: usize) -> Self {
        Self {
            columns: Arc::clone(&self.columns),
            first: self.first + at,
            numbers: self.numbers.split_off(at * width(&self.columns)),
            outcomes: self.outcomes.split_off(at),
        }
    }

    /// How many rows there are.
    pub fn len(&self) -> usize {
        self.outcomes.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.outcomes.is_empty()
    }

    /// The rows that are written: those that hold the conditions of the sweep.
    pub fn written(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.len()).filter(|row| self.outcomes[*row].written)
    }

    /// How the point of a row ended, and what went wrong there; `None` beyond the last row.
    pub fn status(&self, row: usize) -> Option<(Status, &str)> {
        self.outcomes.get(row).map(|outcome| (outcome.status, outcome.message.as_str()))
    }

    /// The number of a cell; `None` of one that is empty or has a text.
    pub(crate) fn number(&self, row: usize, column: usize) -> Option<f64> {
        if let CsvCell::Number(number) = self.cell(row, column) { Some(number) } else { None }
    }

    /// One cell; empty outside the table.
    pub fn cell(&self, row: usize, column: usize) -> CsvCell<'_> {
        let columns = &self.columns;
        let (Some(outcome), true) = (self.outcomes.get(row), column < columns.names.len()) else {
            return CsvCell::Empty;
        };
        let Some(place) = column.checked_sub(1) else { return CsvCell::Number((self.first + row) as f64) };
        let number = self.numbers[row * width(columns) + place];
        match place.checked_sub(columns.parameters.len()) {
            None if let Some(words) = &columns.parameters[place] => {
                word(words, number).map_or(CsvCell::Empty, CsvCell::Text)
            }
            Some(0) => CsvCell::Text(outcome.status.text()),
            Some(1) => filled(&outcome.message),
            _ if columns.is_motor(column) => filled(&outcome.motor),
            _ if number.is_finite() => CsvCell::Number(number),
            _ => CsvCell::Empty,
        }
    }

    /// The written rows as CSV without a header: comma separated, numbers with all their digits; `ascii`: no character beyond
    /// ASCII. A line end is the end of a row.
    pub fn to_csv(&self, ascii: bool) -> Result<String, CsvError> {
        self.csv_of(self.written(), ascii)
    }

    /// One row as CSV, whether or not it is written.
    pub fn row_to_csv(&self, row: usize, ascii: bool) -> Result<String, CsvError> {
        self.csv_of(std::iter::once(row), ascii)
    }

    fn csv_of(&self, which: impl Iterator<Item = usize>, ascii: bool) -> Result<String, CsvError> {
        let names = &self.columns.names;
        rows(names, which.map(|row| (0..names.len()).map(move |column| self.cell(row, column))), ascii)
    }
}

/// Most names of columns that a message lists.
const MOST_NAMES: usize = 24;

/// Names of columns for a message, the first ones of many.
pub(crate) fn shown(names: &[&str]) -> Text {
    let more = names.get(MOST_NAMES).map(|_| "...");
    list(names.iter().take(MOST_NAMES).copied().chain(more).map(|own| name(own.to_owned())))
}

/// How many numbers a row has.
fn width(columns: &Columns) -> usize {
    columns.names.len() - 1
}

/// A text; none is an empty cell.
fn filled(text: &str) -> CsvCell<'_> {
    if text.is_empty() { CsvCell::Empty } else { CsvCell::Text(text) }
}

/// A row as CSV has it.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadRow {
    /// Number of its point.
    pub point: usize,
    /// How the calculation of the point ended.
    pub status: Status,
    /// The number of a column that was asked for; `None` where it has none.
    pub value: Option<f64>,
}

impl Sweep {
    /// Reads a row of CSV without its line end, and of it the number of a column. `None` if it is no row of this sweep: one with another
    /// number of columns, without a point or a status.
    pub fn read_row(&self, row: &str, column: Option<usize>) -> Option<ReadRow> {
        let mut quoted = false;
        let is_comma = |sign: char| {
            quoted ^= sign == '"';
            sign == ',' && !quoted
        };
        let cells: Vec<&str> = row.split(is_comma).collect();
        let columns = &self.columns;
        let value = column.and_then(|column| cells.get(column)?.parse().ok());
        let [point, status] = [0, columns.status()].map(|column| cells.get(column).copied());
        let found = ReadRow { point: point?.parse().ok()?, status: status?.parse().ok()?, value };
        (cells.len() == columns.names.len() && found.point < self.points()).then_some(found)
    }
}
