//! Rows of a sweep.

use std::sync::Arc;

use assur_report::csv::{CsvCell, CsvError, rows};
use assur_words::Text;
use strum::{EnumString, IntoStaticStr};

use crate::Sweep;

/// How the calculation of a point ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, EnumString, IntoStaticStr)]
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

/// The columns of a sweep: parameters, status, message, failed positions, values, and the motor where there is one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Columns {
    /// Their names.
    pub names: Vec<String>,
    parameters: usize,
    has_motor: bool,
}

impl Columns {
    pub(crate) fn new(parameters: Vec<String>, values: Vec<String>, has_motor: bool) -> Self {
        let count = parameters.len();
        let outcome = ["status", "message", "failed_positions"].map(str::to_owned);
        let motor = has_motor.then(|| "motor".to_owned());
        let names = parameters.into_iter().chain(outcome).chain(values).chain(motor);
        Self { names: assur_report::csv::unique(names), parameters: count, has_motor }
    }

    pub(crate) fn value_name(&self, value: usize) -> &str {
        self.names.get(self.parameters + 3 + value).map_or("", String::as_str)
    }

    /// Whether a column holds texts; otherwise numbers.
    pub fn is_text(&self, column: usize) -> bool {
        [self.parameters, self.parameters + 1].contains(&column) || self.is_motor(column)
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
}

/// Rows of successive points of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct Rows {
    /// The columns.
    pub columns: Arc<Columns>,
    /// Number of the point of the first row.
    pub first: usize,
    /// The numbers of all columns, one row after the other; NaN is an empty cell.
    numbers: Vec<f64>,
    outcomes: Vec<Outcome>,
}

impl Rows {
    /// No rows yet; `first`: number of the first point.
    pub(crate) fn new(columns: &Arc<Columns>, first: usize, capacity: usize) -> Self {
        let numbers = Vec::with_capacity(capacity * columns.names.len());
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
                (Outcome { status: Status::Ok, message: String::new(), motor }, Some(0))
            }
            Err(Failure { status, message, failed }) => {
                let message = message.to_string().split_whitespace().collect::<Vec<_>>().join(" ");
                (Outcome { status, message, motor: String::new() }, failed)
            }
        };
        self.numbers.extend_from_slice(parameters);
        // Status and message are texts.
        self.numbers.extend([0.0, 0.0, failed.map_or(f64::NAN, |count| count as f64)]);
        self.numbers.extend_from_slice(values);
        self.outcomes.push(outcome);
        self.numbers.resize(self.outcomes.len() * self.columns.names.len(), f64::NAN);
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
            numbers: self.numbers.split_off(at * self.columns.names.len()),
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
        let (columns, width) = (&self.columns, self.columns.names.len());
        let (Some(outcome), true) = (self.outcomes.get(row), column < width) else { return CsvCell::Empty };
        match column.checked_sub(columns.parameters) {
            Some(0) => CsvCell::Text(outcome.status.text()),
            Some(1) => text(&outcome.message),
            _ if columns.is_motor(column) => text(&outcome.motor),
            _ => match self.numbers[row * width + column] {
                number if number.is_finite() => CsvCell::Number(number),
                _ => CsvCell::Empty,
            },
        }
    }

    /// The rows as CSV without a header: comma separated, numbers with all their digits; `ascii`: no character beyond
    /// ASCII. A line end is the end of a row.
    pub fn to_csv(&self, ascii: bool) -> Result<String, CsvError> {
        let names = &self.columns.names;
        let row = |row| (0..names.len()).map(move |column| self.cell(row, column));
        rows(names, (0..self.len()).map(row), ascii)
    }
}

fn text(text: &str) -> CsvCell<'_> {
    if text.is_empty() { CsvCell::Empty } else { CsvCell::Text(text) }
}

impl Sweep {
    /// Reads what [`Tally`](crate::Tally) counts from a row of CSV without its line end: how the calculation of the
    /// point ended. `None` if it is no row of this sweep: one with another number of columns, or without a status.
    pub fn status_in_csv(&self, row: &str) -> Option<Status> {
        let mut quoted = false;
        let is_comma = |sign: &char| {
            quoted ^= *sign == '"';
            *sign == ',' && !quoted
        };
        if row.chars().filter(is_comma).count() + 1 != self.columns.names.len() {
            return None;
        }
        // Parameters are numbers, so there is no quoted comma before the status.
        row.split(',').nth(self.columns.parameters)?.parse().ok()
    }
}

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
    pub fn add(&mut self, point: usize, status: Status) {
        self.points += 1;
        self.hopeless += usize::from(status.is_hopeless());
        if status != Status::Ok {
            self.failures += 1;
            self.first.get_or_insert(point);
        }
    }

    /// Counts rows.
    pub fn of(rows: &Rows) -> Self {
        let mut tally = Self::default();
        let each = (0..rows.len()).filter_map(|row| Some((rows.first + row, rows.status(row)?.0)));
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
