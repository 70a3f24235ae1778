//! Warnings about a motor that can be used nevertheless.

use assur_words::{Text, text};
use serde::Serialize;

use crate::Characteristic;
use crate::motor::{digits, rpm, tenths, torque_of};

/// A remark on the drive.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(transparent)]
pub struct MotorWarning {
    /// What it says.
    pub text: Text,
    /// Where the motor can't do its work, so that another one is needed: why, beside its name. Else only something about it is not
    /// known.
    #[serde(skip)]
    pub unfit: Option<Text>,
}

/// Whether one of the working speeds (rad/s, of the motor shaft) is beyond the breakdown point; the worst one.
///
/// With Kloss's formula: |s| > sk. With the straight line: its torque exceeds the breakdown torque, where that
/// is known. Both as motor and as brake.
pub fn check_breakdown(
    characteristic: &Characteristic,
    working_speeds: impl IntoIterator<Item = f64>,
) -> Option<MotorWarning> {
    let slip = |w: &f64| characteristic.slip(*w).abs();
    let speed = working_speeds.into_iter().max_by(|a, b| slip(a).total_cmp(&slip(b)))?;
    let breakdown_torque = characteristic.breakdown_torque?;
    let torque = characteristic.torque(speed);
    let beyond = match characteristic.critical_slip {
        Some(sk) => slip(&speed) > sk,
        None => torque.abs() > breakdown_torque,
    };
    beyond.then(|| {
        let [torque, breakdown] = [torque, breakdown_torque].map(torque_of);
        let text = text!("motor-beyond-breakdown", speed = tenths(rpm(speed)), torque, breakdown);
        MotorWarning { unfit: Some(text.clone()), text }
    })
}

/// Torque at rest, N·m: from the ratio in the catalogue, else from the characteristic; `None` if neither gives it.
///
/// The printed ratio comes first: in a cage rotor the current displacement raises the starting torque above
/// Kloss's value.
pub fn starting_torque(characteristic: &Characteristic, starting_torque_ratio: Option<f64>) -> Option<f64> {
    let printed = starting_torque_ratio.map(|ratio| ratio * characteristic.rated_torque);
    printed.or_else(|| characteristic.starting_torque())
}

/// Whether the motor starts against the load torque `required` (N·m, at rest, on the motor shaft).
pub fn check_starting(
    characteristic: &Characteristic,
    starting_torque_ratio: Option<f64>,
    required: f64,
) -> Option<MotorWarning> {
    let available = starting_torque(characteristic, starting_torque_ratio)?;
    (required > available).then(|| {
        let [have, need, lack] = [available, required, required - available].map(torque_of);
        let text = text!("motor-starting-torque", available = have, required = need, lack);
        let [available, required] = [available, required].map(digits);
        MotorWarning { text, unfit: Some(text!("motor-passed-start", available, required)) }
    })
}

/// Root mean square of torques, N·m, each with its duration, s; zero if no time passes.
pub fn rms_torque(samples: impl IntoIterator<Item = (f64, f64)>) -> f64 {
    let (heat, time) = samples.into_iter().fold((0.0, 0.0), |(heat, time), (torque, duration)| {
        (heat + torque * torque * duration, time + duration)
    });
    if time > 0.0 { (heat / time).sqrt() } else { 0.0 }
}

/// Whether the motor becomes too hot: the losses in its windings grow with the square of the torque.
pub fn check_rms(characteristic: &Characteristic, rms: f64) -> Option<MotorWarning> {
    let rated = characteristic.rated_torque;
    (rms > rated).then(|| {
        let excess = tenths(100.0 * (rms / rated - 1.0));
        let unfit = Some(text!("motor-passed-hot", excess = &excess));
        let [rms, rated] = [rms, rated].map(torque_of);
        MotorWarning { text: text!("motor-rms-torque", rms, rated, excess), unfit }
    })
}

/// Whether the rotor of a motor can be modeled: its moment of inertia is known.
pub fn check_rotor_inertia(inertia: Option<f64>, designation: Text) -> Option<MotorWarning> {
    let text = text!("motor-rotor-inertia-unknown", designation);
    inertia.is_none().then_some(MotorWarning { text, unfit: None })
}
