//! Lists the numbers of a scene, and formats new values for them.

use std::ops::Range;

use assur_mechanism::Key;

use super::ParsedText;
use crate::units::{is_unit, number_length};

/// A number of a scene, with or without a unit.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneValue {
    /// Its key.
    pub key: Key,
    /// Bytes of the file that the value takes, quotes included.
    pub span: Range<usize>,
    /// Its text in the file: `"100 mm"`, `0.25`.
    pub written: String,
    number: f64,
    unit: String,
    /// Whether it must be a whole number.
    whole: bool,
}

impl SceneValue {
    /// Text for the current value changed by a percentage of the file's value; a count changes by at least 1. If the
    /// result is the file's value, its text is returned unchanged. `None` if the file's value is zero or the current
    /// value is not a number.
    pub fn moved(&self, now: &str, per_cent: f64) -> Option<String> {
        let (number, unit) = split(&bare(now).replace('_', ""))?;
        // A value in another unit can't be compared with that of the file.
        let base = if unit == self.unit { self.number } else { number };
        let step = base.abs() * per_cent / 100.0;
        let step = if self.whole { step.abs().round().max(1.0).copysign(per_cent) } else { step };
        let moved = decimal(number + step);
        (step != 0.0).then(|| self.with(moved, &unit))
    }

    /// Text for a value that was typed; a number without a unit takes the unit of the file.
    pub fn typed(&self, text: &str) -> String {
        let text = text.trim();
        match (text.parse(), split(text)) {
            (Ok(number), _) if f64::is_finite(number) => self.with(number, &self.unit),
            (_, Some((number, unit))) if is_unit(&unit) => self.with(number, &unit),
            _ => quoted(text),
        }
    }

    fn with(&self, number: f64, unit: &str) -> String {
        match unit {
            unit if unit == self.unit && number.total_cmp(&self.number).is_eq() => self.written.clone(),
            "" => shortest(number),
            unit => quoted(&format!("{} {unit}", shortest(number))),
        }
    }
}

/// The shortest text that is read back as the same number, without rows of zeros.
fn shortest(number: f64) -> String {
    let common = number == 0.0 || (1e-6..1e12).contains(&number.abs());
    if common { number.to_string() } else { format!("{number:e}") }
}

/// A value of the file without its quotes.
pub fn bare(written: &str) -> String {
    written.trim_matches(['"', '\'']).to_owned()
}

/// All numbers in the order of the file.
pub(super) fn of(scene: &ParsedText<'_>) -> Vec<SceneValue> {
    let numbers = crate::reading("", scene.text).map(|reading| reading.numbers).unwrap_or_default();
    let value = |key: Key, span: Range<usize>, number: Option<(f64, String)>, whole: bool| {
        let written = scene.text.get(span.clone())?.to_owned();
        let own =
            || split(&bare(&written).replace('_', "")).filter(|(_, unit)| unit.is_empty() || is_unit(unit));
        let (number, unit) = number.or_else(own)?;
        Some(SceneValue { key, span, written, number, unit, whole })
    };
    let motor = Key::of("drive").at("motor");
    let choice = scene.find(&motor).ok().and_then(|found| found.into_iter().next());
    // A choice among names has no number, and no percentage of it.
    let choice = choice.and_then(|place| value(motor, place.span, Some((f64::NAN, String::new())), false));
    let all = numbers
        .into_iter()
        .filter_map(|number| value(number.key.clone(), number.span.clone(), None, number.is_count()));
    let mut values: Vec<SceneValue> = all.chain(choice).collect();
    values.sort_by_key(|value| value.span.start);
    values
}

/// A number and the unit that follows it: "100 mm" is (100, "mm").
pub fn split(text: &str) -> Option<(f64, String)> {
    let text = text.trim();
    let (number, unit) = text.split_at(number_length(text));
    let value: f64 = number.replace('\u{2212}', "-").parse().ok()?;
    let unit: Vec<&str> = unit.split_whitespace().collect();
    value.is_finite().then(|| (value, unit.join(" ")))
}

/// Rounds to the 15 digits that every double keeps, so decimal steps remain decimal: 0.12, not 0.12000000000000001.
pub fn decimal(value: f64) -> f64 {
    format!("{value:.14e}").parse().unwrap_or(value)
}

/// A text as a TOML string.
pub fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}
