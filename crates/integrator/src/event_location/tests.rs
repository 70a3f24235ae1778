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
fn a_start_on_the_bound_is_no_exit_but_a_return_is() {
    assert_eq!(first_negative(|x| x, 1.0), None);
    let back = first_negative(|x| x * (0.75 - x), 1.0).unwrap();
    assert!((back - 0.75).abs() < 1e-15, "{back}");
    let soon = first_negative(|x| x * (0.001 - x), 1.0).unwrap();
    assert!((soon - 0.001).abs() < 1e-15, "{soon}");
}

/// A step that was aimed at a bound may end a rounding behind it; its dense output then ends on it and shows no exit.
#[test]
fn a_bound_passed_by_a_rounding_is_met() {
    let at = |coordinate: f64| State { time: 0.0, coordinate, speed: 1.0 };
    let node = Node { state: at(0.0), acceleration: 1000.0 };
    let piece = Piece { coordinate: [0.0, 1e-3], ..Piece::UNBOUNDED };
    let bounds = Bounds::new(&piece, &Request::new(at(0.0), Until::Coordinate(1.0)), &node);
    let passed = |from: f64, to: f64| bounds.passed_by_rounding(&at(from), &at(to));
    assert_eq!(passed(0.0, 1e-3 + 2.2e-19), Some(Side::CoordinateHigh));
    assert_eq!(passed(0.0, 1e-3), None);
    assert_eq!(passed(0.0, 1.1e-3), None);
    assert_eq!(passed(1e-3, 1e-3 + 2.2e-19), None);
}
