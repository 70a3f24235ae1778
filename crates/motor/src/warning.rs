//! Warnings about a motor that can be used nevertheless.

use crate::motor::rpm;
use crate::{Characteristic, Motor};

/// A remark on the drive, with its numbers. Speeds and torques are those of the motor shaft.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MotorWarning {
    /// The motor is loaded beyond its breakdown torque, or would have to be.
    #[error(
        "the motor works at {:.1} rpm with {torque:.3} N*m, beyond its breakdown torque of {breakdown_torque:.3} N*m; \
         it would stall: take a larger motor or a larger flywheel", rpm(*speed)
    )]
    BeyondBreakdown {
        /// The worst working speed, rad/s.
        speed: f64,
        /// Torque of the characteristic there, N·m.
        torque: f64,
        /// Breakdown torque, N·m.
        breakdown_torque: f64,
    },
    /// The motor cannot start under that load.
    #[error(
        "starting torque {available:.3} N*m is less than the {required:.3} N*m of the load at rest \
         (by {:.3} N*m): start without load or take a larger motor", required - available
    )]
    StartingTorque {
        /// Starting torque of the motor, N·m.
        available: f64,
        /// Torque of the load at rest, on the motor shaft, N·m.
        required: f64,
    },
    /// The motor becomes too hot in continuous duty.
    #[error(
        "root mean square torque {rms:.3} N*m exceeds the rated torque {rated:.3} N*m by {:.1} %: \
         the motor overheats in continuous duty", 100.0 * (rms / rated - 1.0)
    )]
    RmsTorque {
        /// Root mean square torque over a cycle, N·m.
        rms: f64,
        /// Rated torque, N·m.
        rated: f64,
    },
    /// The rotor counts as massless.
    #[error("the rotor inertia of {designation} is not in its catalogue: it is not modelled")]
    RotorInertiaUnknown {
        /// The motor.
        designation: String,
    },
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
    let beyond = match characteristic.critical_slip() {
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

/// Whether the rotor can be modelled.
pub fn check_rotor_inertia(motor: &Motor) -> Option<MotorWarning> {
    let designation = motor.designation.clone();
    motor.rotor_inertia.is_none().then_some(MotorWarning::RotorInertiaUnknown { designation })
}
