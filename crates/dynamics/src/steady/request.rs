//! The request for a steady regime: the cycle, the drive, and which of its quantities are to be found.

use assur_motor::Characteristic;

/// The cycle of the regime.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CycleRequest {
    /// Coordinate at which a cycle begins, rad.
    pub start: f64,
    /// Its length, rad, positive.
    pub length: f64,
    /// Requested mean speed with its sign, rad/s: (max + min)/2.
    pub mean_speed: f64,
    /// The part of J(q) that does not vary, kg m²: the input link about its pin. For the methods of the textbooks.
    pub constant_inertia: f64,
}

/// What drives, and which of its quantities are to be found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DriveRequest {
    /// The torque.
    pub torque: TorqueRequest,
    /// Given flywheel, kg m² on its own shaft; `None`: find it from `unevenness`.
    pub flywheel: Option<f64>,
    /// The flywheel sits on the motor shaft.
    pub flywheel_on_motor: bool,
    /// Requested unevenness; needed if the flywheel is to be found.
    pub unevenness: Option<f64>,
}

impl DriveRequest {
    /// The same with another motor in the place of its own.
    pub(crate) fn with(&self, other: &Characteristic, of_other: f64) -> Self {
        let mut drive = *self;
        if let TorqueRequest::Motor { characteristic, rotor, .. } = &mut drive.torque {
            (*characteristic, *rotor) = (*other, of_other);
        }
        drive
    }
}

/// Torque of the drive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TorqueRequest {
    /// None.
    None,
    /// The constant moment that makes the work of a cycle zero.
    Balance,
    /// A constant moment, N m, positive along the motion.
    Constant(f64),
    /// An asynchronous motor.
    Motor {
        /// Its characteristic.
        characteristic: Characteristic,
        /// Rotor, kg m² on its own shaft; 0: not modelled.
        rotor: f64,
        /// Given ratio; `None`: find it from the mean speed.
        ratio: Option<f64>,
        /// Efficiency of the reducer, (0, 1].
        efficiency: f64,
    },
}
