//! Keys and values as they are written in TOML.

use assur_mechanism::Step;
use toml::Spanned;
use toml::de::DeValue;

use crate::layout::in_one_piece;

/// A name as a key of TOML, in quotes where it must be.
pub(crate) fn word(name: &str) -> String {
    let is_bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if !name.is_empty() && name.chars().all(is_bare) { name.to_owned() } else { quoted(name) }
}

/// A text as a string of TOML.
pub(crate) fn quoted(text: &str) -> String {
    let mut out = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            c if c.is_control() => out.extend(format!("\\u{:04X}", u32::from(c)).chars()),
            c => out.push(c),
        }
    }
    out + "\""
}

/// The names of a key with points between them, as a header or the beginning of a line has them.
pub(crate) fn dotted(steps: &[Step]) -> String {
    let names =
        steps.iter().filter_map(|step| if let Step::Name(name) = step { Some(word(name)) } else { None });
    names.collect::<Vec<_>>().join(".")
}

/// A value below some steps, in braces: `{ points = { A = 0 } }`. `None` for an element of a list that is not its first.
pub(crate) fn nested(steps: &[Step], value: &str) -> Option<String> {
    steps.iter().rev().try_fold(value.to_owned(), |value, step| match step {
        Step::Name(name) => Some(format!("{{ {} = {value} }}", word(name))),
        Step::Index(0) => Some(format!("[{value}]")),
        _ => None,
    })
}

/// A value of a text in one piece: what stands as headers or longer keys is put in braces.
pub(crate) fn inline(text: &str, value: &Spanned<DeValue<'_>>) -> String {
    if in_one_piece(text, value) {
        return text[value.span()].to_owned();
    }
    match value.get_ref() {
        DeValue::Table(_) => format!("{{ {} }}", pairs(text, value).join(", ")),
        DeValue::Array(array) => {
            let items: Vec<_> = array.iter().map(|item| inline(text, item)).collect();
            format!("[{}]", items.join(", "))
        }
        _ => text[value.span()].to_owned(),
    }
}

/// The keys of a table with their values, in the order of the text: `a = 1`.
pub(crate) fn pairs(text: &str, value: &Spanned<DeValue<'_>>) -> Vec<String> {
    let mut all: Vec<_> = value.get_ref().as_table().into_iter().flatten().collect();
    all.sort_by_key(|(key, _)| key.span().start);
    all.into_iter().map(|(key, value)| format!("{} = {}", word(key.get_ref()), inline(text, value))).collect()
}
