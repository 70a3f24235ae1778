//! The sizes that a load may have where its argument is rounded.

use assur_force::LoadState;
use assur_mechanism::Value;

use super::{At, Extremes, sizes};

/// The value of a moment as a scene writes it.
fn value(text: &str) -> Value {
    let scene = format!(
        "[ground]\npoints = {{ O = 0 }}\n[link.a]\npoints = {{ O = 0 }}\n[input]\nlink = \"a\"\n\
         [[moment]]\nlink = \"a\"\nvalue = {text}\n[motion]\nspeed = 1\n"
    );
    assur_scene::read("scene", &scene).unwrap().loads[0].kind.law().unwrap().clone()
}

const PERIOD: f64 = 8.0;

fn between(value: &Value, state: LoadState, extremes: Option<Extremes>) -> [f64; 2] {
    let (point, pf1) = ([0.25, 0.0], [1.0, 0.0]);
    sizes(value, &At { state: &state, point, pf1, extremes, sense: 1.0, period: Some(PERIOD), scale: 2.0 })
        .range
}

fn assert_between([low, high]: [f64; 2], middle: f64, half: f64) {
    let (found, width) = (f64::midpoint(low, high), 0.5 * (high - low));
    let rounding = 8.0 * f64::EPSILON * middle.abs().max(1.0);
    assert!((found - middle).abs() <= rounding, "{found} instead of {middle}");
    assert!((width - half).abs() <= rounding + 1e-6 * half, "{width:e} instead of {half:e}");
}

#[test]
fn a_line_has_what_it_gains_over_the_rounding_of_its_argument() {
    // A slope of 3: 1e-11 of the argument, at least of 1 s.
    let table = value("{ over = \"time\", table = [[0, 0], [4000, 12000]] }");
    for (time, width) in [(0.25, 1e-11), (1000.0, 1e-8)] {
        let state = LoadState { time, ..LoadState::default() };
        assert_between(between(&table, state, None), 3.0 * time, 3.0 * width);
    }
}

#[test]
fn a_formula_has_what_it_gains_over_the_rounding_of_each_variable() {
    let state = LoadState { coordinate: 2.0, speed: 40.0, time: 30.0, ..LoadState::default() };
    for (formula, middle, width) in [("3*q", 6.0, 3.0 * PERIOD), ("3*w", 120.0, 120.0), ("3*t", 90.0, 90.0)] {
        let value = value(&format!("{{ formula = \"{formula}\" }}"));
        assert_between(between(&value, state, None), middle, 1e-11 * width);
    }
    // A time of less than a second is rounded as one of a second.
    let early = LoadState { time: 0.25, ..state };
    assert_between(between(&value("{ formula = \"3*t\" }"), early, None), 0.75, 3e-11);
}
