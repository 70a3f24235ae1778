//! Units: values by hand, and the text of each error.

use std::f64::consts::{PI, TAU};

use super::Dimension as D;
use super::*;

/// Text, dimension, SI value calculated by hand.
#[rustfmt::skip]
const GOOD: &[(&str, Dimension, f64)] = &[
    ("1/30", D::Number, 1.0 / 30.0), ("120 mm", D::Length, 0.12), ("270 mm", D::Length, 0.27), ("-400 mm", D::Length, -0.4), ("2.5 cm", D::Length, 0.025),
    ("3 km", D::Length, 3000.0), ("5 um", D::Length, 5e-6), ("5 \u{b5}m", D::Length, 5e-6), ("1 m", D::Length, 1.0),
    ("180 deg", D::Angle, PI), ("360 deg", D::Angle, TAU), ("720 deg", D::Angle, 2.0 * TAU), ("90\u{b0}", D::Angle, PI / 2.0),
    ("5 rev", D::Angle, 5.0 * TAU), ("1 turn", D::Angle, TAU), ("1.5 rad", D::Angle, 1.5),
    ("4 kg", D::Mass, 4.0), ("250 g", D::Mass, 0.25), ("1.2 t", D::Mass, 1200.0),
    ("1.5 kN", D::Force, 1500.0), ("2 MN", D::Force, 2e6), ("3 mN", D::Force, 0.003), ("7 N", D::Force, 7.0),
    ("25 N*m", D::Moment, 25.0), ("25 N\u{b7}m", D::Moment, 25.0), ("25 N\u{22c5}m", D::Moment, 25.0), ("25 Nm", D::Moment, 25.0),
    ("25 N m", D::Moment, 25.0), ("2 kN*m", D::Moment, 2000.0), ("500 N*mm", D::Moment, 0.5),
    ("0.5 s", D::Time, 0.5), ("30 ms", D::Time, 0.03), ("2 min", D::Time, 120.0), ("1 h", D::Time, 3600.0),
    ("60 rpm", D::AngularSpeed, TAU), ("90 deg/s", D::AngularSpeed, PI / 2.0), ("2 rev/s", D::AngularSpeed, 2.0 * TAU),
    ("2 rad/s", D::AngularSpeed, 2.0), ("2 1/s", D::AngularSpeed, 2.0), ("2 s^-1", D::AngularSpeed, 2.0), ("60 rev/min", D::AngularSpeed, TAU),
    ("0.3 m/s", D::Speed, 0.3), ("250 mm/s", D::Speed, 0.25), ("36 km/h", D::Speed, 10.0),
    ("9.81 m/s^2", D::Acceleration, 9.81), ("9.81 m/s\u{b2}", D::Acceleration, 9.81), ("9.81 m/s2", D::Acceleration, 9.81),
    ("9810 mm/s^2", D::Acceleration, 9.81), ("180 deg/s^2", D::AngularAcceleration, PI), ("4 rad/s\u{b2}", D::AngularAcceleration, 4.0),
    ("0.02 kg*m^2", D::Inertia, 0.02), ("0.02 kg\u{b7}m\u{b2}", D::Inertia, 0.02), ("5e6 g*mm^2", D::Inertia, 0.005),
    ("200 kg*mm^2", D::Inertia, 0.0002), ("4 kg cm^2", D::Inertia, 0.0004),
    ("4530 N/m", D::Stiffness, 4530.0), ("4.53 N/mm", D::Stiffness, 4530.0), ("2 kN/m", D::Stiffness, 2000.0),
    ("12 N*s/m", D::Damping, 12.0), ("12 N\u{b7}s/m", D::Damping, 12.0), ("1 kN*s/m", D::Damping, 1000.0),
    ("2 in", D::Length, 0.0508), ("1.5 ft", D::Length, 0.4572), ("1 lbf", D::Force, 4.448_221_615_260_5), ("1 kgf", D::Force, 9.806_65),
    ("1 hp", D::Power, 745.699_871_582_270_2), ("1 ft lbf", D::Moment, 1.355_817_948_331_400_4), ("2 lb", D::Mass, 0.907_184_74), ("1 slug", D::Mass, 14.593_902_937_206_364),
    ("1.5 kW", D::Power, 1500.0), ("2 W", D::Power, 2.0), ("0.1 MW", D::Power, 1e5),
    ("0.5", D::Number, 0.5), ("4", D::Mass, 4.0), (" 4   kg ", D::Mass, 4.0), ("4kg", D::Mass, 4.0),
    ("1e3 mm", D::Length, 1.0), ("+.5 m", D::Length, 0.5), ("\u{2212}5 m", D::Length, -5.0), ("2 m / s", D::Speed, 2.0),
];

#[test]
fn good_quantities() {
    for &(text, dimension, value) in GOOD {
        let read = quantity(text, dimension).unwrap_or_else(|error| panic!("{text}: {error}"));
        approx::assert_relative_eq!(read, value, max_relative = 1e-15);
    }
}

