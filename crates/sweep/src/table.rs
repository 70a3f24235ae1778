//! Points from a table: its columns are parameters, its rows are points.

use std::sync::Arc;

use assur_scene::edit::ParsedText;
use assur_words::{Text, name, number, text};

use crate::column::{ROW, STATUS, parameter};
use crate::vary::Written;
use crate::{SweepError, Vary};

/// Most cells of a table of points: they are kept in memory.
const MOST_CELLS: usize = 1 << 22;

/// How rows of a table are called.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Numbering {
    /// By lines of a file, from 1.
    Lines,
    /// By rows, from 0.
    Rows,
}

/// Where the cells of a table are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Places {
    file: String,
    numbering: Numbering,
    /// The line or row of each point.
    numbers: Vec<usize>,
}

impl Places {
    /// What is wrong with the cell of a point.
    pub(crate) fn told(&self, point: usize, problem: Text) -> Text {
        let (file, at) = (name(self.file.clone()), number(self.numbers.get(point).copied().unwrap_or(0)));
        match self.numbering {
            Numbering::Lines => text!("sweep-at-line", file, line = at, problem),
            Numbering::Rows => text!("sweep-at-row", file, row = at, problem),
        }
    }
}

/// A table of points: the names of its columns are keys of the scene, or those that rows of a sweep have for them, which end with the
/// unit. A cell is a number in SI, a number with a unit, or a text. In a table of rows of a sweep, columns from `status` on are results
/// and passed over, and so is `row`.
///
/// # Examples
///
/// ```
/// use assur_sweep::{Numbering, PointTable};
///
/// let mut table = PointTable::new("points.csv", Numbering::Lines, ["row", "link.crank.points.A_m", "motion.speed"]);
/// table.push(2, ["0", "0.1", "60 rpm"])?;
/// assert!(table.push(3, ["1", "0.12"]).unwrap_err().to_string().contains("points.csv, line 3"));
/// # Ok::<(), assur_sweep::SweepError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PointTable {
    places: Places,
    /// How many cells a row has.
    width: usize,
    /// The parameters: number of the column, its name, its cells.
    columns: Vec<(usize, String, Vec<String>)>,
}

impl PointTable {
    /// A table with these columns, without rows.
    pub fn new<'a>(file: &str, numbering: Numbering, header: impl IntoIterator<Item = &'a str>) -> Self {
        let header: Vec<&str> = header.into_iter().map(str::trim).collect();
        let parameters = header.iter().take_while(|column| **column != STATUS).enumerate();
        let column = |(index, column): (usize, &&str)| (index, (*column).to_owned(), Vec::new());
        let columns = parameters.filter(|(_, column)| **column != ROW).map(column).collect();
        let places = Places { file: file.to_owned(), numbering, numbers: Vec::new() };
        Self { places, width: header.len(), columns }
    }

    /// Adds a row, which is called by its line or its number.
    ///
    /// # Errors
    ///
    /// More or fewer cells than columns; too many cells in all.
    pub fn push<'a>(
        &mut self,
        at: usize,
        cells: impl IntoIterator<Item = &'a str>,
    ) -> Result<(), SweepError> {
        let cells: Vec<&str> = cells.into_iter().map(str::trim).collect();
        let point = self.places.numbers.len();
        self.places.numbers.push(at);
        let problem = if cells.len() != self.width {
            text!("sweep-table-cells", cells = number(cells.len()), columns = number(self.width))
        } else if point * self.columns.len() >= MOST_CELLS {
            text!("sweep-table-size", most = number(MOST_CELLS))
        } else {
            let each = self.columns.iter_mut();
            each.for_each(|(index, _, column)| column.push(cells[*index].to_owned()));
            return Ok(());
        };
        Err(SweepError::Request(self.places.told(point, problem)))
    }

    /// The parameters of the table, for the points [`Points::Table`](crate::Points::Table) of a scene.
    ///
    /// # Errors
    ///
    /// No rows, no columns, or a column that is named after no key of the scene.
    pub fn vary(self, scene: &str) -> Result<Vec<Vary>, SweepError> {
        let document = ParsedText::of(scene);
        if self.columns.is_empty() || self.places.numbers.is_empty() {
            return Err(SweepError::Request(text!("sweep-table-empty", file = name(self.places.file))));
        }
        let places = Arc::new(self.places);
        let column = |(_, column, mut cells): (usize, String, Vec<String>)| {
            let unknown = |problem| {
                let file = name(places.file.clone());
                SweepError::vary(&column, text!("sweep-table-column", file, problem))
            };
            let (key, unit) = parameter(&document, &column).map_err(unknown)?;
            if let Some(unit) = unit {
                // Where a key takes several quantities, the name of the column tells which.
                let is_bare = |cell: &&mut String| cell.parse::<f64>().is_ok();
                cells.iter_mut().filter(is_bare).for_each(|cell| *cell = format!("{cell} {}", unit.si()));
            }
            Ok(Vary { key, values: Written::Column(cells, Arc::clone(&places)) })
        };
        self.columns.into_iter().map(column).collect()
    }
}
