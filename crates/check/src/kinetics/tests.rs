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
