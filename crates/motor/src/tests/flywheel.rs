use approx::assert_relative_eq;
use proptest::prelude::*;

use crate::flywheel_sizes;

#[test]
fn a_disc_by_hand() {
    // D = 0.5 m, b = 0.05 m, steel: m = 7850 pi/4 0.25 0.05 = 77.067 kg, J = m D²/8 = 2.40835 kg m²
    let mass = 7850.0 * std::f64::consts::PI / 4.0 * 0.25 * 0.05;
    let [size, _] = flywheel_sizes(mass * 0.25 / 8.0, 10.0, -40.0);
    assert_relative_eq!(size.diameter, 0.5, max_relative = 1e-13);
    assert_relative_eq!(size.width, 0.05, max_relative = 1e-13);
    assert_relative_eq!(size.mass, mass, max_relative = 1e-13);
    assert_relative_eq!(size.rim_speed, 10.0, max_relative = 1e-13);
}

#[test]
fn rim_speed_is_held_to_the_custom() {
    let at = |speed: f64| flywheel_sizes(2.0, 1.0, speed)[0];
    let fastest = 100.0 / (at(1.0).diameter / 2.0);
    assert!(at(0.99 * fastest).ok && !at(1.01 * fastest).ok);
}

#[test]
fn on_the_motor_shaft_the_wheel_is_smaller_and_its_rim_faster() {
    let u = 24.0;
    let [input, motor] = flywheel_sizes(30.0, u, 6.5);
    assert_eq!((input.shaft, motor.shaft), ("input", "motor"));
    assert_relative_eq!(motor.inertia, 30.0 / 576.0, max_relative = 1e-14);
    // J grows with D⁵, m with D³.
    let scale = 576f64.powf(0.2);
    assert_relative_eq!(input.diameter / motor.diameter, scale, max_relative = 1e-12);
    assert_relative_eq!(input.mass / motor.mass, scale.powi(3), max_relative = 1e-12);
    assert_relative_eq!(motor.rim_speed / input.rim_speed, u / scale, max_relative = 1e-12);
}

proptest! {
    /// Inertia and mass of the disc, summed over thin rings: independent of the closed forms.
    #[test]
    fn closed_forms_agree_with_the_sum_over_rings(inertia in 1e-4..1e4f64) {
        let [size, _] = flywheel_sizes(inertia, 1.0, 0.0);
        let rings = 5_000;
        let dr = size.diameter / 2.0 / f64::from(rings);
        let (j, m) = (0..rings).fold((0.0, 0.0), |(j, m), k| {
            let r = (f64::from(k) + 0.5) * dr;
            let dm = 7850.0 * size.width * std::f64::consts::TAU * r * dr;
            (j + dm * r * r, m + dm)
        });
        prop_assert!((j / inertia - 1.0).abs() < 1e-6 && (m / size.mass - 1.0).abs() < 1e-6);
    }
}
