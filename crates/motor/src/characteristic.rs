//! The mechanical characteristic: torque of the motor as a function of its speed.

use assur_words::{number, text};
use serde::Serialize;

use crate::{CharacteristicKind, MotorError, RatedMotor};

/// Torque of an asynchronous motor, N·m, over its speed, rad/s. The motor drives towards positive speed.
///
/// * Kloss's formula M = 2 Mmax / (s/sk + sk/s), s = 1 - w/ws: the whole characteristic. It fits a motor without
///   current displacement in the rotor bars; the real starting torque of a cage motor is higher and is in the catalogue.
/// * The straight line M = Mn (ws - w) / (ws - wn): the working section only. It has no breakdown, so its torque is too
///   great far from the working section.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Characteristic {
    /// By which formula it goes.
    #[serde(rename = "characteristic")]
    pub kind: CharacteristicKind,
    /// Slip of the greatest torque; `None` for a straight line.
    #[serde(skip)]
    pub critical_slip: Option<f64>,
    /// Synchronous speed, rad/s.
    #[serde(skip)]
    pub synchronous_speed: f64,
    /// Rated speed, rad/s.
    #[serde(skip)]
    pub rated_speed: f64,
    /// Rated torque, N·m.
    pub rated_torque: f64,
    /// Breakdown torque, N·m; `None` for a straight line without this value in the catalogue.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub breakdown_torque: Option<f64>,
}

impl Characteristic {
    /// The characteristic of that kind through synchronous speed and the rated point.
    ///
    /// # Errors
    ///
    /// [`MotorError`] for data that can't be those of an asynchronous motor, or without the breakdown torque that Kloss's formula
    /// needs.
    pub fn new(kind: CharacteristicKind, rated: &RatedMotor) -> Result<Self, MotorError> {
        validate(rated)?;
        let RatedMotor { power, rated_speed, synchronous_speed, max_torque_ratio, .. } = *rated;
        let rated_torque = power / rated_speed;
        let rated_slip = (synchronous_speed - rated_speed) / synchronous_speed;
        // sk = sn (l + sqrt(l² - 1)): M(sn) = Mn solved for sk, the root above sn.
        let critical_slip = |ratio: f64| rated_slip * (ratio + ((ratio - 1.0) * (ratio + 1.0)).sqrt());
        let critical_slip = match kind {
            CharacteristicKind::Kloss => {
                let absent = || MotorError(text!("motor-no-torque-ratio"));
                Some(max_torque_ratio.map(critical_slip).ok_or_else(absent)?)
            }
            CharacteristicKind::Linear => None,
        };
        let breakdown_torque = max_torque_ratio.map(|ratio| ratio * rated_torque);
        Ok(Self { kind, critical_slip, synchronous_speed, rated_speed, rated_torque, breakdown_torque })
    }

    /// Torque at the motor speed `speed` (rad/s), N·m. Above synchronous speed the motor brakes (M < 0);
    /// at reversed speed (`speed` < 0, s > 1) it still pulls forward, hence brakes, too.
    pub fn torque(&self, speed: f64) -> f64 {
        self.kloss(speed).map_or_else(
            || self.line_slope() * (speed - self.synchronous_speed),
            // Numerator and denominator are multiplied by s sk, so that nothing divides by zero at s = 0.
            |[most, s, sk]| 2.0 * most * sk * s / (s * s + sk * sk),
        )
    }

    /// dM/dw at the motor speed `speed` (rad/s), N·m·s. Negative where the motor runs stably.
    pub fn slope(&self, speed: f64) -> f64 {
        let Some([most, s, sk]) = self.kloss(speed) else { return self.line_slope() };
        // -dM/ds / ws, dM/ds = 2 Mmax sk (sk² - s²) / (s² + sk²)².
        let d = s * s + sk * sk;
        -2.0 * most * sk * ((sk - s) / d) * ((sk + s) / d) / self.synchronous_speed
    }

    /// Mmax, s and sk of Kloss's formula; `None` for a straight line.
    fn kloss(&self, speed: f64) -> Option<[f64; 3]> {
        Some([self.breakdown_torque?, self.slip(speed), self.critical_slip?])
    }

    fn line_slope(&self) -> f64 {
        -self.rated_torque / (self.synchronous_speed - self.rated_speed)
    }

    /// Slip s = (ws - w) / ws: 0 at synchronous speed, 1 at rest, negative above synchronous speed.
    pub fn slip(&self, speed: f64) -> f64 {
        (self.synchronous_speed - speed) / self.synchronous_speed
    }

    /// Speed of the greatest torque, rad/s; `None` for a straight line. Negative if the critical slip exceeds 1.
    pub fn breakdown_speed(&self) -> Option<f64> {
        self.critical_slip.map(|sk| self.synchronous_speed * (1.0 - sk))
    }

    /// The section on which the motor drives and runs stably, rad/s: from the speed of its greatest torque (of a straight line:
    /// where the line reaches the breakdown torque, or without this value from the rated speed) to synchronous speed.
    pub fn stable_section(&self) -> [f64; 2] {
        let slip_of = |torque: f64| torque / self.rated_torque * self.slip(self.rated_speed);
        let slip =
            self.critical_slip.unwrap_or_else(|| slip_of(self.breakdown_torque.unwrap_or(self.rated_torque)));
        [self.synchronous_speed * (1.0 - slip), self.synchronous_speed]
    }

    /// Torque at rest, N·m; `None` for a straight line, which does not hold there.
    pub fn starting_torque(&self) -> Option<f64> {
        self.critical_slip.map(|_| self.torque(0.0))
    }
}

/// Checks every value that is given.
pub(crate) fn validate(rated: &RatedMotor) -> Result<(), MotorError> {
    let named = [
        (text!("motor-rated-power"), rated.power),
        (text!("motor-rated-synchronous"), rated.synchronous_speed),
        (text!("motor-rated-speed"), rated.rated_speed),
        (text!("motor-rated-inertia"), rated.inertia.unwrap_or(1.0)),
    ];
    for (what, value) in named {
        if !(value > 0.0 && value.is_finite()) {
            return Err(MotorError(text!("motor-rated-not-positive", what, value = number(value))));
        }
    }
    let RatedMotor { rated_speed, synchronous_speed, .. } = *rated;
    if rated_speed >= synchronous_speed {
        let [rated, synchronous, excess] =
            [rated_speed, synchronous_speed, rated_speed - synchronous_speed].map(number);
        return Err(MotorError(text!("motor-no-slip", rated, synchronous, excess)));
    }
    match rated.max_torque_ratio {
        Some(value) if !(value > 1.0 && value.is_finite()) => {
            Err(MotorError(text!("motor-bad-torque-ratio", ratio = number(value))))
        }
        _ => Ok(()),
    }
}
