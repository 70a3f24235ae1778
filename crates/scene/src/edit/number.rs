//! Numbers with units as text.

/// A number and the unit that follows it: "100 mm" is (100, "mm").
pub fn split(text: &str) -> Option<(f64, String)> {
    let text = text.replace('\u{2212}', "-");
    let number = |end: &usize| {
        let head = text[..*end].trim();
        let digits = head.ends_with(|c: char| c.is_ascii_digit() || c == '.');
        head.parse().ok().filter(|value: &f64| digits && value.is_finite()).map(|value| (value, *end))
    };
    let mut ends = text.char_indices().map(|(at, c)| at + c.len_utf8()).rev();
    let (value, end) = ends.find_map(|end| number(&end))?;
    let unit: Vec<&str> = text[end..].split_whitespace().collect();
    Some((value, unit.join(" ")))
}

/// Rounds to the 15 digits that every double keeps, so decimal steps remain decimal: 0.12, not 0.12000000000000001.
pub fn decimal(value: f64) -> f64 {
    format!("{value:.14e}").parse().unwrap_or(value)
}

/// A text as a TOML string.
pub fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}
