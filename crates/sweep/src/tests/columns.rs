//! The columns against known values.

use std::f64::consts::TAU;

use super::{SLIDER, column, failures, numbers, requested, rows, run, sweep};
use assur_report::csv::CsvCell;

use crate::{Measure, Status, SweepRequest, Tally};

fn close(found: f64, known: f64) {
    assert!((found - known).abs() <= 1e-12 * (1.0 + known.abs()), "{found} is not {known}");
}

/// Place of the piston: r cos q + sqrt(l² - r² sin² q).
fn piston(r: f64, l: f64, q: f64) -> f64 {
    r * q.cos() + (l * l - (r * q.sin()).powi(2)).sqrt()
}

#[test]
fn a_slider_crank_has_its_closed_form() {
    let table = run(SLIDER, &["link.crank.points.A=50 mm..150 mm:3"], 2);
    for (row, r) in [0.05, 0.1, 0.15].into_iter().enumerate() {
        let at = |name: &str| numbers(&table, name)[row];
        close(at("B_x_max_m"), 0.3 + r);
        close(at("B_x_min_m"), 0.3 - r);
        close(at("piston/ground_travel_m"), 2.0 * r);
        close(at("A_y_max_m"), r);
        close(at("A_y_min_m"), -r);
        close(at("rod_angle_max_rad"), (r / 0.3).asin());
        // M dq = F dx: the moment that holds 1 kN on the piston, by central differences of the closed form.
        let h = 1e-6;
        let arm = |q: f64| ((piston(r, 0.3, q + h) - piston(r, 0.3, q - h)) / (2.0 * h)).abs();
        let arms: Vec<f64> = (0..12).map(|index| arm(f64::from(index) * TAU / 12.0)).collect();
        let greatest = 1000.0 * arms.iter().copied().fold(0.0, f64::max);
        assert!((at("balancing_greatest_Nm") - greatest).abs() < 1e-6 * greatest);
        let mean = 1000.0 * arms.iter().sum::<f64>() / 12.0;
        assert!((at("balancing_mean_modulus_Nm") - mean).abs() < 1e-6 * mean);
        // Over whole turns the force gives back what it takes.
        assert!(at("balancing_mean_Nm").abs() < 1e-9 * mean);
        // The massless rod carries F / cos(angle of the rod); it leans most where the crank stands across.
        close(at("reaction_B_greatest_N"), 1000.0 / (1.0 - (r / 0.3).powi(2)).sqrt());
        close(at("failed_positions"), 0.0);
        assert_eq!(table.status(row), Some((Status::Ok, "")));
    }
}

#[test]
fn a_point_that_can_not_be_assembled_keeps_its_row() {
    // The crank turns fully while it is shorter than the rod of 300 mm.
    let table = run(SLIDER, &["link.crank.points.A=200 mm..400 mm:3"], 2);
    assert_eq!(table.len(), 3);
    assert_eq!(table.status(0), Some((Status::Ok, "")));
    let (status, message) = table.status(2).unwrap();
    assert_eq!(status, Status::NoAssembly);
    assert!(message.contains("no assembly"), "{message}");
    assert_eq!(numbers(&table, "link.crank.points.A_m"), [0.2, 0.3, 0.4]);
    // |sin q| > 3/4 at 60, 90, 120 degrees and their opposites.
    assert_eq!(table.cell(2, column(&table, "failed_positions")), CsvCell::Number(6.0));
    assert_eq!(table.cell(2, column(&table, "B_x_max_m")), CsvCell::Empty, "extremes over a part are none");
    assert!(failures(&table).contains(&2));
}

#[test]
fn a_point_that_the_reader_refuses_keeps_its_row() {
    let table = run(SLIDER, &["link.piston.mass=-1 kg..1 kg:2"], 1);
    let message = "`mass` must not be negative, got \"-1 kg\" (line 12)";
    assert_eq!(table.status(0), Some((Status::Refused, message)));
    assert_eq!(table.status(1), Some((Status::Ok, "")));
    assert_eq!(table.cell(0, column(&table, "failed_positions")), CsvCell::Empty);
}

#[test]
fn a_grid_of_refused_points_is_a_mistake() {
    let grid = sweep(SLIDER, &["link.piston.mass=-1 kg..-2 kg:2"]).unwrap();
    let tally = Tally::of(&rows(&grid, 2));
    assert!(tally.is_hopeless());
    assert_eq!((tally.points(), tally.failures(), tally.first_failure), (2, 2, Some(0)));
    let error = grid.all_refused(0);
    assert_eq!(
        error.to_string(),
        "no point of the sweep can be calculated; the first, link.piston.mass = -1 kg:\n\
         error: `mass` must not be negative, got \"-1 kg\"\n  a.toml, line 12, column 8\n   |\n\
         12 | mass = \"-1 kg\"\n   |        ^^^^^^^ such as \"4 kg\", or a number in kg\n"
    );
}

#[test]
fn a_column_that_only_some_points_have_stands_in_the_table() {
    // Without a load nothing has to be balanced: a point has reactions or it has none.
    let scene = "gravity = 9.81\n[ground]\npoints = { O = 0 }\n[link.arm]\npoints = { O = 0, C = 0.5 }\n\
                 mass = 1\ncenter = \"C\"\n[input]\nlink = \"arm\"\npositions = 4\n";
    let table = run(scene, &["link.arm.mass=0..2 kg:3"], 2);
    let greatest = column(&table, "balancing_greatest_Nm");
    assert_eq!(table.cell(0, greatest), CsvCell::Empty);
    assert_eq!(table.cell(1, greatest), CsvCell::Number(1.0 * 9.81 * 0.5));
    assert_eq!(table.cell(2, greatest), CsvCell::Number(2.0 * 9.81 * 0.5));
}

