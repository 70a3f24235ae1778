//! Warnings about a motor that can be used nevertheless.

use assur_words::{Describe, Text, name, number, text};
use serde::{Serialize, Serializer};

use crate::motor::rpm;
use crate::{Characteristic, Motor};

/// A remark on the drive, with its numbers. Speeds and torques are those of the motor shaft.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum MotorWarning {
    /// The motor is loaded beyond its breakdown torque, or would have to be.
    BeyondBreakdown {
        /// The worst working speed, rad/s.
        speed: f64,
        /// Torque of the characteristic there, N·m.
        torque: f64,
        /// Breakdown torque, N·m.
        breakdown_torque: f64,
    },
    /// The motor cannot start under that load.
    StartingTorque {
        /// Starting torque of the motor, N·m.
        available: f64,
        /// Torque of the load at rest, on the motor shaft, N·m.
        required: f64,
    },
    /// The motor becomes too hot in continuous duty.
    RmsTorque {
        /// Root mean square torque over a cycle, N·m.
        rms: f64,
        /// Rated torque, N·m.
        rated: f64,
    },
    /// The rotor counts as massless.
    RotorInertiaUnknown {
        /// The motor.
        designation: Text,
    },
}

impl MotorWarning {
    /// Whether the motor can't do its work, so that another one is needed; else only something about it is not known.
    pub fn is_unfit(&self) -> bool {
        !matches!(self, Self::RotorInertiaUnknown { .. })
    }
}

impl Serialize for MotorWarning {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.describe().serialize(serializer)
    }
}

impl Describe for MotorWarning {
    fn describe(&self) -> Text {
        let torque_of = |torque: f64| number(format_args!("{torque:.3}"));
        let tenths = |value: f64| number(format_args!("{value:.1}"));
        match *self {
            Self::BeyondBreakdown { speed, torque, breakdown_torque } => text!(
                "motor-beyond-breakdown",
                speed = tenths(rpm(speed)),
                torque = torque_of(torque),
                breakdown = torque_of(breakdown_torque)
            ),
            Self::StartingTorque { available, required } => text!(
                "motor-starting-torque",
                available = torque_of(available),
                required = torque_of(required),
                lack = torque_of(required - available)
            ),
            Self::RmsTorque { rms, rated } => text!(
                "motor-rms-torque",
                rms = torque_of(rms),
                rated = torque_of(rated),
                excess = tenths(100.0 * (rms / rated - 1.0))
            ),
            Self::RotorInertiaUnknown { ref designation } => {
                text!("motor-rotor-inertia-unknown", designation)
            }
        }
    }
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
    beyond.then_some(MotorWarning::BeyondBreakdown { speed, torque, breakdown_torque })
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
    (required > available).then_some(MotorWarning::StartingTorque { available, required })
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
    (rms > rated).then_some(MotorWarning::RmsTorque { rms, rated })
}

/// Whether the rotor can be modeled.
pub fn check_rotor_inertia(motor: &Motor) -> Option<MotorWarning> {
    let designation = name(motor.designation.clone());
    motor.rotor_inertia.is_none().then_some(MotorWarning::RotorInertiaUnknown { designation })
}
