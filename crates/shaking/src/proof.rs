//! The proof that no unknowns make the greatest of some forces less: forces `y_i` with `sum |y_i| = 1`. For every w, the greatest
//! modulus of `F_i + B_i w` is at least `sum y_i (F_i + B_i w)`, which is the same for all w where `sum B_i y_i = 0`.

use nalgebra::{DMatrix, DVector};

use crate::cone::Cone;

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

/// The best bound that a dual point proves for all unknowns of a modulus up to `radius`, with all its rows or with those alone
/// that have a share in it.
pub(crate) fn bound(rows: &[LinearForce], dual: &[Cone], radius: f64) -> f64 {
    let size = |[_, x, y]: Cone| x.hypot(y);
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
        let weights: Vec<f64> = self.forces.iter().map(|[x, y]| x.hypot(*y).sqrt()).collect();
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

    /// The greatest modulus is at least this for all unknowns of a modulus up to `radius`.
    fn bound(&self, radius: f64) -> f64 {
        let size: f64 = self.forces.iter().map(|[x, y]| x.hypot(*y)).sum();
        let each = self.rows.iter().zip(&self.forces);
        let work: f64 = each.map(|(row, [x, y])| x * row.force[0] + y * row.force[1]).sum();
        if size > 0.0 { (work - radius * self.left().norm()) / size } else { 0.0 }
    }
}
