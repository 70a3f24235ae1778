//! Every number of a scene, and other numbers in its place.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::find::element_name;
use super::key::{Step, shown};
use super::number::{decimal, quoted, split};
use super::replaced;
use crate::units::is_unit;

/// A number of a scene, with or without a unit.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneValue {
    /// Its key, as [`Key`](super::Key) reads it.
    pub key: String,
    /// Bytes of the file, quotes included.
    pub span: Range<usize>,
    /// As the file has it: `"100 mm"`, `0.25`.
    pub written: String,
    number: f64,
    unit: String,
    /// Whether only whole numbers are taken there.
    whole: bool,
}

impl SceneValue {
    /// As the file would have it, moved from what it is now by so many per cent of what the file has; a count by at
    /// least 1. The text of the file itself where that is the number again. `None` where there is nothing to take per
    /// cent of: a zero, or no number now.
    pub fn moved(&self, now: &str, per_cent: f64) -> Option<String> {
        let (number, unit) = split(&bare(now).replace('_', ""))?;
        // In another unit the number of the file says nothing.
        let base = if unit == self.unit { self.number } else { number };
        let step = base.abs() * per_cent / 100.0;
        let step = if self.whole { step.abs().round().max(1.0).copysign(per_cent) } else { step };
        let moved = decimal(number + step);
        (step != 0.0).then(|| self.with(moved, &unit))
    }

    /// As the file would have it, from what was typed; a number without a unit has the unit of the file.
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

/// The shortest text that reads back as the number: a page of zeros says nothing.
fn shortest(number: f64) -> String {
    let common = number == 0.0 || (1e-6..1e12).contains(&number.abs());
    if common { number.to_string() } else { format!("{number:e}") }
}

/// A value of the file as a reader wants it: without quotes.
pub fn bare(written: &str) -> String {
    written.trim_matches(['"', '\'']).to_owned()
}

/// All in the order of the file.
pub(super) fn of(text: &str, table: &DeTable<'_>) -> Vec<SceneValue> {
    let mut values = Vec::new();
    in_table(text, table, &mut Vec::new(), &mut values);
    values.sort_by_key(|value| value.span.start);
    if crate::read("", text).is_ok() {
        // A zero does not move, and no count stands in a list: most integers need no trial.
        let may_count = |value: &&mut SceneValue| {
            value.written.replace('_', "").parse::<i64>().is_ok_and(|number| number != 0)
                && !value.key.ends_with(']')
        };
        for value in values.iter_mut().filter(may_count) {
            // The reader says what is a count: there is no second list of that.
            let fraction = format!("{}.0", value.written);
            value.whole = crate::read("", &replaced(text, [(&value.span, fraction.as_str())])).is_err();
        }
    }
    values
}

fn in_table(text: &str, table: &DeTable<'_>, steps: &mut Vec<Step>, values: &mut Vec<SceneValue>) {
    for (key, value) in table {
        steps.push(Step::Name(key.get_ref().to_string()));
        in_value(text, value, steps, values);
        steps.pop();
    }
}

fn in_value(text: &str, value: &Spanned<DeValue<'_>>, steps: &mut Vec<Step>, values: &mut Vec<SceneValue>) {
    match value.get_ref() {
        DeValue::Table(table) => in_table(text, table, steps, values),
        DeValue::Array(array) => {
            let names: Vec<_> = array.iter().map(|item| element_name(item.get_ref())).collect();
            for (index, item) in array.iter().enumerate() {
                let name = names[index].clone();
                let own = name.filter(|_| names.iter().filter(|other| **other == names[index]).count() == 1);
                steps.push(own.map_or(Step::Index(index), Step::Name));
                in_value(text, item, steps, values);
                steps.pop();
            }
        }
        leaf => {
            let written = text.get(value.span()).unwrap_or_default();
            values.extend(number(leaf, written).map(|(number, unit)| SceneValue {
                key: shown(steps),
                span: value.span(),
                written: written.to_owned(),
                number,
                unit,
                whole: false,
            }));
        }
    }
}

/// Number and unit: of a bare number, or of a text that is a number with a known unit.
fn number(value: &DeValue<'_>, written: &str) -> Option<(f64, String)> {
    match value {
        DeValue::Integer(_) | DeValue::Float(_) => {
            split(&written.replace('_', "")).filter(|(_, unit)| unit.is_empty())
        }
        DeValue::String(text) => split(text).filter(|(_, unit)| is_unit(unit)),
        _ => None,
    }
}
