use approx::assert_relative_eq;
use proptest::prelude::*;

use super::{kloss, linear, shaper_motor};
use crate::{Characteristic, CharacteristicKind, RatedMotor};

#[test]
fn kloss_of_the_shaper_motor_by_hand() {
    let c = kloss();
    // Mn = 1100 / (47 pi), sn = 0.06, sk = 0.06 (2.2 + sqrt(3.84))
    let mn = 1100.0 / (47.0 * std::f64::consts::PI);
    assert_relative_eq!(c.rated_torque, mn, max_relative = 1e-14);
    assert_relative_eq!(c.critical_slip.unwrap(), 0.249_575_507_653_592_5, max_relative = 1e-12);
    assert_relative_eq!(c.breakdown_torque.unwrap(), 2.2 * mn, max_relative = 1e-14);
    assert_relative_eq!(c.starting_torque().unwrap(), 7.7012, max_relative = 1e-4);
}

#[test]
fn both_pass_through_synchronous_speed_and_the_rated_point() {
    for c in [kloss(), linear()] {
        assert_relative_eq!(c.torque(c.rated_speed), c.rated_torque, max_relative = 1e-12);
        assert_eq!(c.torque(c.synchronous_speed).abs(), 0.0);
        assert!(c.slope(c.synchronous_speed) < 0.0);
    }
}

#[test]
fn kloss_is_odd_in_the_slip() {
    let c = kloss();
    let ws = c.synchronous_speed;
    for dw in [0.1, 9.4, 40.0, 157.0, 400.0] {
        assert_relative_eq!(c.torque(ws + dw), -c.torque(ws - dw), max_relative = 1e-12);
        assert!(c.torque(ws + dw) < 0.0, "a generator brakes");
    }
}

#[test]
fn kloss_pulls_forward_at_reversed_speed() {
    let c = kloss();
    let (mut previous, ws) = (c.torque(0.0), c.synchronous_speed);
    for k in 1..=20 {
        let now = c.torque(-f64::from(k) * ws / 10.0);
        assert!(now > 0.0 && now < previous, "{now} after {previous}");
        previous = now;
    }
    // The published form, s = 3 at w = -2 ws.
    let sk = c.critical_slip.unwrap();
    let published = 2.0 * c.breakdown_torque.unwrap() / (3.0 / sk + sk / 3.0);
    assert_relative_eq!(c.torque(-2.0 * ws), published, max_relative = 1e-12);
}

#[test]
fn the_greatest_torque_is_at_the_critical_slip() {
    let c = kloss();
    let (w, top) = (c.breakdown_speed().unwrap(), c.breakdown_torque.unwrap());
    assert_relative_eq!(c.torque(w), top, max_relative = 1e-13);
    for h in [0.01, 0.1, 1.0, 10.0] {
        assert!(c.torque(w - h) < top && c.torque(w + h) < top);
    }
    assert!(c.slope(w).abs() < 1e-12 * top);
    assert!(c.slope(w - 1.0) > 0.0 && c.slope(w + 1.0) < 0.0);
}

#[test]
fn linear_knows_no_breakdown_point() {
    let c = linear();
    assert_eq!((c.critical_slip, c.breakdown_speed(), c.starting_torque()), (None, None, None));
    // Twice the rated slip, twice the rated torque.
    let w = 2.0 * c.rated_speed - c.synchronous_speed;
    assert_relative_eq!(c.torque(w), 2.0 * c.rated_torque, max_relative = 1e-12);
}

#[test]
fn impossible_data_are_refused() {
    let why = |data: RatedMotor| {
        let error = Characteristic::new(CharacteristicKind::Kloss, &data).unwrap_err();
        error.0.identity().unwrap()
    };
    let good = shaper_motor();
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(why(RatedMotor { power: bad, ..good }), "motor-rated-not-positive");
        assert_eq!(why(RatedMotor { rated_speed: bad, ..good }), "motor-rated-not-positive");
        assert_eq!(why(RatedMotor { inertia: Some(bad), ..good }), "motor-rated-not-positive");
    }
    for bad in [1.0, 0.5, -2.0, f64::NAN, f64::INFINITY] {
        let data = RatedMotor { max_torque_ratio: Some(bad), ..good };
        assert_eq!(why(data), "motor-bad-torque-ratio");
        assert!(Characteristic::new(CharacteristicKind::Linear, &data).is_err());
    }
    assert_eq!(why(RatedMotor { max_torque_ratio: None, ..good }), "motor-no-torque-ratio");
    let equal = RatedMotor { synchronous_speed: 100.0, rated_speed: 100.0, ..good };
    assert_eq!(why(equal), "motor-no-slip");
}

#[test]
fn errors_say_how_much_and_what_to_do() {
    let data = RatedMotor { synchronous_speed: 100.0, rated_speed: 102.5, ..shaper_motor() };
    assert_eq!(
        Characteristic::new(CharacteristicKind::Linear, &data).unwrap_err().to_string(),
        "rated speed 102.5 rad/s exceeds or equals the synchronous speed 100 rad/s (by 2.5 rad/s): \
         an asynchronous motor needs a slip; check both speeds"
    );
}

prop_compose! {
    /// Motors as catalogues have them, and somewhat beyond.
    fn any_motor()(power in 10.0..1e6, ws in 30.0..400.0f64, sn in 0.002..0.2, l in 1.05..6.0) -> RatedMotor {
        RatedMotor { power, synchronous_speed: ws, rated_speed: ws * (1.0 - sn), max_torque_ratio: Some(l), inertia: None }
    }
}

proptest! {
    #[test]
    fn slope_is_the_derivative(data in any_motor(), x in -2.0..3.0f64, linear: bool) {
        let kind = if linear { CharacteristicKind::Linear } else { CharacteristicKind::Kloss };
        let c = Characteristic::new(kind, &data).unwrap();
        let (w, h) = (x * data.synchronous_speed, 1e-6 * data.synchronous_speed);
        let difference = (c.torque(w + h) - c.torque(w - h)) / (2.0 * h);
        // The steepest place is synchronous speed: it sets the scale of the rounding.
        let scale = c.slope(data.synchronous_speed).abs();
        prop_assert!((c.slope(w) - difference).abs() <= 1e-6 * scale);
    }

    #[test]
    fn kloss_agrees_with_the_published_form(data in any_motor(), x in -2.0..3.0f64) {
        let c = Characteristic::new(CharacteristicKind::Kloss, &data).unwrap();
        let (s, sk) = (c.slip(x * data.synchronous_speed), c.critical_slip.unwrap());
        prop_assume!(s != 0.0);
        let published = 2.0 * c.breakdown_torque.unwrap() / (s / sk + sk / s);
        prop_assert!((c.torque(x * data.synchronous_speed) - published).abs() <= 1e-12 * published.abs());
        prop_assert!((c.torque(data.rated_speed) / c.rated_torque - 1.0).abs() < 1e-12);
    }

    #[test]
    fn torque_is_finite_everywhere(data in any_motor(), w in prop::num::f64::NORMAL) {
        let c = Characteristic::new(CharacteristicKind::Kloss, &data).unwrap();
        prop_assume!(w.abs() < 1e300);
        prop_assert!(c.torque(w).is_finite() && c.slope(w).is_finite());
        prop_assert!(c.torque(w).abs() <= c.breakdown_torque.unwrap() * (1.0 + 1e-12));
    }
}
