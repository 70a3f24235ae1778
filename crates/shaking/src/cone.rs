//! The least maximum of the magnitudes of forces that depend linearly on a few unknowns, and the proof that it is the least.
//!
//! The problem is convex: find w and the least t with `|F_i + B_i w| <= t`, a program of second-order cones. It is solved
//! with its dual by an interior-point method with the scaling of Nesterov and Todd (Andersen, Roos, Terlaky, On
//! implementing a primal-dual interior-point method for conic quadratic optimization, 2003; Vandenberghe, The CVXOPT linear
//! and quadratic cone program solvers, 2010).
//!
//! The proof are forces `y_i` with `sum |y_i| = 1`: for every w, the greatest magnitude of `F_i + B_i w` is at least
//! `sum y_i (F_i + B_i w)`, which is the same for all w where `sum B_i y_i = 0`.

use assur_number::elementary;
use nalgebra::{DMatrix, DVector};

/// Greatest number of steps; about fifteen are needed.
const MOST_STEPS: usize = 60;

/// Part of the way to the boundary of the cones that a step takes.
const INSIDE: f64 = 0.99;

/// A shorter step no longer moves anything but rounding.
const SHORTEST: f64 = 1e-8;

/// The unknowns that make the greatest magnitude of some forces least.
pub(crate) struct Least {
    pub(crate) unknowns: DVector<f64>,
    /// No unknowns make the greatest magnitude less than this.
    pub(crate) bound: f64,
}

/// Makes the greatest magnitude of the forces of `rows`, which are of size 1, least, from any start. `radius` is a bound of the magnitude of the best unknowns; what is
/// missing between maximum and bound is at most `missing`, if rounding permits.
pub(crate) fn least_maximum(rows: &[LinearForce], start: &DVector<f64>, radius: f64, missing: f64) -> Least {
    let mut points = Points::above(rows, start);
    let mut least = Least { unknowns: start.clone(), bound: 0.0 };
    let mut greatest = f64::INFINITY;
    for _ in 0..MOST_STEPS {
        let found = points.point.rows(1, start.len()).into_owned();
        let modulus = rows.iter().map(|row| row.at(found.as_slice())).map(|[x, y]| elementary::hypot(x, y));
        let here = modulus.fold(0.0, f64::max);
        least.bound = least.bound.max(bound(rows, &points.dual, radius));
        if here < greatest {
            (greatest, least.unknowns) = (here, found);
        }
        if greatest - least.bound <= missing || points.advance(rows).is_none() {
            break;
        }
    }
    least
}

/// A point strictly inside all cones, and one inside those of the dual.
struct Points {
    /// t and the unknowns.
    point: DVector<f64>,
    dual: Vec<Cone>,
}

impl Points {
    fn above(rows: &[LinearForce], start: &DVector<f64>) -> Self {
        let modulus = rows.iter().map(|row| row.at(start.as_slice())).map(|[x, y]| elementary::hypot(x, y));
        let most = modulus.fold(0.0, f64::max);
        let point =
            DVector::from_iterator(1 + start.len(), [1.5 * most].into_iter().chain(start.iter().copied()));
        Self { point, dual: vec![[1.0 / rows.len() as f64, 0.0, 0.0]; rows.len()] }
    }

    /// A predictor and a corrector step; `None` where rounding permits none.
    fn advance(&mut self, rows: &[LinearForce]) -> Option<()> {
        let newton = Newton::at(self, rows)?;
        let affine: Vec<Cone> = newton.scaled.iter().map(|&at| at.map(|part| -part)).collect();
        let predicted = newton.direction(rows, &affine)?;
        let left = 1.0 - newton.longest(&predicted).min(1.0);
        let center = left.powi(3) * newton.mean;
        let each = newton.scaled.iter().zip(&predicted.cones);
        let corrected = each.map(|(&at, &[slack, dual])| {
            let (square, change) = (product(at, at), product(slack, dual));
            let wanted = [center - square[0] - change[0], -square[1] - change[1], -square[2] - change[2]];
            quotient(at, wanted)
        });
        let step = newton.direction(rows, &corrected.collect::<Vec<_>>())?;
        let length = (INSIDE * newton.longest(&step)).min(1.0);
        if length.is_nan() || length < SHORTEST {
            return None;
        }
        self.point.axpy(length, &step.point, 1.0);
        for ((dual, scaling), [_, change]) in self.dual.iter_mut().zip(&newton.scalings).zip(&step.cones) {
            let change = scaling.divided(*change);
            *dual = [0, 1, 2].map(|i| dual[i] + length * change[i]);
        }
        Some(())
    }
}

/// Newton's equations at a point, scaled.
struct Newton {
    scalings: Vec<Scaling>,
    /// Slack and dual after scaling, where they are one.
    scaled: Vec<Cone>,
    /// Mean product of slack and dual.
    mean: f64,
    /// The scaled rows, decomposed.
    orthogonal: DMatrix<f64>,
    triangular: DMatrix<f64>,
    /// What the dual point lacks in feasibility.
    lacks: DVector<f64>,
}

