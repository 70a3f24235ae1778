//! Doubts about a row: what can be, but seldom is, and then should carry a flag.
//!
//! A transcription that is shifted by a row or has lost a digit shows here.

use assur_motor::{Characteristic, CharacteristicKind, Motor, flag_meaning};

/// Slips of real motors from 0.06 kW on, fractions.
const SLIPS: [f64; 2] = [0.005, 0.12];
/// Breakdown torque ratios of real motors.
const MAX_TORQUE_RATIOS: [f64; 2] = [1.6, 5.0];
/// Mains of 380 V and 400 V: current is compared at the middle, with this relative slack.
const CURRENT_SLACK: f64 = 0.12;

/// Something in a row that should be verified.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(crate) enum Doubt {
    /// A value outside of the usual range.
    #[error("{what} is {value:.4}, usual are {low} to {high}")]
    Unusual {
        /// Which value, in words.
        what: &'static str,
        /// The value.
        value: f64,
        /// Lower limit.
        low: f64,
        /// Upper limit.
        high: f64,
    },
    /// Printed slip and printed speed disagree.
    #[error("printed slip {printed:.4} differs from the slip {from_speeds:.4} of the printed speeds")]
    Slip {
        /// Printed slip, a fraction.
        printed: f64,
        /// Slip from the speeds, a fraction.
        from_speeds: f64,
    },
    /// Starting torque above the greatest torque.
    #[error("starting torque ratio {starting} exceeds the maximum torque ratio {max}")]
    StartAboveMax {
        /// Starting torque ratio.
        starting: f64,
        /// Maximum torque ratio.
        max: f64,
    },
    /// A flag that is not of the common list.
    #[error("flag `{flag}` is not known")]
    Flag {
        /// The flag.
        flag: String,
    },
}

/// The doubts about a row that its flags do not already name.
pub(crate) fn doubts(motor: &Motor) -> Vec<Doubt> {
    let slip = (motor.synchronous_speed - motor.rated_speed) / motor.synchronous_speed;
    let has = |name: &str| motor.flags.iter().any(|flag| flag.starts_with(name));
    let mut doubts: Vec<Doubt> = motor
        .flags
        .iter()
        .filter(|flag| flag_meaning(flag).is_none())
        .cloned()
        .map(|flag| Doubt::Flag { flag })
        .collect();
    if !has("slip_out_of") {
        doubts.extend(unusual("slip from the speeds", slip, SLIPS));
    }
    if !has("slip_printed_vs_speed") {
        let far = |printed: &f64| (printed - slip).abs() > 0.0071;
        doubts
            .extend(motor.printed_slip.filter(far).map(|printed| Doubt::Slip { printed, from_speeds: slip }));
    }
    if !has("start_gt_max") {
        doubts.extend(start_above_max(motor));
    }
    if !has("current_power_mismatch") {
        doubts.extend(current(motor));
    }
    doubts.extend(breakdown(motor));
    doubts
}

fn unusual(what: &'static str, value: f64, [low, high]: [f64; 2]) -> Option<Doubt> {
    // A printed limit value is not outside by its rounding.
    let inside = value >= low * (1.0 - 1e-9) && value <= high * (1.0 + 1e-9);
    (!inside).then_some(Doubt::Unusual { what, value, low, high })
}

fn start_above_max(motor: &Motor) -> Option<Doubt> {
    let (starting, max) = (motor.starting_torque_ratio?, motor.max_torque_ratio?);
    (starting > max).then_some(Doubt::StartAboveMax { starting, max })
}

/// Shaft power over the power that current, efficiency and cos φ give at 390 V.
fn current(motor: &Motor) -> Option<Doubt> {
    let electric = 3f64.sqrt() * 390.0 * motor.rated_current? * motor.power_factor?;
    let ratio = motor.rated_power / (electric * motor.efficiency?);
    unusual("rated power / (sqrt(3) 390 V I eta cos phi)", ratio, [1.0 - CURRENT_SLACK, 1.0 + CURRENT_SLACK])
}

/// The breakdown torque ratio, and the breakdown speed that Kloss's formula gives for it: not backwards.
fn breakdown(motor: &Motor) -> Vec<Doubt> {
    let Some(ratio) = motor.max_torque_ratio else { return Vec::new() };
    let kloss = Characteristic::new(CharacteristicKind::Kloss, &motor.rated_data());
    let sk = kloss.ok().and_then(|kloss| kloss.critical_slip);
    let doubt = unusual("maximum torque ratio", ratio, MAX_TORQUE_RATIOS);
    doubt
        .into_iter()
        .chain(unusual("critical slip of Kloss's formula", sk.unwrap_or(f64::NAN), [0.0, 1.0]))
        .collect()
}
