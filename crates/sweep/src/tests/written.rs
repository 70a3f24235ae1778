//! CSV, and that nothing depends on threads.

use std::num::NonZeroUsize;

use super::{SLIDER, failures, requested, rows, run, sweep};
use assur_report::csv::{CsvCell, header};
use assur_words::Text;

use crate::{Measure, Rows, SweepError, SweepRequest};

const GRID: [&str; 2] = ["link.crank.points.A=100 mm..400 mm:7", "link.rod.points.B=200 mm..400 mm:5"];

#[test]
fn one_thread_and_four_write_the_same_bytes() {
    let (one, four) = (run(SLIDER, &GRID, 1), run(SLIDER, &GRID, 4));
    assert!((1..one.len()).contains(&failures(&one).len()), "some points have no solution, some have");
    assert_eq!(one.to_csv(false).unwrap(), four.to_csv(false).unwrap());
}

#[test]
fn csv_reads_back_as_the_same_numbers() {
    let table = run(SLIDER, &GRID, 2);
    let text = header(&table.columns.names, false).unwrap() + &table.to_csv(false).unwrap();
    let mut reader = ::csv::Reader::from_reader(text.as_bytes());
    assert_eq!(reader.headers().unwrap(), table.columns.names);
    let records: Vec<_> = reader.records().map(Result::unwrap).collect();
    assert_eq!(records.len(), 35);
    for (row, record) in records.iter().enumerate() {
        for (column, text) in record.iter().enumerate() {
            match table.cell(row, column) {
                CsvCell::Empty => assert_eq!(text, ""),
                CsvCell::Text(known) => assert_eq!(text, known),
                CsvCell::Number(known) => assert_eq!(text.parse::<f64>().unwrap().to_bits(), known.to_bits()),
            }
        }
    }
}

#[test]
fn parts_of_a_sweep_follow_one_another() {
    let grid = sweep(SLIDER, &GRID).unwrap();
    let whole = rows(&grid, 2).to_csv(false).unwrap();
    for parts in [1, 2, 3, 7, 35, 40] {
        let mut text = String::new();
        let mut next = 0;
        for part in 1..=parts {
            let points = grid.part(part, parts);
            assert_eq!(points.start, next, "{part} of {parts}");
            assert!(points.len().abs_diff(35 / parts) <= 1);
            next = points.end;
            let accept = |block: String| {
                text += &block;
                Ok::<_, SweepError>(())
            };
            let threads = NonZeroUsize::new(2).unwrap();
            grid.run(&points, threads, |rows| rows.to_csv(false).unwrap(), accept).unwrap();
        }
        assert_eq!((next, &text), (35, &whole));
    }
}

#[test]
fn the_writer_can_end_a_run() {
    let grid = sweep(SLIDER, &["link.crank.points.A=100 mm..200 mm:100000"]).unwrap();
    let mut blocks = 0;
    let accept = |_: Rows| {
        blocks += 1;
        if blocks == 3 { Err(SweepError::Request(Text::default())) } else { Ok(()) }
    };
    let ended = grid.run(&(0..grid.points()), NonZeroUsize::new(2).unwrap(), |rows| rows, accept);
    assert_eq!((ended, blocks), (Err(SweepError::Request(Text::default())), 3));
}

#[test]
fn the_more_columns_the_fewer_rows_are_in_memory() {
    let points = (0..200).fold(String::new(), |text, i| text + &format!(", P{i} = [0.1, 0.{i:03}]"));
    let scene = SLIDER.replace("A = \"100 mm\"", &format!("A = \"100 mm\"{points}"));
    let asked = SweepRequest {
        measures: Measure::named(&["default", "extremes"]).unwrap(),
        ..SweepRequest::default()
    };
    let (wide, narrow) = (requested(&scene, &GRID, asked).unwrap(), sweep(SLIDER, &GRID).unwrap());
    let columns = wide.columns.names.len();
    assert!(columns > 800, "blocks have fewer than 64 points: {columns}");
    let most = 1_usize << 23;
    assert!(
        wide.rows_of_part(1_000_000_000) * columns <= most
            && (wide.rows_of_part(1_000_000_000) + 1) * columns > most
    );
    assert_eq!(narrow.rows_of_part(1_000_000_000), 65_536);
    // The rows are those of the points one by one.
    let table = rows(&wide, 3);
    let single: String = (0..35).map(|point| wide.row(point).to_csv(false).unwrap()).collect();
    assert_eq!(table.to_csv(false).unwrap(), single);
}
