//! Tests of the grid, the keys, the columns and the forms.

mod between;
mod columns;
mod conditions;
mod grid;
mod keys;
mod measures;
mod reports;
mod sample;
mod tables;
mod variants;
mod written;

use std::num::NonZeroUsize;

use assur_all as _;
use assur_report::csv::CsvCell;

use crate::{Rows, Status, Sweep, SweepError, SweepRequest, Vary};

/// A slider-crank whose places are known in closed form: crank r, rod l, slide along x.
const SLIDER: &str = r#"[ground]
points = { O = [0, 0] }

[link.crank]
points = { O = 0, A = "100 mm" }

[link.rod]
points = { A = 0, B = 0.3 }

[link.piston]
points = { B = 0 }
mass = "2 kg"

[[slide]]
link = "piston"
on = "ground"
angle = "0 deg"

[input]
link = "crank"
positions = 12

[[force]]
name = "gas"
link = "piston"
at = "B"
angle = "180 deg"
value = "1 kN"

[[force]]
link = "rod"
at = "A"
angle = 0
value = 0

[assembly]
B = [0.4, 0]
"#;

fn requested(scene: &str, vary: &[&str], request: SweepRequest) -> Result<Sweep, SweepError> {
    let vary: Vec<Vary> =
        vary.iter().map(|vary| Vary::parse(vary, request.points)).collect::<Result<_, _>>()?;
    Sweep::of("a.toml", scene, &vary, request)
}

fn sweep(scene: &str, vary: &[&str]) -> Result<Sweep, SweepError> {
    requested(scene, vary, SweepRequest::default())
}

fn rows(sweep: &Sweep, threads: usize) -> Rows {
    let mut all: Option<Rows> = None;
    let accept = |rows: Rows| {
        match &mut all {
            Some(all) => all.append(rows),
            None => all = Some(rows),
        }
        Ok::<_, SweepError>(())
    };
    sweep.run(&(0..sweep.points()), NonZeroUsize::new(threads).unwrap(), |rows| rows, accept).unwrap();
    all.unwrap()
}

fn run(scene: &str, vary: &[&str], threads: usize) -> Rows {
    rows(&sweep(scene, vary).unwrap(), threads)
}

fn column(table: &Rows, name: &str) -> usize {
    let found = table.columns.names.iter().position(|column| column == name);
    found.unwrap_or_else(|| panic!("no column {name}: {:?}", table.columns.names))
}

/// The numbers of a column, which has one in every row.
fn numbers(table: &Rows, name: &str) -> Vec<f64> {
    let column = column(table, name);
    let cells = (0..table.len()).map(|row| match table.cell(row, column) {
        CsvCell::Number(value) => value,
        other => panic!("row {row} of {name}: {other:?}"),
    });
    cells.collect()
}

fn failures(table: &Rows) -> Vec<usize> {
    (0..table.len()).filter(|row| table.status(*row).unwrap().0 != Status::Ok).collect()
}
