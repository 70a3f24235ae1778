//! Formatting of numbers for a reader.

/// A number in few characters: `1e-6`, `3.2e-5`, `0.02`, `24`.
pub fn short(number: f64) -> String {
    if number == 0.0 || (1e-2..1e4).contains(&number.abs()) {
        return ((1e3 * number).round() / 1e3).to_string();
    }
    format!("{number:.1e}").replace(".0e", "e")
}

/// A time with its unit, three digits: `215 ns`, `1.20 ms`.
pub fn time(seconds: f64, ascii: bool) -> String {
    let micro = if ascii { "us" } else { "µs" };
    let (value, unit) = match seconds {
        s if s < 1e-6 => (s * 1e9, "ns"),
        s if s < 1e-3 => (s * 1e6, micro),
        s if s < 1.0 => (s * 1e3, "ms"),
        s => (s, "s"),
    };
    let digits = if value < 9.995 { 2 } else { usize::from(value < 99.95) };
    format!("{value:.digits$} {unit}")
}

/// An error: `3.1e-9`, or `<=3.1e-9`.
pub fn error(value: f64, at_most: bool, ascii: bool) -> String {
    let sign = match (at_most, ascii) {
        (false, _) => "",
        (true, true) => "<=",
        (true, false) => "≤",
    };
    if value == 0.0 { format!("{sign}0") } else { format!("{sign}{value:.1e}") }
}
