//! The measures that are not written by default, against known values.

use std::f64::consts::TAU;

use super::{SLIDER, numbers, requested, rows};
use assur_report::csv::CsvCell;

use crate::{MEASURES, Measure, Rows, SweepRequest, Target, Tie};

fn measured(scene: &str, vary: &[&str], names: &[&str]) -> Rows {
    let request = SweepRequest { measures: Measure::named(names).unwrap(), ..SweepRequest::default() };
    rows(&requested(scene, vary, request).unwrap(), 1)
}

const ONE: [&str; 1] = ["link.crank.points.A=100 mm..100 mm:1"];

#[test]
fn columns_are_those_of_the_named_measures_in_their_own_order() {
    let table = measured(SLIDER, &ONE, &["stroke", "health"]);
    assert_eq!(
        table.columns.names[5..],
        [
            "smallest_health",
            "smallest_health_at_rad",
            "piston/ground_stroke_m",
            "crank_stroke_rad",
            "rod_stroke_rad",
            "piston_stroke_rad"
        ]
    );
    let all = measured(SLIDER, &ONE, &["all"]).columns.names.len();
    let each: usize =
        MEASURES.iter().map(|one| measured(SLIDER, &ONE, &[one.name]).columns.names.len() - 5).sum();
    assert_eq!(all, 5 + each);
    assert_eq!(measured(SLIDER, &ONE, &["default"]).columns.names, super::run(SLIDER, &ONE, 1).columns.names);
}

#[test]
fn an_unknown_measure_is_named() {
    let error = Measure::named(&["health", "weight"]).unwrap_err().to_string();
    assert!(error.starts_with("there is no measure `weight`: choose from health, transmission, "), "{error}");
}

#[test]
fn roots_of_mean_squares_are_those_of_the_closed_form() {
    let scene = SLIDER.replace("positions = 12", "positions = 360");
    let table = measured(&scene, &ONE, &["balancing-rms", "reaction-rms"]);
    // The massless rod carries 1 kN / cos(b) with sin(b) = r sin(q) / l; the moment is that force times its arm.
    let (r, l) = (0.1, 0.3);
    let (mut force, mut moment) = (0.0, 0.0);
    for q in (0..360).map(|index| f64::from(index) * TAU / 360.0) {
        let b = (r * q.sin() / l).asin();
        force += (1000.0 / b.cos()).powi(2) / 360.0;
        moment += (1000.0 / b.cos() * r * (q + b).sin()).powi(2) / 360.0;
    }
    let close = |name: &str, known: f64| {
        let found = numbers(&table, name)[0];
        assert!((found / known - 1.0).abs() < 1e-12, "{name}: {found} is not {known}");
    };
    close("reaction_A_rms_N", force.sqrt());
    close("reaction_B_rms_N", force.sqrt());
    close("balancing_rms_Nm", moment.sqrt());
}

#[test]
fn strokes_time_ratio_and_transmission_angle_are_those_of_the_closed_form() {
    // With an offset e the dead points lie where crank and rod are in line: at asin(e / (l - r)) and asin(e / (l + r)).
    let (r, l, e) = (0.1, 0.3, 0.1);
    // Twelve positions: the dead points lie between them.
    let offset = SLIDER.replace("angle = \"0 deg\"\n\n[input]", "angle = 0\nthrough = [0, 0.1]\n\n[input]");
    let table = measured(&offset, &ONE, &["stroke", "time-ratio", "transmission"]);
    let at = |name: &str| numbers(&table, name)[0];
    let reach = |length: f64| (length * length - e * e).sqrt();
    assert!((at("piston/ground_stroke_m") - (reach(l + r) - reach(l - r))).abs() < 1e-14);
    let (far, near) = ((e / (l + r)).asin(), (e / (l - r)).asin());
    let there = std::f64::consts::PI + near - far;
    let ratio = there.max(TAU - there) / there.min(TAU - there);
    assert!((at("piston/ground_time_ratio") / ratio - 1.0).abs() < 1e-12, "{ratio}");
    // The rod leans by asin((r + e) / l) and asin((r - e) / l) at most.
    let swing = ((r + e) / l).asin() + ((r - e) / l).asin();
    assert!((at("rod_stroke_rad") - swing).abs() < 1e-12);
    let turning = table.columns.names.iter().position(|name| name == "crank_stroke_rad").unwrap();
    assert_eq!(table.cell(0, turning), CsvCell::Empty, "a link that turns has no stroke");
    // Where the crank points down, the rod leans by asin((r + e) / l): its pressure angle.
    let least = std::f64::consts::FRAC_PI_2 - ((r + e) / l).asin();
    assert!((at("least_transmission_angle_rad") - least).abs() < 1e-12);
    assert!((at("least_transmission_angle_at_rad") / TAU - 0.75).abs() < 1e-12);
}

