//! Extremes between samples.

use super::extreme;

#[test]
fn extremes_between_samples() {
    let values: Vec<f64> =
        (0..=40).map(|i| (f64::from(i) * std::f64::consts::TAU / 40.0 + 0.07).sin()).collect();
    assert!((extreme(&values, 1.0).unwrap() - 1.0).abs() < 1e-4);
    assert!((-extreme(&values, -1.0).unwrap() + 1.0).abs() < 1e-4);
}
