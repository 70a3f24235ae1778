//! The energy form of motions that are known in closed form.

use std::f64::consts::PI;

use assur_dynamics::Figures;
use assur_words::Language;
use assur_worksheet::{Entry, WIDTH};

use crate::{Done, Ending, EnergyForm};

fn form<'a>(
    mechanism: &'a assur_mechanism::Mechanism,
    works: &[(&'static str, f64)],
    ends: [[f64; 3]; 2],
) -> EnergyForm<'a> {
    let works = works.iter().enumerate().map(|(load, (name, work))| Done {
        name: assur_words::name(*name),
        load: Some(load),
        work: *work,
    });
    let ends = ends.map(|[coordinate, speed, energy]| Ending { coordinate, speed, energy });
    EnergyForm { mechanism, ends, works: works.collect(), links: Vec::new(), inertia: None, cycle: None }
}

/// The result of the line of a symbol.
fn result(form: &EnergyForm<'_>, symbol: &str) -> f64 {
    let sections = form.sections();
    let lines = sections.iter().flat_map(|section| &section.entries);
    let found = lines.filter_map(|entry| match entry {
        Entry::Line(line) if line.symbol.plain(Language::english()) == symbol => Some(line.value),
        _ => None,
    });
    let all: Vec<f64> = found.collect();
    assert_eq!(
        all.len(),
        1,
        "{symbol}: {all:?}\n{}",
        assur_worksheet::text(&sections, WIDTH, Language::english())
    );
    all[0]
}

fn near(found: f64, wanted: f64) {
    assert!((found - wanted).abs() < 1e-12 * wanted.abs().max(1.0), "{found} {wanted}");
}

/// E example 1: 150 pi and 100 pi J over 10 pi rad, 56.05 rad/s; the works are those of the areas, whatever a quadrature gave.
#[test]
fn example_1_is_worked_by_areas() {
    let mechanism = assur_scene::read("run-up.toml", assur_fixtures::scene("run-up")).unwrap();
    let end = [10.0 * PI, (1000.0 * PI).sqrt(), 50.0 * PI];
    let form = form(&mechanism, &[("driving", 470.0), ("resistance", -310.0)], [[0.0; 3], end]);
    near(result(&form, "φ"), 10.0 * PI);
    near(result(&form, "n"), 5.0);
    near(result(&form, "A_driving"), 150.0 * PI);
    near(result(&form, "A_d"), 150.0 * PI);
    near(result(&form, "A_res"), 100.0 * PI);
    near(result(&form, "A"), 50.0 * PI);
    near(result(&form, "T"), 50.0 * PI);
    near(result(&form, "ω"), (1000.0 * PI).sqrt());
}

/// E example 2: 20 N m, 10 pi J between 90 and 270 degrees, pi/20 kg m², 0.0127.
#[test]
fn example_2_is_worked_by_areas() {
    let mechanism = assur_scene::read("flywheel.toml", assur_fixtures::scene("flywheel")).unwrap();
    let cycle = Figures {
        ratio: None,
        mean_speed: 100.0,
        unevenness: 0.02,
        speed_min: 99.0,
        speed_max: 101.0,
        coordinate_at_min: 0.5 * PI,
        coordinate_at_max: 1.5 * PI,
        excess_work: f64::NAN,
        dynamic_unevenness: None,
        required_power: 0.0,
        torque: Some(-20.0),
    };
    let ends = [[0.0, 100.0, 0.0], [2.0 * PI, 100.0, 0.0]];
    let form = EnergyForm { cycle: Some(&cycle), ..form(&mechanism, &[("driving", 120.0)], ends) };
    near(result(&form, "M_res"), 20.0);
    near(result(&form, "A_d"), 40.0 * PI);
    near(result(&form, "A_res"), 40.0 * PI);
    near(result(&form, "Δφ"), PI);
    near(result(&form, "δ"), 0.02);
    near(result(&form, "A_ex"), 10.0 * PI);
    near(result(&form, "J_fw"), PI / 20.0);
    near(result(&form, "χ"), 0.04 / PI);
    // With a reduced inertia that varies the speed has its extremes elsewhere than the energy.
    for (inertia, words) in [(Some(1.0), "are equal:"), (None, "not where the moments")] {
        let form = EnergyForm { inertia, ..form.clone() };
        let text = assur_worksheet::text(&form.sections(), WIDTH, Language::english());
        assert!(text.contains(words), "{text}");
    }
}

/// What begins with a speed keeps its energy; a brake that no line is drawn of has the work of the quadrature.
#[test]
fn the_energy_at_the_start_counts() {
    let text = assur_fixtures::scene("brake")
        .replace("force = \"20 N\"", "force = { formula = \"20 + 0*w\", unit = \"N\" }");
    let mechanism = assur_scene::read("brake.toml", &text).unwrap();
    let ends = [[0.0, 100.0, 2000.0], [2250.0, 60.0, 720.0]];
    let form = form(&mechanism, &[("brake", -1280.0)], ends);
    near(result(&form, "A"), -1280.0);
    near(result(&form, "T"), 720.0);
    near(result(&form, "ω"), 60.0);
}

/// D 3.22: 0.8 N m stop 0.4 kg m² from 100 rad/s after 50 s and 2500 rad; the work is the area, whatever a quadrature gave.
#[test]
fn the_brake_is_worked_in_closed_form() {
    let mechanism = assur_scene::read("brake.toml", assur_fixtures::scene("brake")).unwrap();
    let ends = [[0.0, 100.0, 2000.0], [2500.0, 0.0, 0.0]];
    let form = EnergyForm { inertia: Some(0.4), ..form(&mechanism, &[("brake", -1990.0)], ends) };
    near(result(&form, "A_brake"), -2000.0);
    near(result(&form, "M"), -0.8);
    near(result(&form, "ε"), -2.0);
    near(result(&form, "t"), 50.0);
    near(result(&form, "φ_2"), 2500.0);
}
