//! The results of a scene as CSV: one file for the positions, one for reactions, one for the motion over time.

use assur_analysis::results::{Analysis, Column, Owner, Quantity, Schema, Table};

use super::{CsvError, header, number, unique};
use crate::template::{Template, Templates};
use assur_book::catalogue;

/// The names of all files that an analysis may have.
pub const FILES: [&str; 3] = ["positions.csv", "reactions.csv", "trajectory.csv"];

/// The name of the column with the numbers of the positions.
pub const INDEX: &str = "index";

/// One CSV file: its columns.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CsvTable {
    /// `positions.csv`
    pub file: &'static str,
    /// Columns of the table, and their names.
    columns: Vec<(usize, String)>,
    /// Whether the number of the position stands in front.
    numbered: bool,
    ascii: bool,
}

/// The files of the positions: `positions.csv`, and `reactions.csv` where it applies; `ascii`: no character beyond ASCII.
pub fn of_positions(analysis: &Analysis, ascii: bool) -> Vec<CsvTable> {
    let schema = analysis.positions.schema();
    let has = |column: usize| analysis.survey.has(schema.section_of(column)) || schema.is_nullable(column);
    let sheet = |file, columns| CsvTable { file, columns, numbered: true, ascii };
    let mut sheets = vec![sheet(FILES[0], places(schema, &has))];
    let balances = |column: &Column| column.quantity == Quantity::Balancing && column.cause.is_none();
    if schema.select(balances).into_iter().any(has) {
        sheets.push(sheet(FILES[1], reactions(schema, &has)));
    }
    sheets
}

/// The columns of all files of the positions in one table, in the order of the schema, each with a name that no other has; `index`, the
/// number of the position, is none of them and is not a name.
pub fn columns_of_positions(analysis: &Analysis) -> Vec<(usize, String)> {
    let schema = analysis.positions.schema();
    let has = |column: usize| analysis.survey.has(schema.section_of(column)) || schema.is_nullable(column);
    let all = shown(schema, &has, |_| true);
    let names = std::iter::once(INDEX.to_owned()).chain(all.iter().map(|(_, name)| name.clone()));
    let names = unique(names).into_iter().skip(1);
    all.iter().map(|(column, _)| *column).zip(names).collect()
}

/// The file of the motion over time, `trajectory.csv`, where it applies.
pub fn of_trajectory(analysis: &Analysis, ascii: bool) -> Option<CsvTable> {
    let table = &analysis.trajectory;
    let columns = samples(table.schema(), &|column| table.has(column) || table.schema().is_nullable(column));
    (!table.is_empty()).then_some(CsvTable { file: FILES[2], columns, numbered: false, ascii })
}

/// Whether a column is about forces.
fn is_reaction(column: Column) -> bool {
    matches!(column.quantity, Quantity::Force | Quantity::Moment | Quantity::Balancing)
}

/// Whether any row has a number in a column.
type Has<'a> = dyn Fn(usize) -> bool + 'a;

/// Columns that CSV has, with numbers in any row, in the order of the schema.
fn shown(schema: &Schema, has: &Has<'_>, wanted: impl Fn(Column) -> bool) -> Vec<(usize, String)> {
    let each = schema.select(|column| wanted(*column)).into_iter().filter(|column| has(*column));
    each.filter_map(|column| Some((column, catalogue::csv(schema, schema.columns()[column])?))).collect()
}

fn places(schema: &Schema, has: &Has<'_>) -> Vec<(usize, String)> {
    shown(schema, has, |column| !is_reaction(column))
}

fn reactions(schema: &Schema, has: &Has<'_>) -> Vec<(usize, String)> {
    // The balancing load stands before the reactions, the coordinate (over time those of all drives) before it.
    let is_coordinate = |column: Column| {
        column == Column::COORDINATE
            || schema.find(column) == schema.find(Column::COORDINATE)
            || matches!((column.quantity, column.owner), (Quantity::Transfer(0), Owner::Drive(_)))
    };
    let is_first = |column: Column| is_coordinate(column) || column.quantity == Quantity::Balancing;
    let mut all = shown(schema, has, is_first);
    all.extend(shown(schema, has, |column| is_reaction(column) && !is_first(column)));
    all
}

fn samples(schema: &Schema, has: &Has<'_>) -> Vec<(usize, String)> {
    let mut all = places(schema, has);
    // The balancing load of a motion is what the drive does.
    let drive = shown(schema, has, |column| column.quantity == Quantity::Balancing).into_iter();
    all.extend(drive.map(|(column, name)| (column, name.replace("balancing", "drive"))));
    all.extend(shown(schema, has, |column| is_reaction(column) && column.quantity != Quantity::Balancing));
    all
}

impl CsvTable {
    /// The columns of the table with their names, each of which no other has; the number of the position is none of them.
    pub fn columns(&self) -> Vec<(usize, String)> {
        let names = unique(self.columns.iter().map(|(_, name)| name.clone()));
        self.columns.iter().map(|(column, _)| *column).zip(names).collect()
    }

    /// The header row.
    pub fn header(&self) -> Result<Vec<u8>, CsvError> {
        let index = self.numbered.then_some(INDEX);
        let names = index.into_iter().chain(self.columns.iter().map(|(_, name)| name.as_str()));
        Ok(header(&names.collect::<Vec<_>>(), self.ascii)?.into_bytes())
    }

    /// The rows of a table, whose numbers are finite.
    pub fn rows(&self, table: &Table) -> Vec<u8> {
        let mut templates = Templates::new(table, self.columns.iter().map(|(column, _)| *column));
        let mut out = Vec::new();
        for row in 0..table.len() {
            if self.numbered {
                out.extend_from_slice(table.numbers()[row].to_string().as_bytes());
            }
            let make = |has: &Has<'_>| template(&self.columns, self.numbered, has);
            templates.of(table, row, make).write(table, row, &mut out, number);
        }
        out
    }
}

/// Commas between the numbers; a column without a number leaves its cell empty.
fn template(columns: &[(usize, String)], numbered: bool, has: &Has<'_>) -> Template {
    let (mut text, mut pieces) = (String::new(), Vec::new());
    for (place, (column, _)) in columns.iter().enumerate() {
        if numbered || place > 0 {
            text.push(',');
        }
        if has(*column) {
            pieces.push((std::mem::take(&mut text), *column));
        }
    }
    Template { pieces, end: text + "\n" }
}
