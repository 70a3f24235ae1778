//! Numbers as a column shows them.

/// What stands for a value that is not determined. No text shows a number that is not finite: every number of it passes
/// through [`beside`] or [`scientific`].
const NONE: &str = "-";

/// Significant digits of the largest value of a column.
const DIGITS: i32 = 6;

/// A number below this part of the largest of its kind is shown as zero.
const ROUNDING: f64 = 1e-13;

/// Formats the values of one column with one number of decimals: as many as its largest needs for six significant
/// digits, so that small values are seen to be small. `None` is a dash. `kind`: the largest number of this unit nearby.
pub(super) fn column(values: &[Option<f64>], kind: f64) -> Vec<String> {
    let clean = |value: f64| if is_rounding(value, kind) { 0.0 } else { value };
    let values: Vec<_> = values.iter().map(|value| value.map(clean)).collect();
    let finite = values.iter().flatten().filter(|value| value.is_finite());
    let largest = finite.fold(0.0_f64, |largest, value| largest.max(value.abs()));
    values.iter().map(|value| value.map_or_else(|| NONE.to_owned(), |value| beside(value, largest))).collect()
}

/// Whether a number is rounding compared with the greatest of its kind.
pub(super) fn is_rounding(value: f64, greatest: f64) -> bool {
    value.abs() <= ROUNDING * greatest
}

/// One value with six significant digits.
pub(super) fn single(value: f64) -> String {
    beside(value, value.abs())
}

/// One value with six significant digits and no zeros at the end.
pub(super) fn short(value: f64) -> String {
    let text = single(value);
    if text.contains('.') && !text.contains('e') {
        return text.trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    text
}

/// One value with three significant digits and an exponent.
pub(super) fn scientific(value: f64) -> String {
    match value {
        0.0 => "0".to_owned(),
        value if value.is_finite() => format!("{value:.2e}"),
        _ => NONE.to_owned(),
    }
}

fn beside(value: f64, largest: f64) -> String {
    if !value.is_finite() {
        return NONE.to_owned();
    }
    if largest == 0.0 {
        return "0".to_owned();
    }
    let exponent = largest.log10().floor();
    if !(-4.0..7.0).contains(&exponent) {
        return if value == 0.0 { "0".to_owned() } else { format!("{value:.5e}") };
    }
    #[expect(clippy::cast_possible_truncation, reason = "between -4 and 7")]
    let decimals = (DIGITS - 1 - exponent as i32).max(0);
    let text = format!("{value:.*}", usize::try_from(decimals).unwrap_or(0));
    // No minus before a zero.
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| matches!(c, '0' | '.')) => rest.to_owned(),
        _ => text,
    }
}
