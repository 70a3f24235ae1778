//! Positions as Parquet: one column each, optional where some positions have no number.

use std::io::Write;

use assur_analysis::results::{Analysis, Section, Table};

use crate::{Column, File, ParquetError, Values};
use assur_report::csv;

/// Numbers of one group of rows: 96 MB, kept until they are compressed. Of each column of each group a kilobyte is kept until
/// the file ends: smaller groups take more memory in long files, larger ones in short files.
const NUMBERS: usize = 3 << 22;

/// Writes the positions of an analysis, block by block.
pub struct Writer<W: Write + Send> {
    file: File<W>,
    columns: Vec<Column>,
    /// Of each column but the first, which has the numbers of the positions: its column in the table.
    sources: Vec<usize>,
    rows: usize,
}

impl<W: Write + Send> Writer<W> {
    /// Begins a file with the columns that CSV has, under the same names.
    pub fn new(analysis: &Analysis, out: W) -> Result<Self, ParquetError> {
        let schema = analysis.positions.schema();
        let (sources, names): (Vec<usize>, Vec<String>) =
            csv::columns_of_positions(analysis).into_iter().unzip();
        let index = Column::of_whole(csv::INDEX.to_owned());
        let column = |(name, source): (String, &usize)| {
            Column::of_numbers(name, schema.section_of(*source) != Section::ALWAYS)
        };
        let columns: Vec<Column> =
            std::iter::once(index).chain(names.into_iter().zip(&sources).map(column)).collect();
        Ok(Self { file: File::new(&columns, Vec::new(), false, out)?, columns, sources, rows: 0 })
    }

    /// Adds the rows of a table.
    pub fn add(&mut self, table: &Table) -> Result<(), ParquetError> {
        for (nth, column) in self.columns.iter_mut().enumerate() {
            let source = nth.checked_sub(1).map(|nth| self.sources[nth]);
            column.extend(table, source);
        }
        self.rows += table.len();
        if self.rows * self.columns.len() >= NUMBERS { self.write_group() } else { Ok(()) }
    }

    /// Ends the file.
    pub fn finish(mut self) -> Result<(), ParquetError> {
        if self.rows > 0 {
            self.write_group()?;
        }
        self.file.finish().map(drop)
    }

    fn write_group(&mut self) -> Result<(), ParquetError> {
        self.rows = 0;
        self.file.write_group(&mut self.columns)
    }
}

impl Column {
    /// Adds the numbers of a column of a table; `None`: the numbers of the positions.
    fn extend(&mut self, table: &Table, source: Option<usize>) {
        match (&mut self.values, source) {
            (Values::Numbers(numbers), Some(source)) => {
                let values = table.values(source);
                let Some(levels) = &mut self.levels else { return numbers.extend_from_slice(values) };
                let present = table.present(table.schema().section_of(source));
                levels.extend(present.iter().map(|present| i16::from(*present)));
                numbers.extend(values.iter().zip(present).filter(|(_, has)| **has).map(|(value, _)| *value));
            }
            (Values::Whole(numbers), None) => {
                let each = table.numbers().iter();
                numbers.extend(each.map(|number| i64::try_from(*number).unwrap_or(i64::MAX)));
            }
            _ => {}
        }
    }
}
