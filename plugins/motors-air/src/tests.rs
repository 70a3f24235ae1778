//! Every row, and the ways of writing it.

use approx::assert_relative_eq;
use assur_motor::{Characteristic, CharacteristicKind, Motor, find_catalogue, find_motor};

fn rows() -> &'static [Motor] {
    find_catalogue("air").unwrap().rows().unwrap()
}

#[test]
fn every_row_is_complete_for_kloss() {
    assert_eq!(rows().len(), 50);
    for motor in rows() {
        assert_eq!(motor.catalogue, "AIR");
        assert!((370.0..=30_000.0).contains(&motor.rated_power), "{}", motor.designation);
        let c = Characteristic::new(CharacteristicKind::Kloss, &motor.rated_data()).unwrap();
        assert_relative_eq!(
            c.torque(motor.rated_speed),
            motor.rated_power / motor.rated_speed,
            max_relative = 1e-12
        );
        assert_eq!(motor.rotor_inertia, None, "the sources print none");
    }
}

#[test]
fn poles_are_spread_as_in_the_table() {
    let count = |poles| rows().iter().filter(|m| m.poles == poles).count();
    assert_eq!([2, 4, 6, 8].map(count), [13, 14, 13, 10]);
}

#[test]
fn every_row_is_found_by_each_way_of_writing_it() {
    for motor in rows() {
        let latin = motor.latin_designation();
        assert!(latin.starts_with("AIR") && latin.is_ascii(), "{latin}");
        let with_climate = format!("{}У3", motor.designation);
        for text in [motor.designation.as_str(), &latin, &latin.to_lowercase(), &with_climate] {
            assert_eq!(find_motor(Some("АИР"), text).unwrap(), motor, "{text}");
        }
    }
}
