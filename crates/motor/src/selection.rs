//! Choosing a motor: the smallest that gives the power and keeps the speed limit.

use assur_words::{Describe, Text, name, number, text};
use serde::{Serialize, Serializer};

use crate::motor::{better, digits, rpm, tenths};
use crate::{CharacteristicKind, Motor, MotorError};

/// Relative slack of comparisons with a rated value, so that the rounding of a unit conversion doesn't decide.
const SLACK: f64 = 1e-9;

/// What the motor has to do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SelectionRequest {
    /// Power needed on the motor shaft, W: losses of the reducer are included.
    pub required_power: f64,
    /// Mean speed of the input shaft, rad/s; the sign does not matter.
    pub input_speed: f64,
    /// Highest admissible synchronous speed, rad/s; `None`: no limit.
    pub max_motor_speed: Option<f64>,
    /// The characteristic; the motor must have the data for it.
    pub characteristic: CharacteristicKind,
}

/// A suitable motor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Candidate<'a> {
    /// The catalogue row.
    pub motor: &'a Motor,
    /// Rated speed / input speed.
    pub ratio: f64,
}

impl Serialize for Candidate<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.motor.entry(Some(self.ratio)).serialize(serializer)
    }
}

/// A motor that was not taken.
#[derive(Debug, Clone, PartialEq)]
pub struct PassedOver<'a> {
    /// The catalogue row.
    pub motor: &'a Motor,
    /// Why.
    pub why: Text,
}

impl Describe for PassedOver<'_> {
    fn describe(&self) -> Text {
        let (power, speed) = (digits(self.motor.rated_power / 1e3), whole_rpm(self.motor.synchronous_speed));
        let (motor, why) = (name(self.motor.designation.clone()), &self.why);
        text!("motor-passed", motor, power, speed, why)
    }
}

fn whole_rpm(speed: f64) -> Text {
    number(format_args!("{:.0}", rpm(speed)))
}

/// Of each reason the motor that stands closest before the chosen one in the order of preference, the nearest first. Those that are
/// too weak are reported where there are no others.
pub fn nearest<'a>(mut passed: Vec<PassedOver<'a>>, chosen: &Motor) -> Vec<PassedOver<'a>> {
    passed.retain(|one| better(one.motor, chosen).is_lt());
    passed.sort_by(|a, b| better(b.motor, a.motor));
    let mut known = Vec::new();
    passed.retain(|one| {
        // That there is no regime is one reason, whatever the cause.
        let reason = one.why.identity().filter(|id| id.starts_with("motor-"));
        let is_weak = reason == Some("motor-passed-weak");
        let is_new = !known.contains(&reason) && (known.is_empty() || !is_weak);
        known.push(reason);
        is_new
    });
    passed
}

/// What was chosen, and from what.
#[derive(Debug, Clone, PartialEq)]
pub struct Selection<'a> {
    /// The choice.
    pub chosen: Candidate<'a>,
    /// The other suitable motors, the best first.
    pub runners_up: Vec<Candidate<'a>>,
    /// The motors that are not suitable.
    pub passed_over: Vec<PassedOver<'a>>,
}

/// The smallest rated power that suffices among `motors`.
///
/// Among equal powers the highest synchronous speed within the limit comes first: such a motor has the least
/// torque, hence the least size, mass and price, and the limit is there to say how fast it may be. Then the
/// least slip (less is lost in the rotor), then the designation.
///
/// # Errors
///
/// [`MotorError`] for a request that can't be answered, or where no motor meets it: by how much the nearest one misses it.
pub fn select<'a, I>(motors: I, request: &SelectionRequest) -> Result<Selection<'a>, MotorError>
where
    I: IntoIterator<Item = &'a Motor>,
{
    request.validate()?;
    let motors: Vec<&Motor> = motors.into_iter().collect();
    let (mut fits, mut passed_over) = (Vec::new(), Vec::new());
    for motor in &motors {
        match request.refusal(motor) {
            Some(why) => passed_over.push(PassedOver { motor, why }),
            None => fits.push(*motor),
        }
    }
    fits.sort_by(|a, b| better(a, b));
    let ratio = |motor: &Motor| motor.rated_speed / request.input_speed.abs();
    let mut candidates = fits.into_iter().map(|motor| Candidate { motor, ratio: ratio(motor) });
    let chosen = candidates.next().ok_or_else(|| request.why_none(&motors))?;
    Ok(Selection { chosen, runners_up: candidates.collect(), passed_over })
}

/// Whether the synchronous speed of a motor is within a limit, rad/s.
pub(crate) fn keeps(motor: &Motor, limit: f64) -> bool {
    motor.synchronous_speed <= limit * (1.0 + SLACK)
}

impl SelectionRequest {
    fn validate(&self) -> Result<(), MotorError> {
        let named = [
            (text!("motor-select-power"), self.required_power),
            (text!("motor-select-speed"), self.input_speed.abs()),
            (text!("motor-select-limit"), self.max_motor_speed.unwrap_or(1.0)),
        ];
        let bad = named.into_iter().find(|(_, value)| !(*value > 0.0 && value.is_finite()));
        bad.map_or(Ok(()), |(what, value)| {
            Err(MotorError(text!("motor-select-not-positive", what, value = number(value))))
        })
    }

    fn has_data(&self, motor: &Motor) -> bool {
        self.characteristic == CharacteristicKind::Linear || motor.max_torque_ratio.is_some()
    }

    fn keeps_limit(&self, motor: &Motor) -> bool {
        self.max_motor_speed.is_none_or(|limit| keeps(motor, limit))
    }

    /// The first demand that a motor does not meet.
    fn refusal(&self, motor: &Motor) -> Option<Text> {
        if motor.rated_power < self.required_power * (1.0 - SLACK) {
            return Some(text!("motor-passed-weak", required = digits(self.required_power / 1e3)));
        }
        if !self.has_data(motor) {
            return Some(text!("motor-passed-no-breakdown"));
        }
        let limit = self.max_motor_speed.filter(|_| !self.keeps_limit(motor))?;
        Some(text!("motor-passed-fast", limit = whole_rpm(limit)))
    }

    /// Which of the demands no row meets, the most fundamental first.
    fn why_none(&self, motors: &[&Motor]) -> MotorError {
        if motors.is_empty() {
            return MotorError(text!("motor-select-no-motors"));
        }
        let designation = |motor: &Motor| name(motor.designation.clone());
        let known: Vec<&Motor> = motors.iter().copied().filter(|m| self.has_data(m)).collect();
        let Some(slowest) = known.iter().min_by(|a, b| a.synchronous_speed.total_cmp(&b.synchronous_speed))
        else {
            return MotorError(text!("motor-select-no-ratio", count = motors.len()));
        };
        let slow = known.iter().filter(|m| self.keeps_limit(m));
        let strongest = slow.max_by(|a, b| a.rated_power.total_cmp(&b.rated_power));
        MotorError(if let Some(strongest) = strongest {
            let (required, largest) = (self.required_power, strongest.rated_power);
            text!(
                "motor-select-too-weak",
                required = tenths(required),
                designation = designation(strongest),
                largest = tenths(largest),
                lack = tenths(required - largest)
            )
        } else {
            let limit = self.max_motor_speed.unwrap_or(f64::INFINITY);
            text!(
                "motor-select-too-fast",
                limit = tenths(rpm(limit)),
                designation = designation(slowest),
                slowest = tenths(rpm(slowest.synchronous_speed)),
                excess = tenths(rpm(slowest.synchronous_speed - limit))
            )
        })
    }
}
