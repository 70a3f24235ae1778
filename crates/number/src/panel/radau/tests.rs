//! Order conditions of the rule.

use std::sync::LazyLock;

use super::Radau;

const S: usize = 8;

static RULE: LazyLock<Radau<S, 9>> = LazyLock::new(Radau::new);

fn assert_close(found: f64, wanted: f64, allowed: f64) {
    assert!((found - wanted).abs() <= allowed, "{found} is not {wanted}: off by {:e}", found - wanted);
}

#[test]
fn integrates_powers_exactly() {
    // The weights are those of Radau: exact to degree 2 S - 2 = 14. The matrix is exact to degree S - 1.
    for power in 0..15_i32 {
        let values = RULE.c.map(|c| c.powi(power));
        assert_close(RULE.integral(&values), 1.0 / f64::from(power + 1), 3e-15);
        if power < 8 {
            let powers = |c: f64| c.powi(power + 1) / f64::from(power + 1);
            for (got, c) in RULE.integrals(&values).iter().zip(&RULE.c) {
                assert_close(*got, powers(*c), 3e-15);
            }
            assert_close(RULE.integral_to_middle(&values), powers(RULE.middle), 3e-15);
            assert_close(RULE.at_middle(&values), RULE.middle.powi(power), 1e-14);
        }
    }
}

#[test]
fn interpolates_polynomials_of_degree_eight() {
    let p = |x: f64| 1.0 - 3.0 * x + x.powi(3) - 2.0 * x.powi(8);
    let values = RULE.c.map(p);
    for x in [0.0, 0.013, 0.3, RULE.middle, RULE.c[5], 0.99, 1.0] {
        assert_close(RULE.interpolate(&values, x), p(x), 1e-13);
    }
}

#[test]
fn last_node_is_the_end() {
    assert_close(RULE.c[S], 1.0, 0.0);
    assert!(RULE.c.windows(2).all(|pair| pair[0] < pair[1]) && RULE.c[0] == 0.0);
}

/// Radau IIA of order 5, whose numbers are known in closed form (Hairer & Wanner II, table IV.5.6).
#[test]
fn three_nodes_give_the_known_table() {
    let (rule, root) = (Radau::<3, 4>::new(), 6.0_f64.sqrt());
    assert_close(rule.c[1], (4.0 - root) / 10.0, 1e-15);
    assert_close(rule.a[0][0], (88.0 - 7.0 * root) / 360.0, 1e-15);
    assert_close(rule.a[0][1], (296.0 - 169.0 * root) / 1800.0, 1e-15);
    assert_close(rule.a[2][2], 1.0 / 9.0, 1e-15);
}
