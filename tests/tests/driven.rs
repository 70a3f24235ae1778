//! Driven pairs between two moving links, against closed forms: the law of cosines, and the work of the drive, which lifts the weights.

use assur_all as _;
use assur_analysis::{Calculation, Options, Progress};
use assur_group::Order;
use assur_kinematics::Linkage;
use assur_report::json::analysis::to_json;
use serde_json::Value;
use std::error::Error;
use std::ops::ControlFlow;

type Tested = Result<(), Box<dyn Error>>;

/// The results of a shipped scene at rest: without its motion.
fn at_rest(name: &str) -> Result<Value, Box<dyn Error>> {
    let mut mechanism =
        assur_scene::read("scene.toml", assur_fixtures::scene(name)).map_err(|faults| faults.to_string())?;
    mechanism.motion = None;
    let mut watch = |_: Progress| ControlFlow::Continue(());
    let calculation =
        Calculation::of(mechanism, &Options::default(), &mut watch).map_err(|error| error.to_string())?;
    let analysis = calculation.analyze(&mut watch).map_err(|_| "stopped")?;
    Ok(serde_json::from_str(&to_json(&analysis, false)?)?)
}

fn number(value: &Value, path: &str) -> f64 {
    value.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("no {path}"))
}

/// Compares numbers of every position with functions of its coordinate; limits are parts of 1 and of the number.
fn compare(results: &Value, expected: impl Fn(f64) -> Vec<(&'static str, f64)>, limit: f64) -> Tested {
    let positions = results["positions"].as_array().ok_or("no positions")?;
    assert!(positions.len() > 10);
    for position in positions {
        let q = number(position, "/coordinate");
        for (path, value) in expected(q) {
            let found = number(position, path);
            let off = (found - value).abs() / value.abs().max(1.0);
            assert!(off < limit, "at {q}: {path} is {found}, {value} expected");
        }
    }
    Ok(())
}

/// The derivative of a function by differences of fourth order.
fn slope(of: impl Fn(f64) -> f64, at: f64) -> f64 {
    let step = 1e-3;
    let near = |k: f64| of(at + k * step);
    (8.0 * (near(1.0) - near(-1.0)) - (near(2.0) - near(-2.0))) / (12.0 * step)
}

const G: f64 = 9.81;

/// Angle of the boom by the law of cosines.
fn boom(s: f64) -> f64 {
    let (ab, ac) = (0.4_f64.hypot(0.2), 1.2_f64.hypot(0.15));
    (-0.2_f64).atan2(0.4) + ((ab * ab + ac * ac - s * s) / (2.0 * ab * ac)).acos() - 0.15_f64.atan2(1.2)
}

#[test]
fn a_cylinder_lifts_a_boom_by_the_law_of_cosines() -> Tested {
    let results = at_rest("boom")?;
    let structure = &results["structure"];
    assert_eq!(structure["formula"], "I(barrel,rod) -> II1(boom,barrel+rod)");
    assert_eq!(structure["groups"][0]["driven"], serde_json::json!(["rod/barrel"]));
    assert_eq!(structure["groups"][0]["inner"], serde_json::json!(["C"]));
    let height = |s: f64, [x, y]: [f64; 2]| x * boom(s).sin() + y * boom(s).cos();
    // Weights of the boom and of both parts of the cylinder, and the load at the tip.
    let potential = |s: f64| {
        let c = height(s, [1.2, 0.15]);
        let sine = (c + 0.2) / s;
        let weights = 120.0 * height(s, [1.4, 0.05]) + 20.0 * (-0.2 + 0.3 * sine) + 10.0 * (c - 0.3 * sine);
        G * weights + 2000.0 * height(s, [3.0, 0.0])
    };
    let (ab, ac) = (0.4_f64.hypot(0.2), 1.2_f64.hypot(0.15));
    let expected = |s: f64| {
        let opening = boom(s) + 0.15_f64.atan2(1.2) - (-0.2_f64).atan2(0.4);
        let first = s / (ab * ac * opening.sin());
        let second = (1.0 - ab * ac * opening.cos() * first * first) / (ab * ac * opening.sin());
        vec![
            ("/links/boom/pf0", boom(s)),
            ("/links/boom/pf1", first),
            ("/links/boom/pf2", second),
            ("/slides/rod~1barrel/pf0", s),
            ("/slides/rod~1barrel/pf1", 1.0),
            ("/slides/rod~1barrel/pf2", 0.0),
        ]
    };
    compare(&results, expected, 1e-12)?;
    compare(&results, |s| vec![("/balancing", slope(potential, s))], 1e-8)
}

#[test]
fn a_cylinder_that_is_too_short_is_told_how_long_it_may_be() -> Tested {
    let mut mechanism = assur_scene::read("scene.toml", assur_fixtures::scene("boom"))
        .map_err(|faults| faults.to_string())?;
    mechanism.input.from = 0.1;
    let linkage = Linkage::compile(mechanism).map_err(|error| error.to_string())?;
    let error = linkage.solve_index(0, Order::Place, &mut linkage.position()).err().ok_or("assembled")?;
    // Stretched and folded: the difference and the sum of the arms.
    let (ab, ac) = (0.4_f64.hypot(0.2), 1.2_f64.hypot(0.15));
    let ends = error.elsewhere.ok_or("no other place")?;
    for (found, end) in ends.iter().zip([ac - ab, ac + ab]) {
        assert!((found - end).abs() < 1e-12, "{found} is not {end}");
    }
    Ok(())
}

#[test]
fn a_cylinder_between_its_arms_lifts_a_table() -> Tested {
    let results = at_rest("scissor-lift")?;
    assert_eq!(
        results["structure"]["formula"],
        "I(barrel,rod) -> III/2(arm1,arm2,lower,barrel+rod) -> II3(upper,table)"
    );
    // P and Q are 200 cos a apart across and 600 sin a up, mm.
    let sine = |s: f64| ((s * s - 0.04) / 0.32).sqrt();
    let potential = |s: f64| {
        let (sine, along) = (sine(s), 0.15 * 0.6 * sine(s) / s);
        let arms = 2.0 * 15.0 * 0.6 * sine + 60.0 * 1.2 * sine;
        G * (arms + 6.0 * (0.2 * sine + along) + 3.0 * (0.8 * sine - along)) + 3000.0 * 1.2 * sine
    };
    let expected = |s: f64| {
        let first = s / (0.32 * sine(s));
        vec![
            ("/points/W/pf0/1", 1.2 * sine(s)),
            ("/points/W/pf1/1", 1.2 * first),
            ("/points/S/pf2/1", 1.2 * (1.0 / 0.32 - first * first) / sine(s)),
            ("/links/table/pf0", 0.0),
        ]
    };
    compare(&results, expected, 1e-11)?;
    compare(&results, |s| vec![("/balancing", slope(potential, s))], 1e-8)
}

#[test]
fn a_drive_in_the_knee_lifts_the_trunk() -> Tested {
    let results = at_rest("leg")?;
    assert_eq!(results["structure"]["formula"], "I(shin,thigh) -> II2(shin+thigh,trunk)");
    let (shin, thigh) = (0.43, 0.42);
    let hips = |q: f64| (shin * shin + thigh * thigh + 2.0 * shin * thigh * q.cos()).sqrt();
    // The shin leans away from the line from the ankle to the hips by the law of sines.
    let lean = |q: f64| (thigh * q.sin() / hips(q)).asin();
    let potential = |q: f64| {
        let knee = shin * lean(q).cos();
        let of_thigh = knee + 0.18 / thigh * (hips(q) - knee);
        G * (3.5 * 0.245 / shin * knee + 8.0 * of_thigh + 50.0 * hips(q))
    };
    let expected = |q: f64| {
        let first = -shin * thigh * q.sin() / hips(q);
        vec![
            ("/points/H/pf0/1", hips(q)),
            ("/points/H/pf1/1", first),
            ("/points/H/pf2/1", -(shin * thigh * q.cos() + first * first) / hips(q)),
            ("/links/shin/pf0", std::f64::consts::FRAC_PI_2 - lean(q)),
        ]
    };
    compare(&results, expected, 1e-12)?;
    compare(&results, |q| vec![("/balancing", slope(potential, q))], 1e-8)
}
