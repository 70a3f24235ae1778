//! The axis of a plot: its range, its scale and its ticks.

#[cfg(test)]
mod tests;

use assur_words::{Text, number};

use crate::number::{round_up, stepped};
use crate::scale::{SCALES, Scale};

/// How the numbers of an axis are spread, and where its ticks are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxisKind {
    /// Equal steps, ticks at round numbers.
    Linear,
    /// Equal steps, ticks at parts of a turn (0, 90, 180, 270, 360).
    Degrees,
    /// Equal steps, ticks at whole numbers.
    Whole,
    /// Equal ratios, ticks at powers of ten.
    Logarithmic,
    /// Equal steps without ticks, for rows that have names.
    Unmarked,
}

/// An axis of a plot.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// What is drawn along it, with its unit; may be empty.
    pub label: Text,
    /// Its ends, the lower one first.
    pub range: [f64; 2],
    /// How its numbers are spread.
    pub kind: AxisKind,
    /// What its numbers measure, told with the scale of a drawing sheet.
    pub scale: Option<Box<Scale>>,
}

/// A range this small compared with its ends is one value.
const SAME: f64 = 1e-9;
/// Steps of round numbers, as parts of a power of ten.
const ROUND: [f64; 4] = [1.0, 2.0, 2.5, 5.0];
/// Steps of angles, degrees.
const ANGLES: [f64; 8] = [1.0, 5.0, 10.0, 15.0, 30.0, 45.0, 90.0, 180.0];

/// Least and greatest finite value.
pub fn extent(values: impl IntoIterator<Item = f64>) -> Option<[f64; 2]> {
    values.into_iter().filter(|v| v.is_finite()).fold(None, |found, v| match found {
        None => Some([v, v]),
        Some([low, high]) => Some([f64::min(low, v), f64::max(high, v)]),
    })
}

impl Axis {
    /// An axis of equal steps around values, never empty; values up to `floor` count as zero. A constant is drawn in the
    /// middle between zero and twice its value, to be recognizable as a constant.
    pub fn around(label: Text, values: impl IntoIterator<Item = f64>, floor: f64) -> Self {
        let [low, high] = extent(values).unwrap_or_default();
        let most = low.abs().max(high.abs());
        let range = if most <= floor || most == 0.0 {
            [-1.0, 1.0]
        } else if high - low > SAME * most {
            [low, high]
        } else {
            [(low + high).min(0.0), (low + high).max(0.0)]
        };
        Self { label, range, kind: AxisKind::Linear, scale: None }
    }

    /// The axis of numbers in this unit.
    #[must_use]
    pub fn measuring(self, unit: &str) -> Self {
        Self { scale: Scale::measuring(unit).map(Box::new), ..self }
    }

    /// The axis of the coordinate, in this unit: its scale factor is another one than that of what has the same unit over it.
    #[must_use]
    pub fn of_coordinate(self, unit: &str) -> Self {
        let own = |scale: Scale| if scale.symbol == "t" { scale } else { Scale { symbol: "q", ..scale } };
        Self { scale: Scale::measuring(unit).map(own).map(Box::new), ..self }
    }

    /// Units in a millimeter, a round number, where the axis is at most this long; `None` of an axis without equal steps of a unit.
    pub(crate) fn units_in_mm(&self, length: f64) -> Option<f64> {
        self.scale.as_ref().filter(|_| self.kind != AxisKind::Logarithmic)?;
        Some(round_up((self.range[1] - self.range[0]) / length, &SCALES))
    }

    /// Place of a value on the axis: 0 at its lower end, 1 at its upper end.
    pub fn part(&self, value: f64) -> f64 {
        let at = |x: f64| if self.kind == AxisKind::Logarithmic { x.log10() } else { x };
        let [low, high] = self.range.map(at);
        (at(value) - low) / (high - low)
    }

    /// The value at a place of the axis.
    pub fn value(&self, part: f64) -> f64 {
        let between = |[low, high]: [f64; 2]| low + part * (high - low);
        if self.kind == AxisKind::Logarithmic {
            10.0_f64.powf(between(self.range.map(f64::log10)))
        } else {
            between(self.range)
        }
    }

    /// At most this many round values within the range, with their texts; powers of ten at least at every fifth.
    pub fn ticks(&self, most: usize) -> Vec<(f64, Text)> {
        let [low, high] =
            if self.kind == AxisKind::Logarithmic { self.range.map(f64::log10) } else { self.range };
        let span = high - low;
        if self.kind == AxisKind::Unmarked || !(span.is_finite() && span > 0.0) {
            return Vec::new();
        }
        let step = self.step(span / most.max(1) as f64);
        let (first, last) = ((low / step - SAME).ceil(), (high / step + SAME).floor());
        let mut ticks = Vec::new();
        let mut count = first;
        while count <= last {
            let at = count * step;
            ticks.push(match self.kind {
                AxisKind::Logarithmic => (10.0_f64.powf(at), number(format_args!("1e{at}"))),
                _ => (at, number(stepped(if at.abs() < SAME * step { 0.0 } else { at }, step))),
            });
            count += 1.0;
        }
        ticks
    }

    /// The least round step that is not below another one.
    fn step(&self, least: f64) -> f64 {
        match self.kind {
            AxisKind::Logarithmic => least.ceil().clamp(1.0, 5.0),
            AxisKind::Whole if least < 1.0 => 1.0,
            AxisKind::Degrees if (1.0..=180.0).contains(&least) => {
                ANGLES.into_iter().find(|step| *step >= least).unwrap_or(180.0)
            }
            AxisKind::Degrees if least > 180.0 => 360.0 * (least / 360.0).ceil(),
            _ => round_up(least, &ROUND),
        }
    }
}
