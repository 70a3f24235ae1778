//! Numbers as they are shown.

use assur_figure::number::trimmed;
use assur_words::{Text, name, number};

/// What stands for a value that is not determined. No text shows a number that is not finite: every number of it passes
/// through [`digits`].
pub(crate) const NONE: &str = "-";

/// Significant digits of the largest value of a column, where a reader does not ask for others.
pub(crate) const DIGITS: usize = 6;

/// A number below this part of the largest of its kind is rounding, and zero.
pub const ROUNDING: f64 = 1e-13;

/// How the numbers of a column are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Digits {
    /// All with one number of decimals: as many as the largest of their unit in the table needs for six significant
    /// digits, so that small values are seen to be small.
    Even,
    /// Each with six significant digits and no zeros at the end.
    Short,
    /// As [`Self::Even`], but one that is very small beside the greatest has six digits of its own: ratios, of which a small one is no
    /// rounding of zero.
    Ratio,
    /// Each with three significant digits and an exponent.
    Exponent,
    /// Each with two thirds more significant digits than others, to show how an iteration converges.
    Long,
}

impl Digits {
    /// A number as it is written; `largest`: the greatest magnitude in its column, `kind`: in all columns of its unit.
    pub(crate) fn write(self, value: f64, [largest, kind]: [f64; 2], significant: usize) -> Text {
        if !value.is_finite() {
            return name(NONE);
        }
        let [clean, largest] = [value, largest].map(|value| zero_if_rounding(value, kind));
        number(match self {
            Self::Ratio if is_rounding(value, kind) => trimmed(value, significant),
            Self::Even | Self::Ratio => digits(clean, largest, significant),
            Self::Short => trimmed(clean, significant),
            Self::Exponent if value == 0.0 => "0".to_owned(),
            Self::Exponent => format!("{value:.2e}"),
            Self::Long => long(value, significant * 5 / 3),
        })
    }
}

/// A number, or zero where it is only rounding of the greatest of its kind.
pub fn zero_if_rounding(value: f64, greatest: f64) -> f64 {
    if is_rounding(value, greatest) { 0.0 } else { value }
}

/// Whether a number is rounding compared with the greatest of its kind.
fn is_rounding(value: f64, greatest: f64) -> bool {
    value.abs() <= ROUNDING * greatest.abs()
}

/// One value with six significant digits and no zeros at the end.
pub(crate) fn short(value: f64) -> String {
    trimmed(value, DIGITS)
}

/// One value with as many decimals as the largest beside it needs for so many significant digits.
pub(crate) fn digits(value: f64, largest: f64, significant: usize) -> String {
    if !value.is_finite() {
        return NONE.to_owned();
    }
    if largest == 0.0 {
        return "0".to_owned();
    }
    let exponent = largest.log10().floor();
    if !(-4.0..7.0).contains(&exponent) {
        return if value == 0.0 {
            "0".to_owned()
        } else {
            format!("{value:.*e}", significant.saturating_sub(1))
        };
    }
    #[expect(clippy::cast_possible_truncation, reason = "between -4 and 7")]
    let exponent = exponent as i32;
    let decimals = i32::try_from(significant).unwrap_or(i32::MAX) - 1 - exponent;
    let text = format!("{value:.*}", usize::try_from(decimals).unwrap_or(0));
    // No minus before a zero.
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| matches!(c, '0' | '.')) => rest.to_owned(),
        _ => text,
    }
}

fn long(value: f64, significant: usize) -> String {
    let size = if value == 0.0 { 0.0 } else { value.abs().log10().floor() };
    if !(-4.0..10.0).contains(&size) {
        let decimals = significant - 1;
        return format!("{value:.decimals$e}");
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 13")]
    let decimals = (significant as f64 - 1.0 - size).max(0.0) as usize;
    format!("{value:.decimals$}")
}
