//! Converts quantities, a number with a unit, to SI.

mod dimension;
mod parse;
#[cfg(test)]
mod tests;

pub use dimension::{Dimension, LEAST};

use assur_words::{Describe, Text, name, text};

use crate::text::shown;

/// Why a text is no quantity of the wanted dimension. The text of an error continues the name of what was read:
/// "`mass` " + "wants a mass (kg, g, t, lb), got `mm`, a length".
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum UnitError {
    /// The text does not begin with a number.
    NotANumber {
        /// The text.
        text: String,
        /// What was wanted.
        wanted: Dimension,
    },
    /// The number contains a comma (the text).
    Comma(String),
    /// The digits of the number stand in groups (the text).
    Grouped(String),
    /// The number is so great that results would have no correct digits.
    TooLarge {
        /// The text.
        text: String,
        /// What was wanted.
        wanted: Dimension,
    },
    /// The number is not 0, but smaller than anything that can be measured.
    TooSmall {
        /// The text.
        text: String,
        /// What was wanted.
        wanted: Dimension,
    },
    /// No unit of this name is known.
    UnknownUnit {
        /// The unit, or the part of it that is unknown.
        unit: String,
        /// A known unit with nearly the same spelling.
        near: Option<String>,
        /// What was wanted.
        wanted: Dimension,
    },
    /// The unit measures something else.
    WrongDimension {
        /// The unit.
        unit: String,
        /// What it measures, if a scene has such a quantity.
        found: Option<Dimension>,
        /// What was wanted.
        wanted: Dimension,
    },
}

assur_words::errors!(UnitError);

impl Describe for UnitError {
    fn describe(&self) -> Text {
        let wants =
            |wanted: &Dimension, got: Text| text!("scene-wants", wanted = wanted.with_units(), got = got);
        match self {
            Self::NotANumber { text, wanted } => {
                wants(wanted, text!("scene-got-no-number", text = shown(text)))
            }
            Self::Comma(number) => text!("scene-comma", number = shown(number)),
            Self::Grouped(number) => text!("scene-grouped-digits", text = shown(number)),
            Self::TooLarge { text, wanted } => {
                let most = name(format!("{:e} {}", wanted.most(), wanted.si()));
                text!("scene-too-large", text = shown(text), most = most)
            }
            Self::TooSmall { text, wanted } => {
                let least = name(format!("{:e} {}", dimension::LEAST, wanted.si()));
                text!("scene-too-small", text = shown(text), least = least)
            }
            Self::UnknownUnit { unit, wanted, .. } => {
                wants(wanted, text!("scene-got-unknown-unit", unit = shown(unit)))
            }
            Self::WrongDimension { unit, found, wanted } => wants(wanted, measures(unit, *found)),
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
/// [`UnitError::TooLarge`], [`UnitError::TooSmall`].
pub(crate) fn within(value: f64, text: &str, wanted: Dimension) -> Result<f64, UnitError> {
    let text = || text.to_owned();
    match value.abs() {
        size if size > wanted.most() => Err(UnitError::TooLarge { text: text(), wanted }),
        size if size > 0.0 && size < dimension::LEAST => Err(UnitError::TooSmall { text: text(), wanted }),
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
        if wanted == Dimension::AngularSpeed && parse::is_count_by_time(&scale) {
            let near = Some("rpm".to_owned());
            return Err(UnitError::UnknownUnit { unit: name.to_owned(), near, wanted });
        }
        if wanted.accepts(scale.powers) {
            return Ok(Self(scale));
        }
        let found = Dimension::of(scale.powers);
        Err(UnitError::WrongDimension { unit: name.to_owned(), found, wanted })
    }

    /// The SI value of a number of this unit.
    pub fn si(&self, number: f64) -> f64 {
        let Self(scale) = self;
        // Multiplied first and divided once: 270 mm is the double nearest to 0.27, as if it had been written so. Pi
        // comes last, so 60 rpm is 2 pi rad/s to the last bit.
        number * scale.up / scale.down * std::f64::consts::PI.powi(scale.turns)
    }
}

/// The SI value of a text such as `120 mm`, `25 N*m` or `9.81 m/s²`; a number without a unit is taken as SI.
///
/// # Errors
///
/// [`UnitError`]: no number, one out of range, an unknown unit, a unit of another dimension.
pub fn quantity(text: &str, wanted: Dimension) -> Result<f64, UnitError> {
    let (number, unit) = parse::split(text, wanted)?;
    within(Unit::of(unit, wanted)?.si(number), text, wanted)
}

/// Whether a text is a unit of any quantity.
pub(crate) fn is_unit(text: &str) -> bool {
    parse::unit(text, Dimension::Number).is_ok()
}

/// Whether a text is a number without a unit.
pub(crate) fn is_bare(text: &str, wanted: Dimension) -> bool {
    matches!(parse::split(text, wanted), Ok((_, "")))
}
