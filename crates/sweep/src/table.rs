//! The rows of a sweep.

use assur_report::csv::{Cell, CsvError, unique, write};

use crate::row::Row;

/// How the calculation of a point ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// Everything that the scene requests was found.
    Ok,
    /// A position can't be assembled.
    NoAssembly,
    /// A position is singular, or the motion has no solution.
    NoSolution,
    /// The scene as a whole can't be calculated.
    Error,
    /// The reader of scenes refuses the values.
    Refused,
}

impl Status {
    /// The word for it in the table.
    pub fn text(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::NoAssembly => "no assembly",
            Self::NoSolution => "no solution",
            Self::Error => "error",
            Self::Refused => "refused",
        }
    }
}

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Column {
    Parameter(usize),
    Status,
    Message,
    Failed,
    Value(usize),
    Motor,
}

/// The rows of a sweep, in the order of the grid: the last parameter changes fastest.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    header: Vec<String>,
    columns: Vec<Column>,
    rows: Vec<Row>,
}

impl Table {
    pub(crate) fn of(parameters: Vec<String>, mut rows: Vec<Row>) -> Self {
        let names = union(&rows);
        for row in rows.iter_mut().filter(|row| !row.names.is_empty() && *row.names != *names) {
            let own = |name| row.names.iter().position(|own| own == name).map(|at| row.values[at]);
            // A value that a row lacks is NaN, and an empty cell.
            row.values = names.iter().map(|name| own(name).unwrap_or(f64::NAN)).collect();
        }
        let mut columns: Vec<Column> = (0..parameters.len()).map(Column::Parameter).collect();
        columns.extend([Column::Status, Column::Message, Column::Failed]);
        columns.extend((0..names.len()).map(Column::Value));
        let mut header = parameters;
        header.extend(["status", "message", "failed_positions"].map(str::to_owned));
        header.extend(names);
        if rows.iter().any(|row| row.motor.is_some()) {
            columns.push(Column::Motor);
            header.push("motor".to_owned());
        }
        Self { header: unique(header), columns, rows }
    }

    /// Names of the columns.
    pub fn header(&self) -> &[String] {
        &self.header
    }

    /// The table as CSV: one header row, comma separated, numbers with all their digits; `ascii`: no character beyond ASCII.
    ///
    /// # Errors
    ///
    /// [`CsvError`] if the writer fails.
    pub fn to_csv(&self, ascii: bool) -> Result<String, CsvError> {
        let row = |row| (0..self.header.len()).map(move |column| self.cell(row, column));
        write(&self.header, (0..self.len()).map(row), ascii)
    }

    /// How many rows there are.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// How the point of a row ended, and what went wrong there; `None` beyond the last row.
    pub fn status(&self, row: usize) -> Option<(Status, &str)> {
        self.rows.get(row).map(|row| (row.status, row.message.as_str()))
    }

    /// Rows whose point has no solution.
    pub fn failures(&self) -> impl Iterator<Item = usize> {
        (0..self.len()).filter(|row| self.rows[*row].status != Status::Ok)
    }

    /// Whether a column holds texts; otherwise numbers.
    pub fn is_text(&self, column: usize) -> bool {
        matches!(self.columns.get(column), Some(Column::Status | Column::Message | Column::Motor))
    }

    /// One cell; empty outside the table.
    pub fn cell(&self, row: usize, column: usize) -> Cell<'_> {
        let (Some(found), Some(column)) = (self.rows.get(row), self.columns.get(column)) else {
            return Cell::Empty;
        };
        match *column {
            Column::Parameter(index) => found.parameters.get(index).map_or(Cell::Empty, |x| Cell::Number(*x)),
            Column::Status => Cell::Text(found.status.text()),
            Column::Message => text(&found.message),
            Column::Failed => found.failed.map_or(Cell::Empty, |count| Cell::Number(count as f64)),
            Column::Motor => text(found.motor.as_deref().unwrap_or_default()),
            Column::Value(index) => match found.values.get(index) {
                Some(value) if value.is_finite() => Cell::Number(*value),
                _ => Cell::Empty,
            },
        }
    }
}

fn text(text: &str) -> Cell<'_> {
    if text.is_empty() { Cell::Empty } else { Cell::Text(text) }
}

/// The names of all rows; a name that an earlier row lacks is inserted after its neighbor to the left.
fn union(rows: &[Row]) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    let mut last: &[String] = &[];
    for row in rows {
        // Rows that share their list of names add nothing new.
        if *row.names == *last {
            continue;
        }
        last = &row.names;
        let mut after = 0;
        for name in last {
            if let Some(at) = all.iter().position(|known| known == name) {
                after = at + 1;
            } else {
                all.insert(after, name.clone());
                after += 1;
            }
        }
    }
    all
}
