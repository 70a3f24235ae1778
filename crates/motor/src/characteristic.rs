//! The mechanical characteristic: torque of the motor as a function of its speed.

use crate::{RatedData, RatedDataError};

/// Which characteristic to build from the rated data.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum CharacteristicKind {
    /// Kloss's formula: the whole characteristic.
    #[default]
    Kloss,
    /// The straight line through synchronous speed and the rated point: the working section only.
    Linear,
}

impl CharacteristicKind {
    /// Every kind.
    pub const ALL: [Self; 2] = [Self::Kloss, Self::Linear];

    /// Stable identifier, as scenes write it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Kloss => "kloss",
            Self::Linear => "linear",
        }
    }

    /// The kind of that identifier.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }
}

/// Torque of the motor, N·m, over its speed, rad/s. The motor drives towards positive speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Characteristic {
    /// Kloss's formula.
    Kloss(Kloss),
    /// The working section as a straight line.
    Linear(Linear),
}

/// Kloss's formula M = 2 Mmax / (s/sk + sk/s), s = 1 - w/ws.
///
/// Fits a motor without current displacement in the rotor bars; the starting torque of a cage motor is higher
/// in reality and stands in the catalogue.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kloss {
    synchronous_speed: f64,
    rated_speed: f64,
    rated_torque: f64,
    breakdown_torque: f64,
    critical_slip: f64,
}

/// The straight line M = Mn (ws - w) / (ws - wn).
///
/// Holds on the working section only; it has no breakdown, so far from it the torque is too great.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Linear {
    synchronous_speed: f64,
    rated_speed: f64,
    rated_torque: f64,
    breakdown_torque: Option<f64>,
}

impl Kloss {
    /// The characteristic through the rated point with the given breakdown torque.
    ///
    /// # Errors
    ///
    /// [`RatedDataError`] for impossible data, or if the breakdown torque is not given.
    pub fn new(rated: &RatedData) -> Result<Self, RatedDataError> {
        rated.validate()?;
        let ratio = rated.max_torque_ratio.ok_or(RatedDataError::NoMaxTorqueRatio)?;
        Ok(Self {
            synchronous_speed: rated.synchronous_speed,
            rated_speed: rated.rated_speed,
            rated_torque: rated.torque(),
            breakdown_torque: ratio * rated.torque(),
            // sk = sn (l + sqrt(l² - 1)): M(sn) = Mn solved for sk, the root above sn.
            critical_slip: rated.slip() * (ratio + ((ratio - 1.0) * (ratio + 1.0)).sqrt()),
        })
    }

    fn torque(&self, slip: f64) -> f64 {
        let sk = self.critical_slip;
        // Kloss with numerator and denominator times s sk: nothing divides by zero at s = 0.
        2.0 * self.breakdown_torque * sk * slip / (slip * slip + sk * sk)
    }

    /// dM/dw = -dM/ds / ws, dM/ds = 2 Mmax sk (sk² - s²) / (s² + sk²)².
    fn slope(&self, slip: f64) -> f64 {
        let sk = self.critical_slip;
        let d = slip * slip + sk * sk;
        -2.0 * self.breakdown_torque * sk * ((sk - slip) / d) * ((sk + slip) / d) / self.synchronous_speed
    }
}

impl Linear {
    /// The straight line through synchronous speed and the rated point.
    ///
    /// # Errors
    ///
    /// [`RatedDataError`] for impossible data.
    pub fn new(rated: &RatedData) -> Result<Self, RatedDataError> {
        rated.validate()?;
        Ok(Self {
            synchronous_speed: rated.synchronous_speed,
            rated_speed: rated.rated_speed,
            rated_torque: rated.torque(),
            breakdown_torque: rated.max_torque_ratio.map(|ratio| ratio * rated.torque()),
        })
    }

    fn slope(&self) -> f64 {
        -self.rated_torque / (self.synchronous_speed - self.rated_speed)
    }
}

impl Characteristic {
    /// The characteristic of that kind.
    ///
    /// # Errors
    ///
    /// [`RatedDataError`] for impossible data; Kloss's formula needs the breakdown torque.
    pub fn new(kind: CharacteristicKind, rated: &RatedData) -> Result<Self, RatedDataError> {
        match kind {
            CharacteristicKind::Kloss => Kloss::new(rated).map(Self::Kloss),
            CharacteristicKind::Linear => Linear::new(rated).map(Self::Linear),
        }
    }

    /// Torque at the motor speed `speed` (rad/s), N·m. Above synchronous speed the motor brakes (M < 0);
    /// at reversed speed (`speed` < 0, s > 1) it still pulls forward, hence brakes, too.
    pub fn torque(&self, speed: f64) -> f64 {
        match self {
            Self::Kloss(kloss) => kloss.torque(self.slip(speed)),
            Self::Linear(linear) => linear.slope() * (speed - linear.synchronous_speed),
        }
    }

    /// dM/dw at the motor speed `speed` (rad/s), N·m·s. Negative where the motor runs stably.
    pub fn slope(&self, speed: f64) -> f64 {
        match self {
            Self::Kloss(kloss) => kloss.slope(self.slip(speed)),
            Self::Linear(linear) => linear.slope(),
        }
    }

    /// Slip s = (ws - w) / ws: 0 at synchronous speed, 1 at rest, negative above synchronous speed.
    pub fn slip(&self, speed: f64) -> f64 {
        (self.synchronous_speed() - speed) / self.synchronous_speed()
    }

    /// Which characteristic it is.
    pub fn kind(&self) -> CharacteristicKind {
        match self {
            Self::Kloss(_) => CharacteristicKind::Kloss,
            Self::Linear(_) => CharacteristicKind::Linear,
        }
    }

    /// Synchronous speed, rad/s.
    pub fn synchronous_speed(&self) -> f64 {
        match self {
            Self::Kloss(Kloss { synchronous_speed, .. }) | Self::Linear(Linear { synchronous_speed, .. }) => {
                *synchronous_speed
            }
        }
    }

    /// Rated speed, rad/s.
    pub fn rated_speed(&self) -> f64 {
        match self {
            Self::Kloss(Kloss { rated_speed, .. }) | Self::Linear(Linear { rated_speed, .. }) => *rated_speed,
        }
    }

    /// Rated torque, N·m.
    pub fn rated_torque(&self) -> f64 {
        match self {
            Self::Kloss(Kloss { rated_torque, .. }) | Self::Linear(Linear { rated_torque, .. }) => {
                *rated_torque
            }
        }
    }

    /// Breakdown torque, N·m; `None` for a straight line whose motor does not print it.
    pub fn breakdown_torque(&self) -> Option<f64> {
        match self {
            Self::Kloss(kloss) => Some(kloss.breakdown_torque),
            Self::Linear(linear) => linear.breakdown_torque,
        }
    }

    /// Slip of the greatest torque; `None` for a straight line.
    pub fn critical_slip(&self) -> Option<f64> {
        match self {
            Self::Kloss(kloss) => Some(kloss.critical_slip),
            Self::Linear(_) => None,
        }
    }

    /// Speed of the greatest torque, rad/s; `None` for a straight line. Negative if the critical slip exceeds 1.
    pub fn breakdown_speed(&self) -> Option<f64> {
        self.critical_slip().map(|sk| self.synchronous_speed() * (1.0 - sk))
    }

    /// Torque at rest, N·m; `None` for a straight line, which does not hold there.
    pub fn starting_torque(&self) -> Option<f64> {
        match self {
            Self::Kloss(kloss) => Some(kloss.torque(1.0)),
            Self::Linear(_) => None,
        }
    }
}
