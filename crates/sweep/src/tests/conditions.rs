//! Rows that hold conditions are those of the whole sweep.

use super::{SLIDER, column, numbers, requested, rows, run};
use crate::{Best, Condition, Measure, Status, Sweep, SweepError, SweepRequest, Tally};

/// The rod of 300 mm is too short for the longest cranks.
const LENGTHS: [&str; 2] = ["link.crank.points.A=100 mm..330 mm:24", "link.piston.mass=1 kg..3 kg:3"];

fn sought(conditions: &[&str], measures: &[&str]) -> Result<Sweep, SweepError> {
    let conditions = conditions.iter().map(|one| Condition::parse(one)).collect::<Result<_, _>>()?;
    let measures = Measure::named(measures)?;
    requested(SLIDER, &LENGTHS, SweepRequest { measures, conditions, ..SweepRequest::default() })
}

fn fault(condition: &str) -> String {
    sought(&[condition], &["default"]).unwrap_err().to_string()
}

#[test]
fn written_rows_are_those_of_the_whole_that_hold_every_condition() {
    let measures = ["default", "transmission"];
    let whole = rows(&sought(&[], &measures).unwrap(), 2);
    let angle = column(&whole, "least_transmission_angle_rad");
    let mass = column(&whole, "link.piston.mass_kg");
    for (conditions, holds) in [
        (&["transmission > 40 deg"][..], (|angle, _| angle > 40_f64.to_radians()) as fn(f64, f64) -> bool),
        (&["transmission>=40deg", "link.piston.mass_kg < 2"], |angle, mass| {
            angle >= 40_f64.to_radians() && mass < 2.0
        }),
        (&["least_transmission_angle_rad <= 0.8", "link.piston.mass_kg >= 2000 g"], |angle, mass| {
            angle <= 0.8 && mass >= 2.0
        }),
        (&["transmission > 100 deg"], |_, _| false),
    ] {
        let sweep = sought(conditions, &measures).unwrap();
        let held = |row: &usize| {
            whole.status(*row).unwrap().0 == Status::Ok
                && holds(whole.number(*row, angle).unwrap(), whole.number(*row, mass).unwrap())
        };
        let wanted: Vec<usize> = (0..whole.len()).filter(held).collect();
        let text: String = wanted.iter().map(|row| whole.row_to_csv(*row, false).unwrap()).collect();
        for threads in [1, 4] {
            let found = rows(&sweep, threads);
            assert_eq!(found.to_csv(false).unwrap(), text, "{conditions:?}");
            let tally = Tally::of(&found);
            assert_eq!((tally.points(), tally.written), (whole.len(), wanted.len()));
            assert_eq!(tally.count(Status::Ok), whole.len() - super::failures(&whole).len());
            assert_eq!(Tally::parse(&tally.line()), Some(tally));
        }
    }
}

#[test]
fn a_measure_of_a_condition_is_calculated_though_not_asked_for() {
    let asked = rows(&sought(&["transmission > 40 deg"], &["extremes"]).unwrap(), 2);
    let both = rows(&sought(&["transmission > 40 deg"], &["extremes", "transmission"]).unwrap(), 2);
    assert_eq!(asked.columns.names, both.columns.names);
    assert_eq!(asked.to_csv(false).unwrap(), both.to_csv(false).unwrap());
    // Where no parameter can change it by structure, too.
    let conditions = vec![Condition::parse("health > 0").unwrap()];
    let request = SweepRequest { conditions, ..SweepRequest::default() };
    let table = rows(&requested(SLIDER, &["link.piston.mass=1..3:3"], request).unwrap(), 1);
    assert_eq!(table.written().count(), 3);
    assert!(numbers(&table, "smallest_health").iter().all(|health| *health > 0.0));
}

#[test]
fn the_best_is_among_the_rows_that_hold() {
    let sweep = sought(&["transmission > 40 deg"], &["default"]).unwrap();
    let table = rows(&sweep, 2);
    let best = Best::parse("greatest:link.crank.points.A_m").unwrap();
    let found = best.of(&table, best.find(&sweep.columns).unwrap()).unwrap();
    let last = table.written().last().unwrap();
    assert_eq!(found.point, last - 2, "of equal ones the first");
    // The cosine of the angle is crank over rod.
    assert!(
        found.value <= 0.3 * 40_f64.to_radians().cos()
            && found.value > 0.3 * 40_f64.to_radians().cos() - 0.01
    );
}

#[test]
fn a_row_of_csv_reads_back_its_point_its_status_and_a_value() {
    let sweep = sought(&[], &["default"]).unwrap();
    let table = rows(&sweep, 1);
    let value = column(&table, "balancing_greatest_Nm");
    for row in 0..table.len() {
        let text = table.row_to_csv(row, false).unwrap();
        let read = sweep.read_row(text.trim_end(), Some(value)).unwrap();
        assert_eq!((read.point, read.status), (row, table.status(row).unwrap().0));
        assert_eq!(read.value, table.number(row, value));
    }
    assert_eq!(sweep.read_row("0,0.1,1,ok,,0", None), None);
}

#[test]
fn a_condition_that_is_none_is_told() {
    let form = "write it as COLUMN > VALUE, with <, <=, > or >=, such as \"transmission > 40 deg\"";
    for condition in ["transmission", "transmission = 40 deg", "> 3", "transmission >"] {
        assert_eq!(fault(condition), format!("`{condition}`: {form}"));
    }
    for (condition, problem) in [
        ("transmision > 40 deg", "there is no column transmision"),
        ("status > 1", "there is no column status"),
        ("balancing > 1", "it has several columns, name one: balancing_greatest_Nm, "),
        ("transmission > 40 kg", "wants an angle"),
        ("transmission > few", "wants an angle"),
        ("smallest_health > 1 mm", "write a number without a unit"),
    ] {
        let told = fault(condition);
        assert!(told.contains(problem), "{told}");
    }
    // Without conditions every row is written, failures too.
    let table = run(SLIDER, &LENGTHS, 2);
    assert_eq!(table.written().count(), table.len());
}
