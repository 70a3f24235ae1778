//! Choosing a motor: the smallest that gives the power and keeps the speed limit.

use assur_words::{name, number, text};
use serde::{Serialize, Serializer};

use crate::motor::{better, rpm};
use crate::{CharacteristicKind, Motor, MotorError, PassedOver, Refusal};

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
    let mut candidates = fits.into_iter().map(|motor| request.candidate(motor));
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
    fn refusal(&self, motor: &Motor) -> Option<Refusal> {
        let required = self.required_power;
        if motor.rated_power < required * (1.0 - SLACK) {
            Some(Refusal::Weak { required })
        } else if !self.has_data(motor) {
            Some(Refusal::NoBreakdown)
        } else {
            let limit = self.max_motor_speed.filter(|_| !self.keeps_limit(motor));
            limit.map(|limit| Refusal::Fast { limit })
        }
    }

    fn candidate<'a>(&self, motor: &'a Motor) -> Candidate<'a> {
        Candidate { motor, ratio: motor.rated_speed / self.input_speed.abs() }
    }

    /// Which of the demands no row meets, the most fundamental first.
    fn why_none(&self, motors: &[&Motor]) -> MotorError {
        if motors.is_empty() {
            return MotorError(text!("motor-select-no-motors"));
        }
        let tenths = |value: f64| number(format_args!("{value:.1}"));
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