/// A step of t and unknowns, and what it makes of the scaled slack and dual of each cone.
struct Step {
    point: DVector<f64>,
    cones: Vec<[Cone; 2]>,
}

impl Newton {
    fn at(points: &Points, rows: &[LinearForce]) -> Option<Self> {
        let size = points.point.len();
        let mut matrix = DMatrix::zeros(3 * rows.len(), size);
        let mut lacks = DVector::zeros(size);
        lacks[0] = 1.0;
        let (mut scalings, mut scaled, mut mean) = (Vec::new(), Vec::new(), 0.0);
        for (i, (row, &dual)) in rows.iter().zip(&points.dual).enumerate() {
            let slack = row.cone(&points.point);
            let scaling = Scaling::of(slack, dual)?;
            let columns = row.columns.iter().map(|&[x, y]| [0.0, x, y]);
            for (j, column) in std::iter::once([1.0, 0.0, 0.0]).chain(columns).enumerate() {
                lacks[j] -= dot(column, dual);
                for (k, part) in scaling.divided(column).into_iter().enumerate() {
                    matrix[(3 * i + k, j)] = part;
                }
            }
            mean += dot(slack, dual) / rows.len() as f64;
            scaled.push(scaling.times(dual));
            scalings.push(scaling);
        }
        let (orthogonal, triangular) = matrix.qr().unpack();
        Some(Self { scalings, scaled, mean, orthogonal, triangular, lacks })
    }

    /// The step after which slack and dual, scaled, have changed by `wanted` together, and the dual is feasible.
    fn direction(&self, rows: &[LinearForce], wanted: &[Cone]) -> Option<Step> {
        let wanted_all = DVector::from_iterator(3 * wanted.len(), wanted.iter().flatten().copied());
        let mut point = self.triangular.tr_solve_upper_triangular(&self.lacks)?;
        point = self.orthogonal.tr_mul(&wanted_all) - point;
        let point = self.triangular.solve_upper_triangular(&point)?;
        let each = rows.iter().zip(&self.scalings).zip(wanted);
        let cones = each.map(|((row, scaling), wanted)| {
            let slack = scaling.divided(row.step(&point));
            [slack, [0, 1, 2].map(|i| wanted[i] - slack[i])]
        });
        let cones = cones.collect();
        Some(Step { point, cones })
    }

    /// How far a step stays inside all cones.
    fn longest(&self, step: &Step) -> f64 {
        let each = self.scaled.iter().zip(&step.cones);
        each.flat_map(|(&at, step)| step.map(|step| most(at, step))).fold(f64::INFINITY, f64::min)
    }
}

fn dot(a: Cone, b: Cone) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The product of Jordan's algebra of the cone.
fn product(a: Cone, b: Cone) -> Cone {
    [dot(a, b), a[0] * b[1] + b[0] * a[1], a[0] * b[2] + b[0] * a[2]]
}

/// What gives `b` when it is multiplied by `a`.
fn quotient(a: Cone, b: Cone) -> Cone {
    let first = (a[0] * b[0] - a[1] * b[1] - a[2] * b[2]) / inner(a);
    [first, (b[1] - first * a[1]) / a[0], (b[2] - first * a[2]) / a[0]]
}

/// A magnitude and a vector; inside the cone the magnitude is greater than that of the vector.
pub(crate) type Cone = [f64; 3];

/// The square of the magnitude less that of the vector.
pub(crate) fn inner([t, x, y]: Cone) -> f64 {
    let size = elementary::hypot(x, y);
    (t - size) * (t + size)
}

/// How many steps a point inside the cone stays in it.
pub(crate) fn most(at: Cone, step: Cone) -> f64 {
    let cross = at[0] * step[0] - at[1] * step[1] - at[2] * step[2];
    // Zero of inner(at + part step), by its reciprocal.
    let root = cross * cross - inner(at) * inner(step);
    let reciprocal = if root >= 0.0 { root.sqrt() - cross } else { 0.0 };
    if reciprocal > 0.0 { inner(at) / reciprocal } else { f64::INFINITY }
}

/// The map W of the cone onto itself with `W dual = W⁻¹ slack`.
pub(crate) struct Scaling {
    size: f64,
    axis: Cone,
}

impl Scaling {
    /// `None` where slack or dual are not strictly inside their cones.
    pub(crate) fn of(slack: Cone, dual: Cone) -> Option<Self> {
        let inside = |at: Cone| at[0] > 0.0 && inner(at) > 0.0;
        if !(inside(slack) && inside(dual)) {
            return None;
        }
        let [s, z] = [slack, dual].map(|at| at.map(|part| part / inner(at).sqrt()));
        let middle = (0.5 * (1.0 + s[0] * z[0] + s[1] * z[1] + s[2] * z[2])).sqrt();
        let axis = [s[0] + z[0], s[1] - z[1], s[2] - z[2]].map(|part| 0.5 * part / middle);
        Some(Self { size: (inner(slack) / inner(dual)).sqrt().sqrt(), axis })
    }

