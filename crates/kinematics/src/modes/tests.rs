//! Modes that vanish, and which is taken then.

use super::{Body, Mode, Modes};

#[test]
fn a_mode_whose_place_only_others_take_has_vanished() {
    let modes = |angles: &[f64], present: usize| {
        let body = |angle: &f64| Body { c: angle.cos(), s: angle.sin(), ..Body::ground() };
        let mode = |angle| Mode { bodies: vec![body(angle)], way: 0, health: 1.0 };
        Modes { all: angles.iter().map(mode).collect(), present, is_numbered: false }
    };
    let found = |after: &[f64]| {
        let of = |present| modes(&[0.0, 0.1, 0.4], present).present_after(&modes(after, 0), 1.0, 1.0);
        [0, 1, 2].map(of)
    };
    // The first two meet and vanish; the third one, not far away, has moved a little.
    assert_eq!(found(&[0.42]), [None, None, Some(0)]);
    // All of them go on.
    assert_eq!(found(&[-0.02, 0.15, 0.42]), [Some(0), Some(1), Some(2)]);
}
