//! A scene with many values of its numbers.

use std::num::NonZeroUsize;

use assur_report::csv::CsvCell;
use assur_sweep::{Condition, Measure, Points, Sweep, SweepError, SweepRequest, Vary};
use assur_words::Describe;

use crate::{Error, Scene};

/// The rows of a sweep: one for each point, in their order, without those that a condition leaves out.
#[derive(Debug, Clone)]
pub struct SweepRows {
    points: Vec<usize>,
    names: Vec<String>,
    statuses: Vec<&'static str>,
    messages: Vec<String>,
    values: Vec<Vec<f64>>,
    texts: Vec<Vec<String>>,
}

pub(crate) fn of(
    scene: &Scene,
    vary: &[&str],
    measures: &[&str],
    conditions: &[&str],
) -> Result<SweepRows, Error> {
    let failed = |error: SweepError| Error::told(error.describe());
    let axes: Result<Vec<Vary>, SweepError> = vary.iter().map(|one| Vary::parse(one, Points::Grid)).collect();
    let measures =
        if measures.is_empty() { Measure::defaults() } else { Measure::named(measures).map_err(failed)? };
    let conditions =
        conditions.iter().map(|one| Condition::parse(one)).collect::<Result<_, _>>().map_err(failed)?;
    let request = SweepRequest { measures, conditions, ..SweepRequest::default() };
    let sweep = Sweep::of(&scene.file, &scene.text, &axes.map_err(failed)?, request).map_err(failed)?;
    let names = sweep.columns.names.clone();
    let mut rows = SweepRows {
        points: Vec::new(),
        statuses: Vec::new(),
        messages: Vec::new(),
        values: vec![Vec::new(); names.len()],
        texts: vec![Vec::new(); names.len()],
        names,
    };
    let threads = std::thread::available_parallelism().unwrap_or(NonZeroUsize::MIN);
    let taken = sweep.run(
        &(0..sweep.points()),
        threads,
        |rows| rows,
        |block| -> Result<(), SweepError> {
            for row in block.written() {
                rows.points.push(block.first + row);
                if let Some((status, message)) = block.status(row) {
                    rows.statuses.push(status.text());
                    rows.messages.push(message.to_owned());
                }
                for column in 0..rows.names.len() {
                    match block.cell(row, column) {
                        CsvCell::Number(value) => rows.values[column].push(value),
                        CsvCell::Text(text) => rows.texts[column].push(text.to_owned()),
                        CsvCell::Empty if sweep.columns.is_text(column) => {
                            rows.texts[column].push(String::new());
                        }
                        CsvCell::Empty => rows.values[column].push(f64::NAN),
                    }
                }
            }
            Ok(())
        },
    );
    taken.map_err(failed).map(|()| rows)
}

impl SweepRows {
    /// How many rows there are.
    pub fn len(&self) -> usize {
        self.statuses.len()
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.statuses.is_empty()
    }

    /// The number of the point of each row, from 0: where a condition leaves rows out, with gaps.
    pub fn points(&self) -> &[usize] {
        &self.points
    }

    /// The names of the columns, as `assur sweep` writes them.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// How each point ended: `ok`, or what it lacks.
    pub fn statuses(&self) -> &[&'static str] {
        &self.statuses
    }

    /// What went wrong at each point; empty where nothing did.
    pub fn messages(&self) -> &[String] {
        &self.messages
    }

    /// The numbers of a column in SI; NaN where a point has none.
    ///
    /// # Errors
    ///
    /// No column of numbers has the name; the error names the most similar.
    pub fn column(&self, name: &str) -> Result<&[f64], Error> {
        let found =
            self.names.iter().position(|own| own == name).filter(|index| self.texts[*index].is_empty());
        found
            .map(|index| &*self.values[index])
            .ok_or_else(|| Error::unknown("column of numbers", name, self.names.iter().map(String::as_str)))
    }

    /// The words of a column, such as `motor`.
    ///
    /// # Errors
    ///
    /// No column of texts has the name.
    pub fn texts(&self, name: &str) -> Result<&[String], Error> {
        let found =
            self.names.iter().position(|own| own == name).filter(|index| self.values[*index].is_empty());
        found
            .map(|index| &*self.texts[index])
            .ok_or_else(|| Error::unknown("column of texts", name, self.names.iter().map(String::as_str)))
    }
}
