//! Each kind of doubt, and the flags that name one.

use assur_motor::{Motor, flag_meaning, parse_table};

use super::plausibility::{Doubt, doubts};

/// A table with the least columns: designation, poles, kW, synchronous and rated rpm, Mmax/Mn.
fn motors(rows: &[&str]) -> Vec<Motor> {
    let header =
        "designation,poles,rated_power_kw,synchronous_speed_rpm,rated_speed_rpm,max_torque_ratio,source\n";
    let rows: Vec<String> = rows.iter().map(|row| format!("{row},by hand")).collect();
    parse_table("TEST", &format!("{header}{}\n", rows.join("\n"))).expect("the table is well-formed")
}

fn of(row: &str, flags: &[&str]) -> Vec<Doubt> {
    let mut motor = motors(&[row]).remove(0);
    motor.flags = flags.iter().map(|&f| f.to_owned()).collect();
    doubts(&motor)
}

#[test]
fn a_good_row_raises_no_doubt() {
    assert_eq!(of("x,4,1.1,1500,1410,2.2", &["maker_max_torque_2.6", "start_gt_max"]), []);
}

#[test]
fn doubts_that_a_flag_names_are_not_raised_again() {
    assert!(matches!(of("x,4,1.1,1500,1300,2.2", &[])[..], [Doubt::Unusual { .. }]));
    assert_eq!(of("x,4,1.1,1500,1300,2.2", &["slip_out_of_0.5_12"]), []);
}

#[test]
fn each_kind_of_doubt_can_be_raised() {
    assert!(matches!(of("x,4,1.1,1500,1410,7", &[])[..], [Doubt::Unusual { value: 7.0, .. }]));
    assert_eq!(of("x,4,1.1,1500,1410,2.2", &["odd"]), [Doubt::Flag { flag: "odd".to_owned() }]);
    let mut motor = motors(&["x,4,1.1,1500,1410,2.2"]).remove(0);
    motor.printed_slip = Some(0.08);
    motor.starting_torque_ratio = Some(2.3);
    (motor.rated_current, motor.power_factor, motor.efficiency) = (Some(2.0), Some(0.8), Some(0.5));
    let found = doubts(&motor);
    assert!(
        matches!(found[..], [Doubt::Slip { .. }, Doubt::StartAboveMax { .. }, Doubt::Unusual { .. }]),
        "{found:?}"
    );
}

#[test]
fn flags_with_a_value_need_a_number() {
    assert!(flag_meaning("maker_max_torque_2.6").is_some());
    assert!(flag_meaning("inertia_0.0081_removed").is_some());
    assert_eq!(flag_meaning("maker_max_torque_high"), None);
    assert_eq!(flag_meaning("maker_max_torque_"), None);
    assert_eq!(flag_meaning("start_gt_max "), None);
}
