use super::*;

#[test]
fn first_root_is_the_nearest_ahead() {
    // x + x²/2·2 = 2: x = 1. Back to the start from w = 1, a = -1: 2 s. Never: w = 1, a = -1, d = 1.
    let close =
        |found: Option<f64>, wanted: f64| assert!((found.unwrap() - wanted).abs() < 1e-15, "{found:?}");
    close(first_root(2.0, 1.0, 2.0), 1.0);
    close(first_root(0.0, 1.0, -1.0), 2.0);
    close(first_root(-1.5, 1.0, -2.0), 0.5 * (1.0 + 7.0_f64.sqrt()));
    close(first_root(1e-12, 1e6, -1e-6), 1e-18);
    assert_eq!(first_root(1.0, 1.0, -1.0), None);
    assert_eq!(first_root(1.0, -1.0, 0.0), None);
}

#[test]
fn a_start_on_the_wall_is_no_exit_but_a_return_is() {
    assert_eq!(first_negative(|x| x, 1.0), None);
    let back = first_negative(|x| x * (0.75 - x), 1.0).unwrap();
    assert!((back - 0.75).abs() < 1e-15, "{back}");
    let soon = first_negative(|x| x * (0.001 - x), 1.0).unwrap();
    assert!((soon - 0.001).abs() < 1e-15, "{soon}");
}

#[test]
fn roots_are_exact_to_rounding() {
    for place in [1e-9, 0.1, 0.5, 0.999_999] {
        let found = root(&|x: f64| (place - x) * (1.0 + 50.0 * x).powi(3), 0.0, 1.0);
        assert!((found - place).abs() < 4e-16, "{found} {place}");
    }
}