/// Whoever misses a unit is told all that are read, each once: a unit in other letters is one of those told.
#[test]
fn every_named_unit_is_told_where_one_is_wanted() {
    for (unit, _, _, _, powers) in parse::NAMED.iter().filter(|unit| unit.4 != [0; 4]) {
        let Some(dimension) = Dimension::of(*powers) else { panic!("{unit}") };
        let size = |unit: &str| Unit::of(unit, dimension).unwrap().si(1.0).to_bits();
        let is_told = dimension.units().split(", ").any(|told| told == *unit || size(told) == size(unit));
        assert!(is_told, "{unit}: {}", dimension.units());
    }
}

#[test]
fn decimal_units_round_once() {
    for tenths in 1..5000_i32 {
        let text = format!("{tenths} mm");
        let written: f64 = format!("{tenths}e-3").parse().unwrap();
        assert_eq!(quantity(&text, Dimension::Length).map(f64::to_bits), Ok(written.to_bits()), "{text}");
    }
}

/// Text, dimension, the whole message.
const BAD: &[(&str, Dimension, &str)] = &[
    ("3 mm", D::Mass, "wants a mass (kg, g, t, lb, slug), got `mm`, a length"),
    ("3 N", D::Moment, "wants a moment (N*m, kN*m, N*mm, lbf*in), got `N`, a force"),
    ("3 m^3", D::Length, "wants a length (m, mm, cm, dm, km, um, in, ft), got `m^3`, no quantity of a scene"),
    ("3 1/s", D::Angle, "wants an angle (rad, mrad, deg, rev), got `1/s`, no quantity of a scene"),
    ("3 rad", D::Number, "wants a plain number, got `rad`, an angle"),
    ("3 kgg", D::Mass, "wants a mass (kg, g, t, lb, slug), got the unknown unit `kgg`"),
    ("3 kg*", D::Mass, "wants a mass (kg, g, t, lb, slug), got the unknown unit `kg*`"),
    ("3 kg^x", D::Mass, "wants a mass (kg, g, t, lb, slug), got the unknown unit `kg^x`"),
    (
        "3 m^2147483647",
        D::Length,
        "wants a length (m, mm, cm, dm, km, um, in, ft), got the unknown unit `m^2147483647`",
    ),
    ("1,5 kN", D::Force, "has a comma in the number `1,5 kN`: the decimal sign is a point"),
    ("kN", D::Force, "wants a force (N, kN, MN, mN, kgf, lbf), got `kN`, which does not begin with a number"),
    ("", D::Time, "wants a time (s, ms, min, h), got ``, which does not begin with a number"),
    (
        "inf m",
        D::Length,
        "wants a length (m, mm, cm, dm, km, um, in, ft), got `inf m`, which does not begin with a number",
    ),
    (
        "nan",
        D::Length,
        "wants a length (m, mm, cm, dm, km, um, in, ft), got `nan`, which does not begin with a number",
    ),
    ("1e999 m", D::Length, "is too large: `1e999 m`, at most 1e6 m"),
    ("1e308 km", D::Length, "is too large: `1e308 km`, at most 1e6 m"),
];

#[test]
fn bad_quantities() {
    for &(text, dimension, message) in BAD {
        assert_eq!(
            quantity(text, dimension).map_err(|error| error.to_string()),
            Err(message.to_owned()),
            "{text}"
        );
    }
}

#[test]
fn near_units_are_suggested() {
    let near = |text, dimension| match quantity(text, dimension) {
        Err(UnitError { fault: UnitFault::UnknownUnit(near), .. }) => near,
        other => panic!("{text}: {other:?}"),
    };
    assert_eq!(near("3 Kg", D::Mass).as_deref(), Some("kg"));
    assert_eq!(near("3 rmp", D::AngularSpeed).as_deref(), Some("rpm"));
    assert_eq!(near("3 degr", D::Angle).as_deref(), Some("deg"));
    assert_eq!(near("3 furlong", D::Length), None);
}

#[test]
fn every_dimension_reads_its_example_and_its_units() {
    let all = [
        D::Length,
        D::Angle,
        D::Mass,
        D::Time,
        D::Force,
        D::Moment,
        D::Speed,
        D::AngularSpeed,
        D::Acceleration,
        D::AngularAcceleration,
        D::Inertia,
        D::Stiffness,
        D::Damping,
        D::Power,
    ];
    for dimension in all {
        assert!(quantity(dimension.example(), dimension).is_ok(), "{dimension:?}");
        assert_eq!(quantity(&format!("1 {}", dimension.si()), dimension), Ok(1.0));
        for unit in dimension.units().split(", ") {
            assert!(quantity(&format!("1 {unit}"), dimension).is_ok(), "{unit}");
        }
    }
    assert_eq!(assur_words::Describe::describe(&Dimension::Number).to_string(), "a plain number");
}

proptest::proptest! {
    #[test]
    fn any_text_is_answered(text in "\\PC{0,12}", tail in "[0-9.eE+*/^ mNskgrad\u{b0}\u{b2}\u{b7}\u{2212}-]{0,16}") {
        for text in [text.clone() + &tail, tail + &text] {
            if let Ok(value) = quantity(&text, Dimension::Length) {
                proptest::prop_assert!(value.is_finite());
            }
        }
    }
}
