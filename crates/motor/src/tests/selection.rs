use approx::assert_relative_eq;

use super::motors;
use crate::{CharacteristicKind, Motor, SelectionRequest, rad_per_s, select};

fn rows() -> Vec<Motor> {
    motors(&[
        "two,2,1.1,3000,2800,2.2",
        "four slow,4,1.1,1500,1400,2.2",
        "four,4,1.1,1500,1410,2.2",
        "six,6,1.1,1000,920,2.2",
        "big four,4,1.5,1500,1415,2.2",
        "no data,4,1.2,1500,1410,",
        "small,4,0.75,1500,1390,2.2",
    ])
}

fn request(power: f64, limit: Option<f64>) -> SelectionRequest {
    SelectionRequest {
        required_power: power,
        input_speed: rad_per_s(60.0),
        max_motor_speed: limit.map(rad_per_s),
        characteristic: CharacteristicKind::Kloss,
    }
}

fn order(request: &SelectionRequest) -> Vec<String> {
    let rows = rows();
    let found = select(&rows, request).unwrap();
    let all = std::iter::once(&found.chosen).chain(&found.runners_up);
    all.map(|c| c.motor.designation.clone()).collect()
}

#[test]
fn smallest_power_then_highest_speed_then_least_slip() {
    assert_eq!(order(&request(900.0, None)), ["two", "four", "four slow", "six", "big four"]);
    assert_eq!(order(&request(900.0, Some(1500.0))), ["four", "four slow", "six", "big four"]);
    assert_eq!(order(&request(700.0, Some(1500.0)))[0], "small");
}

#[test]
fn exactly_enough_is_enough() {
    assert_eq!(order(&request(1100.0, Some(1500.0)))[0], "four");
    assert_eq!(order(&request(1100.01, Some(1500.0)))[0], "big four");
}

#[test]
fn ratio_of_a_motor_that_drives_clockwise() {
    let rows = rows();
    let clockwise = SelectionRequest { input_speed: -rad_per_s(60.0), ..request(1000.0, Some(1500.0)) };
    let chosen = select(&rows, &clockwise).unwrap().chosen;
    assert_relative_eq!(chosen.ratio, 23.5, max_relative = 1e-12);
}

#[test]
fn rows_without_breakdown_torque_are_skipped() {
    let rows = rows();
    let found = select(&rows, &request(1150.0, Some(1500.0))).unwrap();
    assert_eq!(found.chosen.motor.designation, "big four");
    let linear = SelectionRequest { characteristic: CharacteristicKind::Linear, ..request(1150.0, None) };
    assert_eq!(select(&rows, &linear).unwrap().chosen.motor.designation, "no data");
}

#[test]
fn too_fast_rows_are_skipped() {
    let rows = rows();
    let found = select(&rows, &request(1100.0, Some(1000.0))).unwrap();
    assert_eq!(found.chosen.motor.designation, "six");
    assert!(found.runners_up.is_empty());
}

#[test]
fn nothing_fits_says_by_how_much() {
    let rows = rows();
    let error = |request: &SelectionRequest| select(&rows, request).unwrap_err().to_string();
    assert_eq!(
        error(&request(2000.0, None)),
        "no motor gives 2000.0 W: the most powerful one that is otherwise suitable, big four, has 1500.0 W, 500.0 W too little; \
         take another catalogue, raise max_motor_speed or lower the load"
    );
    assert_eq!(
        error(&request(500.0, Some(800.0))),
        "no motor stays within the speed limit of 800.0 rpm: the slowest, six, has 1000.0 rpm, 200.0 rpm too many; \
         raise max_motor_speed"
    );
    // Enough power, but only too fast: the limit is what hurts.
    assert!(error(&request(1300.0, Some(1000.0))).contains("six, has 1100.0 W, 200.0 W too little"));
}

#[test]
fn senseless_requests_are_refused() {
    let rows = rows();
    let refusal =
        |rows: &[Motor], request: &SelectionRequest| select(rows, request).unwrap_err().0.identity();
    for bad in [0.0, -5.0, f64::NAN, f64::INFINITY] {
        assert_eq!(refusal(&rows, &request(bad, None)), Some("motor-select-not-positive"));
    }
    let still = SelectionRequest { input_speed: 0.0, ..request(100.0, None) };
    assert_eq!(refusal(&rows, &still), Some("motor-select-not-positive"));
    assert_eq!(refusal(&[], &request(1.0, None)), Some("motor-select-no-motors"));
    let silent = motors(&["no data,4,1.2,1500,1410,"]);
    assert_eq!(refusal(&silent, &request(1.0, None)), Some("motor-select-no-ratio"));
}
