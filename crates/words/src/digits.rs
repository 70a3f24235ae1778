//! Significant digits of numbers.

/// A number with so many significant digits; very large and very small ones with an exponent.
pub fn digits(value: f64, significant: usize) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return "-".to_owned();
    }
    let scientific = format!("{value:.*e}", significant.saturating_sub(1));
    let exponent = scientific.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok());
    let exponent = exponent.unwrap_or_default();
    match exponent {
        -4..=6 => {
            let decimals = i32::try_from(significant).unwrap_or(i32::MAX) - 1 - exponent;
            format!("{value:.*}", usize::try_from(decimals).unwrap_or(0))
        }
        _ => scientific,
    }
}

/// A number of at most so many significant digits without trailing zeros: for given data.
pub fn trimmed(value: f64, significant: usize) -> String {
    let text = digits(value, significant);
    match text.split_once('e') {
        None if text.contains('.') => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        _ => text,
    }
}
