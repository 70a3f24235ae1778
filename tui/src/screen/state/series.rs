//! Every quantity over the positions, in the unit that is shown.

#[cfg(test)]
mod tests;

use crate::number::number;

/// A value this small compared with the greatest one counts as zero.
const ROUNDING: f64 = 1e-14;

/// One quantity over the positions.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Series {
    /// `point D x`, without the order.
    pub(crate) of: String,
    /// Column header: `D.x'`.
    pub(crate) short: String,
    /// Unit of the values.
    pub(crate) unit: String,
    /// The values; NaN where a position has none.
    pub(crate) values: Vec<f64>,
    /// Values below this count as zero, however small the rest of the series is.
    pub(crate) floor: f64,
}

impl Series {
    /// Value at a position; NaN where there is none.
    pub(crate) fn at(&self, position: usize) -> f64 {
        self.values.get(position).copied().unwrap_or(f64::NAN)
    }

    /// Value and unit at a position.
    pub(crate) fn show(&self, position: usize) -> String {
        format!("{} {}", self.bare(position), self.unit)
    }

    /// Value at a position without its unit; 0 if it is rounding compared with the greatest value.
    pub(crate) fn bare(&self, position: usize) -> String {
        let value = self.at(position);
        if value.abs() <= (ROUNDING * greatest(&self.values)).max(self.floor) {
            "0".to_owned()
        } else {
            number(value)
        }
    }
}

/// Greatest absolute value of those that are finite; 0 where there are none.
pub(crate) fn greatest<'a>(values: impl IntoIterator<Item = &'a f64>) -> f64 {
    values.into_iter().filter(|value| value.is_finite()).fold(0.0_f64, |most, value| most.max(value.abs()))
}

/// A quantity with its two derivatives: indices of three series.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Transfer {
    /// `point D x`.
    pub(crate) name: String,
    /// The name for the command `:point D`.
    pub(crate) owner: Owner,
    /// PF0, PF1, PF2.
    pub(crate) orders: [usize; 3],
}

/// The element to which it belongs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Owner {
    /// A point of the mechanism, by its index.
    Point(usize),
    /// A link of the mechanism, by its index.
    Link(usize),
    /// A slide of the mechanism, by its index.
    Slide(usize),
}

/// Places (between positions: linear) at which a series passes zero, as position numbers.
pub(crate) fn zeros(values: &[f64], closed: bool) -> Vec<f64> {
    let count = values.len();
    // Rounding around an identical zero is no zero crossing.
    let least = 1e-9 * greatest(values);
    let pairs = if closed { count } else { count.saturating_sub(1) };
    let mut found = Vec::new();
    for i in 0..pairs {
        let (a, b) = (values[i], values[(i + 1) % count]);
        if !(a.is_finite() && b.is_finite()) || a.abs().max(b.abs()) <= least {
            continue;
        }
        if a.abs() <= least {
            found.push(i as f64);
        } else if b.abs() > least && a * b < 0.0 {
            found.push(i as f64 + a / (a - b));
        }
    }
    found
}
