//! Motors that were passed over when one was chosen, and why.

use std::mem::discriminant;

use assur_words::{Describe, Text, name, number, text};

use crate::motor::{better, rpm};
use crate::{Motor, MotorWarning};

/// A motor that was not taken.
#[derive(Debug, Clone, PartialEq)]
pub struct PassedOver<'a> {
    /// The catalogue row.
    pub motor: &'a Motor,
    /// Why.
    pub why: Refusal,
}

/// Why a motor was not taken.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Refusal {
    /// Its rated power is less than that required.
    Weak {
        /// Required power, W.
        required: f64,
    },
    /// Its synchronous speed is above the limit, rad/s.
    Fast {
        /// The limit, rad/s.
        limit: f64,
    },
    /// Its row lacks the breakdown torque that the characteristic needs.
    NoBreakdown,
    /// It was tried and can't do the work.
    Unfit(MotorWarning),
    /// It was tried and gives no regime.
    NoRegime(Text),
}

impl Describe for PassedOver<'_> {
    fn describe(&self) -> Text {
        let digits = |value: f64| number((1e3 * value).round() / 1e3);
        let tenths = |value: f64| number(format_args!("{value:.1}"));
        let whole = |speed: f64| number(format_args!("{:.0}", rpm(speed)));
        let why = match self.why {
            Refusal::Weak { required } => text!("motor-passed-weak", required = digits(required / 1e3)),
            Refusal::Fast { limit } => text!("motor-passed-fast", limit = whole(limit)),
            Refusal::NoBreakdown => text!("motor-passed-no-breakdown"),
            Refusal::Unfit(MotorWarning::RmsTorque { rms, rated }) => {
                text!("motor-passed-hot", excess = tenths(100.0 * (rms / rated - 1.0)))
            }
            Refusal::Unfit(MotorWarning::StartingTorque { available, required }) => {
                text!("motor-passed-start", available = digits(available), required = digits(required))
            }
            Refusal::Unfit(ref other) => other.describe(),
            Refusal::NoRegime(ref why) => why.clone(),
        };
        let (power, speed) = (digits(self.motor.rated_power / 1e3), whole(self.motor.synchronous_speed));
        text!("motor-passed", motor = name(self.motor.designation.clone()), power, speed, why)
    }
}

/// Of each reason the motor that stands closest before the chosen one in the order of preference, the nearest first. Those that are
/// too weak are reported where there are no others.
pub fn nearest<'a>(mut passed: Vec<PassedOver<'a>>, chosen: &Motor) -> Vec<PassedOver<'a>> {
    passed.retain(|one| better(one.motor, chosen).is_lt());
    passed.sort_by(|a, b| better(b.motor, a.motor));
    let kind = |why: &Refusal| match why {
        Refusal::Unfit(warning) => (discriminant(why), Some(discriminant(warning))),
        _ => (discriminant(why), None),
    };
    let mut known = Vec::new();
    passed.retain(|one| {
        let own = kind(&one.why);
        let is_new = !known.contains(&own) && (known.is_empty() || !matches!(one.why, Refusal::Weak { .. }));
        known.push(own);
        is_new
    });
    passed
}
