//! Converts quantities, a number with a unit, to SI.

mod dimension;
mod parse;
#[cfg(test)]
mod tests;

pub use dimension::{Dimension, LEAST};
pub(crate) use parse::number_length;

use assur_words::{Describe, Text, name, text};

use crate::text::shown;

/// Why a text is no quantity of the wanted dimension. The text of an error continues the name of what was read:
/// "`mass` " + "wants a mass (kg, g, t, lb, slug), got `mm`, a length".
#[derive(Clone, PartialEq)]
pub struct UnitError {
    /// What is wrong.
    pub fault: UnitFault,
    /// The text, or its unit, or the part of it that is unknown.
    pub text: String,
    /// What was wanted.
    pub wanted: Dimension,
}

/// What is wrong with a text that should be a quantity.
#[derive(Debug, Clone, PartialEq)]
pub enum UnitFault {
    /// It does not begin with a number.
    NotANumber,
    /// Its number contains a comma.
    Comma,
    /// The digits of its number stand in groups.
    Grouped,
    /// Its number is so great that results would have no correct digits.
    TooLarge,
    /// Its number is not 0, but smaller than anything that can be measured.
    TooSmall,
    /// No unit of this name is known; a known one may have nearly the same spelling.
    UnknownUnit(Option<String>),
    /// The unit measures something else; what, if a scene has such a quantity.
    WrongDimension(Option<Dimension>),
}

impl UnitError {
    fn new(fault: UnitFault, text: &str, wanted: Dimension) -> Self {
        Self { fault, text: text.to_owned(), wanted }
    }
}

assur_words::errors!(UnitError);

impl Describe for UnitError {
    fn describe(&self) -> Text {
        let Self { fault, text, wanted } = self;
        let wants = |got: Text| text!("scene-wants", wanted = wanted.with_units(), got);
        let limit = |size: f64| name(format!("{size:e} {}", wanted.si()));
        let text = shown(text);
        match fault {
            UnitFault::NotANumber => wants(text!("scene-got-no-number", text)),
            UnitFault::Comma => text!("scene-comma", number = text),
            UnitFault::Grouped => text!("scene-grouped-digits", text),
            UnitFault::TooLarge => text!("scene-too-large", text, most = limit(wanted.most())),
            UnitFault::TooSmall => text!("scene-too-small", text, least = limit(LEAST)),
            UnitFault::UnknownUnit(_) => wants(text!("scene-got-unknown-unit", unit = text)),
            UnitFault::WrongDimension(found) => wants(measures(&self.text, *found)),
        }
    }
}

pub(crate) fn measures(unit: &str, found: Option<Dimension>) -> Text {
    let found = found.map_or_else(|| text!("scene-no-quantity"), |found| found.describe());
    text!("scene-got-unit", unit = shown(unit), measures = found)
}

/// Returns an SI value if it is in the range of its kind; `text` is its text in the file.
///
/// # Errors
///
/// [`UnitFault::TooLarge`], [`UnitFault::TooSmall`].
pub(crate) fn within(value: f64, text: &str, wanted: Dimension) -> Result<f64, UnitError> {
    match value.abs() {
        size if size > wanted.most() => Err(UnitError::new(UnitFault::TooLarge, text, wanted)),
        size if size > 0.0 && size < LEAST => Err(UnitError::new(UnitFault::TooSmall, text, wanted)),
        _ => Ok(value),
    }
}

/// A unit of one kind of quantity, to convert many numbers to SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit(parse::Scale);

impl Unit {
    /// The unit of this name: `mm`, `kg*m^2`; without a name the SI unit.
    ///
    /// # Errors
    ///
    /// [`UnitError`]: an unknown unit, or a unit of another dimension.
    pub fn of(name: &str, wanted: Dimension) -> Result<Self, UnitError> {
        if name.is_empty() {
            return Ok(Self(parse::Scale::ONE));
        }
        let scale = parse::unit(name, wanted)?;
        // Something by minute or hour is read as radians by some and as turns by others: `1/min`.
        let is_count_by_time = scale.powers == [0, 0, -1, 0] && scale.down > scale.up;
        if wanted == Dimension::AngularSpeed && is_count_by_time {
            return Err(UnitError::new(UnitFault::UnknownUnit(Some("rpm".to_owned())), name, wanted));
        }
        if wanted.accepts(scale.powers) {
            return Ok(Self(scale));
        }
        Err(UnitError::new(UnitFault::WrongDimension(Dimension::of(scale.powers)), name, wanted))
    }

    /// The SI value of a number of this unit.
    pub fn si(&self, number: f64) -> f64 {
        let Self(scale) = self;
        // Multiplied first and divided once: 270 mm is the double nearest to 0.27, as if it had been written so. Pi
        // comes last, so 60 rpm is 2 pi rad/s to the last bit.
        number * scale.up / scale.down * std::f64::consts::PI.powi(scale.turns)
    }
}

/// The SI value of a text such as `120 mm`, `25 N*m` or `9.81 m/s²`; a number without a unit is taken as SI. A plain number may be a
/// fraction: `1/30`.
///
/// # Errors
///
/// [`UnitError`]: no number, one out of range, an unknown unit, a unit of another dimension.
pub fn quantity(text: &str, wanted: Dimension) -> Result<f64, UnitError> {
    if let Some(value) = fraction(text).filter(|_| wanted == Dimension::Number) {
        return within(value, text, wanted);
    }
    let (number, unit) = parse::split(text, wanted)?;
    within(Unit::of(unit, wanted)?.si(number), text, wanted)
}

/// The value of a fraction of two numbers: `1/30`.
fn fraction(text: &str) -> Option<f64> {
    let (over, under) = text.split_once('/')?;
    let [over, under] = [over, under].map(|part| part.trim().parse::<f64>().ok());
    Some(over? / under?).filter(|value| value.is_finite())
}

/// Whether a text is a unit of any quantity.
pub(crate) fn is_unit(text: &str) -> bool {
    parse::unit(text, Dimension::Number).is_ok()
}

/// Whether a text is a number without a unit.
pub(crate) fn is_bare(text: &str, wanted: Dimension) -> bool {
    matches!(parse::split(text, wanted), Ok((_, "")))
}