/// A crank without mass under 0-40-0 N m over a turn and the constant resistance that balances it: the excess work is
/// 10 pi J, so the flywheel is 10 pi / (w² delta).
const ENGINE: &str = r#"[ground]
points = { A = [0, 0] }
[link.AB]
points = { A = 0, B = 0.1 }
[[moment]]
link = "AB"
value = { over = "angle", table = [[0, 0], ["180 deg", 40], ["360 deg", 0]] }
[input]
link = "AB"
positions = 24
[motion]
kind = "steady"
mean_speed = 100
unevenness = 0.02
[drive]
torque = "balance"
flywheel = "solve"
"#;

#[test]
fn a_flywheel_follows_its_formula() {
    let table = run(ENGINE, &["motion.unevenness=0.001..0.002:2", "motion.mean_speed=50..100 rad/s:2"], 2);
    let flywheels = numbers(&table, "flywheel_kgm2");
    assert_eq!(table.columns.names[2], "motion.mean_speed_rad_per_s");
    for (row, (delta, speed)) in
        [(0.001, 50.0), (0.001, 100.0), (0.002, 50.0), (0.002, 100.0)].into_iter().enumerate()
    {
        let known = 10.0 * std::f64::consts::PI / (delta * speed * speed);
        // The formula holds where the unevenness is small: the next term is of the order of delta.
        assert!((flywheels[row] / known - 1.0).abs() < delta, "{} is not {known}", flywheels[row]);
        assert!((numbers(&table, "unevenness")[row] / delta - 1.0).abs() < 1e-6);
        assert!((numbers(&table, "torque_Nm")[row] + 20.0).abs() < 1e-9);
        assert!((numbers(&table, "excess_work_J")[row] / 10.0 / std::f64::consts::PI - 1.0).abs() < 1e-3);
    }
}

#[test]
fn a_run_up_ends_where_the_work_says() {
    // Work of 2 pi n turns at M: J w² / 2 = M 2 pi n.
    let scene = "[ground]\npoints = { A = 0 }\n[link.AB]\npoints = { A = 0 }\ninertia = 0.1\n\
                 [[moment]]\nlink = \"AB\"\nvalue = 20\n[input]\nlink = \"AB\"\n\
                 [motion]\nkind = \"transient\"\nspeed = 0\nuntil = \"5 rev\"\n";
    let table = run(scene, &["motion.until=5..10 rev:2", "link.AB.inertia=0.1..0.2:2"], 2);
    assert_eq!(table.columns.names[1..3], ["motion.until_rad", "link.AB.inertia_kgm2"]);
    for (row, (turns, inertia)) in [(5.0, 0.1), (5.0, 0.2), (10.0, 0.1), (10.0, 0.2)].into_iter().enumerate()
    {
        let speed = (2.0 * 20.0 * TAU * turns / inertia).sqrt();
        let at = |name: &str| numbers(&table, name)[row];
        assert!((at("end_speed_rad_per_s") / speed - 1.0).abs() < 1e-8, "{}", at("end_speed_rad_per_s"));
        close(at("end_coordinate_rad"), TAU * turns);
        assert!((at("end_time_s") / (inertia * speed / 20.0) - 1.0).abs() < 1e-8);
    }
}

/// What no parameter can change by structure is left out unless its measure is named, and is constant there; what moves stays.
#[test]
fn columns_that_no_parameter_reaches_are_left_out() {
    let shaper = assur_fixtures::scene("shaper");
    for (scene, vary, out, kept) in [
        (SLIDER, "link.piston.mass=1 kg..2 kg:2", "B_x_min_m", "reaction_B_greatest_N"),
        (shaper, "link.rocker.points.D=600 mm..700 mm:2", "rocker_angle_min_rad", "E_x_min_m"),
        (shaper, "link.rocker.points.C=-10 mm..10 mm:2", "A_y_max_m", "D_x_min_m"),
        (shaper, "ground.points.C[1]=-410 mm..-400 mm:2", "A_y_max_m", "C_y_min_m"),
        (shaper, "link.crank.points.A=90 mm..100 mm:2", "C_x_min_m", "A_y_max_m"),
        (shaper, "link.ram.mass=20 kg..30 kg:2", "smallest_health", "reaction_A_greatest_N"),
        (shaper, "link.crank.mass=2 kg..4 kg:2", "reaction_D_greatest_N", "reaction_O_greatest_N"),
        (
            shaper,
            "link.stone2.mass=2 kg..4 kg:2",
            "reaction_ram/ground_moment_greatest_Nm",
            "reaction_C_greatest_N",
        ),
        (shaper, "link.ram.points.K[0]=200 mm..250 mm:2", "E_x_max_m", "K_x_max_m"),
        (shaper, "motion.speed=30 rpm..60 rpm:2", "E_x_max_m", "reaction_ram/ground_greatest_N"),
    ] {
        let table = run(scene, &[vary], 2);
        let names = ["health", "balancing", "reactions", "extremes"];
        let request = SweepRequest { measures: Measure::named(&names).unwrap(), ..SweepRequest::default() };
        let whole = rows(&requested(scene, &[vary], request).unwrap(), 1);
        assert!(
            !table.columns.names.contains(&out.to_owned()) && table.columns.names.contains(&kept.to_owned()),
            "{vary}"
        );
        for name in whole.columns.names.iter().filter(|name| !table.columns.names.contains(name)) {
            let [one, other] = numbers(&whole, name)[..] else { panic!("{name}") };
            assert!((one - other).abs() <= 1e-12 * one.abs().max(1.0), "{vary}: {name} is {one} and {other}");
        }
    }
}
