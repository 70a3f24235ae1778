//! The linear system of a group: dense on the stack for up to 8 links, sparse beyond.

use assur_number::Real;
use assur_number::elimination::{Factored, Lu, SparseLu};

use crate::plane::{direction, minus, vector};
use crate::{Body, Driven, GroupError, GroupFrame, Pair, PairGeometry};

/// The factored matrix J of a group, or its transpose.
pub(crate) trait Solver<T: Real>: Sized {
    /// A vector of unknowns or right-hand sides.
    type Vector: AsRef<[T]> + AsMut<[T]>;

    /// Factors J of a placed group.
    fn factor(frame: &GroupFrame, bodies: &[Body<T>], is_transposed: bool) -> Self;

    fn zeros(frame: &GroupFrame) -> Self::Vector;

    /// The solution for a right-hand side.
    fn solve(&self, right: &Self::Vector) -> Self::Vector;

    /// Pivots and sign of the determinant.
    fn factored(&self) -> Factored;

    /// An error for a singular matrix.
    fn determined(&self) -> Result<(), GroupError> {
        GroupError::if_singular(self.factored().health)
    }
}

impl<T: Real, const N: usize> Solver<T> for Lu<T, N> {
    type Vector = [T; N];

    fn factor(frame: &GroupFrame, bodies: &[Body<T>], is_transposed: bool) -> Self {
        let mut matrix = [[T::ZERO; N]; N];
        for (i, line) in matrix.iter_mut().enumerate().skip(3 * frame.links.len()) {
            line[i] = T::ONE;
        }
        entries(frame, bodies, |row, column, entry| {
            let (row, column) = if is_transposed { (column, row) } else { (row, column) };
            matrix[row][column] = entry;
        });
        Self::new(matrix)
    }

    fn zeros(_: &GroupFrame) -> [T; N] {
        [T::ZERO; N]
    }

    fn solve(&self, right: &[T; N]) -> [T; N] {
        self.solve(right)
    }

    fn factored(&self) -> Factored {
        self.factored
    }
}

impl<T: Real> Solver<T> for SparseLu<T> {
    type Vector = Vec<T>;

    fn factor(frame: &GroupFrame, bodies: &[Body<T>], is_transposed: bool) -> Self {
        let mut rows = vec![Vec::new(); 3 * frame.links.len()];
        entries(frame, bodies, |row, column, entry| {
            let (row, column) = if is_transposed { (column, row) } else { (row, column) };
            rows[row].push((column, entry));
        });
        Self::new(rows)
    }

    fn zeros(frame: &GroupFrame) -> Vec<T> {
        vec![T::ZERO; 3 * frame.links.len()]
    }

    fn solve(&self, right: &Vec<T>) -> Vec<T> {
        self.solve(right)
    }

    fn factored(&self) -> Factored {
        self.factored
    }
}

/// Unit vector along the guide of a slide, in the frame of the ground.
pub(crate) fn guide<T: Real>(bodies: &[Body<T>], carrier: usize, angle: f64) -> [T; 2] {
    bodies[carrier].turned(direction(angle))
}

/// Arms of the point of application of a pair, on `a` and on `b`. A slide acts at the point of `a`.
pub(crate) fn arms<T: Real>(pair: &Pair, bodies: &[Body<T>]) -> ([T; 2], [T; 2]) {
    match pair.geometry {
        PairGeometry::Pin { at_a, at_b } => {
            (bodies[pair.a].arm(vector(at_a)), bodies[pair.b].arm(vector(at_b)))
        }
        PairGeometry::Slide { point, .. } => {
            let on_a = bodies[pair.a].arm(vector(point));
            (on_a, minus(bodies[pair.a].point(vector(point)), bodies[pair.b].origin()))
        }
    }
}

/// The two constraint directions of a pair: for a pin x and y; for a slide the normal of its guide, and the angle.
pub(crate) fn rows<T: Real>(pair: &Pair, bodies: &[Body<T>]) -> [Option<[T; 2]>; 2] {
    match pair.geometry {
        PairGeometry::Pin { .. } => [Some([T::ONE, T::ZERO]), Some([T::ZERO, T::ONE])],
        PairGeometry::Slide { angle, .. } => {
            let [c, s] = guide(bodies, pair.b, angle);
            [Some([-s, c]), None]
        }
    }
}

/// The direction of the constraint by which a driven pair follows its coordinate: of a slide along its guide; `None`: the angle of a pin.
pub(crate) fn driven_row<T: Real>(driven: &Driven, bodies: &[Body<T>]) -> Option<[T; 2]> {
    match driven.pair.geometry {
        PairGeometry::Pin { .. } => None,
        PairGeometry::Slide { angle, .. } => Some(guide(bodies, driven.pair.b, angle)),
    }
}

/// The coefficients in a constraint of a pair of the velocities of `a` and of `b`, as in [`constraints`].
fn coefficients<T: Real>(
    direction: Option<[T; 2]>,
    (on_a, on_b): ([T; 2], [T; 2]),
    inverse_scale: T,
) -> [[T; 3]; 2] {
    [(on_a, T::ONE), (on_b, -T::ONE)].map(|(arm, sign)| match direction {
        Some([nx, ny]) => [sign * nx, sign * ny, sign * (ny * arm[0] - nx * arm[1]) * inverse_scale],
        None => [T::ZERO, T::ZERO, sign],
    })
}

/// The two constraints of a pair: for each the coefficients in it of the velocities of `a` and of `b`, of the origin in units of
/// the scale and of the rotation.
pub fn constraints<T: Real>(pair: &Pair, bodies: &[Body<T>], scale: f64) -> [[[T; 3]; 2]; 2] {
    let inverse_scale = T::ONE / T::from_f64(scale);
    let arms = arms(pair, bodies);
    rows(pair, bodies).map(|direction| coefficients(direction, arms, inverse_scale))
}

/// The constraint by which a driven pair follows its coordinate, as [`constraints`].
pub fn driven_constraint<T: Real>(driven: &Driven, bodies: &[Body<T>], scale: f64) -> [[T; 3]; 2] {
    let arms = arms(&driven.pair, bodies);
    coefficients(driven_row(driven, bodies), arms, T::ONE / T::from_f64(scale))
}

/// Calls a function with each entry of J in units of the scale that may differ from 0: row, column, entry.
pub(crate) fn entries<T: Real>(frame: &GroupFrame, bodies: &[Body<T>], mut put: impl FnMut(usize, usize, T)) {
    let is_zero = |entry: T| entry.abs().greatest() == 0.0;
    let mut next = 0;
    let mut put_row = |pair: &Pair, sides: [[T; 3]; 2]| {
        for (body, entries) in [pair.a, pair.b].into_iter().zip(sides) {
            let Some(column) = frame.column(body) else { continue };
            let entries = entries.into_iter().enumerate().filter(|(_, entry)| !is_zero(*entry));
            entries.for_each(|(i, entry)| put(next, 3 * column + i, entry));
        }
        next += 1;
    };
    for pair in frame.pairs() {
        for sides in constraints(pair, bodies, frame.scale) {
            put_row(pair, sides);
        }
    }
    for driven in &frame.driven {
        put_row(&driven.pair, driven_constraint(driven, bodies, frame.scale));
    }
}
