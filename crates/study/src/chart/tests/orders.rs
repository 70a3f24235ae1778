//! The order of each method, as its rows show it.

use super::scenes::{charted, rows};
use crate::chart::{ChartData, Measurement, SettingValue, Stage};

fn number(row: &Measurement, name: &str) -> f64 {
    match row.setting.get(name) {
        Some(SettingValue::Number(value)) => value,
        other => panic!("{name}: {other:?}"),
    }
}

/// Slope of log error over log of `across` between the rows at two values of a setting.
fn slope(
    data: &ChartData,
    stage: Stage,
    method: &str,
    setting: &str,
    ends: [f64; 2],
    across: fn(&Measurement) -> f64,
) -> f64 {
    let at = |wanted: f64| {
        let near = |row: &&Measurement| (number(row, setting) / wanted).ln().abs();
        rows(data, stage, method).into_iter().min_by(|a, b| near(a).total_cmp(&near(b))).unwrap()
    };
    let (one, two) = (at(ends[0]), at(ends[1]));
    (one.error.unwrap() / two.error.unwrap()).ln() / (across(one) / across(two)).ln()
}

#[track_caller]
fn assert_between(value: f64, [low, high]: [f64; 2]) {
    assert!((low..=high).contains(&value), "{value} is not between {low} and {high}");
}

#[test]
fn differences_have_order_two_and_four() {
    let data = charted("shaper");
    let step = |row: &Measurement| number(row, "step");
    let of = |method, ends| slope(&data, Stage::Kinematics, method, "step", ends, step);
    assert_between(of("differences-2", [1e-1, 1e-3]), [1.9, 2.1]);
    assert_between(of("differences-4", [1e-1, 1e-2]), [3.8, 4.2]);
    // Second differences of rounded places: the error grows with the inverse square of the step.
    assert_between(of("differences-2", [1e-6, 1e-9]), [-2.3, -1.7]);
}

#[test]
fn fixed_steps_have_their_order() {
    let data = charted("andrews");
    let step = |row: &Measurement| number(row, "step");
    let of = |method, ends| slope(&data, Stage::Motion, method, "step", ends, step);
    assert_between(of("uniform", [1e-4, 1e-5]), [0.9, 1.1]);
    assert_between(of("rk4", [1e-4, 1e-5]), [3.6, 4.4]);
}

#[test]
fn steps_under_control_have_their_order() {
    let data = charted("andrews");
    let evaluations = |row: &Measurement| row.evaluations.unwrap() as f64;
    let of = |method| -slope(&data, Stage::Motion, method, "tolerance", [1e-6, 1e-11], evaluations);
    assert_between(of("dopri5"), [4.5, 6.5]);
    assert_between(of("dop853"), [7.0, 10.0]);
    assert_between(of("radau5"), [4.0, 6.0]);
}

#[test]
fn errors_fall_with_the_tolerance() {
    for scene in ["andrews", "n-four-bar-2", "shaper-drive"] {
        let data = charted(scene);
        for method in ["dopri5", "dop853", "radau5"] {
            let at = |tolerance: f64| {
                let rows = rows(&data, Stage::Motion, method);
                let row = rows
                    .iter()
                    .find(|row| (number(row, "tolerance") / tolerance - 1.0).abs() < 1e-6)
                    .unwrap();
                row.error.unwrap()
            };
            assert!(at(1e-8) < 1e-2 * at(1e-4), "{scene} {method}: {} {}", at(1e-4), at(1e-8));
            assert!(at(1e-8) < 1e-4, "{scene} {method}: {}", at(1e-8));
        }
    }
}

#[test]
fn numbers_have_their_precision() {
    for scene in ["shaper", "press", "slider-crank", "stephenson3"] {
        let data = charted(scene);
        for stage in [Stage::Kinematics, Stage::Forces] {
            for row in data.of(stage).filter(|row| row.ok) {
                let error = row.error.unwrap();
                match row.setting.get("number") {
                    Some(SettingValue::Word("f32")) => assert_between(error, [1e-9, 1e-2]),
                    Some(SettingValue::Word(_)) if row.method != "longitudinal-published" => {
                        assert!(error < 1e-10, "{scene} {row:?}");
                    }
                    _ => {}
                }
            }
        }
    }
}
