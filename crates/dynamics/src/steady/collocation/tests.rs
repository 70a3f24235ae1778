//! Order conditions of the rule.

use approx::assert_relative_eq;

use super::{RULE, S, Values};

#[test]
fn integrates_powers_exactly() {
    // The weights are those of Radau: exact to degree 2 S - 2 = 14. The matrix is exact to degree S - 1.
    for power in 0..15_i32 {
        let values = RULE.c.map(|c| c.powi(power));
        assert_relative_eq!(RULE.integral(&values), 1.0 / f64::from(power + 1), epsilon = 3e-15);
        if power < 8 {
            let powers = |c: f64| c.powi(power + 1) / f64::from(power + 1);
            for (got, c) in RULE.integrals(&values).iter().zip(&RULE.c) {
                assert_relative_eq!(*got, powers(*c), epsilon = 3e-15);
            }
            assert_relative_eq!(RULE.integral_to_middle(&values), powers(RULE.middle), epsilon = 3e-15);
            assert_relative_eq!(RULE.at_middle(&values), RULE.middle.powi(power), epsilon = 1e-14);
        }
    }
}

#[test]
fn interpolates_polynomials_of_degree_eight() {
    let p = |x: f64| 1.0 - 3.0 * x + x.powi(3) - 2.0 * x.powi(8);
    let values: Values = RULE.c.map(p);
    for x in [0.0, 0.013, 0.3, RULE.middle, RULE.c[5], 0.99, 1.0] {
        assert_relative_eq!(RULE.interpolate(&values, x), p(x), epsilon = 1e-13);
    }
}

#[test]
fn last_node_is_the_end() {
    assert_relative_eq!(RULE.c[S], 1.0, epsilon = 1e-16);
    assert!(RULE.c.windows(2).all(|pair| pair[0] < pair[1]) && RULE.c[0] == 0.0);
}
