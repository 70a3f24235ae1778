//! Formatting of numbers for a reader.

/// A number in few characters: `1e-6`, `3.2e-5`, `0.02`, `24`.
pub fn short(number: f64) -> String {
    if number == 0.0 {
        return "0".to_owned();
    }
    if (1e-2..1e4).contains(&number.abs()) {
        return trimmed(&format!("{number:.3}"));
    }
    let text = format!("{number:.1e}");
    text.replace(".0e", "e")
}

fn trimmed(text: &str) -> String {
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
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

/// A power of ten of seconds with its unit: `100 ns`.
pub fn decade(exponent: i32, ascii: bool) -> String {
    let micro = if ascii { "us" } else { "µs" };
    let unit = exponent.div_euclid(3);
    let name = match unit {
        0 => "s",
        -1 => "ms",
        -2 => micro,
        -3 => "ns",
        _ => return format!("1e{exponent} s"),
    };
    format!("1{} {name}", "0".repeat(usize::try_from(exponent.rem_euclid(3)).unwrap_or(0)))
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
