//! Tests of `series`.

use crate::screen::state::zeros;

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
