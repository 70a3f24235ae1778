//! Loads: what acts on the links, and by which law its size changes.

use crate::{LinkId, Place};

/// A number, or a law by which it changes.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// Always the same.
    Constant(f64),
    /// Follows a table over one quantity.
    Table {
        /// The quantity.
        over: Over,
        /// The table.
        table: Table,
        /// Over the coordinate: whether the table repeats with the cycle, counted from its first row.
        repeat: bool,
    },
    /// Follows the stroke of the load's point along an axis of the ground.
    Stroke {
        /// Direction of the axis, rad.
        axis: f64,
        /// Over 0 to 1 (place between the extremes) while the point moves along the axis.
        forward: Table,
        /// The same while it returns.
        back: Table,
    },
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

/// Rows (argument, value), arguments not decreasing; two rows of one argument make a jump. Never empty.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// The rows.
    pub rows: Vec<[f64; 2]>,
    /// What holds between two rows.
    pub shape: Shape,
}

/// What holds between two rows of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// A straight line.
    Linear,
    /// The left value.
    Step,
}

impl Table {
    /// A table that always has one value.
    pub fn constant(value: f64) -> Self {
        Self { rows: vec![[0.0, value]], shape: Shape::Linear }
    }

    /// Index of the segment that holds `x`: the number of rows at or before it. At a jump, the segment after it.
    pub fn segment(&self, x: f64) -> usize {
        self.rows.partition_point(|row| row[0] <= x)
    }

    /// Value at `x` by the formula of `segment`, also beyond its ends.
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

    /// Value at `x`; the end values hold outside; at a jump the value after it.
    pub fn at(&self, x: f64) -> f64 {
        self.at_segment(self.segment(x), x)
    }
}

/// A force at a point of a link.
#[derive(Debug, Clone, PartialEq)]
pub struct Force {
    /// Name for reports: the scene's, or one made from its link.
    pub name: String,
    /// Point of application.
    pub at: Place,
    /// Where it points.
    pub direction: Direction,
    /// Its size, N.
    pub value: Value,
}

/// Direction of a force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Direction {
    /// Angle in the frame of the ground, rad.
    Ground(f64),
    /// Angle in the frame of the loaded link, rad.
    Link(f64),
    /// Always opposite to the velocity of the point; no force while the point stands.
    AgainstMotion,
}

/// A moment on a link.
#[derive(Debug, Clone, PartialEq)]
pub struct Moment {
    /// Name for reports.
    pub name: String,
    /// The link.
    pub link: LinkId,
    /// Its size, N m, counter-clockwise positive.
    pub value: Value,
}

/// A spring with a damper between points of two links.
#[derive(Debug, Clone, PartialEq)]
pub struct Spring {
    /// Name for reports.
    pub name: String,
    /// Its ends.
    pub ends: [Place; 2],
    /// Stiffness, N/m.
    pub stiffness: f64,
    /// Free length, m.
    pub length: f64,
    /// Damping along the line between the ends, N s/m.
    pub damping: f64,
}

/// An arc of a link that rolls and slides along a straight line of the ground.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    /// Name for reports.
    pub name: String,
    /// Center N of the arc.
    pub center: Place,
    /// Radius R, m.
    pub radius: f64,
    /// Angle a, rad: the force acts at K = N + R (-sin a, -cos a).
    pub angle: f64,
    /// F, N, along (sin a, cos a) on the link.
    pub force: Value,
    /// f: adds f F along (cos a, -sin a).
    pub friction: f64,
    /// Interval of the input coordinate in which there is contact; `None`: always.
    pub during: Option<[f64; 2]>,
}

/// Where the balancing load acts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Balance {
    /// A force at a place, along this direction of the ground, rad.
    Force {
        /// Point of application.
        at: Place,
        /// Direction, rad.
        angle: f64,
    },
    /// A moment on a link.
    Moment(LinkId),
}
