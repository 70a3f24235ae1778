use std::io::Write;
use std::num::NonZeroUsize;

use ::parquet::file::reader::{FileReader, SerializedFileReader};
use ::parquet::record::Field;
use assur_all as _;
use assur_report::csv::CsvCell;
use assur_sweep::{Origin, Points, Rows as SweepRows, Sweep, SweepError, SweepRequest, Vary};

use crate::Rows;
use crate::sweep::{join, part};

/// A slider-crank, of which some points have no solution, and all have a text.
const SLIDER: &str = r#"[ground]
points = { O = [0, 0] }
[link.crank]
points = { O = 0, A = "100 mm" }
[link.rod]
points = { A = 0, B = 0.3 }
[link.piston]
points = { B = 0 }
[[slide]]
link = "piston"
on = "ground"
angle = "0 deg"
[input]
link = "crank"
positions = 12
[assembly]
B = [0.4, 0]
"#;

fn grid() -> Result<Sweep, SweepError> {
    let vary = ["link.crank.points.A=100 mm..400 mm:7", "link.rod.points.B=200 mm..400 mm:5"];
    let vary = vary.iter().map(|vary| Vary::parse(vary, Points::Grid)).collect::<Result<Vec<_>, _>>()?;
    Sweep::of("a.toml", SLIDER, &vary, SweepRequest::default())
}

fn run(threads: usize) -> Result<SweepRows, SweepError> {
    let sweep = grid()?;
    let mut all: Option<SweepRows> = None;
    let accept = |rows: SweepRows| {
        match &mut all {
            Some(all) => all.append(rows),
            None => all = Some(rows),
        }
        Ok::<_, SweepError>(())
    };
    let threads = NonZeroUsize::new(threads).unwrap_or(NonZeroUsize::MIN);
    sweep.run(&(0..sweep.points()), threads, |rows| rows, accept)?;
    all.ok_or(SweepError::Request(assur_words::Text::default()))
}

#[test]
fn one_thread_and_four_write_the_same_bytes() {
    assert_eq!(
        part(&run(1).unwrap(), &Origin::new()).unwrap(),
        part(&run(4).unwrap(), &Origin::new()).unwrap()
    );
}

#[test]
fn parquet_reads_back_as_the_same_cells() {
    let table = run(2).unwrap();
    let mut file = tempfile::tempfile().unwrap();
    file.write_all(&part(&table, &Origin::new()).unwrap()).unwrap();
    let reader = SerializedFileReader::new(file).unwrap();
    let rows: Vec<_> = reader.get_row_iter(None).unwrap().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 35);
    for (row, found) in rows.iter().enumerate() {
        let names: Vec<_> = found.get_column_iter().map(|(name, _)| name).collect();
        assert_eq!(names, table.columns.names.iter().collect::<Vec<_>>());
        for (column, (_, field)) in found.get_column_iter().enumerate() {
            match (table.cell(row, column), field) {
                (CsvCell::Empty, Field::Null) => {}
                (CsvCell::Text(known), Field::Str(text)) => assert_eq!(text, known),
                (CsvCell::Number(known), Field::Long(value)) => {
                    assert_eq!((column, i64::try_from(row)), (0, Ok(*value)));
                    assert_eq!(known.to_string(), value.to_string());
                }
                (CsvCell::Number(known), Field::Double(value)) => {
                    assert_eq!(value.to_bits(), known.to_bits());
                }
                (known, field) => panic!("{known:?} became {field:?}"),
            }
        }
    }
}

#[test]
fn a_file_tells_its_scene_its_ranges_and_the_extremes_of_its_columns() {
    let file = |bytes: &[u8]| {
        let mut file = tempfile::tempfile().unwrap();
        file.write_all(bytes).unwrap();
        file
    };
    let (sweep, table) = (grid().unwrap(), run(1).unwrap());
    let mut joined = tempfile::tempfile().unwrap();
    join(&sweep, &sweep.origin(), [Ok(file(&part(&table, &Origin::new()).unwrap()))], &mut joined).unwrap();
    let reader = SerializedFileReader::new(joined.try_clone().unwrap()).unwrap();
    let metadata = reader.metadata().file_metadata();
    let value = |key: &str| {
        let all = metadata.key_value_metadata().unwrap();
        all.iter().find(|one| one.key == key).and_then(|one| one.value.clone()).unwrap()
    };
    assert_eq!(value("assur.scene"), SLIDER);
    assert_eq!(
        value("assur.vary"),
        "link.crank.points.A=100 mm..400 mm:7\nlink.rod.points.B=200 mm..400 mm:5"
    );
    let statistics = reader.metadata().row_group(0).column(1).statistics().unwrap();
    let ends = [statistics.min_bytes_opt(), statistics.max_bytes_opt()];
    assert_eq!(ends.map(Option::unwrap), [0.1_f64, 0.4].map(f64::to_le_bytes));
    // The last parameter changes fastest.
    let mut rows = Rows::of(joined, |name| name != "status" && !name.starts_with("reaction")).unwrap();
    let names = ["row", "link.crank.points.A_m", "link.rod.points.B_m"];
    assert_eq!(rows.header[..3], names);
    assert!(!rows.header.contains(&"status".to_owned()));
    assert_eq!(rows.nth(6).unwrap().unwrap()[..3], ["6", "0.15", "0.25"]);
    assert_eq!(rows.count(), 28);
}
