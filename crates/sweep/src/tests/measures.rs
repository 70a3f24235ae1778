//! The measures that are not written by default, against known values.

use std::f64::consts::TAU;

use super::{SLIDER, numbers, requested, rows};
use crate::{MEASURES, Measure, Request, Rows};

fn measured(scene: &str, vary: &[&str], names: &[&str]) -> Rows {
    let request = Request { measures: Measure::named(names).unwrap(), ..Request::default() };
    rows(&requested(scene, vary, request).unwrap(), 1)
}

const ONE: [&str; 1] = ["link.crank.points.A=100 mm..100 mm:1"];

#[test]
fn columns_are_those_of_the_named_measures_in_their_own_order() {
    let table = measured(SLIDER, &ONE, &["stroke", "health"]);
    assert_eq!(
        table.header()[4..],
        [
            "smallest_health",
            "smallest_health_at_rad",
            "piston/ground_stroke_m",
            "crank_stroke_rad",
            "rod_stroke_rad",
            "piston_stroke_rad"
        ]
    );
    let all = measured(SLIDER, &ONE, &["all"]).header().len();
    let each: usize = MEASURES.iter().map(|one| measured(SLIDER, &ONE, &[one.name]).header().len() - 4).sum();
    assert_eq!(all, 4 + each);
    assert_eq!(measured(SLIDER, &ONE, &["default"]).header(), super::run(SLIDER, &ONE, 1).header());
}

#[test]
fn an_unknown_measure_is_named() {
    let error = Measure::named(&["health", "weight"]).unwrap_err().to_string();
    assert!(
        error.starts_with("there is no measure `weight`: name some of health, transmission, "),
        "{error}"
    );
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
    let offset = SLIDER
        .replace("positions = 12", "positions = 3600")
        .replace("angle = \"0 deg\"\n\n[input]", "angle = 0\nthrough = [0, 0.1]\n\n[input]");
    let table = measured(&offset, &ONE, &["stroke", "time-ratio", "transmission"]);
    let at = |name: &str| numbers(&table, name)[0];
    let reach = |length: f64| (length * length - e * e).sqrt();
    assert!((at("piston/ground_stroke_m") - (reach(l + r) - reach(l - r))).abs() < 1e-6);
    let (far, near) = ((e / (l + r)).asin(), (e / (l - r)).asin());
    let there = std::f64::consts::PI + near - far;
    let ratio = there.max(TAU - there) / there.min(TAU - there);
    assert!((at("piston/ground_time_ratio") / ratio - 1.0).abs() < 2e-3, "{ratio}");
    // Where the crank points down, the rod leans by asin((r + e) / l): its pressure angle.
    let least = std::f64::consts::FRAC_PI_2 - ((r + e) / l).asin();
    assert!((at("least_transmission_angle_rad") - least).abs() < 1e-12);
    assert!((at("least_transmission_angle_at_rad") / TAU - 0.75).abs() < 1e-12);
    assert!((at("crank_stroke_rad") - TAU * 3599.0 / 3600.0).abs() < 1e-12, "continuous over the turn");
}