    /// W v.
    pub(crate) fn times(&self, v: Cone) -> Cone {
        turned(self.axis, v).map(|part| self.size * part)
    }

    /// W⁻¹ v.
    pub(crate) fn divided(&self, v: Cone) -> Cone {
        let [t, x, y] = self.axis;
        turned([t, -x, -y], v).map(|part| part / self.size)
    }
}

/// The hyperbolic rotation with an axis of inner product 1.
fn turned([t, x, y]: Cone, [a, b, c]: Cone) -> Cone {
    let along = x * b + y * c;
    let more = a + along / (1.0 + t);
    [t * a + along, b + x * more, c + y * more]
}

/// Parts of the greatest force of the dual point below which a row may be left out of the proof.
const SHARES: [f64; 4] = [0.0, 1e-6, 1e-4, 1e-2];

/// A force as a linear function of the unknowns: `force + columns w`, columns as x and y.
pub(crate) struct LinearForce {
    pub(crate) force: [f64; 2],
    /// What each unknown adds, along x and along y.
    pub(crate) columns: Vec<[f64; 2]>,
}

impl LinearForce {
    pub(crate) fn at(&self, unknowns: &[f64]) -> [f64; 2] {
        let each = self.columns.iter().zip(unknowns);
        each.fold(self.force, |sum, (column, w)| [sum[0] + column[0] * w, sum[1] + column[1] * w])
    }

    /// The cone of t and force.
    pub(crate) fn cone(&self, point: &DVector<f64>) -> Cone {
        let [x, y] = self.at(&point.as_slice()[1..]);
        [point[0], x, y]
    }

    /// What a step of t and the unknowns adds to the cone.
    pub(crate) fn step(&self, step: &DVector<f64>) -> Cone {
        let [x, y] = self.at(&step.as_slice()[1..]);
        [step[0], x - self.force[0], y - self.force[1]]
    }
}

/// The best bound that a dual point proves for all unknowns of a magnitude up to `radius`, with all its rows or with those alone
/// that have a share in it.
pub(crate) fn bound(rows: &[LinearForce], dual: &[Cone], radius: f64) -> f64 {
    let size = |[_, x, y]: Cone| elementary::hypot(x, y);
    let most = dual.iter().copied().map(size).fold(0.0, f64::max);
    let bound = |share: f64| {
        let shared = rows.iter().zip(dual).filter(|(_, dual)| size(**dual) >= share * most);
        Shares::of(shared.map(|(row, [_, x, y])| (row, [-x, -y]))).bound(radius)
    };
    SHARES.into_iter().map(bound).fold(0.0, f64::max)
}

/// Forces y at some rows that prove a bound.
struct Shares<'r> {
    rows: Vec<&'r LinearForce>,
    forces: Vec<[f64; 2]>,
}

impl<'r> Shares<'r> {
    fn of(all: impl Iterator<Item = (&'r LinearForce, [f64; 2])>) -> Self {
        let (rows, forces) = all.unzip();
        let mut shares = Self { rows, forces };
        shares.balance();
        shares
    }

    /// The sums `sum B_i y_i`, one for each unknown: a proof needs them to be zero.
    fn left(&self) -> DVector<f64> {
        let unknowns = self.rows.first().map_or(0, |row| row.columns.len());
        let mut left = DVector::zeros(unknowns);
        for (row, [x, y]) in self.rows.iter().zip(&self.forces) {
            for (left, column) in left.iter_mut().zip(&row.columns) {
                *left += x * column[0] + y * column[1];
            }
        }
        left
    }

    /// The least change of the forces, in parts of each, that leaves nothing for the unknowns. The bound changes by the square
    /// of it only, since the dual is at its greatest.
    fn balance(&mut self) {
        let left = self.left();
        let weights: Vec<f64> = self.forces.iter().map(|[x, y]| elementary::hypot(*x, *y).sqrt()).collect();
        let matrix = DMatrix::from_fn(left.len(), 2 * self.rows.len(), |unknown, at| {
            weights[at / 2] * self.rows[at / 2].columns[unknown][at % 2]
        });
        let decomposed = matrix.svd(true, true);
        let least =
            f64::EPSILON * left.len() as f64 * decomposed.singular_values.iter().copied().fold(0.0, f64::max);
        let Ok(change) = decomposed.solve(&left, least) else { return };
        for (i, force) in self.forces.iter_mut().enumerate() {
            *force = [0, 1].map(|axis| force[axis] - weights[i] * change[2 * i + axis]);
        }
    }

    /// The greatest magnitude is at least this for all unknowns of a magnitude up to `radius`.
    fn bound(&self, radius: f64) -> f64 {
        let size: f64 = self.forces.iter().map(|[x, y]| elementary::hypot(*x, *y)).sum();
        let each = self.rows.iter().zip(&self.forces);
        let work: f64 = each.map(|(row, [x, y])| x * row.force[0] + y * row.force[1]).sum();
        if size > 0.0 { (work - radius * self.left().norm()) / size } else { 0.0 }
    }
}

#[cfg(test)]
mod tests;
