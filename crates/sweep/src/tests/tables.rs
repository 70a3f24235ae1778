//! Points of a table, and texts as values.

use super::{SLIDER, numbers, requested, rows, run, sweep};
use assur_report::csv::CsvCell;

use crate::{Measure, Numbering, PointTable, Points, Status, Sweep, SweepError, SweepRequest, Tie};

/// A sweep over the rows of a table of CSV without quotes.
fn of_table(scene: &str, table: &str) -> Result<Sweep, SweepError> {
    let mut lines = table.lines();
    let header = lines.next().unwrap_or_default().split(',');
    let mut table = PointTable::new("p.csv", Numbering::Lines, header);
    for (line, text) in (2..).zip(lines) {
        table.push(line, text.split(','))?;
    }
    let request = SweepRequest { points: Points::Table, ..SweepRequest::default() };
    Sweep::of("a.toml", scene, &table.vary(scene)?, request)
}

fn fault(table: &str) -> String {
    of_table(SLIDER, table).unwrap_err().to_string()
}

const GRID: [&str; 3] =
    ["link.crank.points.A=100 mm..400 mm:7", "slide[0].angle=-10 deg..10 deg:3", "input.positions=6..8:2"];

#[test]
fn rows_of_a_grid_are_the_points_of_the_same_rows() {
    let whole = run(SLIDER, &GRID, 2);
    let text = whole.to_csv(false).unwrap();
    // As a sweep writes them, units in the names of the columns.
    let header = whole.columns.names.join(",");
    let short = |line: &str| line.split(',').take(6).collect::<Vec<_>>().join(",");
    let body: Vec<String> = text.lines().map(short).collect();
    let again = of_table(SLIDER, &format!("{}\n{}", short(&header), body.join("\n"))).unwrap();
    assert_eq!(rows(&again, 2).to_csv(false).unwrap(), text);
    // In another order, by the keys alone.
    let second =
        "link.crank.points.A,slide[0].angle,input.positions\n0.15,0,8\n0.1,-10 deg,6\n15 cm,0 deg,8\n";
    let other = rows(&of_table(SLIDER, second).unwrap(), 1);
    let values = |row: &str| row.split_once(',').unwrap().1.to_owned();
    let [own, wanted] =
        [other.to_csv(false).unwrap(), text].map(|text| text.lines().map(values).collect::<Vec<_>>());
    assert_eq!(own, [&*wanted[9], &*wanted[0], &*wanted[9]]);
    assert_eq!(numbers(&other, "row"), [0.0, 1.0, 2.0]);
}

#[test]
fn a_bare_cell_is_si_whatever_the_others_are() {
    let table = rows(&of_table(SLIDER, "link.crank.points.A\n90 mm\n0.1\n0.12 m\n").unwrap(), 1);
    assert_eq!(numbers(&table, "link.crank.points.A_m"), [0.09, 0.1, 0.12]);
}

#[test]
fn a_fault_of_a_table_has_file_line_and_key() {
    for (table, problem) in [
        (
            "link.crank.points.A\n0.1\nx\n",
            "`link.crank.points.A`: p.csv, line 3: `x` does not begin with a finite number",
        ),
        (
            "link.crank.points.A\n0.1\n2 kg\n",
            "`link.crank.points.A`: p.csv, line 3: wants a length (m, mm, cm, dm, km, um, in, ft), got `kg`, a mass",
        ),
        ("link.crank.points.A,slide[0].angle\n0.1\n", "p.csv, line 2: it has 1 cells, the header has 2"),
        (
            "link.crank.points.A\n",
            "p.csv has no points: its columns are keys of the scene, its rows are points",
        ),
        ("row\n1\n", "p.csv has no points: its columns are keys of the scene, its rows are points"),
        ("a\n1\n", "`a`: column of p.csv: the scene has no `a`; "),
    ] {
        let told = fault(table);
        assert!(told.starts_with(problem), "{told}");
    }
    let uneven = ["link.crank.points.A=0.1,0.2", "slide[0].angle=0,0.1,0.2"];
    let request = SweepRequest { points: Points::Table, ..SweepRequest::default() };
    let error = requested(SLIDER, &uneven, request).unwrap_err().to_string();
    assert_eq!(error, "the parameters have different numbers of values: 2, 3");
}

