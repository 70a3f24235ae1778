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
    /// Column header: `D.x'`; no two quantities have the same.
    pub(crate) short: String,
    /// What it is, in words by which it is looked for: `velocity`, `PF1`.
    pub(crate) kind: &'static str,
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

/// The values over the positions in a few numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Summary {
    /// Greatest value and its position.
    pub(crate) greatest: (f64, usize),
    /// Least value and its position.
    pub(crate) least: (f64, usize),
    /// Mean of the values over the positions.
    pub(crate) mean: f64,
    /// Root of the mean square.
    pub(crate) rms: f64,
}

impl Series {
    /// Its extremes and means; `None` where no position has a value.
    pub(crate) fn summary(&self) -> Option<Summary> {
        let finite = || self.values.iter().enumerate().filter(|(_, value)| value.is_finite());
        let by = |a: &(usize, &f64), b: &(usize, &f64)| a.1.total_cmp(b.1).then(b.0.cmp(&a.0));
        let (greatest, least) = (finite().max_by(by)?, finite().min_by(|a, b| a.1.total_cmp(b.1))?);
        let count = finite().count() as f64;
        let mean = finite().map(|(_, value)| value).sum::<f64>() / count;
        let square = finite().map(|(_, value)| value * value).sum::<f64>() / count;
        let at = |(position, value): (usize, &f64)| (*value, position);
        Some(Summary { greatest: at(greatest), least: at(least), mean, rms: square.sqrt() })
    }

    /// Its name for a list: `point D x PF1, m/rad`.
    pub(crate) fn title(&self) -> String {
        let kind = if self.kind.is_empty() { String::new() } else { format!(" {}", self.kind) };
        let unit = if self.unit.is_empty() { String::new() } else { format!(", {}", self.unit) };
        format!("{}{kind}{unit}", self.of)
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
