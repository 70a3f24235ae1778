use crate::numbers::extrapolated;
use crate::numbers::{SAMPLES, rounding_of};

fn central(f: impl Fn(f64) -> f64, x: f64, first: f64) -> Vec<(f64, f64)> {
    let step = |k: i32| first * 0.5_f64.powi(k);
    (0..9).map(|k| (step(k), (f(x + step(k)) - f(x - step(k))) / (2.0 * step(k)))).collect()
}

#[test]
fn a_smooth_function_is_differentiated_to_rounding() {
    let found = extrapolated(&central(f64::sin, 0.7, 0.2), f64::EPSILON);
    let off = (found.value - 0.7_f64.cos()).abs();
    assert!(off <= found.error && found.error < 1e-12, "off by {off:e}, estimated {:e}", found.error);
}

#[test]
fn the_estimate_covers_the_error_of_harder_functions() {
    // Poles at a distance of 0.05 to 0.5 from the place, beside the steps.
    for distance in [0.05_f64, 0.1, 0.3, 0.5] {
        let f = |x: f64| 1.0 / (x * x + distance * distance);
        let x = 0.4 * distance;
        let exact = -2.0 * x / (x * x + distance * distance).powi(2);
        let found = extrapolated(&central(f, x, 0.2), f64::EPSILON * f(0.0));
        let off = (found.value - exact).abs();
        assert!(off <= 2.0 * found.error, "distance {distance}: off by {off:e}, estimated {:e}", found.error);
        assert!(found.error < 1e-6 * exact.abs());
    }
}

#[test]
fn what_all_large_steps_step_over_is_not_overlooked() {
    // A spike of width 1e-3 beside a straight line: all but the smallest steps agree that the slope is 1.
    let (width, place) = (1e-3, 5e-4);
    let f = |x: f64| x + 1e-6 / (width * width + (x - place) * (x - place));
    let found = extrapolated(&central(f, 0.0, 0.2), 1e-16);
    let exact = 1.0 + 2e-6 * place / (width * width + place * place).powi(2);
    assert!((found.value - exact).abs() <= 2.0 * found.error, "{found:?} instead of {exact}");
}

#[test]
fn rounding_is_measured_and_smooth_functions_have_none() {
    let at = |i: usize| 0.3 + 1e-9 * i as f64;
    let smooth: [f64; SAMPLES] = std::array::from_fn(|i| 3.0 * at(i) - 0.5 * at(i) * at(i));
    assert!(rounding_of(&smooth) < 4.0 * f64::EPSILON);
    // A sum that loses the digits below 2^-30.
    let coarse: [f64; SAMPLES] = std::array::from_fn(|i| {
        let big = 4_194_304.0;
        (at(i) * (1.0 + 1e9 * i as f64 * 0.1)).sin() + big - big
    });
    let noise = rounding_of(&coarse);
    assert!(noise > 1e-10, "{noise:e}");
}

#[test]
fn alternating_errors_are_measured_by_their_size() {
    // Fourth differences of +1, -1, ... are 16; of independent errors of deviation 1 they have the deviation sqrt(70).
    let size = 0.25;
    let alternating: [f64; SAMPLES] =
        std::array::from_fn(|i| 7.0 * i as f64 + if i % 2 == 0 { size } else { -size });
    let found = rounding_of(&alternating);
    assert!((found - 16.0 * size / 70.0_f64.sqrt()).abs() < 1e-12, "{found}");
}

#[test]
fn rows_that_disagree_have_an_error_of_their_distance() {
    // Quotients that converge to 1 down to the last one, which is off: the best row can't be trusted beyond that.
    let steps: Vec<f64> = (0..6).map(|k| 0.5_f64.powi(k)).collect();
    let last_off = |by: f64| {
        let quotients: Vec<_> =
            steps.iter().enumerate().map(|(k, step)| (*step, if k == 5 { 1.0 + by } else { 1.0 })).collect();
        extrapolated(&quotients, 0.0)
    };
    let agreed = last_off(0.0);
    assert!((agreed.value - 1.0).abs() < 1e-15 && agreed.error < 1e-15, "{agreed:?}");
    let found = last_off(1e-3);
    assert!((found.value - 1.0).abs() < 1e-15, "{found:?}");
    // The row of the smallest step is off by at most 4/3 of it, by 16/15, ...
    assert!((1e-3..2e-3).contains(&found.error), "{found:?}");
}

#[test]
fn what_the_rounding_of_the_smallest_step_explains_is_no_disagreement() {
    // Rounding of 1e-10 over steps of 1 down to a thousandth: the great steps know the slope to 1e-9.
    let quotients: Vec<_> =
        (0..6).map(|k| (0.25_f64.powi(k), if k == 5 { 1.0 + 1e-7 } else { 1.0 })).collect();
    let found = extrapolated(&quotients, 1e-10);
    assert!((found.value - 1.0).abs() < 1e-15 && found.error < 1e-9, "{found:?}");
}
