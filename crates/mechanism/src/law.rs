//! The laws by which the size of a load varies.

use assur_formula::Formula;

/// A number, or a law by which it varies.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A constant.
    Constant(f64),
    /// Given by a table over one quantity.
    Table {
        /// The quantity.
        over: Over,
        /// The table.
        table: LawTable,
        /// For a table over the coordinate: whether it repeats with the cycle, which is counted from its first row.
        repeat: bool,
    },
    /// Depends on the stroke of the load's point along an axis of the ground.
    Stroke {
        /// Direction of the axis, rad.
        axis: f64,
        /// Table over 0 to 1 (position between the extremes of the stroke) while the point moves in the direction of
        /// the axis.
        forward: LawTable,
        /// Table over 0 to 1 (position between the extremes of the stroke) while the point moves against the axis.
        back: LawTable,
    },
    /// Given by a formula.
    Formula {
        /// The formula over coordinate, speed (with its sign), time, and the place of the load's point.
        formula: Formula,
        /// SI value of a result of 1.
        factor: f64,
        /// Direction of the axis along which the place `x` of the load's point is taken, rad; `None`: the formula does not
        /// use it.
        axis: Option<f64>,
    },
}

impl Value {
    /// The same law with another size: every value of it times a factor.
    #[must_use]
    pub fn scaled(mut self, scale: f64) -> Self {
        let all = |table: &mut LawTable| table.rows.iter_mut().for_each(|row| row[1] *= scale);
        match &mut self {
            Self::Constant(value) => *value *= scale,
            Self::Table { table, .. } => all(table),
            Self::Stroke { forward, back, .. } => [forward, back].into_iter().for_each(all),
            Self::Formula { factor, .. } => *factor *= scale,
        }
        self
    }

    /// Whether it depends on time or speed.
    pub fn follows_motion(&self) -> bool {
        match self {
            Self::Constant(_) | Self::Stroke { .. } => false,
            Self::Table { over, .. } => *over != Over::Coordinate,
            Self::Formula { formula, .. } => formula.used().time || formula.used().speed,
        }
    }

    /// The sizes that it gives: the values of a constant and of tables, the SI value of a formula's result of 1.
    pub fn sizes(&self) -> impl Iterator<Item = f64> {
        let (number, tables) = match self {
            Self::Constant(number) | Self::Formula { factor: number, .. } => (Some(*number), [None, None]),
            Self::Table { table, .. } => (None, [Some(table), None]),
            Self::Stroke { forward, back, .. } => (None, [Some(forward), Some(back)]),
        };
        let rows = tables.into_iter().flatten().flat_map(|table| &table.rows);
        number.into_iter().chain(rows.map(|row| row[1]))
    }
}

/// The quantity of a table's first column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Over {
    /// The input coordinate, rad or m.
    Coordinate,
    /// Time, s.
    Time,
    /// Speed of the input coordinate with its sign, rad/s or m/s.
    Speed,
}

/// Rows (argument, value), arguments not decreasing; two rows with one argument make a jump. Never empty.
#[derive(Debug, Clone, PartialEq)]
pub struct LawTable {
    /// The rows.
    pub rows: Vec<[f64; 2]>,
    /// How values between two rows are found.
    pub shape: Shape,
}

/// How values between two rows of a table are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// By linear interpolation.
    Linear,
    /// The value of the row before.
    Step,
}

impl LawTable {
    /// A table with one constant value.
    pub fn constant(value: f64) -> Self {
        Self { rows: vec![[0.0, value]], shape: Shape::Linear }
    }

    /// The same function of the opposite argument: `mirrored().at(-x)` is `at(x)`, except on a jump, where it is the value
    /// before it.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let mut rows: Vec<[f64; 2]> = Vec::with_capacity(2 * self.rows.len());
        for (i, [x, y]) in self.rows.iter().enumerate().rev() {
            rows.push([-x, *y]);
            // A step of the mirrored table would hold the value of the wrong row.
            if let (Shape::Step, Some(before)) = (self.shape, i.checked_sub(1)) {
                rows.push([-x, self.rows[before][1]]);
            }
        }
        Self { rows, shape: Shape::Linear }
    }

    /// Index of the segment that contains `x`: the number of rows at or before it. At a jump, the segment after it.
    pub fn segment(&self, x: f64) -> usize {
        self.rows.partition_point(|row| row[0] <= x)
    }

    /// Value at `x` by the formula of `segment`, which may be extrapolated.
    pub fn at_segment(&self, segment: usize, x: f64) -> f64 {
        if segment == 0 {
            return self.rows[0][1];
        }
        let [x0, y0] = self.rows[segment - 1];
        match self.rows.get(segment) {
            Some(&[x1, y1]) if self.shape == Shape::Linear => y0 + (y1 - y0) * ((x - x0) / (x1 - x0)),
            _ => y0,
        }
    }

    /// Value at `x`: beyond the table that of the nearest end, at a jump the value after it.
    pub fn at(&self, x: f64) -> f64 {
        self.at_segment(self.segment(x), x)
    }
}
