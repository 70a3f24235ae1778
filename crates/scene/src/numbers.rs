//! Numbers and quantities in the file.

use toml::de::DeValue;

use crate::text::{did_you_mean, shown};
use crate::units::{Dimension, UnitError, is_bare, quantity, within};
use crate::walk::{Entry, Section};

/// The range of a number, besides being finite.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Bound {
    /// Anything.
    Any,
    /// Not negative.
    NotNegative,
    /// Greater than 0.
    Positive,
    /// An angle that is a direction.
    Direction,
}

/// The greatest angle of a direction, rad, 1000 turns: a greater one would lose more than four of its 16 digits.
const MOST_DIRECTION: f64 = 1000.0 * std::f64::consts::TAU;

/// Hint for a number out of range.
const OUT_OF_RANGE: &str = "results would have no digits: is the unit right?";

impl Entry<'_> {
    /// Reads a bare number (SI) or a text with a unit. Without a dimension (which another fault has hidden) any unit
    /// is accepted.
    pub fn quantity(&self, wanted: impl Into<Option<Dimension>>) -> Option<f64> {
        let wanted = wanted.into();
        match self.value {
            DeValue::String(text) => match wanted {
                Some(wanted) => self.with_unit(text, wanted),
                None => Some(0.0),
            },
            DeValue::Integer(_) | DeValue::Float(_) => self.number(wanted),
            _ => {
                let wanted = wanted.unwrap_or(Dimension::Number);
                self.wrong(wanted.name(), such_as(wanted));
                None
            }
        }
    }

    /// Reads a number or a text with a unit, within a bound.
    pub(crate) fn bounded(&self, wanted: impl Into<Option<Dimension>>, bound: Bound) -> Option<f64> {
        let wanted = wanted.into();
        let value = self.quantity(wanted)?;
        let wanted = wanted.unwrap_or(Dimension::Number);
        let (holds, limit) = match bound {
            Bound::Any => (true, ""),
            Bound::NotNegative => (value >= 0.0, "must not be negative"),
            Bound::Positive => (value > 0.0, "must be greater than 0"),
            Bound::Direction => (value.abs() <= MOST_DIRECTION, "is a direction and at most 1000 turns"),
        };
        if !holds {
            self.fault(format!("`{}` {limit}, got {}", shown(&self.name), self.written()), such_as(wanted));
        }
        holds.then_some(value)
    }

    /// The value as it is written in the file.
    pub(crate) fn written(&self) -> String {
        match self.value {
            DeValue::String(text) => format!("\"{}\"", shown(text)),
            DeValue::Integer(number) => shown(&number.to_string()),
            DeValue::Float(number) => shown(&number.to_string()),
            other => crate::walk::kind(other).to_owned(),
        }
    }

    fn with_unit(&self, text: &str, wanted: Dimension) -> Option<f64> {
        let name = shown(&self.name);
        if wanted != Dimension::Number && is_bare(text, wanted) {
            let label = format!("for {} write it without quotes", wanted.si());
            self.fault(format!("`{name}` has no unit: \"{}\"", shown(text)), label);
            return None;
        }
        let error = match quantity(text, wanted) {
            Ok(value) => return Some(value),
            Err(error) => error,
        };
        let label = match &error {
            UnitError::UnknownUnit { near: Some(near), .. } => did_you_mean(Some(near)),
            UnitError::TooLarge { .. } | UnitError::TooSmall { .. } => OUT_OF_RANGE.to_owned(),
            _ => such_as(wanted),
        };
        self.fault(format!("`{name}` {error}"), label);
        None
    }

    fn number(&self, wanted: Option<Dimension>) -> Option<f64> {
        let value = match self.value {
            DeValue::Integer(number) => integer(number.as_str(), number.radix()),
            DeValue::Float(number) => number.as_str().parse().ok(),
            _ => None,
        };
        let finite = value.filter(|value: &f64| value.is_finite());
        if let (Some(value), Some(wanted)) = (finite, wanted)
            && let Err(error) = within(value, &self.written(), wanted)
        {
            self.fault(format!("`{}` {error}", shown(&self.name)), OUT_OF_RANGE);
            return None;
        }
        if finite.is_none() {
            let message = format!("`{}` wants a finite number, got {}", shown(&self.name), self.written());
            self.fault(message, "nan, inf and numbers beyond 1.8e308 are refused");
        }
        finite
    }

    /// A whole number between two limits.
    pub fn count(&self, least: usize, most: usize) -> Option<usize> {
        let wanted = format!("a whole number from {least} to {most}");
        let number = match self.value {
            DeValue::Integer(number) => number,
            DeValue::Float(_) => {
                self.fault(format!("`{}` wants {wanted}, got {}", shown(&self.name), self.written()), "");
                return None;
            }
            _ => {
                self.wrong(&wanted, "");
                return None;
            }
        };
        let value = usize::from_str_radix(number.as_str(), number.radix()).ok();
        let value = value.filter(|value| (least..=most).contains(value));
        if value.is_none() {
            self.fault(format!("`{}` wants {wanted}, got {}", shown(&self.name), self.written()), "");
        }
        value
    }
}

fn integer(digits: &str, radix: u32) -> Option<f64> {
    match i128::from_str_radix(digits, radix) {
        #[expect(
            clippy::cast_precision_loss,
            reason = "an integer beyond 2^53 is rounded like any decimal number"
        )]
        Ok(value) => Some(value as f64),
        Err(_) if radix == 10 => digits.parse().ok(),
        Err(_) => None,
    }
}

fn such_as(wanted: Dimension) -> String {
    match wanted {
        Dimension::Number => "such as 0.5".to_owned(),
        _ => format!("such as \"{}\", or a number in {}", wanted.example(), wanted.si()),
    }
}

impl Section<'_> {
    /// The quantity of a key, or `default` if the key is absent or wrong.
    pub(crate) fn quantity_or(
        &self,
        key: &str,
        wanted: impl Into<Option<Dimension>>,
        bound: Bound,
        default: f64,
    ) -> f64 {
        self.get(key).and_then(|entry| entry.bounded(wanted, bound)).unwrap_or(default)
    }
}
