//! Links in given poses and the pairs that are put between them, the basis of samples and specimens.

use assur_group::{PairSort, Pattern};
use nalgebra::DMatrix;

use crate::Rng;

/// Pose of a link.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pose {
    /// Origin of the link's frame, x, m.
    pub(crate) x: f64,
    /// Origin of the link's frame, y, m.
    pub(crate) y: f64,
    /// Angle of its x axis, rad.
    pub(crate) angle: f64,
}

impl Pose {
    /// Position of a point of the link in the ground's frame.
    pub(crate) fn world(&self, at: [f64; 2]) -> [f64; 2] {
        let (s, c) = self.angle.sin_cos();
        [self.x + c * at[0] - s * at[1], self.y + s * at[0] + c * at[1]]
    }

    /// The point of the link that is at a place of the ground's frame.
    pub(crate) fn local(&self, world: [f64; 2]) -> [f64; 2] {
        let (s, c) = self.angle.sin_cos();
        let [dx, dy] = [world[0] - self.x, world[1] - self.y];
        [c * dx + s * dy, c * dy - s * dx]
    }
}

/// A pair that joins two bodies in their given poses.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Join {
    /// The bodies; of an outer pair the link of the group first.
    pub(crate) bodies: [usize; 2],
    /// The pin, or a point of the guide, in the ground's frame, m.
    pub(crate) at: [f64; 2],
    /// Direction of the guide in the ground's frame, rad; `None` for a pin.
    pub(crate) guide: Option<f64>,
}

/// The pairs of a pattern as bodies and sorts, in the order inner, outer. Pairs of either sort are drawn, one in
/// three as a slide.
pub(crate) fn drawn_pairs(
    rng: &mut Rng,
    pattern: &Pattern,
    links: &[usize],
    outside: &[usize],
) -> Vec<([usize; 2], bool)> {
    let inner = pattern.inner.iter().map(|(ends, sort)| (ends.map(|end| links[end]), sort));
    let outer = pattern.outer.iter().zip(outside).map(|((link, sort), body)| ([links[*link], *body], sort));
    let is_slide = |sort: &PairSort| match sort {
        PairSort::Pin => false,
        PairSort::Slide => true,
        PairSort::Any => rng.chance(1.0 / 3.0),
    };
    let mut is_slide = is_slide;
    inner.chain(outer).map(|(bodies, sort)| (bodies, is_slide(sort))).collect()
}

/// The matrix of the constraints of a group in a given arrangement, two rows for each pair and three columns for each
/// link; lengths in units of `size`. Derived from the places of the pairs alone, independently of the program's equations.
pub(crate) fn constraints(
    links: &[usize],
    joins: &[Join],
    origin: impl Fn(usize) -> [f64; 2],
    size: f64,
) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(2 * joins.len(), 3 * links.len());
    for (k, join) in joins.iter().enumerate() {
        for (body, sign) in [(join.bodies[0], 1.0), (join.bodies[1], -1.0)] {
            let Some(column) = links.iter().position(|&link| link == body) else { continue };
            let from = origin(body);
            let arm = [(join.at[0] - from[0]) / size, (join.at[1] - from[1]) / size];
            let mut row = |row: usize, entries: [f64; 3]| {
                for (i, entry) in entries.into_iter().enumerate() {
                    matrix[(row, 3 * column + i)] = sign * entry;
                }
            };
            if let Some(guide) = join.guide {
                let (s, c) = guide.sin_cos();
                row(2 * k, [-s, c, c * arm[0] + s * arm[1]]);
                row(2 * k + 1, [0.0, 0.0, 1.0]);
            } else {
                row(2 * k, [1.0, 0.0, -arm[1]]);
                row(2 * k + 1, [0.0, 1.0, arm[0]]);
            }
        }
    }
    matrix
}

/// Smallest over greatest singular value of the matrix of constraints: 0 at a singular position.
pub(crate) fn regularity(matrix: &DMatrix<f64>) -> f64 {
    let values = matrix.singular_values();
    values.min() / values.max()
}
