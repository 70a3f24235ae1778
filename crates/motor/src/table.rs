//! Reading a catalogue from a CSV table.

use std::collections::BTreeSet;
use std::sync::OnceLock;

use assur_words::{Text, name, number, text};
use serde::Deserialize;

use crate::{Motor, MotorError, lookup::normalize_latin, motor::rad_per_s};

/// Highest breakdown or starting torque ratio, or current ratio, that is accepted.
const MOST_RATIO: f64 = 20.0;

/// The text of a table of motors, which is parsed once, at its first use.
#[derive(Debug)]
pub struct CatalogueTable {
    text: &'static str,
    rows: OnceLock<Result<Vec<Motor>, MotorError>>,
}

impl CatalogueTable {
    /// A table in CSV, see the columns in [`parse_table`].
    pub const fn new(text: &'static str) -> Self {
        Self { text, rows: OnceLock::new() }
    }

    /// All rows, as those of the catalogue `name`, in the order of the table.
    pub(crate) fn rows(&self, name: &str) -> Result<&[Motor], MotorError> {
        let rows = self.rows.get_or_init(|| parse_table(name, self.text));
        rows.as_deref().map_err(Clone::clone)
    }
}

/// The motors of a CSV table, in SI units: one header row, comma separated, UTF-8, decimal point.
///
/// Columns (those with * must have a value): `designation`*, `poles`*, `rated_power_kw`*,
/// `synchronous_speed_rpm`*, `rated_speed_rpm`*, `source`*, `rated_slip_percent`, `efficiency_percent`,
/// `cos_phi`, `rated_current_a`, `max_torque_ratio`, `starting_torque_ratio`, `min_torque_ratio`,
/// `starting_current_ratio`, `critical_slip_percent`, `rotor_inertia_kg_m2`, `mass_kg`, `shaft_height_mm`,
/// `length_mm`, `diameter_mm`, `stator_bore_mm`, `stator_core_length_mm`, `flags` (separated by spaces).
///
/// # Errors
///
/// [`MotorError`] for what is not such a table, an impossible value, a designation that occurs twice, a table without rows.
pub fn parse_table(catalogue: &str, text: &str) -> Result<Vec<Motor>, MotorError> {
    let own = |letters: &str| name(letters.to_owned());
    let unreadable = |e: csv::Error| {
        MotorError(text!("motor-table-unreadable", catalogue = own(catalogue), reason = own(&e.to_string())))
    };
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let headers = reader.headers().map_err(unreadable)?.clone();
    let mut motors = Vec::new();
    let mut seen = BTreeSet::new();
    for record in reader.into_records() {
        let record = record.map_err(unreadable)?;
        let row: MotorRow = record.deserialize(Some(&headers)).map_err(unreadable)?;
        let new = seen.insert(normalize_latin(&row.designation));
        if let Some(fault) = if new { row.fault() } else { Some(text!("motor-row-twice")) } {
            let line = number(record.position().map_or(0, csv::Position::line));
            let (catalogue, designation) = (own(catalogue), name(row.designation));
            return Err(MotorError(text!("motor-bad-row", catalogue, line, designation, fault)));
        }
        motors.push(row.into_motor(catalogue));
    }
    if motors.is_empty() {
        return Err(MotorError(text!("motor-no-rows", catalogue = own(catalogue))));
    }
    Ok(motors)
}

/// One row, in the units of the table. Columns that a [`Motor`] does not hold are checked only.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct MotorRow {
    designation: String,
    poles: u32,
    rated_power_kw: f64,
    synchronous_speed_rpm: f64,
    rated_speed_rpm: f64,
    rated_slip_percent: Option<f64>,
    efficiency_percent: Option<f64>,
    cos_phi: Option<f64>,
    rated_current_a: Option<f64>,
    max_torque_ratio: Option<f64>,
    starting_torque_ratio: Option<f64>,
    min_torque_ratio: Option<f64>,
    starting_current_ratio: Option<f64>,
    critical_slip_percent: Option<f64>,
    rotor_inertia_kg_m2: Option<f64>,
    mass_kg: Option<f64>,
    shaft_height_mm: Option<f64>,
    length_mm: Option<f64>,
    diameter_mm: Option<f64>,
    stator_bore_mm: Option<f64>,
    stator_core_length_mm: Option<f64>,
    #[serde(default)]
    flags: String,
    source: String,
}

