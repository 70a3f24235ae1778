//! The conformance suite of motor catalogues.

use std::collections::BTreeSet;

use assur_motor::{CataloguePlugin, Characteristic, CharacteristicKind, Motor, find_catalogue};

use crate::Fault;

/// Tests a registered catalogue with the whole suite, and returns a failure as a value.
///
/// # Errors
///
/// The first [`Fault`] found.
pub fn judge_catalogue(name: &str) -> Result<(), Fault> {
    let plugin = find_catalogue(name).map_err(|error| Fault::of_entry("registry", error))?;
    judge_table(plugin)
}

/// Tests the entry of a catalogue with the whole suite: rows that can be read, data that a motor can have, designations that are
/// found.
///
/// # Errors
///
/// The first [`Fault`] found.
pub fn judge_table(plugin: &CataloguePlugin) -> Result<(), Fault> {
    let rows = plugin.rows().map_err(|error| Fault::of_entry("rows", error))?;
    if rows.is_empty() {
        return Err(Fault::of_entry("rows", "the table is empty"));
    }
    let mut seen = BTreeSet::new();
    for motor in rows {
        if !seen.insert((motor.latin_designation(), motor.poles)) {
            return Err(Fault::of_entry("designations", format!("`{}` is there twice", motor.designation)));
        }
        physics(motor).map_err(|what| Fault::of_entry("data", format!("`{}`: {what}", motor.designation)))?;
    }
    Ok(())
}

/// What is wrong with the data of a motor.
fn physics(motor: &Motor) -> Result<(), String> {
    let synchronous = 100.0 * std::f64::consts::PI * 2.0 / f64::from(motor.poles);
    if (motor.synchronous_speed / synchronous - 1.0).abs() > 1e-6 {
        return Err(format!(
            "{} poles at 50 Hz turn with {synchronous} rad/s, not {}",
            motor.poles, motor.synchronous_speed
        ));
    }
    let slip = 1.0 - motor.rated_speed / motor.synchronous_speed;
    if slip.is_nan() || slip <= 0.0 || slip > 0.2 {
        return Err(format!("a slip of {slip:.3}"));
    }
    if motor.rated_power.is_nan() || motor.rated_power <= 0.0 {
        return Err(format!("a rated power of {} W", motor.rated_power));
    }
    if motor.rotor_inertia.is_some_and(|inertia| inertia.is_nan() || inertia <= 0.0) {
        return Err(format!("a rotor of {:?} kg m^2", motor.rotor_inertia));
    }
    let Some(ratio) = motor.max_torque_ratio else { return Ok(()) };
    if ratio.is_nan() || ratio <= 1.0 {
        return Err(format!("a breakdown torque of {ratio} rated torques"));
    }
    let kloss = Characteristic::new(CharacteristicKind::Kloss, &motor.rated_data())
        .map_err(|error| error.to_string())?;
    let rated = motor.rated_power / motor.rated_speed;
    let found = kloss.torque(motor.rated_speed);
    if (found / rated - 1.0).abs() > 1e-12 {
        return Err(format!("Kloss gives {found} N m at the rated speed, the data {rated} N m"));
    }
    Ok(())
}
