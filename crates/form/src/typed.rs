//! What a person types, as TOML.

use assur_scene::edit::{bare, quoted, split};
use assur_scene::reference::ValueKind;
use toml::de::DeValue;

use crate::field::{Field, quantity_of};

/// What was typed for a field as TOML; empty where nothing was typed, which leaves the key out.
///
/// A number without a unit takes the unit of the value that stands there; names and words get their quotes, two coordinates (`12, 5
/// mm`) and lists of names (`A, B`) their brackets. A comma within a number is taken as a decimal point. What is TOML already is left
/// as it is, but for a text that stands for itself: a title, a formula.
pub fn typed(field: &Field, typed: &str) -> String {
    let text = typed.trim();
    let has = |wanted: fn(&ValueKind) -> bool| field.kinds.iter().any(wanted);
    if text.is_empty() {
        return String::new();
    }
    if let Some(choice) =
        field.choices.iter().find(|choice| [&choice.toml, &bare(&choice.toml)].contains(&&text.to_owned()))
    {
        return choice.toml.clone();
    }
    let is_quoted = text.starts_with(['"', '\'']) && DeValue::parse(text).is_ok();
    // Of a text that may be a table of languages, what reads as a table is one.
    let may_be_text = has(|kind| *kind == ValueKind::Text);
    let is_table = || field.kinds.len() > 1 && text.starts_with('{') && DeValue::parse(text).is_ok();
    let is_open = text.starts_with(['[', '{']) && (!may_be_text || is_table());
    if is_quoted || is_open {
        return text.to_owned();
    }
    let list = field.kinds.iter().find_map(|kind| match kind {
        ValueKind::Two(item) | ValueKind::List(item) => Some((&**item, matches!(kind, ValueKind::Two(_)))),
        ValueKind::Place => Some((&ValueKind::Quantity(assur_scene::Dimension::Length), true)),
        _ => None,
    });
    if let Some((item, is_pair)) = list {
        let parts = parts(text, quantity_of(item).is_some());
        let single = field.kinds.iter().any(|kind| !matches!(kind, ValueKind::Two(_) | ValueKind::List(_)));
        if parts.len() > 1 || !(single && is_pair) {
            return of_list(&parts, item, field);
        }
    }
    if has(|kind| matches!(kind, ValueKind::Count)) {
        return text.to_owned();
    }
    let is_number = has(|kind| quantity_of(kind).is_some() || matches!(kind, ValueKind::ByInput(..)));
    let number = if is_number { number(text, &own_unit(field)) } else { None };
    number.unwrap_or_else(|| quoted(text))
}

/// The unit that stands in a value: of a list, in its first element with one.
fn own_unit(field: &Field) -> String {
    let written = field.value.as_deref().filter(|value| !value.starts_with('{') && !value.starts_with("[["));
    let written = written.unwrap_or_default();
    let items = written.trim_start_matches('[').trim_end_matches(']').split(',');
    let unit = |item: &str| split(&bare(item.trim())).map(|(_, unit)| unit).filter(|unit| !unit.is_empty());
    items.into_iter().find_map(unit).unwrap_or_default()
}

/// The elements of a list that was typed: between commas or semicolons; a comma within a number is a decimal sign.
fn parts(text: &str, numbers: bool) -> Vec<&str> {
    if text.contains(';') {
        return text.split(';').map(str::trim).collect();
    }
    let mut parts = Vec::new();
    let mut from = 0;
    for (at, _) in text.match_indices(',') {
        let within = text[..at].ends_with(|c: char| c.is_ascii_digit())
            && text[at + 1..].starts_with(|c: char| c.is_ascii_digit());
        if !(numbers && within) {
            parts.push(text[from..at].trim());
            from = at + 1;
        }
    }
    parts.push(text[from..].trim());
    parts
}

fn of_list(parts: &[&str], item: &ValueKind, field: &Field) -> String {
    // "12, 5 mm" are two numbers in mm.
    let typed = parts.iter().rev().find_map(|part| split(&with_point(part)).map(|(_, unit)| unit));
    let unit = typed.filter(|unit| !unit.is_empty()).unwrap_or_else(|| own_unit(field));
    let item = |part: &&&str| match item {
        ValueKind::Count => (**part).to_owned(),
        ValueKind::Quantity(_) | ValueKind::ByInput(..) => {
            number(part, &unit).unwrap_or_else(|| quoted(part))
        }
        _ => quoted(part),
    };
    let items: Vec<String> = parts.iter().filter(|part| !part.is_empty()).map(|part| item(&part)).collect();
    format!("[{}]", items.join(", "))
}

/// A number with a point in place of its decimal comma.
fn with_point(text: &str) -> String {
    let is_decimal = |at: usize| {
        text[..at].ends_with(|c: char| c.is_ascii_digit())
            && text[at + 1..].starts_with(|c: char| c.is_ascii_digit())
    };
    match text.match_indices(',').map(|(at, _)| at).collect::<Vec<_>>()[..] {
        [at] if is_decimal(at) => format!("{}.{}", &text[..at], &text[at + 1..]),
        _ => text.to_owned(),
    }
}

/// A number, with a unit where it has one or where one is given for numbers without; `None` where it does not begin with a number.
fn number(text: &str, unit: &str) -> Option<String> {
    let text = with_point(text).replace('\u{2212}', "-");
    let (value, own) = split(&text)?;
    let rest: String = own.split_whitespace().collect();
    let digits: String = text.split_whitespace().collect();
    let digits = digits.strip_suffix(rest.as_str())?;
    let unit = if own.is_empty() { unit } else { &own };
    if !unit.is_empty() {
        return Some(quoted(&format!("{digits} {unit}")));
    }
    // `.5` and `05` are no TOML.
    let is_toml =
        DeValue::parse(digits).is_ok_and(|toml| toml.get_ref().is_integer() || toml.get_ref().is_float());
    Some(if is_toml { digits.to_owned() } else { value.to_string() })
}
