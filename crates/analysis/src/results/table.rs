//! Rows of numbers under a schema.

use std::sync::Arc;

use assur_number::{Lanes, Real, elementary};

use super::{Column, Part, Schema, Section};

/// Which of eight rows.
pub type Mask = [bool; Lanes::WIDTH];

/// Rows of numbers, column by column.
///
/// A row without a number in a column is marked, not filled with NaN: the columns of a [`Section`] have numbers in the
/// same rows. A position without a solution has no row. A block of a long calculation is a table of some of its rows.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Table {
    schema: Arc<Schema>,
    /// Number of the position or sample of each row, increasing.
    numbers: Vec<usize>,
    columns: Vec<Vec<f64>>,
    /// By section, whether a row has its numbers; 0 stands where it has none.
    present: Vec<Vec<bool>>,
}

impl Table {
    /// No rows yet.
    pub fn new(schema: Arc<Schema>) -> Self {
        let (columns, sections) = (schema.columns().len(), schema.sections);
        Self {
            schema,
            numbers: Vec::new(),
            columns: vec![Vec::new(); columns],
            present: vec![Vec::new(); sections],
        }
    }

    /// Makes room for more rows.
    pub(crate) fn reserve(&mut self, rows: usize) {
        self.numbers.reserve(rows);
        self.columns.iter_mut().for_each(|column| column.reserve(rows));
        self.present.iter_mut().for_each(|present| present.reserve(rows));
    }

