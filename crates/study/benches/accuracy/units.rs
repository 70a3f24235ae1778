//! Numbers for a reader.

use assur_words::{Text, name, number, quantity};

/// A number in few characters: `1e-6`, `3.2e-5`, `0.02`, `24`.
pub(crate) fn short(value: f64) -> Text {
    if value == 0.0 || (1e-2..1e4).contains(&value.abs()) {
        return number((1e3 * value).round() / 1e3);
    }
    number(format!("{value:.1e}").replace(".0e", "e"))
}

/// A time with its unit, three digits: `215 ns`, `1.20 ms`.
pub(crate) fn time(seconds: f64) -> Text {
    let (value, unit) = match seconds {
        s if s < 1e-6 => (s * 1e9, "ns"),
        s if s < 1e-3 => (s * 1e6, "µs"),
        s if s < 1.0 => (s * 1e3, "ms"),
        s => (s, "s"),
    };
    let digits = if value < 9.995 { 2 } else { usize::from(value < 99.95) };
    quantity(format!("{value:.digits$}"), unit)
}

/// An error: `3.1e-9`, or `≤3.1e-9`.
pub(crate) fn error(value: f64, at_most: bool) -> Text {
    let value = if value == 0.0 { number(0) } else { number(format_args!("{value:.1e}")) };
    if at_most { assur_words::joined("", [name("≤"), value]) } else { value }
}
