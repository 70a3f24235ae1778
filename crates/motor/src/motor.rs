//! One row of a catalogue.

use std::cmp::Ordering;
use std::f64::consts::PI;

use assur_words::{Text, number, text};
use serde::Serialize;

use crate::{RatedMotor, latin_designation};

/// A three-phase asynchronous motor as its catalogue prints it, in SI units.
///
/// Nothing is estimated: a value that the source does not print is `None`. A motor that a scene gives by its rated data has
/// no more than these, and neither catalogue nor designation. Results have the rated data, mass and size.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Motor {
    /// Type as printed; may hold Cyrillic letters, see [`latin_designation`](Self::latin_designation).
    pub designation: String,
    /// Name of the catalogue that the row belongs to.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub catalogue: String,
    /// Number of poles: 2, 4, 6, 8, ...
    #[serde(skip)]
    pub poles: u32,
    /// Rated shaft power, W.
    #[serde(rename = "power")]
    pub rated_power: f64,
    /// Synchronous speed, rad/s.
    pub synchronous_speed: f64,
    /// Rated speed, rad/s; less than the synchronous speed.
    pub rated_speed: f64,
    /// Rated slip as printed, a fraction. May differ from the slip of the printed speeds (then flagged).
    #[serde(skip)]
    pub printed_slip: Option<f64>,
    /// Efficiency at full load, a fraction.
    #[serde(skip)]
    pub efficiency: Option<f64>,
    /// Power factor cos φ at full load.
    #[serde(skip)]
    pub power_factor: Option<f64>,
    /// Rated current, A.
    #[serde(skip)]
    pub rated_current: Option<f64>,
    /// Breakdown torque / rated torque.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_torque_ratio: Option<f64>,
    /// Locked-rotor torque / rated torque.
    #[serde(skip)]
    pub starting_torque_ratio: Option<f64>,
    /// Moment of inertia of the rotor, kg·m².
    #[serde(rename = "inertia", skip_serializing_if = "Option::is_none")]
    pub rotor_inertia: Option<f64>,
    /// Mass of the whole motor, kg.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mass: Option<f64>,
    /// Length with one shaft end, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub length: Option<f64>,
    /// Diameter of the housing, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub diameter: Option<f64>,
    /// Remarks on the row, see [`flag_meaning`](crate::flag_meaning); empty if every check passed.
    #[serde(skip)]
    pub flags: Vec<String>,
    /// Short reference to where the row is printed.
    #[serde(skip)]
    pub source: String,
}

impl Motor {
    /// What the mechanical characteristic needs.
    pub fn rated_data(&self) -> RatedMotor {
        RatedMotor {
            power: self.rated_power,
            synchronous_speed: self.synchronous_speed,
            rated_speed: self.rated_speed,
            max_torque_ratio: self.max_torque_ratio,
            inertia: self.rotor_inertia,
        }
    }

    /// What lists of motors in results say of one; `ratio`: motor speed / input speed, where that is asked for.
    pub fn entry(&self, ratio: Option<f64>) -> impl Serialize {
        Entry {
            designation: &self.designation,
            catalogue: &self.catalogue,
            power: self.rated_power,
            rated_speed: self.rated_speed,
            ratio,
            mass: self.mass,
        }
    }

    /// The designation in ASCII: [`latin_designation`] of what is printed.
    pub fn latin_designation(&self) -> String {
        latin_designation(&self.designation)
    }
}

#[derive(Serialize)]
struct Entry<'a> {
    designation: &'a str,
    catalogue: &'a str,
    power: f64,
    rated_speed: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    ratio: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    mass: Option<f64>,
}

/// The order of preference of [`select`](crate::select).
pub(crate) fn better(a: &Motor, b: &Motor) -> Ordering {
    (a.rated_power.total_cmp(&b.rated_power))
        .then(b.synchronous_speed.total_cmp(&a.synchronous_speed))
        .then(b.rated_speed.total_cmp(&a.rated_speed))
        .then_with(|| a.designation.cmp(&b.designation))
        .then_with(|| a.catalogue.cmp(&b.catalogue))
}

/// Speed in rad/s of a speed in 1/min.
pub fn rad_per_s(rpm: f64) -> f64 {
    rpm * PI / 30.0
}

/// Speed in 1/min of a speed in rad/s.
pub const fn rpm(rad_per_s: f64) -> f64 {
    rad_per_s * 30.0 / PI
}

/// A torque, or another number of a message, to a thousandth.
pub(crate) fn torque_of(torque: f64) -> Text {
    number(format_args!("{torque:.3}"))
}

/// A number to a thousandth, without zeros at its end.
pub(crate) fn digits(value: f64) -> Text {
    number((1e3 * value).round() / 1e3)
}

/// A number to a tenth.
pub(crate) fn tenths(value: f64) -> Text {
    number(format_args!("{value:.1}"))
}

/// Flags and what they mean. `*` stands for the printed value.
static FLAGS: [(&str, Text); 18] = [
    ("cos_phi_sources_differ", text!("motor-flag-cos-phi")),
    ("current_implausible_removed_*", text!("motor-flag-current-removed")),
    ("current_power_mismatch", text!("motor-flag-current-power")),
    ("designation_completed", text!("motor-flag-completed")),
    ("designation_repaired", text!("motor-flag-repaired")),
    ("designation_swapped_in_one_source", text!("motor-flag-swapped")),
    ("inertia_*_removed", text!("motor-flag-inertia-removed")),
    ("inertia_not_monotone", text!("motor-flag-inertia-frame")),
    ("inertia_vs_same_frame", text!("motor-flag-inertia-power")),
    ("maker_max_torque_*", text!("motor-flag-maker-torque")),
    ("mass_vs_same_frame", text!("motor-flag-mass")),
    ("power_22_printed_22.5", text!("motor-flag-power")),
    ("printed_slip_over_12", text!("motor-flag-slip-large")),
    ("single_source_eta_cos_mass", text!("motor-flag-single-source")),
    ("slip_out_of_0.5_12", text!("motor-flag-slip-range")),
    ("slip_printed_vs_speed", text!("motor-flag-slip-speed")),
    ("speed_sources_differ", text!("motor-flag-speed")),
    ("start_gt_max", text!("motor-flag-start")),
];

/// What a flag of a row means; `None` for a flag that is not of the common list.
pub fn flag_meaning(flag: &str) -> Option<&'static Text> {
    FLAGS.iter().find(|(pattern, _)| fits(pattern, flag)).map(|(_, meaning)| meaning)
}

/// Whether the flag is the pattern, with a number in place of `*`.
fn fits(pattern: &str, flag: &str) -> bool {
    let Some((head, tail)) = pattern.split_once('*') else { return pattern == flag };
    flag.strip_prefix(head)
        .and_then(|rest| rest.strip_suffix(tail))
        .is_some_and(|value| value.parse::<f64>().is_ok_and(f64::is_finite))
}
