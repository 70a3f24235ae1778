//! A table of the size of a load.

use assur_mechanism::{LawTable, Shape};

/// A table with a straight line for each of its segments: that before the first row, those between two rows, and that
/// after the last.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Curve {
    /// Arguments of the rows, not decreasing; two equal ones make a jump.
    arguments: Vec<f64>,
    /// One more than rows.
    lines: Vec<Line>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Line {
    argument: f64,
    value: f64,
    slope: f64,
}

impl Curve {
    pub(crate) fn of(table: &LawTable) -> Self {
        let rows = &table.rows;
        let before = rows.first().map(|row| Line { argument: row[0], value: row[1], slope: 0.0 });
        let after = rows.iter().enumerate().map(|(index, &[argument, value])| {
            let slope = match rows.get(index + 1) {
                Some(next) if table.shape == Shape::Linear && next[0] > argument => {
                    (next[1] - value) / (next[0] - argument)
                }
                _ => 0.0,
            };
            Line { argument, value, slope }
        });
        let lines = before.into_iter().chain(after).collect();
        Self { arguments: rows.iter().map(|row| row[0]).collect(), lines }
    }

    pub(crate) fn arguments(&self) -> &[f64] {
        &self.arguments
    }

    /// Whether the value is the same everywhere.
    pub(crate) fn is_flat(&self) -> bool {
        self.lines.iter().all(|line| line.value.to_bits() == self.lines[0].value.to_bits())
    }

    /// Index of the segment that contains `x`: the number of rows at or before it. At a jump, the segment after it.
    #[inline(always)]
    pub(crate) fn segment(&self, x: f64) -> usize {
        self.arguments.partition_point(|argument| *argument <= x)
    }

    /// The arguments between which a segment lies.
    pub(crate) fn ends(&self, segment: usize) -> [f64; 2] {
        let low = segment.checked_sub(1).map_or(f64::NEG_INFINITY, |before| self.arguments[before]);
        [low, self.arguments.get(segment).copied().unwrap_or(f64::INFINITY)]
    }

    /// Value at `x` by the formula of a segment, which is extrapolated beyond its ends.
    #[inline(always)]
    pub(crate) fn value(&self, segment: usize, x: f64) -> f64 {
        let line = &self.lines[segment];
        line.value + line.slope * (x - line.argument)
    }
}
