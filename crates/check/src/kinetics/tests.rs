//! The reduced inertia of links in known motions.

use assur_group::Body;
use assur_mechanism::Link;

use super::{reduced, sizes};

/// A link of 3 kg and 0.5 kg m² whose center is the origin of its frame, in a motion of the origin and a turn.
fn terms([x1, x2]: [[f64; 2]; 2], [w1, w2]: [f64; 2]) -> ([f64; 2], f64) {
    let scene = "[ground]\npoints = { O = 0 }\n[link.a]\npoints = { O = 0 }\n[input]\nlink = \"a\"\n";
    let mut mechanism = assur_scene::read("scene", scene).unwrap();
    mechanism.links[1] = Link { name: "a".into(), mass: 3.0, center: [0.0; 2], inertia: 0.5.into() };
    let moving = Body { x1: x1[0], y1: x1[1], x2: x2[0], y2: x2[1], w1, w2, ..Body::ground() };
    let bodies = [Body::ground(), moving];
    (reduced(&mechanism, 0.0, &bodies), sizes(&mechanism, 0.0, &bodies)[1])
}

#[test]
fn a_moving_center_and_a_turn_add_up() {
    // J = 3 (3² + 4²) + 0.5 2², J' = 2 (3 (3 6 + 4 8) + 0.5 2 5).
    let ([inertia, slope], size) = terms([[3.0, 4.0], [6.0, 8.0]], [2.0, 5.0]);
    assert_eq!((inertia, slope, size), (77.0, 310.0, 310.0));
}

#[test]
fn the_terms_of_a_sum_that_cancels_are_its_sizes() {
    // The center gains speed while the turn loses it: 300 and -10; or it is accelerated across its way.
    let ([_, slope], size) = terms([[3.0, 4.0], [6.0, 8.0]], [2.0, -5.0]);
    assert_eq!((slope, size), (290.0, 310.0));
    let ([_, slope], size) = terms([[3.0, 4.0], [-8.0, 6.0]], [-2.0, 5.0]);
    assert_eq!((slope, size), (-10.0, 310.0));
}

#[test]
fn a_center_that_nearly_rests_has_the_rounding_of_what_cancels() {
    // The origin moves at 3 while the link turns about a center 1.5 away, which rests: all terms of its speed cancel. A direction
    // that is longer than one by 64 rounding units makes the arm uncertain by as much again.
    let mechanism = {
        let scene = "[ground]\npoints = { O = 0 }\n[link.a]\npoints = { O = 0 }\n[input]\nlink = \"a\"\n";
        let mut mechanism = assur_scene::read("scene", scene).unwrap();
        mechanism.links[1] = Link { name: "a".into(), mass: 2.0, center: [1.5, 0.0], inertia: 0.0.into() };
        mechanism
    };
    let size = |y1: f64, longer: f64| {
        let body = Body { c: 1.0 + longer, s: 0.0, y1, w1: -2.0, ..Body::ground() };
        sizes(&mechanism, 0.0, &[Body::ground(), body])[0]
    };
    assert!(size(3.0, 0.0).abs() < 1e-12, "to first order");
    assert!((size(4.0, 0.0) - 2.0 * 1.0 * (4.0 + 3.0)).abs() < 1e-12);
    let stretched = size(4.0, 32.0 * f64::EPSILON);
    assert!((stretched - 2.0 * (4.0 + 6.0)).abs() < 1e-9, "{stretched}");
}
