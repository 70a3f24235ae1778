//! Rows as CSV.

use assur_report::csv::{CsvError, header, rows};

use crate::{Rows, Sweep};

impl Sweep {
    /// The header row with its line end; `ascii`: no character beyond ASCII.
    ///
    /// # Errors
    ///
    /// [`CsvError`] if the writer fails.
    pub fn csv_header(&self, ascii: bool) -> Result<String, CsvError> {
        header(self.columns.names(), ascii)
    }

    /// Reads what [`Tally`](crate::Tally) counts from a row of CSV without its line end: how the calculation of the
    /// point ended. `None` if it is no row of this sweep.
    pub fn status_in_csv(&self, row: &str) -> Option<crate::Status> {
        // Parameters are numbers, so there is no quoted comma before the status.
        crate::Status::of(row.split(',').nth(self.columns.status())?)
    }
}

impl Rows {
    /// The rows as CSV without a header: comma separated, numbers with all their digits; `ascii`: no character beyond
    /// ASCII. A line end is the end of a row.
    ///
    /// # Errors
    ///
    /// [`CsvError`] if the writer fails.
    pub fn to_csv(&self, ascii: bool) -> Result<String, CsvError> {
        let row = |row| (0..self.header().len()).map(move |column| self.cell(row, column));
        rows(self.header(), (0..self.len()).map(row), ascii)
    }
}
