//! The motor seen from the input shaft of the mechanism, through the reducer.

use crate::Characteristic;

/// A motor behind a reducer. Speeds and torques of the input shaft have the sign of the input coordinate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShaftMotor {
    characteristic: Characteristic,
    ratio: f64,
    efficiency: f64,
    direction: f64,
}

/// Why a motor cannot be put on the input shaft.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ShaftError {
    /// The ratio must be positive.
    #[error("gear ratio (motor speed / input speed) is {value}, must be finite and greater than 0")]
    Ratio {
        /// The value.
        value: f64,
    },
    /// The efficiency must be a fraction.
    #[error("efficiency of the reducer is {value}, must be greater than 0 and at most 1")]
    Efficiency {
        /// The value.
        value: f64,
    },
    /// The direction is a sign.
    #[error("direction of the drive is {value}, must be 1 (counter-clockwise) or -1 (clockwise)")]
    Direction {
        /// The value.
        value: f64,
    },
}

impl ShaftMotor {
    /// A motor that turns `ratio` times as fast as the input shaft, through a reducer of efficiency
    /// `efficiency` (0 to 1), connected so that it drives in the sense of `direction`: 1 or -1.
    ///
    /// # Errors
    ///
    /// [`ShaftError`] with the value that cannot be.
    pub fn new(
        characteristic: Characteristic,
        ratio: f64,
        efficiency: f64,
        direction: f64,
    ) -> Result<Self, ShaftError> {
        if !(ratio > 0.0 && ratio.is_finite()) {
            return Err(ShaftError::Ratio { value: ratio });
        }
        if !(efficiency > 0.0 && efficiency <= 1.0) {
            return Err(ShaftError::Efficiency { value: efficiency });
        }
        if ![1.0, -1.0].contains(&direction) {
            return Err(ShaftError::Direction { value: direction });
        }
        Ok(Self { characteristic, ratio, efficiency, direction })
    }

    /// Torque on the input shaft at the input speed `input_speed` (rad/s), N·m.
    ///
    /// u η M(u w) while the motor drives, u M(u w) / η while it brakes: above synchronous speed, or where the
    /// shaft turns against it. At rest it counts as driving; there, where the shaft reverses, the torque jumps
    /// by the losses of the reducer.
    pub fn torque(&self, input_speed: f64) -> f64 {
        let speed = self.motor_speed(input_speed);
        let torque = self.characteristic.torque(speed);
        self.direction * self.ratio * self.transmitted(speed, torque) * torque
    }

    /// Derivative of [`torque`](Self::torque) by the input speed, N·m·s. At synchronous speed the torque has a
    /// kink if the efficiency is below 1: there it is the derivative on the driving side.
    pub fn slope(&self, input_speed: f64) -> f64 {
        let speed = self.motor_speed(input_speed);
        let transmitted = self.transmitted(speed, self.characteristic.torque(speed));
        // The sign of the direction enters twice: with the speed and with the torque.
        self.ratio * self.ratio * transmitted * self.characteristic.slope(speed)
    }

    /// Speed of the motor, rad/s, in its own sense: negative while the shaft turns against it.
    pub fn motor_speed(&self, input_speed: f64) -> f64 {
        self.direction * self.ratio * input_speed
    }

    /// Torque of the motor on its own shaft, N·m, at that speed of the input shaft.
    pub fn motor_torque(&self, input_speed: f64) -> f64 {
        self.characteristic.torque(self.motor_speed(input_speed))
    }

    /// Input speed, rad/s, at which the motor runs at synchronous speed and gives no torque.
    pub fn synchronous_input_speed(&self) -> f64 {
        self.direction * self.characteristic.synchronous_speed() / self.ratio
    }

    /// A moment of inertia on the motor shaft, kg·m², reduced to the input shaft: u² J.
    pub fn reduced_inertia(&self, on_motor_shaft: f64) -> f64 {
        self.ratio * self.ratio * on_motor_shaft
    }

    /// The characteristic of the motor.
    pub fn characteristic(&self) -> &Characteristic {
        &self.characteristic
    }

    /// Motor speed / input speed.
    pub fn ratio(&self) -> f64 {
        self.ratio
    }

    /// Efficiency of the reducer.
    pub fn efficiency(&self) -> f64 {
        self.efficiency
    }

    /// 1 if the motor drives towards greater input coordinates, else -1.
    pub fn direction(&self) -> f64 {
        self.direction
    }

    /// The same motor behind another ratio.
    ///
    /// # Errors
    ///
    /// [`ShaftError::Ratio`] if it is not positive.
    pub fn with_ratio(&self, ratio: f64) -> Result<Self, ShaftError> {
        Self::new(self.characteristic, ratio, self.efficiency, self.direction)
    }

    /// How much of the torque the reducer lets through: η while power flows to the mechanism, 1/η back.
    fn transmitted(&self, motor_speed: f64, motor_torque: f64) -> f64 {
        if motor_speed * motor_torque < 0.0 { 1.0 / self.efficiency } else { self.efficiency }
    }
}
