//! Lists the numbers of a scene, and formats new values for them.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::find::element_name;
use super::key::{Step, shown};
use super::replaced;
use crate::units::{is_unit, number_length};

/// A number of a scene, with or without a unit.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneValue {
    /// Its key, as [`KeyPath`](super::KeyPath) reads it.
    pub key: String,
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
    /// A part of the file that is no number.
    pub(super) fn whole(key: &str, span: Range<usize>, written: &str) -> Self {
        let (key, written, unit) = (key.to_owned(), written.to_owned(), String::new());
        Self { key, span, written, number: 0.0, unit, whole: false }
    }

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
pub(super) fn of(text: &str, table: &DeTable<'_>) -> Vec<SceneValue> {
    let mut values = Vec::new();
    each(table, &mut |steps, leaf| {
        let written = text.get(leaf.span()).unwrap_or_default();
        // A choice among names has no number, and no percentage of it.
        let choice = || (shown(steps) == MOTOR).then(|| (f64::NAN, String::new()));
        values.extend(number(leaf.get_ref(), written).or_else(choice).map(|(number, unit)| SceneValue {
            key: shown(steps),
            span: leaf.span(),
            written: written.to_owned(),
            number,
            unit,
            whole: false,
        }));
    });
    values.sort_by_key(|value| value.span.start);
    if crate::read("", text).is_ok() {
        // Zeros can't be changed by a percentage and counts are not in lists, so most integers need no trial.
        let may_count = |value: &&mut SceneValue| {
            value.written.replace('_', "").parse::<i64>().is_ok_and(|number| number != 0)
                && !value.key.ends_with(']')
        };
        for value in values.iter_mut().filter(may_count) {
            // The reader of scenes decides what is a count, which avoids a second list of counts.
            let fraction = format!("{}.0", value.written);
            value.whole = crate::read("", &replaced(text, [(&value.span, fraction.as_str())])).is_err();
        }
    }
    values
}

/// Calls a function with every value that is neither a table nor a list, and the steps to it.
fn each(table: &DeTable<'_>, take: &mut impl FnMut(&[Step], &Spanned<DeValue<'_>>)) {
    in_table(table, &mut Vec::new(), take);
}

fn in_table(
    table: &DeTable<'_>,
    steps: &mut Vec<Step>,
    take: &mut impl FnMut(&[Step], &Spanned<DeValue<'_>>),
) {
    for (key, value) in table {
        steps.push(Step::Name(key.get_ref().to_string()));
        in_value(value, steps, take);
        steps.pop();
    }
}

fn in_value(
    value: &Spanned<DeValue<'_>>,
    steps: &mut Vec<Step>,
    take: &mut impl FnMut(&[Step], &Spanned<DeValue<'_>>),
) {
    match value.get_ref() {
        DeValue::Table(table) => in_table(table, steps, take),
        DeValue::Array(array) => {
            let names: Vec<_> = array.iter().map(|item| element_name(item.get_ref())).collect();
            for (index, item) in array.iter().enumerate() {
                let name = names[index].clone();
                let own = name.filter(|_| names.iter().filter(|other| **other == names[index]).count() == 1);
                steps.push(own.map_or(Step::Index(index), Step::Name));
                in_value(item, steps, take);
                steps.pop();
            }
        }
        _ => take(steps, value),
    }
}

/// The key of names, each within the one before.
pub(crate) fn key_of_steps<'n>(names: impl IntoIterator<Item = &'n str>) -> String {
    shown(&names.into_iter().map(|name| Step::Name(name.to_owned())).collect::<Vec<_>>())
}

/// The key of the value that stands at these bytes of the file; of a number in a list, that of the list.
pub(crate) fn key_of(table: &DeTable<'_>, span: &Range<usize>) -> Option<String> {
    let mut found = None;
    each(table, &mut |steps, leaf| {
        if leaf.span() == *span {
            let items = steps.iter().rev().take_while(|step| matches!(step, Step::Index(_))).count();
            found = Some(shown(&steps[..steps.len() - items]));
        }
    });
    found
}

/// The first key that has these steps among its own, in their order and with the last of them last: `link.crank.points.A` of
/// `crank.A`.
pub(super) fn longer(table: &DeTable<'_>, steps: &[Step]) -> Option<String> {
    let mut found = None;
    each(table, &mut |own, _| {
        let mut rest = own.iter();
        let is_part = steps.iter().all(|step| rest.any(|other| other == step));
        if is_part && rest.all(|step| matches!(step, Step::Index(_))) {
            found.get_or_insert_with(|| shown(own));
        }
    });
    found
}

/// The key that chooses a motor by its name.
const MOTOR: &str = "drive.motor";

/// Number and unit, of a bare number or of a text that is a number with a known unit.
fn number(value: &DeValue<'_>, written: &str) -> Option<(f64, String)> {
    match value {
        DeValue::Integer(_) | DeValue::Float(_) => {
            split(&written.replace('_', "")).filter(|(_, unit)| unit.is_empty())
        }
        DeValue::String(text) => split(text).filter(|(_, unit)| is_unit(unit)),
        _ => None,
    }
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
