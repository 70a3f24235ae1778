//! Every row of every catalogue, and what each catalogue promises to print.

use approx::assert_relative_eq;
use assur_motor::{
    Characteristic, CharacteristicKind, Motor, MotorFilter, SelectionRequest, catalogues, find_catalogue,
    find_motor, list_motors, rad_per_s, select,
};
use assur_words::Describe;

/// Name, rows, least and greatest power in W.
const CATALOGUES: [(&str, usize, f64, f64); 7] = [
    ("DELPHI", 115, 60.0, 110_000.0),
    ("IE1-1LE1002", 79, 90.0, 37_000.0),
    ("IE1-BN", 70, 60.0, 30_000.0),
    ("IE3-1LE1003", 88, 120.0, 45_000.0),
    ("IE3-1LE1503", 107, 90.0, 110_000.0),
    ("IE3-FLSES", 59, 750.0, 110_000.0),
    ("IE3-LSES", 72, 120.0, 55_000.0),
];

fn rows(name: &str) -> &'static [Motor] {
    find_catalogue(name).unwrap().rows().unwrap()
}

#[test]
fn all_are_registered_in_the_order_of_their_names() {
    let names: Vec<&str> = catalogues().unwrap().iter().map(|c| c.name).collect();
    assert_eq!(names, CATALOGUES.map(|(name, ..)| name));
}

#[test]
fn rows_and_powers_are_those_of_the_source() {
    for (name, count, least, most) in CATALOGUES {
        assert_eq!(rows(name).len(), count, "{name}");
        for motor in rows(name) {
            assert_eq!(motor.catalogue, name);
            assert!([2, 4, 6, 8].contains(&motor.poles));
        }
        let powers = || rows(name).iter().map(|m| m.rated_power);
        assert_eq!(powers().fold(f64::MAX, f64::min), least, "{name}");
        assert_eq!(powers().fold(0.0, f64::max), most, "{name}");
    }
}

#[test]
fn kloss_passes_through_every_rated_point() {
    for motor in CATALOGUES.iter().flat_map(|(name, ..)| rows(name)) {
        let kloss = Characteristic::new(CharacteristicKind::Kloss, &motor.rated_data());
        if motor.catalogue == "IE1-BN" {
            let absent = kloss.unwrap_err().describe();
            assert_eq!(absent.identity(), Some("motor-no-torque-ratio"));
            continue;
        }
        let torque = kloss.unwrap().torque(motor.rated_speed);
        assert_relative_eq!(torque, motor.rated_power / motor.rated_speed, max_relative = 1e-12);
    }
}

#[test]
fn inertia_and_mass_are_printed_everywhere_but_in_one_row() {
    for motor in CATALOGUES.iter().flat_map(|(name, ..)| rows(name)) {
        assert!(motor.mass.is_some(), "{}", motor.designation);
        let removed = motor.flags.iter().any(|flag| flag == "inertia_0.0081_removed");
        assert_eq!(motor.rotor_inertia.is_none(), removed, "{}", motor.designation);
    }
}

#[test]
fn every_designation_finds_its_own_row() {
    for motor in CATALOGUES.iter().flat_map(|(name, ..)| rows(name)) {
        assert!(motor.designation.is_ascii());
        let lower = motor.designation.to_lowercase().replace(' ', "");
        for text in [&motor.designation, &lower] {
            assert_eq!(find_motor(Some(&motor.catalogue), text).unwrap(), motor);
            assert_eq!(find_motor(None, text).unwrap(), motor, "unique among all catalogues");
        }
    }
}

#[test]
fn a_type_with_several_ratings_is_ambiguous() {
    let error = find_motor(Some("IE3-LSES"), "LSES 63 M").unwrap_err();
    assert!(error.to_string().starts_with("`LSES 63 M` names 4 motors in "), "{error}");
    assert_eq!(find_motor(None, "LSES 250 MZ").unwrap().rated_power, 55_000.0);
}

#[test]
fn lists_are_filtered() {
    let filter = MotorFilter {
        catalogue: Some("delphi".to_owned()),
        min_power: Some(1000.0),
        max_power: Some(1600.0),
        max_speed: None,
        poles: Some(4),
        designation: None,
    };
    let listed = list_motors(&catalogues().unwrap(), &filter).unwrap();
    assert!(!listed.is_empty());
    for m in &listed {
        assert!(m.catalogue == "DELPHI" && m.poles == 4 && (1000.0..=1600.0).contains(&m.rated_power));
    }
    let all = list_motors(&catalogues().unwrap(), &MotorFilter::default()).unwrap();
    assert_eq!(all.len(), 590);
    let unknown = MotorFilter { catalogue: Some("IE3-LSE".to_owned()), ..MotorFilter::default() };
    let error = list_motors(&catalogues().unwrap(), &unknown).unwrap_err().to_string();
    assert!(error.starts_with("no motor catalogue `IE3-LSE`; there are: IE3-LSES, "), "{error}");
}

#[test]
fn the_automatic_choice_suffices_and_nothing_smaller_does() {
    let request = SelectionRequest {
        required_power: 800.0,
        input_speed: rad_per_s(60.0),
        max_motor_speed: Some(rad_per_s(1500.0)),
        characteristic: CharacteristicKind::Kloss,
    };
    let found = select(rows("IE3-LSES"), &request).unwrap();
    // The four-pole row of 0.9 kW is the only one between 0.75 and 1.1 kW.
    assert_eq!(found.chosen.motor.designation, "LSES 80 LG 4p 0.9 kW");
    assert!(found.runners_up.iter().all(|c| c.motor.rated_power >= found.chosen.motor.rated_power));
    assert!(select(rows("IE1-BN"), &request).is_err(), "prints no breakdown torque");
}

#[test]
fn all_conform() {
    for (name, ..) in CATALOGUES {
        assur_testkit::catalogue_conformance(name);
    }
}
