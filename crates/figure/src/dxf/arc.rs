//! Arcs that are drawn as points.

use std::f64::consts::{PI, TAU};

use crate::model::Point;

/// Fewest points that are taken for an arc: fewer are a polygon.
const FEWEST: usize = 9;
/// Relative tolerance of radii and steps.
const SAME: f64 = 1e-9;

/// An arc; y grows as that of its points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Arc {
    pub(super) center: Point,
    pub(super) radius: f64,
    /// The angle of its first point, and how far it goes, rad.
    pub(super) from: f64,
    pub(super) along: f64,
}

impl Arc {
    pub(super) fn is_circle(&self) -> bool {
        (self.along.abs() - TAU).abs() <= SAME
    }

    /// The arc through points that lie on a circle at equal steps.
    pub(super) fn through(points: &[Point]) -> Option<Self> {
        let count = points.len();
        if count < FEWEST {
            return None;
        }
        let center = center([points[0], points[count / 3], points[2 * count / 3]])?;
        let of = |at: &Point| [at[0] - center[0], at[1] - center[1]];
        let radius = points.iter().map(|at| of(at)[0].hypot(of(at)[1])).sum::<f64>() / count as f64;
        let is_on = |at: &Point| (of(at)[0].hypot(of(at)[1]) - radius).abs() <= SAME * radius;
        let step = |two: &[Point]| {
            let [[a, b], [c, d]] = [of(&two[0]), of(&two[1])];
            (a * d - b * c).atan2(a * c + b * d)
        };
        let first = step(&points[..2]);
        let is_even = points.windows(2).all(|two| (step(two) - first).abs() <= SAME * PI);
        let along = first * (count - 1) as f64;
        let from = of(&points[0])[1].atan2(of(&points[0])[0]);
        let is_once = first != 0.0 && along.abs() <= TAU + SAME;
        (points.iter().all(is_on) && is_even && is_once).then_some(Self { center, radius, from, along })
    }
}

/// The center of the circle through three points; `None` where they lie in a line.
fn center([a, b, c]: [Point; 3]) -> Option<Point> {
    let [bx, by] = [b[0] - a[0], b[1] - a[1]];
    let [cx, cy] = [c[0] - a[0], c[1] - a[1]];
    let area = 2.0 * (bx * cy - by * cx);
    let (bb, cc) = (bx * bx + by * by, cx * cx + cy * cy);
    if area.abs() <= SAME * bb.max(cc) {
        return None;
    }
    let at = [a[0] + (cy * bb - by * cc) / area, a[1] + (bx * cc - cx * bb) / area];
    (at[0].is_finite() && at[1].is_finite()).then_some(at)
}
