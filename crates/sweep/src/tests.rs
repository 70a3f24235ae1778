//! Tests of the grid, the keys, the columns and the forms.

mod columns;
mod grid;
mod keys;
mod written;

use std::num::NonZeroUsize;

use assur_all as _;
use assur_analysis::Options;

use assur_report::csv::Cell;

use crate::{Sweep, SweepError, Table, Vary};

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

fn sweep(scene: &str, vary: &[&str]) -> Result<Sweep, SweepError> {
    let vary: Vec<Vary> = vary.iter().map(|vary| Vary::parse(vary)).collect::<Result<_, _>>()?;
    Sweep::of("a.toml", scene, &vary)
}

fn run(scene: &str, vary: &[&str], threads: usize) -> Table {
    let threads = NonZeroUsize::new(threads).unwrap();
    sweep(scene, vary).unwrap().run(&Options::default(), threads, &|_| ()).unwrap()
}

fn column(table: &Table, name: &str) -> usize {
    let found = table.header().iter().position(|column| column == name);
    found.unwrap_or_else(|| panic!("no column {name}: {:?}", table.header()))
}

/// The numbers of a column, which has one in every row.
fn numbers(table: &Table, name: &str) -> Vec<f64> {
    let column = column(table, name);
    let cells = (0..table.len()).map(|row| match table.cell(row, column) {
        Cell::Number(value) => value,
        other => panic!("row {row} of {name}: {other:?}"),
    });
    cells.collect()
}
