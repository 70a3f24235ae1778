//! Every quantity over the positions, in the unit that is shown.

use super::number::number;

/// A value this small beside the greatest one is rounding.
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
    /// The values; NaN where there is none.
    pub(crate) values: Vec<f64>,
    /// Sizes below this are rounding, whatever the rest of the series is.
    pub(crate) floor: f64,
}

impl Series {
    /// Value and unit at a position.
    pub(crate) fn show(&self, position: usize) -> String {
        format!("{} {}", self.bare(position), self.unit)
    }

    /// Value at a position without its unit; what is rounding beside the greatest value is 0.
    pub(crate) fn bare(&self, position: usize) -> String {
        let most = self.values.iter().filter(|v| v.is_finite()).fold(0.0_f64, |most, v| most.max(v.abs()));
        match self.values.get(position) {
            Some(value) if value.abs() <= (ROUNDING * most).max(self.floor) => "0".to_owned(),
            Some(value) if value.is_finite() => number(*value),
            _ => "-".to_owned(),
        }
    }
}

/// A quantity with its two derivatives: indices of three series.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Transfer {
    /// `point D x`.
    pub(crate) name: String,
    /// The name that `:point D` looks for, and its kind.
    pub(crate) key: Key,
    /// PF0, PF1, PF2.
    pub(crate) orders: [usize; 3],
}

/// Whose quantity it is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Key {
    /// A point, by its index.
    Point(usize),
    /// A link.
    Link(usize),
    /// A slide.
    Slide(usize),
}

/// Places (between positions: linear) where a series passes zero, as position numbers.
pub(crate) fn zeros(values: &[f64], closed: bool) -> Vec<f64> {
    let count = values.len();
    let most = values.iter().filter(|v| v.is_finite()).fold(0.0_f64, |most, v| most.max(v.abs()));
    // Rounding around an identical zero is no passage.
    let least = 1e-9 * most;
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

/// Least and greatest finite value.
pub(crate) fn extent(values: &[f64]) -> Option<[f64; 2]> {
    values.iter().filter(|v| v.is_finite()).fold(None, |found, &v| match found {
        None => Some([v, v]),
        Some([low, high]) => Some([low.min(v), high.max(v)]),
    })
}

/// Range of an axis that holds these values and is never empty; what is smaller than `floor` is rounding. A constant stands in the
/// middle between zero and twice itself, so that it is not taken for a curve.
pub(crate) fn axis_range(extent: [f64; 2], floor: f64) -> [f64; 2] {
    let [low, high] = extent;
    let most = low.abs().max(high.abs());
    if most <= floor || most == 0.0 {
        return [-1.0, 1.0];
    }
    if high - low > 1e-9 * most {
        return extent;
    }
    let twice = low + high;
    [twice.min(0.0), twice.max(0.0)]
}

#[cfg(test)]
mod tests {
    use super::{axis_range, extent, zeros};

    #[test]
    #[expect(clippy::float_cmp, reason = "bounds are taken as they are, or doubled")]
    fn an_axis_is_never_empty() {
        assert_eq!(axis_range([-2.0, 3.0], 0.0), [-2.0, 3.0]);
        assert_eq!(axis_range([0.1, 0.1], 0.0), [0.0, 0.2]);
        assert_eq!(axis_range([-4.0, -4.0], 0.0), [-8.0, 0.0]);
        assert_eq!(axis_range([0.0, 0.0], 0.0), [-1.0, 1.0]);
        assert_eq!(axis_range([-1e-17, 2e-17], 1e-15), [-1.0, 1.0]);
        assert_eq!(axis_range([-1e-17, 2e-17], 0.0), [-1e-17, 2e-17]);
    }

    #[test]
    fn zeros_of_a_sine() {
        let sine: Vec<f64> =
            (0..12).map(|i| (f64::from(i) * std::f64::consts::TAU / 12.0 + 0.1).sin()).collect();
        let found = zeros(&sine, true);
        assert_eq!(found.len(), 2, "{found:?}");
        assert!((found[0] - (6.0 - 1.2 / std::f64::consts::TAU)).abs() < 0.01, "{found:?}");
        assert!((found[1] - (12.0 - 1.2 / std::f64::consts::TAU)).abs() < 0.01, "{found:?}");
        assert_eq!(zeros(&sine, false).len(), 1);
    }

    #[test]
    fn a_zero_that_is_met_counts_once() {
        assert_eq!(zeros(&[1.0, 0.0, -1.0, 0.0], true), [1.0, 3.0]);
        assert!(zeros(&[0.0, 0.0], true).is_empty());
        assert!(zeros(&[1.0, f64::NAN, -1.0], false).is_empty());
        assert!(zeros(&[], true).is_empty());
    }

    #[test]
    fn the_extent_ignores_what_is_no_number() {
        assert_eq!(extent(&[f64::NAN, 2.0, -1.0]), Some([-1.0, 2.0]));
        assert_eq!(extent(&[f64::NAN]), None);
    }
}