impl MotorRow {
    /// The first impossible value, if any.
    fn fault(&self) -> Option<Text> {
        let poles = number(self.poles);
        if self.poles == 0 || !self.poles.is_multiple_of(2) {
            return Some(text!("motor-bad-poles", poles));
        }
        let rpm = self.synchronous_speed_rpm;
        let at = |hertz: f64| (rpm - 120.0 * hertz / f64::from(self.poles)).abs() <= 0.5;
        if !(at(50.0) || at(60.0)) {
            return Some(text!("motor-bad-synchronous", rpm = number(rpm), poles));
        }
        self.ranges().into_iter().find_map(|(column, value, above, most)| {
            let value = value?;
            // Written so that NaN is a fault, too.
            let fits = value > above && value <= most && value.is_finite();
            let [value, above, most] = [value, above, most].map(number);
            (!fits).then(|| text!("motor-out-of-range", column = name(column), value, above, most))
        })
    }

    /// Column, value, exclusive lower limit, inclusive upper limit.
    fn ranges(&self) -> [(&'static str, Option<f64>, f64, f64); 18] {
        let any = f64::MAX;
        [
            ("rated_power_kw", Some(self.rated_power_kw), 0.0, any),
            ("rated_speed_rpm", Some(self.rated_speed_rpm), 0.0, self.synchronous_speed_rpm.next_down()),
            ("rated_slip_percent", self.rated_slip_percent, 0.0, 100.0),
            ("efficiency_percent", self.efficiency_percent, 0.0, 100.0),
            ("cos_phi", self.cos_phi, 0.0, 1.0),
            ("rated_current_a", self.rated_current_a, 0.0, any),
            ("max_torque_ratio", self.max_torque_ratio, 1.0, MOST_RATIO),
            ("starting_torque_ratio", self.starting_torque_ratio, 0.0, MOST_RATIO),
            ("min_torque_ratio", self.min_torque_ratio, 0.0, MOST_RATIO),
            ("starting_current_ratio", self.starting_current_ratio, 1.0, MOST_RATIO),
            ("critical_slip_percent", self.critical_slip_percent, 0.0, 100.0),
            ("rotor_inertia_kg_m2", self.rotor_inertia_kg_m2, 0.0, any),
            ("mass_kg", self.mass_kg, 0.0, any),
            ("shaft_height_mm", self.shaft_height_mm, 0.0, any),
            ("length_mm", self.length_mm, 0.0, any),
            ("diameter_mm", self.diameter_mm, 0.0, any),
            ("stator_bore_mm", self.stator_bore_mm, 0.0, any),
            ("stator_core_length_mm", self.stator_core_length_mm, 0.0, any),
        ]
    }

    fn into_motor(self, catalogue: &str) -> Motor {
        let fraction = |percent: Option<f64>| percent.map(|p| p / 100.0);
        let meters = |mm: Option<f64>| mm.map(|l| l / 1000.0);
        Motor {
            catalogue: catalogue.to_owned(),
            designation: self.designation,
            poles: self.poles,
            rated_power: self.rated_power_kw * 1000.0,
            synchronous_speed: rad_per_s(self.synchronous_speed_rpm),
            rated_speed: rad_per_s(self.rated_speed_rpm),
            printed_slip: fraction(self.rated_slip_percent),
            efficiency: fraction(self.efficiency_percent),
            power_factor: self.cos_phi,
            rated_current: self.rated_current_a,
            max_torque_ratio: self.max_torque_ratio,
            starting_torque_ratio: self.starting_torque_ratio,
            rotor_inertia: self.rotor_inertia_kg_m2,
            mass: self.mass_kg,
            length: meters(self.length_mm),
            diameter: meters(self.diameter_mm),
            flags: self.flags.split_whitespace().map(str::to_owned).collect(),
            source: self.source,
        }
    }
}
