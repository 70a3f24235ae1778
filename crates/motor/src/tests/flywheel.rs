use approx::assert_relative_eq;
use proptest::prelude::*;

use crate::{CAST_IRON, FlywheelPlaces, FlywheelProportions, FlywheelShape, FlywheelSize, STEEL};

/// Inertia and mass of a ring, summed over thin rings: independent of the closed forms.
fn summed(size: &FlywheelSize, bore: f64) -> (f64, f64) {
    let (inner, outer, n) = (bore * size.diameter / 2.0, size.diameter / 2.0, 20_000);
    let dr = (outer - inner) / f64::from(n);
    (0..n).fold((0.0, 0.0), |(j, m), k| {
        let r = inner + (f64::from(k) + 0.5) * dr;
        let dm = size.material.density * size.width * std::f64::consts::TAU * r * dr;
        (j + dm * r * r, m + dm)
    })
}

#[test]
fn a_disc_by_hand() {
    // D = 0.5 m, b = 0.05 m, steel: m = 7850 pi/4 0.25 0.05 = 77.067 kg, J = m D²/8 = 2.40835 kg m²
    let mass = 7850.0 * std::f64::consts::PI / 4.0 * 0.25 * 0.05;
    let size = FlywheelSize::new(mass * 0.25 / 8.0, &FlywheelProportions::DISC, STEEL).unwrap();
    assert_relative_eq!(size.diameter, 0.5, max_relative = 1e-13);
    assert_relative_eq!(size.width, 0.05, max_relative = 1e-13);
    assert_relative_eq!(size.mass, mass, max_relative = 1e-13);
    assert_relative_eq!(size.rim_speed(-40.0), 10.0, max_relative = 1e-13);
    assert_relative_eq!(size.hoop_stress(40.0), 785_000.0, max_relative = 1e-13);
}

#[test]
fn a_rim_of_half_the_diameter_is_a_disc() {
    let rim = FlywheelProportions { shape: FlywheelShape::Rim { thickness_ratio: 0.5 }, width_ratio: 0.1 };
    let sizes = [rim, FlywheelProportions::DISC].map(|p| FlywheelSize::new(1.0, &p, STEEL).unwrap());
    assert_eq!(sizes[0], sizes[1]);
}

#[test]
fn rim_speed_is_held_to_the_custom() {
    let size = FlywheelSize::new(2.0, &FlywheelProportions::RIM, CAST_IRON).unwrap();
    let fastest = 35.0 / (size.diameter / 2.0);
    assert!(size.check_rim_speed(0.99 * fastest).ok && !size.check_rim_speed(1.01 * fastest).ok);
}

#[test]
fn on_the_motor_shaft_the_wheel_is_smaller_and_its_rim_faster() {
    let (u, w) = (24.0, 6.5);
    let places = FlywheelPlaces::compare(30.0, u, w, &FlywheelProportions::RIM, STEEL).unwrap();
    assert_relative_eq!(places.on_motor.inertia, 30.0 / 576.0, max_relative = 1e-14);
    // J grows with D⁵, m with D³.
    let scale = 576f64.powf(0.2);
    assert_relative_eq!(places.on_input.diameter / places.on_motor.diameter, scale, max_relative = 1e-12);
    assert_relative_eq!(places.on_input.mass / places.on_motor.mass, scale.powi(3), max_relative = 1e-12);
    assert_relative_eq!(
        places.on_motor_rim.rim_speed / places.on_input_rim.rim_speed,
        u / scale,
        max_relative = 1e-12
    );
}

#[test]
fn no_flywheel_needed_has_no_size() {
    let size = FlywheelSize::new(0.0, &FlywheelProportions::DISC, STEEL).unwrap();
    assert_eq!((size.diameter, size.width, size.mass), (0.0, 0.0, 0.0));
}

#[test]
fn impossible_wheels_are_refused() {
    let rim = |thickness_ratio, width_ratio| FlywheelProportions {
        shape: FlywheelShape::Rim { thickness_ratio },
        width_ratio,
    };
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(FlywheelSize::new(bad, &FlywheelProportions::DISC, STEEL).is_err());
        assert!(FlywheelSize::new(1.0, &rim(0.1, bad), STEEL).is_err());
        assert!(FlywheelPlaces::compare(1.0, bad, 1.0, &FlywheelProportions::DISC, STEEL).is_err());
    }
    assert!(FlywheelSize::new(1.0, &rim(0.0, 0.1), STEEL).is_err());
    let text = FlywheelSize::new(1.0, &rim(0.6, 0.1), STEEL).unwrap_err().to_string();
    assert_eq!(
        text,
        "rim thickness / diameter of the flywheel is 0.6, must be finite, greater than 0 and at most 0.5"
    );
}

proptest! {
    #[test]
    fn closed_forms_agree_with_the_sum_over_rings(
        inertia in 1e-4..1e4f64, tau in 0.02..0.5f64, beta in 0.02..1.0f64,
    ) {
        let rim = FlywheelProportions { shape: FlywheelShape::Rim { thickness_ratio: tau }, width_ratio: beta };
        let size = FlywheelSize::new(inertia, &rim, CAST_IRON).unwrap();
        let (j, m) = summed(&size, 1.0 - 2.0 * tau);
        prop_assert!((j / inertia - 1.0).abs() < 1e-6 && (m / size.mass - 1.0).abs() < 1e-6);
    }
}
