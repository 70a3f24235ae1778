use approx::assert_relative_eq;
use proptest::prelude::*;

use super::{kloss, linear};
use crate::{ShaftError, ShaftMotor};

fn motor(direction: f64) -> ShaftMotor {
    ShaftMotor::new(kloss(), 20.0, 0.8, direction).unwrap()
}

#[test]
fn drives_with_the_efficiency_and_brakes_against_it() {
    let m = motor(1.0);
    let w = kloss().rated_speed() / 20.0;
    assert_relative_eq!(m.torque(w), 20.0 * 0.8 * kloss().rated_torque(), max_relative = 1e-12);
    // As far above synchronous speed: the same torque, braking; the losses of the reducer help.
    let above = 2.0 * m.synchronous_input_speed() - w;
    assert_relative_eq!(m.torque(above), -20.0 / 0.8 * kloss().rated_torque(), max_relative = 1e-10);
    // Turned backwards by the load: torque forward, power back.
    assert_relative_eq!(m.torque(-1.0), 20.0 / 0.8 * kloss().torque(-20.0), max_relative = 1e-12);
    assert!(m.torque(-1.0) > 0.0);
    // At rest: starting the mechanism.
    assert_relative_eq!(m.torque(0.0), 20.0 * 0.8 * kloss().torque(0.0), max_relative = 1e-12);
}

#[test]
fn clockwise_is_the_mirror_image() {
    let (ccw, cw) = (motor(1.0), motor(-1.0));
    assert_eq!(cw.synchronous_input_speed(), -ccw.synchronous_input_speed());
    for w in [-3.0, 0.0, 1.0, 7.0, 7.6, 9.0] {
        assert_eq!(cw.torque(-w), -ccw.torque(w));
        assert_eq!(cw.slope(-w), ccw.slope(w));
    }
}

#[test]
fn power_is_never_made_by_the_reducer() {
    let m = motor(-1.0);
    for k in -40..=40 {
        let w = 0.5 * f64::from(k);
        let (given, taken) = (m.motor_torque(w) * m.motor_speed(w), m.torque(w) * w);
        assert!(taken <= given + 1e-9, "{taken} W out of {given} W at {w}");
    }
}

#[test]
fn rotor_counts_with_the_square_of_the_ratio() {
    assert_relative_eq!(motor(1.0).reduced_inertia(0.0045), 1.8, max_relative = 1e-14);
    assert_relative_eq!(
        motor(1.0).with_ratio(10.0).unwrap().reduced_inertia(0.0045),
        0.45,
        max_relative = 1e-14
    );
}

#[test]
fn impossible_reducers_are_refused() {
    for bad in [0.0, -3.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(ShaftMotor::new(linear(), bad, 1.0, 1.0), Err(ShaftError::Ratio { .. })));
    }
    for bad in [0.0, -0.5, 1.01, f64::NAN] {
        assert!(matches!(ShaftMotor::new(linear(), 1.0, bad, 1.0), Err(ShaftError::Efficiency { .. })));
    }
    for bad in [0.0, 0.5, f64::NAN] {
        assert!(matches!(ShaftMotor::new(linear(), 1.0, 1.0, bad), Err(ShaftError::Direction { .. })));
    }
}

proptest! {
    #[test]
    fn slope_is_the_derivative(w in -20.0..20.0f64, u in 1.0..60.0f64, eta in 0.3..1.0f64, cw: bool, straight: bool) {
        let c = if straight { linear() } else { kloss() };
        let m = ShaftMotor::new(c, u, eta, if cw { -1.0 } else { 1.0 }).unwrap();
        let h = 1e-6;
        // Not across the jump at rest and the kink at synchronous speed.
        prop_assume!(w.abs() > 2.0 * h && (w - m.synchronous_input_speed()).abs() > 2.0 * h);
        let difference = (m.torque(w + h) - m.torque(w - h)) / (2.0 * h);
        let scale = u * u / eta * c.slope(c.synchronous_speed()).abs();
        prop_assert!((m.slope(w) - difference).abs() <= 1e-6 * scale);
    }
}
