//! Order conditions of the rule.

use approx::assert_relative_eq;

use super::{Lu, Nodal, RULE, S, dot, product};

#[test]
fn integrates_powers_exactly() {
    // The weights are those of Radau: exact to degree 2 S - 2 = 14. The matrix is exact to degree S - 1.
    for power in 0..15_i32 {
        let values = RULE.c.map(|c| c.powi(power));
        assert_relative_eq!(dot(&RULE.a[S - 1], &values), 1.0 / f64::from(power + 1), epsilon = 3e-15);
        if power < 8 {
            let integral = product(&RULE.a, &values);
            for (got, c) in integral.iter().zip(&RULE.c) {
                assert_relative_eq!(*got, c.powi(power + 1) / f64::from(power + 1), epsilon = 3e-15);
            }
        }
    }
}

#[test]
fn interpolates_polynomials_of_degree_eight() {
    let p = |x: f64| 1.0 - 3.0 * x + x.powi(3) - 2.0 * x.powi(8);
    let values: Nodal = RULE.c.map(p);
    for x in [0.0, 0.013, 0.3, RULE.middle, RULE.c[4], 0.99, 1.0] {
        assert_relative_eq!(RULE.interpolate(p(0.0), &values, x), p(x), epsilon = 1e-13);
    }
}

#[test]
fn last_node_is_the_end() {
    assert_relative_eq!(RULE.c[S - 1], 1.0, epsilon = 1e-16);
    assert!(RULE.c.windows(2).all(|pair| pair[0] < pair[1]) && RULE.c[0] > 0.0);
}

#[test]
fn solves_a_linear_system_with_pivoting() {
    // A permuted, scaled matrix with a known solution.
    let a: [Nodal; S] = std::array::from_fn(|i| {
        std::array::from_fn(|j| if (i + 3) % S == j { 2.0 } else { 0.1 * ((i * j) as f64).sin() })
    });
    let x: Nodal = std::array::from_fn(|i| 1.0 + i as f64);
    let got = Lu::new(a).solve(&product(&a, &x));
    for (got, x) in got.iter().zip(&x) {
        assert_relative_eq!(*got, *x, epsilon = 1e-13);
    }
}
