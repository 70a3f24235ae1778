//! Every row, and single rows against other places where they are printed.

use approx::assert_relative_eq;
use assur_motor::{Characteristic, CharacteristicKind, Motor, find_catalogue, find_motor, rpm};

fn rows() -> &'static [Motor] {
    find_catalogue("4a").unwrap().rows().unwrap()
}

#[test]
fn every_row_is_complete_for_kloss() {
    assert_eq!(rows().len(), 85);
    for motor in rows() {
        assert_eq!(motor.catalogue, "4A");
        assert!((60.0..=90_000.0).contains(&motor.rated_power), "{}", motor.designation);
        let c = Characteristic::new(CharacteristicKind::Kloss, &motor.rated_data()).unwrap();
        assert_relative_eq!(
            c.torque(motor.rated_speed),
            motor.rated_power / motor.rated_speed,
            max_relative = 1e-12
        );
        assert!(motor.starting_torque_ratio.is_some(), "{}", motor.designation);
        assert_eq!(motor.rotor_inertia, None, "the series prints none");
    }
}

#[test]
fn poles_are_spread_as_in_the_table() {
    let count = |poles| rows().iter().filter(|m| m.poles == poles).count();
    assert_eq!([2, 4, 6, 8].map(count), [23, 24, 20, 18]);
}

#[test]
fn every_row_is_found_by_each_way_of_writing_it() {
    for motor in rows() {
        let latin = motor.latin_designation();
        assert!(latin.is_ascii() && !latin.contains('?'), "{latin}");
        let short = latin.strip_suffix("U3").unwrap();
        for text in [motor.designation.as_str(), &latin, short, &short.to_lowercase()] {
            assert_eq!(find_motor(Some("4A"), text).unwrap(), motor, "{text}");
        }
    }
}

#[test]
fn the_motor_of_the_scene_format() {
    // The type that the scene format takes as its example; the rating is that of the table.
    for text in ["4A100L4", "4А100L4", "4А100L4У3", "4a 100l4 y3"] {
        let motor = find_motor(Some("4A"), text).unwrap();
        assert_eq!((motor.rated_power, motor.poles), (4000.0, 4));
    }
}

#[test]
fn spot_checks_against_other_prints() {
    // 4А112М4: 5.5 kW, slip 3.7 %, 1445 1/min, Mp/Mn 2.0 (a worked example of a gear reducer).
    let m = find_motor(None, "4А112М4").unwrap();
    assert_relative_eq!(rpm(m.rated_speed), 1445.0, max_relative = 1e-12);
    assert_relative_eq!(m.printed_slip.unwrap(), 0.037, max_relative = 1e-12);
    assert_eq!((m.rated_power, m.starting_torque_ratio), (5500.0, Some(2.0)));
    // 4А100S2: 4 kW, 2880 1/min (name plate).
    let m = find_motor(None, "4A100S2").unwrap();
    assert_relative_eq!(rpm(m.rated_speed), 2880.0, max_relative = 1e-12);
    assert_eq!(m.rated_power, 4000.0);
}

#[test]
fn it_conforms() {
    assur_testkit::catalogue_conformance("4A");
}
