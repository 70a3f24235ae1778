//! Every row, and the ways of writing it.

use assur_motor::{Motor, find_catalogue, find_motor};

fn rows() -> &'static [Motor] {
    find_catalogue("air").unwrap().rows().unwrap()
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

#[test]
fn every_row_is_that_of_a_motor_and_complete_for_kloss() {
    assur_testkit::catalogue_conformance("AIR");
    assert_eq!(rows().len(), 50);
    for motor in rows() {
        assert_eq!(motor.catalogue, "AIR");
        assert!((370.0..=30_000.0).contains(&motor.rated_power), "{}", motor.designation);
        assert!(motor.max_torque_ratio.is_some() && motor.rotor_inertia.is_none(), "{}", motor.designation);
    }
}
