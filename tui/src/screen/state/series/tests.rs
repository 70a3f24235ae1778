//! Tests of `series`.

use crate::screen::state::{axis_range, extent, zeros};

#[test]
#[expect(clippy::float_cmp, reason = "bounds are taken as they are, or doubled")]
fn an_axis_is_never_empty() {
    assert_eq!(axis_range([-2.0, 3.0], 0.0), [-2.0, 3.0]);
    assert_eq!(axis_range([0.1, 0.1], 0.0), [0.0, 0.2]);
    assert_eq!(axis_range([-4.0, -4.0], 0.0), [-8.0, 0.0]);
    assert_eq!(axis_range([0.0, 0.0], 0.0), [-1.0, 1.0]);
    assert_eq!(axis_range([-1e-17, 2e-17], 1e-15), [-1.0, 1.0]);
    assert_eq!(axis_range([-1e-17, 2e-17], 0.0), [-1e-17, 2e-17]);
}

#[test]
fn zeros_of_a_sine() {
    let sine: Vec<f64> = (0..12).map(|i| (f64::from(i) * std::f64::consts::TAU / 12.0 + 0.1).sin()).collect();
    let found = zeros(&sine, true);
    assert_eq!(found.len(), 2, "{found:?}");
    assert!((found[0] - (6.0 - 1.2 / std::f64::consts::TAU)).abs() < 0.01, "{found:?}");
    assert!((found[1] - (12.0 - 1.2 / std::f64::consts::TAU)).abs() < 0.01, "{found:?}");
    assert_eq!(zeros(&sine, false).len(), 1);
}

#[test]
fn a_zero_that_is_met_counts_once() {
    assert_eq!(zeros(&[1.0, 0.0, -1.0, 0.0], true), [1.0, 3.0]);
    assert!(zeros(&[0.0, 0.0], true).is_empty());
    assert!(zeros(&[1.0, f64::NAN, -1.0], false).is_empty());
    assert!(zeros(&[], true).is_empty());
}

#[test]
fn the_extent_ignores_what_is_no_number() {
    assert_eq!(extent(&[f64::NAN, 2.0, -1.0]), Some([-1.0, 2.0]));
    assert_eq!(extent(&[f64::NAN]), None);
}
