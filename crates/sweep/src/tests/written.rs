//! CSV and Parquet, and that nothing depends on threads.

use std::io::Write;
use std::sync::Mutex;

use ::parquet::file::reader::{FileReader, SerializedFileReader};
use ::parquet::record::Field;
use assur_analysis::Options;

use super::{SLIDER, run, sweep};
use assur_report::csv::Cell;

use crate::parquet;

const GRID: [&str; 2] = ["link.crank.points.A=100 mm..400 mm:7", "link.rod.points.B=200 mm..400 mm:5"];

#[test]
fn one_thread_and_four_write_the_same_bytes() {
    let (one, four) = (run(SLIDER, &GRID, 1), run(SLIDER, &GRID, 4));
    assert!(one.failures().count() > 0, "some points have no solution");
    assert!(one.failures().count() < one.len(), "and some have");
    assert_eq!(one.to_csv(false).unwrap(), four.to_csv(false).unwrap());
    assert_eq!(parquet::to_parquet(&one).unwrap(), parquet::to_parquet(&four).unwrap());
}

#[test]
fn csv_reads_back_as_the_same_numbers() {
    let table = run(SLIDER, &GRID, 2);
    let text = table.to_csv(false).unwrap();
    let mut reader = ::csv::Reader::from_reader(text.as_bytes());
    assert_eq!(reader.headers().unwrap(), table.header());
    let records: Vec<_> = reader.records().map(Result::unwrap).collect();
    assert_eq!(records.len(), 35);
    for (row, record) in records.iter().enumerate() {
        for (column, text) in record.iter().enumerate() {
            match table.cell(row, column) {
                Cell::Empty => assert_eq!(text, ""),
                Cell::Text(known) => assert_eq!(text, known),
                Cell::Number(known) => assert_eq!(text.parse::<f64>().unwrap().to_bits(), known.to_bits()),
            }
        }
    }
}

#[test]
fn parquet_reads_back_as_the_same_cells() {
    let table = run(SLIDER, &GRID, 2);
    let mut file = tempfile::tempfile().unwrap();
    file.write_all(&parquet::to_parquet(&table).unwrap()).unwrap();
    let reader = SerializedFileReader::new(file).unwrap();
    let rows: Vec<_> = reader.get_row_iter(None).unwrap().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 35);
    for (row, found) in rows.iter().enumerate() {
        let names: Vec<_> = found.get_column_iter().map(|(name, _)| name).collect();
        assert_eq!(names, table.header().iter().collect::<Vec<_>>());
        for (column, (_, field)) in found.get_column_iter().enumerate() {
            match (table.cell(row, column), field) {
                (Cell::Empty, Field::Null) => {}
                (Cell::Text(known), Field::Str(text)) => assert_eq!(text, known),
                (Cell::Number(known), Field::Double(value)) => assert_eq!(value.to_bits(), known.to_bits()),
                (known, field) => panic!("{known:?} became {field:?}"),
            }
        }
    }
}

#[test]
fn progress_hears_every_point_once() {
    let heard = Mutex::new(Vec::new());
    let grid = sweep(SLIDER, &GRID).unwrap();
    let threads = 2.try_into().unwrap();
    grid.run(&Options::default(), threads, &|done| heard.lock().unwrap().push(done)).unwrap();
    let mut heard = heard.into_inner().unwrap();
    heard.sort_unstable();
    assert_eq!(heard, (1..=35).collect::<Vec<_>>());
}
