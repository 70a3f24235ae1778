//! Reactions beside the friction of their pairs, by hand.

use assur_mechanism::{Friction, PairId, Surfaces};

use crate::{friction_circle, friction_cone};

fn friction(coefficient: f64, surfaces: Surfaces) -> Friction {
    Friction { pair: PairId::Pin(0), coefficient, surfaces }
}

#[test]
fn the_reaction_of_a_turning_pin_touches_the_circle_of_friction() {
    let journal = |coefficient| friction(coefficient, Surfaces::Journal { radius: 0.02, owner: 0 });
    // 0.1 * 20 mm * 500 N = 1 N m, clockwise.
    let (radius, lever) = friction_circle(&journal(0.1), [300.0, 400.0], -1.0).unwrap();
    assert!((radius - 0.002).abs() < 1e-17 && (lever + 0.002).abs() < 1e-17, "{radius} {lever}");
    assert_eq!(friction_circle(&journal(0.0), [300.0, 400.0], 0.0), None);
    assert_eq!(friction_circle(&journal(0.1), [0.0; 2], 0.0), None);
}

#[test]
fn two_opposite_normal_forces_rub_more_than_their_sum() {
    let slide = friction(0.1, Surfaces::Place);
    // Across a guide along y: 200 N to the right of it, and 20 N of friction; or 300 N and -100 N on its ends, and 40 N.
    for (share, pressed) in [(20.0, false), (-20.0, false), (40.0, true)] {
        let found = friction_cone(&slide, [200.0, -share], [0.0, 1.0], share);
        let (angle, normal, on_both_ends) = found.unwrap();
        assert!((angle.tan() - 0.1).abs() < 1e-15 && (normal + 200.0).abs() < 1e-12, "{angle} {normal}");
        assert_eq!(on_both_ends, pressed, "{share}");
    }
}
