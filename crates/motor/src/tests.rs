//! Tests of the crate, one file for each idea. Nothing here needs a catalogue: rows are made by hand.

mod catalogue;
mod characteristic;
mod designation;
mod filter;
mod flywheel;
mod selection;
mod table;
mod warning;

use crate::{Characteristic, CharacteristicKind, Motor, RatedMotor, parse_table, rad_per_s};

/// 1.1 kW, 1500 and 1410 rpm, breakdown torque 2.2.
pub(crate) fn shaper_motor() -> RatedMotor {
    RatedMotor {
        power: 1100.0,
        synchronous_speed: rad_per_s(1500.0),
        rated_speed: rad_per_s(1410.0),
        max_torque_ratio: Some(2.2),
        inertia: Some(0.0045),
    }
}

pub(crate) fn kloss() -> Characteristic {
    Characteristic::new(CharacteristicKind::Kloss, &shaper_motor()).unwrap()
}

pub(crate) fn linear() -> Characteristic {
    Characteristic::new(CharacteristicKind::Linear, &shaper_motor()).unwrap()
}

/// A table with the least columns: designation, poles, kW, synchronous and rated rpm, Mmax/Mn.
pub(crate) fn motors(rows: &[&str]) -> Vec<Motor> {
    parse_table("TEST", &table(rows)).unwrap()
}

pub(crate) fn table(rows: &[&str]) -> String {
    let mut text = String::from(
        "designation,poles,rated_power_kw,synchronous_speed_rpm,rated_speed_rpm,max_torque_ratio,source\n",
    );
    for row in rows {
        text.push_str(row);
        text.push_str(",by hand\n");
    }
    text
}