#[test]
fn speeds_transfer_functions_and_the_shaking_force_are_those_of_the_closed_form() {
    // Seven positions: neither the greatest speed of the rod, at 0, nor that of its end are among them.
    let (r, l, w) = (0.1, 0.3, 10.0);
    let scene = SLIDER.replace("positions = 12", "positions = 7\nfrom = 0.2") + "[motion]\nspeed = 10\n";
    let table = measured(&scene, &ONE, &["pf", "speed", "acceleration", "shaking"]);
    let close = |name: &str, known: f64| {
        let found = numbers(&table, name)[0];
        assert!((found / known - 1.0).abs() < 1e-10, "{name}: {found} is not {known}");
    };
    close("A_pf1_greatest_m_per_rad", r);
    close("A_pf2_greatest_m_per_rad2", r);
    close("rod_pf1_greatest_rad_per_rad", r / l);
    // The end of the rod is fastest in its dead point: x'' = -r (1 + r/l) at q = 0.
    close("piston/ground_pf2_greatest_m_per_rad2", r * (1.0 + r / l));
    close("A_speed_greatest_m_per_s", r * w);
    close("crank_speed_greatest_rad_per_s", w);
    close("B_acceleration_greatest_m_per_s2", w * w * r * (1.0 + r / l));
    // The piston alone has a mass, 2 kg.
    close("shaking_force_greatest_N", 2.0 * w * w * r * (1.0 + r / l));
}

#[test]
fn a_tied_key_follows_its_parameter() {
    let ties = |text: &str| vec![Tie::parse(text).unwrap()];
    let vary = ["link.crank.points.A=100 mm..140 mm:3"];
    let request = |tie: &str| SweepRequest {
        ties: ties(tie),
        measures: Measure::named(&["stroke"]).unwrap(),
        ..SweepRequest::default()
    };
    let sweep = requested(SLIDER, &vary, request("link.rod.points.B=link.crank.points.A*3")).unwrap();
    let table = rows(&sweep, 1);
    assert_eq!(table.columns.names[1..3], ["link.crank.points.A_m", "link.rod.points.B_m"]);
    assert_eq!(numbers(&table, "link.rod.points.B_m"), [0.3, 0.36, 0.42]);
    // A rod thrice as long as the crank leans by asin(1/3), whatever the crank.
    let swing = 2.0 * (1.0_f64 / 3.0).asin();
    assert!(numbers(&table, "rod_stroke_rad").iter().all(|found| (found - swing).abs() < 1e-12));
    assert_eq!(sweep.ranges().collect::<Vec<_>>()[1], "link.rod.points.B=link.crank.points.A*3");
    // A constant has a unit of its own.
    for tie in ["link.crank.points.A*3+20 mm", "link.crank.points.A*3+0.02", "link.crank.points.A*3+2 cm"] {
        let sweep = requested(SLIDER, &vary, request(&format!("link.rod.points.B={tie}"))).unwrap();
        assert_eq!(numbers(&rows(&sweep, 1), "link.rod.points.B_m"), [0.32, 0.38, 0.44], "{tie}");
        assert_eq!(sweep.ranges().collect::<Vec<_>>()[1], format!("link.rod.points.B={tie}"));
    }
    let heavy = requested(SLIDER, &vary, request("link.rod.points.B=link.crank.points.A+2 kg"));
    assert!(heavy.unwrap_err().to_string().contains("kg"));
    let error =
        requested(SLIDER, &vary, request("link.rod.points.B=link.piston.mass")).unwrap_err().to_string();
    assert_eq!(
        error,
        "`link.rod.points.B`: it follows `link.piston.mass`, which is not varied: name that key in --vary"
    );
    let mass = requested(
        SLIDER,
        &["link.crank.points.A=0.1..0.2:2"],
        request("link.piston.mass=link.crank.points.A"),
    );
    assert!(
        mass.unwrap_err()
            .to_string()
            .contains("it is a mass and would follow `link.crank.points.A`, a length")
    );
    let own = request("link.crank.points.A=link.crank.points.A");
    assert!(requested(SLIDER, &vary, own).unwrap_err().to_string().contains("are the same value"));
}

/// The pin A of the crank runs round O at r: from a place on the x axis at 300 mm it is 300 mm - r and 300 mm + r away.
#[test]
fn distances_from_places_are_those_of_a_circle() {
    let places = ["A=300 mm, 0", "A=0,0", "A=0,300 mm"];
    let targets = places.map(|place| Target::parse(place).unwrap()).to_vec();
    let request = SweepRequest { targets, ..SweepRequest::default() };
    let vary = ["link.crank.points.A=50 mm..100 mm:2"];
    let scene = SLIDER.replace("positions = 12", "positions = 7");
    let table = rows(&requested(&scene, &vary, request).unwrap(), 1);
    for (row, r) in [0.05, 0.1].into_iter().enumerate() {
        for (name, known) in [
            ("A_distance_1_least_m", 0.3 - r),
            ("A_distance_1_least_at_rad", 0.0),
            ("A_distance_1_greatest_m", 0.3 + r),
            ("A_distance_1_greatest_at_rad", TAU / 2.0),
            ("A_distance_2_least_m", r),
            // Between the seven positions.
            ("A_distance_3_least_m", 0.3 - r),
            ("A_distance_3_least_at_rad", TAU / 4.0),
        ] {
            let found = numbers(&table, name)[row];
            // A turn later is the same place.
            let miss = (found - known).abs();
            assert!(miss.min((miss - TAU).abs()) < 1e-12, "{name}: {found}, {known}");
        }
    }
    let request = SweepRequest { targets: vec![Target::parse("X=0,0").unwrap()], ..SweepRequest::default() };
    let error = requested(SLIDER, &vary, request).unwrap_err().to_string();
    assert!(error.contains("points: O, A, B"), "{error}");
}
