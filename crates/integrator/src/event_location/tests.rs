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

/// Out between 0.005 and 0.03 of the step, and in again at its end.
#[test]
fn a_short_exit_at_the_start_of_a_step_is_found() {
    let exit = first_negative(|x| (x - 0.005) * (x - 0.03), 1.0).unwrap();
    assert!((exit - 0.005).abs() < 1e-15, "{exit}");
}

/// Up and back within a step: both ends are inside, and the turning point, w^2/(2 a) = 50 further, may not be.
#[test]
fn a_turn_beyond_a_bound_within_a_step_is_suspected() {
    let node =
        |time: f64, speed: f64| Node { state: State { time, coordinate: 0.0, speed }, acceleration: -1.0 };
    let (from, to) = (node(10.0, 10.0), node(30.0, -10.0));
    let piece = |high: f64| Piece { coordinate: [-1e4, high], ..Piece::UNBOUNDED };
    let request = Request::new(from.state, Until::Time(100.0));
    let suspected = |high: f64| Bounds::new(&piece(high), &request, &from).may_leave(&from, &to);
    assert!(suspected(49.0) && suspected(100.0), "the tangents reach 100 and more");
    assert!(!suspected(1e4));
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
