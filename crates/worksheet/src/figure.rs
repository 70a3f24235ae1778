//! Formatting of the numbers in a working.

/// Range of decimal exponents printed without an exponent; other numbers have the form 1.5e-7.
const PLAIN: std::ops::RangeInclusive<i32> = -5..=5;

/// What stands for a value that is not finite. No working shows such a number: every number of it is formatted here.
const UNDETERMINED: &str = "–";

/// Formats a number with so many significant digits; returns it with half a unit of its last digit.
pub(crate) fn significant(value: f64, digits: usize) -> (String, f64) {
    if value == 0.0 || !value.is_finite() {
        return (if value == 0.0 { "0" } else { UNDETERMINED }.to_owned(), 0.5);
    }
    let scientific = format!("{:.*e}", digits - 1, value);
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let last = exponent - i32::try_from(digits).unwrap_or(i32::MAX) + 1;
    let half = 0.5 * 10.0_f64.powi(last);
    if PLAIN.contains(&exponent) {
        return (format!("{:.*}", usize::try_from(-last).unwrap_or(0), value), half);
    }
    (format!("{mantissa}e{exponent}"), half)
}

/// A formatted number without trailing zeros.
pub(crate) fn shortest(value: f64, digits: usize) -> String {
    let (text, _) = significant(value, digits);
    let (mantissa, exponent) = text.split_once('e').map_or((text.as_str(), None), |(m, e)| (m, Some(e)));
    let trimmed =
        if mantissa.contains('.') { mantissa.trim_end_matches('0').trim_end_matches('.') } else { mantissa };
    exponent.map_or_else(|| trimmed.to_owned(), |exponent| format!("{trimmed}e{exponent}"))
}

/// Formats a zero that remains of terms of this size, with as many decimals as the digits of the terms have.
pub(crate) fn zero(size: f64, digits: usize) -> (String, f64) {
    /// Greatest number of decimals.
    const MOST: i32 = 15;
    if size == 0.0 || !size.is_finite() {
        return ("0".to_owned(), 0.5e-15);
    }
    let scientific = format!("{size:.15e}");
    let exponent: i32 = scientific.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0);
    let decimals = (i32::try_from(digits).unwrap_or(i32::MAX) - 1 - exponent).clamp(0, MOST);
    (format!("{:.*}", usize::try_from(decimals).unwrap_or(0), 0.0), 0.5 * 10.0_f64.powi(-decimals))
}

/// The value of a printed number.
pub(crate) fn rounded(value: f64, digits: usize) -> f64 {
    shortest(value, digits).parse().unwrap_or(value)
}