#[test]
fn the_origin_tells_one_table_from_another() {
    let table =
        |value: &str| of_table(SLIDER, &format!("link.crank.points.A\n0.1\n{value}\n")).unwrap().origin();
    let (one, other) = (table("0.12"), table("0.13"));
    assert_eq!(one["vary"], "link.crank.points.A");
    assert!(
        one["table"].starts_with("2 points, hash ") && one["table"] != other["table"],
        "{}",
        one["table"]
    );
    assert_eq!(one, table("0.12"));
}

/// Motors by their designations: each row is that of the scene with this motor.
#[test]
fn texts_are_values_of_a_key_that_has_a_text() {
    let rated = assur_fixtures::scene("shaper-drive");
    let place = rated.find("motor = {").unwrap();
    let end = place + rated[place..].find('\n').unwrap();
    let own = |motor: &str| format!("{}motor = \"{motor}\"{}", &rated[..place], &rated[end..]);
    let scene = &own("auto");
    let measures = || Measure::named(&["regime"]).unwrap();
    let swept = |scene: &str, vary: &[&str]| {
        let request = SweepRequest { measures: measures(), ..SweepRequest::default() };
        requested(scene, vary, request)
    };
    let motors = ["4A100L4", "4A90L4", "4A100L4"];
    let grid =
        swept(scene, &[&format!("drive.motor={}", motors.join(",")), "link.ram.mass=40..50:2"]).unwrap();
    assert_eq!(grid.points(), 6);
    let table = rows(&grid, 2);
    assert!(table.columns.is_text(1));
    for (index, motor) in motors.iter().enumerate() {
        let row = 2 * index;
        assert_eq!(table.cell(row, 1), CsvCell::Text(motor));
        assert_eq!(table.status(row), Some((Status::Ok, "")));
        let alone = rows(&swept(&own(motor), &["link.ram.mass=40..50:2"]).unwrap(), 1);
        for column in 2..table.columns.names.len() {
            assert_eq!(table.cell(row, column), alone.cell(0, column - 1), "{motor}");
        }
        assert!(grid.scene(row).contains(&format!("motor = \"{motor}\"")));
    }
    assert_eq!(grid.describe(2).to_string(), "drive.motor = 4A90L4, link.ram.mass = 40 kg");
    assert_eq!(grid.origin()["vary"], "drive.motor=4A100L4,4A90L4,4A100L4\nlink.ram.mass=40..50:2");
    let unknown = rows(&swept(scene, &["drive.motor=4A100L4,none"]).unwrap(), 1);
    assert_eq!(unknown.status(1).unwrap().0, Status::Error);
}

#[test]
fn texts_that_change_the_mechanism_are_refused() {
    let turned = sweep(assur_fixtures::scene("four-bar"), &["input.link=crank,rocker"]);
    let error = turned.map(|_| ()).unwrap_err().to_string();
    assert!(
        error.ends_with("changes the links, the groups or the columns: sweep it as a scene of its own"),
        "{error}"
    );
    // A load on another link of the same mechanism.
    let table = run(SLIDER, &["force[1].at=A,B"], 1);
    assert_eq!((table.len(), table.cell(1, 1)), (2, CsvCell::Text("B")));
    let request = SweepRequest {
        ties: vec![Tie::parse("force[1].angle=force[1].at").unwrap()],
        ..SweepRequest::default()
    };
    let error = requested(SLIDER, &["force[1].at=A,B"], request).unwrap_err().to_string();
    assert_eq!(
        error,
        "`force[1].angle`: it follows `force[1].at`, whose values are texts: tie it to a number"
    );
}
