use super::{INSIDE, NODES, Series, WITH_ENDS, divided, first_zero, integral, inverse, swing, tail, value};

#[test]
fn value_is_the_sum_of_cosines() {
    let series: Series = std::array::from_fn(|k| 1.0 / (1.0 + k as f64) - 0.3);
    for i in 0..=40 {
        let angle = std::f64::consts::PI * f64::from(i) / 40.0;
        let sum: f64 = series.iter().enumerate().map(|(k, c)| c * (k as f64 * angle).cos()).sum();
        assert!((value(&series, angle.cos()) - sum).abs() < 1e-14, "{angle}");
    }
}

/// A polynomial and its integral from -1.
fn polynomial(x: f64) -> [f64; 2] {
    let from = |x: f64| x - 1.5 * x * x + 0.25 * x.powi(4) - 2.0 / 9.0 * x.powi(9);
    [1.0 - 3.0 * x + x.powi(3) - 2.0 * x.powi(8), from(x) - from(-1.0)]
}

const PLACES: [f64; 7] = [-1.0, -0.93, -0.4, 0.0, 0.17, 0.8, 1.0];

#[test]
fn both_bases_fit_a_polynomial_exactly() {
    for basis in [&WITH_ENDS, &INSIDE] {
        let series = basis.fit(&basis.nodes.map(|x| polynomial(x)[0]));
        for x in PLACES {
            assert!((value(&series, x) - polynomial(x)[0]).abs() < 1e-13, "{x}");
            let sum = value(&integral(&series, 0.5), x);
            assert!((sum - 0.5 * polynomial(x)[1]).abs() < 1e-13, "{x}");
        }
    }
    assert!((WITH_ENDS.nodes[0] + 1.0).abs() + (WITH_ENDS.nodes[NODES - 1] - 1.0).abs() < 1e-15);
    assert!(INSIDE.nodes.iter().all(|x| x.abs() < 1.0));
}

#[test]
fn a_divided_series_times_the_distance_from_the_root_is_the_difference() {
    let series = WITH_ENDS.fit(&WITH_ENDS.nodes.map(|x| polynomial(x)[0]));
    for root in [-1.0, 0.3, 1.0] {
        let quotient = divided(&series, root);
        for x in PLACES {
            let difference = polynomial(x)[0] - polynomial(root)[0];
            assert!(((x - root) * value(&quotient, x) - difference).abs() < 1e-12, "{root}, {x}");
        }
    }
}

#[test]
fn tail_and_swing_are_sums_of_sizes() {
    let mut series = [0.0; NODES + 1];
    (series[0], series[3], series[NODES - 2], series[NODES - 1]) = (9.0, -2.0, 0.25, -0.5);
    assert!((tail(&series) - 0.75).abs() < 1e-15 && (swing(&series) - 2.75).abs() < 1e-15);
}

#[test]
fn a_growing_function_is_inverted_from_any_start() {
    for start in [0.0, 0.5, 2.9, 3.0] {
        let found = inverse(8.0, [0.0, 3.0], start, 1e-9, |x| (x * x * x, 3.0 * x * x));
        assert!((found - 2.0).abs() < 1e-14, "{start}: {found}");
    }
    // Newton's method alone would leave the bounds of the arc tangent.
    let found = inverse(0.0, [-20.0, 10.0], 9.0, 1e-9, |x| (x.atan(), 1.0 / (1.0 + x * x)));
    assert!(found.abs() < 1e-14, "{found}");
}

/// (x - a)² + b has a dip at a: two roots or none, both closer together than any fixed set of places tells.
#[test]
fn the_first_zero_is_found_however_narrow_the_dip() {
    for exponent in 1..=24 {
        let depth = 0.5_f64.powi(exponent);
        for a in [-0.83, -0.2, 0.017, 0.6] {
            let dip = |b: f64| {
                let high = |x: f64| ((x - a) * (x - a) + b) * (1.3 + 0.7 * x - 0.2 * x.powi(5));
                first_zero(&WITH_ENDS.fit(&WITH_ENDS.nodes.map(high)))
            };
            assert_eq!(dip(depth), None, "{a}, {depth:e}");
            let first = (a - depth.sqrt() >= -1.0).then(|| a - depth.sqrt());
            if let Some(first) = first {
                let found = dip(-depth).unwrap();
                assert!((found - first).abs() < 1e-7, "{a}, {depth:e}: {found}");
            }
        }
    }
}
