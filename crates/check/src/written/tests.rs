#![expect(clippy::float_cmp, reason = "a sense is exactly 1 or -1")]

use assur_force::{LoadState, Side};

use super::senses;

#[test]
fn a_motion_that_rests_has_the_direction_of_its_acceleration() {
    let of = |speed: f64, acceleration: f64, side: Side| {
        senses(&LoadState { speed, acceleration, side, ..LoadState::default() }, -1.0)
    };
    assert_eq!(of(3.0, -2.0, Side::After), [1.0; 2]);
    assert_eq!(of(-3.0, 2.0, Side::Before), [-1.0; 2]);
    assert_eq!(of(0.0, 2.0, Side::After), [1.0; 2], "it begins");
    assert_eq!(of(0.0, 2.0, Side::Before), [-1.0; 2], "it ends");
    assert_eq!(of(0.0, 0.0, Side::After), [-1.0; 2], "that of the input");
    assert_eq!(of(0.0, 0.0, Side::Held { upper: 0.5 }), [1.0, -1.0]);
    assert_eq!(of(-2.0, 0.0, Side::Held { upper: 0.5 }), [-1.0; 2]);
}
