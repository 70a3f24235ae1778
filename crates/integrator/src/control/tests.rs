use super::*;
use crate::{FixedStep, Request};

fn node(speed: f64, acceleration: f64) -> Node {
    Node { state: State { time: 2.0, coordinate: 1.0, speed }, acceleration }
}

fn near(found: f64, wanted: f64) -> bool {
    (found - wanted).abs() <= 1e-14 * wanted.abs()
}

#[test]
fn an_error_is_measured_by_what_is_allowed() {
    let scale = Scale::new(1e-3, &State { time: 0.0, coordinate: 1.0, speed: 2.0 });
    // Travel of 4 and a speed of 5: 4e-3 and 5e-3 are allowed.
    let end = State { time: 1.0, coordinate: 5.0, speed: -5.0 };
    let [coordinate, speed] = scale.allowed(&end);
    assert!(near(coordinate, 4e-3) && near(speed, 5e-3), "{coordinate} {speed}");
    // Twice and five times that: the root of the mean square.
    let found = scale.norm(&end, 8e-3, -25e-3);
    assert!(near(found, 14.5_f64.sqrt()), "{found}");
    // No step avoids the rounding of the coordinate.
    let exact = Scale { tolerance: 1e-20, ..scale }.allowed(&end);
    assert!(near(exact[0], 20.0 * f64::EPSILON) && near(exact[1], 20.0 * f64::EPSILON), "{exact:?}");
}

#[test]
fn the_fastest_and_farthest_of_a_motion_count() {
    let mut scale = Scale::new(1e-3, &State { time: 0.0, coordinate: 1.0, speed: -2.0 });
    assert!(near(scale.fastest(), 2.0));
    scale.extend(&State { time: 1.0, coordinate: -6.0, speed: 3.0 });
    scale.extend(&State { time: 2.0, coordinate: 2.0, speed: -1.0 });
    let [coordinate, speed] = scale.allowed(&State { time: 3.0, coordinate: 1.0, speed: 0.0 });
    assert!(
        near(coordinate, 7e-3) && near(speed, 3e-3) && near(scale.fastest(), 3.0),
        "{coordinate} {speed}"
    );
}

#[test]
fn a_fixed_step_is_a_thousandth_of_the_duration() {
    let step = |until: Until, fixed_step: Option<FixedStep>, node: &Node| {
        fixed_step_of(&Request { fixed_step, ..Request::new(node.state, until) }, node)
    };
    let steady = &node(4.0, 0.0);
    assert!(near(step(Until::Time(7.0), Some(FixedStep::Time(0.125)), steady), 0.125));
    assert!(near(step(Until::Time(7.0), Some(FixedStep::Coordinate(0.5)), steady), 0.125));
    assert!(near(step(Until::Time(7.0), None, steady), 5e-3));
    assert!(near(step(Until::Coordinate(-7.0), None, steady), 2e-3));
    // 3 x + 2 x²/2 = 10 at x = 2, and a speed of 4 vanishes at 8 in half a second.
    assert!(near(step(Until::Coordinate(11.0), None, &node(3.0, 2.0)), 2e-3));
    assert!(near(step(Until::Rest, None, &node(4.0, -8.0)), 0.5e-3));
    // From rest, for a unit of the coordinate: x²/2 by 8.
    assert!(near(step(Until::Turn, None, &node(0.0, 8.0)), 0.5e-3));
    let limited = Request { time_limit: 3.0, ..Request::new(steady.state, Until::Coordinate(9.0)) };
    assert!(near(fixed_step_of(&limited, steady), 1e-3));
}

fn fixed_step_of(request: &Request, node: &Node) -> f64 {
    super::fixed_step(request, node)
}