    /// Starts those of eight rows that are marked; their numbers follow `first`, and their cells follow in the order of the
    /// columns.
    pub fn rows(&mut self, first: usize, rows: Mask) -> Cells<'_> {
        let count = rows.iter().filter(|row| **row).count();
        self.numbers.extend((first..).zip(rows).filter(|(_, row)| *row).map(|(number, _)| number));
        for (section, present) in self.present.iter_mut().enumerate() {
            present.extend(std::iter::repeat_n(Section(section) == Section::ALWAYS, count));
        }
        Cells { table: self, rows, all: count == Lanes::WIDTH, column: 0 }
    }

    /// Adds a row with the numbers of all columns; `None`: it has none there.
    pub fn push(&mut self, number: usize, values: impl IntoIterator<Item = Option<f64>>) {
        let mut cells = self.rows(number, std::array::from_fn(|lane| lane == 0));
        for value in values {
            cells.put(Lanes::from_f64(value.unwrap_or(0.0)), [value.is_some(); Lanes::WIDTH]);
        }
    }

    /// Adds rows of another table of the same schema at the end: those whose number is wanted.
    pub(crate) fn append(&mut self, more: &Self, wanted: impl Fn(usize) -> bool) {
        let rows: Vec<usize> = (0..more.len()).filter(|row| wanted(more.numbers[*row])).collect();
        self.numbers.extend(rows.iter().map(|row| more.numbers[*row]));
        for (own, more) in self.columns.iter_mut().zip(&more.columns) {
            own.extend(rows.iter().map(|row| more[*row]));
        }
        for (own, more) in self.present.iter_mut().zip(&more.present) {
            own.extend(rows.iter().map(|row| more[*row]));
        }
    }

    /// The rows whose number is wanted.
    #[must_use]
    pub fn only(&self, wanted: impl Fn(usize) -> bool) -> Self {
        let mut table = Self::new(Arc::clone(&self.schema));
        table.append(self, wanted);
        table
    }

    /// Replaces the numbers of a column; each row keeps whether it has one.
    pub(crate) fn column_mut(&mut self, column: usize) -> &mut [f64] {
        &mut self.columns[column]
    }

    /// Adds the columns of another table, with its numbers in the rows of the same number; all its columns are ones that
    /// some rows lack.
    pub(crate) fn join(&mut self, other: &Self) {
        if other.is_empty() {
            return;
        }
        let rows: Vec<Option<usize>> = self.numbers.iter().map(|number| other.row_of(*number)).collect();
        let mut schema = Schema::clone(&self.schema);
        schema.causes.extend(other.schema.causes.iter().cloned());
        let sections: Vec<Section> = (1..other.present.len()).map(|_| schema.section()).collect();
        for (index, column) in other.schema.columns().iter().enumerate() {
            schema.add(sections[other.schema.section_of(index).0 - 1], [*column]);
        }
        let values = |values: &Vec<f64>| rows.iter().map(|row| row.map_or(0.0, |row| values[row])).collect();
        let present =
            |present: &Vec<bool>| rows.iter().map(|row| row.is_some_and(|row| present[row])).collect();
        self.columns.extend(other.columns.iter().map(values));
        self.present.extend(other.present[1..].iter().map(present));
        self.schema = Arc::new(schema);
    }

    /// The columns.
    pub fn schema(&self) -> &Arc<Schema> {
        &self.schema
    }

    /// How many rows there are.
    pub fn len(&self) -> usize {
        self.numbers.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.numbers.is_empty()
    }

    /// Number of the position or sample of each row, increasing.
    pub fn numbers(&self) -> &[usize] {
        &self.numbers
    }

    /// The row of a position or sample by its number; `None` where it has no solution.
    pub fn row_of(&self, number: usize) -> Option<usize> {
        self.numbers.binary_search(&number).ok()
    }

    /// The numbers of a column with 0 where a row has none: see [`present`](Self::present).
    pub fn values(&self, column: usize) -> &[f64] {
        &self.columns[column]
    }

    /// By row, whether it has numbers in this section.
    pub fn present(&self, section: Section) -> &[bool] {
        &self.present[section.0]
    }

    /// The number of a row in a column, by its index.
    pub fn at(&self, row: usize, column: usize) -> Option<f64> {
        let has = *self.present(self.schema.section_of(column)).get(row)?;
        has.then(|| self.columns[column][row])
    }

    /// The number of a row in a column; a [magnitude](Part::Modulus) is that of both projections.
    pub fn get(&self, row: usize, column: Column) -> Option<f64> {
        match column.part {
            Part::Modulus => {
                let [x, y] = [Part::X, Part::Y].map(|part| self.get(row, column.part(part)));
                Some(elementary::hypot(x?, y?))
            }
            _ => self.at(row, self.schema.find(column)?),
        }
    }

    /// The number of each row in a column; `None` where it has none.
    pub fn each(&self, column: usize) -> impl ExactSizeIterator<Item = Option<f64>> {
        let present = self.present(self.schema.section_of(column));
        self.columns[column].iter().zip(present).map(|(value, has)| has.then_some(*value))
    }

    /// Whether any row has a number in this column.
    pub fn has(&self, column: usize) -> bool {
        self.present(self.schema.section_of(column)).contains(&true)
    }

    /// The first number, row by row, that is not finite: its row and its column.
    pub fn not_finite(&self) -> Option<(usize, usize)> {
        let first = |(column, values): (usize, &Vec<f64>)| {
            // Rows without a number hold 0.
            values.iter().position(|value| !value.is_finite()).map(|row| (row, column))
        };
        self.columns.iter().enumerate().filter_map(first).min()
    }
}

/// The cells of the last rows of a table, at most eight, which are filled in the order of the columns.
#[derive(Debug)]
pub struct Cells<'a> {
    table: &'a mut Table,
    rows: Mask,
    /// Whether all eight have a row.
    all: bool,
    column: usize,
}

impl Cells<'_> {
    /// The numbers of the next column, and the rows that have one; all columns of a section have them in the same rows.
    pub fn put(&mut self, values: Lanes, has: Mask) {
        let section = self.table.schema.section_of(self.column);
        let is_full = section == Section::ALWAYS;
        let values =
            if is_full { values } else { Lanes::of(|lane| if has[lane] { values.0[lane] } else { 0.0 }) };
        let Table { columns, present, .. } = &mut *self.table;
        let (column, present) = (&mut columns[self.column], &mut present[section.0]);
        self.column += 1;
        let rows = || (0..Lanes::WIDTH).filter(|lane| self.rows[*lane]);
        if self.all {
            column.extend_from_slice(&values.0);
        } else {
            column.extend(rows().map(|lane| values.0[lane]));
        }
        match present.last_chunk_mut() {
            _ if is_full => {}
            Some(last) if self.all => *last = has,
            _ => {
                let first = present.len() - rows().count();
                present[first..].iter_mut().zip(rows()).for_each(|(present, lane)| *present = has[lane]);
            }
        }
    }
}
