use super::*;

#[test]
fn an_end_nearer_than_the_coordinate_resolves_is_refused() {
    let start = |coordinate: f64| State { time: 0.0, coordinate, speed: 1.0 };
    let accepted = |from: f64, to: f64| Request::new(start(from), Until::Coordinate(to)).check().is_ok();
    assert!(accepted(1e6, 1e6 + 1e-7) && accepted(-1e6, -1e6 - 1e-7) && accepted(0.0, 1e-16));
    assert!(!accepted(1e6, 1e6 + 1e-9) && !accepted(0.0, 1e-18) && !accepted(1.0, 1.0));
}
