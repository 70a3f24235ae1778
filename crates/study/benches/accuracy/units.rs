//! Numbers for a reader.

pub(crate) use assur_study::chart::time;
use assur_words::{Text, name, number};

/// A number in few characters: `1e-6`, `3.2e-5`, `0.02`, `24`.
pub(crate) fn short(value: f64) -> Text {
    if value == 0.0 || (1e-2..1e4).contains(&value.abs()) {
        return number((1e3 * value).round() / 1e3);
    }
    number(format!("{value:.1e}").replace(".0e", "e"))
}

/// An error: `3.1e-9`, or `≤3.1e-9`.
pub(crate) fn error(value: f64, at_most: bool) -> Text {
    let value = if value == 0.0 { number(0) } else { number(format_args!("{value:.1e}")) };
    if at_most { assur_words::joined("", [name("≤"), value]) } else { value }
}
