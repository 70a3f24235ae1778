//! Numbers and quantities in the file.

use std::f64::consts::TAU;
use std::ops::RangeBounds;

use assur_words::{Describe, Text, name, number, quantity as with_unit, text, unit};
use toml::de::DeValue;

use crate::reference::Bound;
use crate::text::{did_you_mean, in_quotes, shown, such_as};
use crate::units::{Dimension, UnitFault, is_bare, quantity, within};
use crate::walk::{Entry, kind};

/// The greatest bare angle that is not doubted, rad: a turn.
const MOST_BARE_ANGLE: f64 = TAU;
/// The greatest bare angular speed that is not doubted, rad/s: 9549 rpm, faster than the links of any usual machine.
const MOST_BARE_SPEED: f64 = 1e3;

/// Whether an angle is one or several quarters of a turn, to seven digits: then it is meant in radians.
fn is_in_quarter_turns(angle: f64) -> bool {
    let quarters = angle / (TAU / 4.0);
    (quarters - quarters.round()).abs() <= 1e-7 * quarters.abs()
}

impl Entry<'_> {
    /// Reads a bare number (SI) or a text with a unit. Without a dimension (which another fault has hidden) any unit
    /// is accepted.
    pub fn quantity(&self, wanted: impl Into<Option<Dimension>>) -> Option<f64> {
        self.bounded(wanted, Bound::Any)
    }

    fn read_quantity(&self, wanted: Option<Dimension>) -> Option<f64> {
        match self.value {
            DeValue::String(text) => match wanted {
                Some(wanted) => self.with_unit(text, wanted),
                None => Some(0.0),
            },
            DeValue::Integer(_) | DeValue::Float(_) => self.number(wanted),
            _ => {
                let wanted = wanted.unwrap_or(Dimension::Number);
                self.wrong(wanted.describe(), example(wanted));
                None
            }
        }
    }

    /// Reads a number or a text with a unit, within a bound.
    pub(crate) fn bounded(&self, wanted: impl Into<Option<Dimension>>, bound: Bound) -> Option<f64> {
        self.bounded_or(wanted.into(), bound, None)
    }

    /// [`Entry::bounded`]; `word`: what may stand there in place of a number, for messages.
    pub(crate) fn bounded_or(
        &self,
        wanted: Option<Dimension>,
        bound: Bound,
        word: Option<&'static str>,
    ) -> Option<f64> {
        let value = self.read_quantity(wanted)?;
        let Some(wanted) = wanted else { return Some(value) };
        self.may_be(Some(wanted), bound);
        let limit = match bound {
            Bound::Any => return Some(value),
            Bound::NotNegative => "scene-negative",
            Bound::Positive => "scene-not-positive",
            Bound::Direction => "scene-many-turns",
        };
        let holds = bound.ends().contains(&value);
        if !holds {
            let example = example(wanted);
            let label = match word {
                Some(word) => text!("scene-example-or-word", example, word = name(word)),
                None => example,
            };
            self.problem(text!(limit, got = self.written()), label);
        }
        holds.then_some(value)
    }

    /// Tells that a number of this kind may stand here, whatever does.
    pub(crate) fn may_be(&self, kind: Option<Dimension>, bound: Bound) {
        self.faults.tell(|told| told.number(&self.span, kind, Some(bound.ends())));
    }

    /// Whether the number is within further limits; tells of them.
    pub(crate) fn is_within(&self, value: f64, limits: impl RangeBounds<f64>) -> bool {
        let ends = (limits.start_bound().cloned(), limits.end_bound().cloned());
        self.faults.tell(|told| told.number(&self.span, None, Some(ends)));
        ends.contains(&value)
    }

    /// The value as it is written in the file.
    pub(crate) fn written(&self) -> Text {
        match self.value {
            DeValue::String(text) => in_quotes(text),
            DeValue::Integer(number) => shown(&number.to_string()),
            DeValue::Float(number) => shown(&number.to_string()),
            other => kind(other),
        }
    }

    fn with_unit(&self, text: &str, wanted: Dimension) -> Option<f64> {
        if wanted != Dimension::Number && is_bare(text, wanted) {
            let label = text!("scene-without-quotes", unit = name(wanted.si()));
            self.problem(text!("scene-no-unit", got = in_quotes(text)), label);
            return None;
        }
        let error = match quantity(text, wanted) {
            Ok(value) => return Some(value),
            Err(error) => error,
        };
        let label = match &error.fault {
            UnitFault::UnknownUnit(Some(near)) => did_you_mean(&error.text, Some(near)),
            UnitFault::TooLarge | UnitFault::TooSmall => text!("scene-no-digits"),
            _ => example(wanted),
        };
        self.problem(error.describe(), label);
        None
    }

    fn number(&self, wanted: Option<Dimension>) -> Option<f64> {
        let value = match self.value {
            DeValue::Integer(number) => integer(number.as_str(), number.radix()),
            DeValue::Float(number) => number.as_str().parse().ok(),
            _ => None,
        };
        let finite = value.filter(|value: &f64| value.is_finite());
        // Of most numbers nothing is said, so that none is written out.
        if let (Some(value), Some(wanted)) = (finite, wanted)
            && within(value, "", wanted).is_err()
            && let Err(error) = within(value, &self.written().to_string(), wanted)
        {
            self.problem(error.describe(), text!("scene-no-digits"));
            return None;
        }
        if finite.is_none() {
            self.wants(text!("scene-a-finite-number"), self.written(), text!("scene-refused-numbers"));
        }
        if let (Some(value), Some(wanted)) = (finite, wanted) {
            self.doubt(value, wanted);
        }
        finite
    }

    /// A bare number is SI: notes where it is one that nobody would give in SI, but that is common in another unit.
    fn doubt(&self, value: f64, wanted: Dimension) {
        let (most, usual, in_usual) = match wanted {
            Dimension::Angle if !is_in_quarter_turns(value) => (MOST_BARE_ANGLE, "deg", value.to_degrees()),
            Dimension::AngularSpeed => (MOST_BARE_SPEED, "rpm", value * 60.0 / TAU),
            _ => return,
        };
        if value.abs() > most {
            let number = self.written();
            let instead = in_quotes(&format!("{number} {usual}"));
            self.faults.mistake(
                self.span.clone(),
                text!(
                    "scene-hardly-meant",
                    key = shown(&self.name),
                    number,
                    unit = unit(wanted.si()),
                    is = with_unit((in_usual * 100.0).round() / 100.0, usual),
                    instead = instead
                ),
            );
        }
    }

    /// A whole number between two limits.
    pub fn count(&self, least: usize, most: usize) -> Option<usize> {
        let wanted = || text!("scene-a-whole-number", least = number(least), most = number(most));
        let value = match self.value {
            DeValue::Integer(digits) => usize::from_str_radix(digits.as_str(), digits.radix()).ok(),
            DeValue::Float(_) => None,
            _ => {
                let quoted = self.value.as_str().is_some_and(|text| text.trim().parse::<usize>().is_ok());
                self.wrong(wanted(), if quoted { text!("scene-no-quotes") } else { Text::default() });
                return None;
            }
        };
        let value = value.filter(|value| (least..=most).contains(value));
        if value.is_none() {
            self.wants(wanted(), self.written(), Text::default());
        }
        self.faults.tell(|told| told.number(&self.span, None, None));
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

fn example(wanted: Dimension) -> Text {
    match wanted {
        Dimension::Number => such_as("0.5"),
        _ => text!("scene-such-as-or-in", example = in_quotes(wanted.example()), unit = name(wanted.si())),
    }
}
