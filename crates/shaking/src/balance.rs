//! The counterweights that make the shaking force least, in the mean square or at its greatest.

use assur_kinematics::PositionError;
use assur_number::{ROUNDING, elementary};
use nalgebra::{DMatrix, DVector};

use crate::cone::{LinearForce, least_maximum};
use crate::course::ShakingCourse;
use crate::data::Proof;
use crate::samples::Sample;

/// Part of the greatest singular value below which counterweights on several links replace each other; the smallest of
/// them are then taken.
const DEPENDENT: f64 = 1e-10;

/// What the least maximum may lack, as a part of it: a thousandth of the last of six printed digits. The rounding of the
/// forces, a thousand times less, does not reach it.
const GAP: f64 = 1e-9;

/// How often places of greatest force are added: their number grows by a few each time, and their places settle
/// quadratically, so that about six times are enough.
const MOST_ROUNDS: usize = 40;

/// Of this many samples one is in the problem from its beginning, so that all unknowns are determined.
const SPREAD: usize = 24;

/// Counterweights on some links, and how the forces depend on them.
pub(crate) struct Fit {
    /// Greatest force without counterweights, N.
    force: f64,
    /// Greatest sum of the magnitudes of the terms of the force, N.
    terms: f64,
    /// Greatest force of a counterweight of 1 kg m along each axis, over the greatest force without counterweights.
    scales: Vec<f64>,
    /// The unknowns that make the mean square least.
    least_squares: DVector<f64>,
    /// The map from independent unknowns w, scaled so that their forces have the mean square |w|² over the samples, to all
    /// unknowns.
    map: DMatrix<f64>,
    carriers: usize,
}

impl Fit {
    /// The fit of counterweights on the first `carriers` links, over samples that are equally spaced; `None` without any force.
    pub(crate) fn of(samples: &[Sample], carriers: usize) -> Option<Self> {
        let mut rows: Vec<LinearForce> = samples.iter().map(|sample| plain(sample, carriers)).collect();
        // Forces and columns of size 1, so that neither units nor lengths matter.
        let size = |value: [f64; 2]| elementary::hypot(value[0], value[1]);
        let force = rows.iter().map(|row| size(row.force)).fold(0.0, f64::max);
        if force == 0.0 {
            return None;
        }
        let scales: Vec<f64> = (0..2 * carriers)
            .map(|i| rows.iter().map(|row| size(row.columns[i])).fold(0.0, f64::max))
            .map(|greatest| if greatest > 0.0 { force / greatest } else { 0.0 })
            .collect();
        for row in &mut rows {
            scale(row, force, &scales);
        }
        let (least_squares, map) = decomposed(&rows, 2 * carriers);
        let terms = samples.iter().map(|sample| sample.terms.force).fold(0.0, f64::max);
        Some(Self { force, terms, scales, least_squares, map, carriers })
    }

    /// Mass times radius of each counterweight, kg m, in the frame of its link.
    fn products(&self, unknowns: &DVector<f64>) -> Vec<[f64; 2]> {
        let product = |i: usize| unknowns[i] * self.scales[i];
        (0..self.carriers).map(|i| [product(2 * i), product(2 * i + 1)]).collect()
    }

    /// The counterweights that make the mean square least.
    pub(crate) fn least_squares(&self) -> Vec<[f64; 2]> {
        self.products(&self.least_squares)
    }

    /// The counterweights that make the maximum over the cycle least, and the proof: places of greatest force, found
    /// between samples, are added to the problem until no force in the cycle is above the bound by more than the gap.
    pub(crate) fn least_maximum(
        &self,
        course: &mut ShakingCourse<'_, '_>,
    ) -> Result<(Vec<[f64; 2]>, Proof), PositionError> {
        let carriers = course.sampler.carriers.clone();
        let mut rows: Vec<LinearForce> =
            course.samples.iter().step_by(SPREAD).map(|at| self.row(at)).collect();
        let mut unknowns = DVector::zeros(self.map.ncols());
        let mut products = self.least_squares();
        let (mut best, mut greatest, mut bound) = (products.clone(), f64::INFINITY, 0.0);
        for _ in 0..MOST_ROUNDS {
            let force = |at: &Sample| {
                let [x, y] = at.balanced(&carriers, &products).0;
                elementary::hypot(x, y)
            };
            let tops = course.tops(force)?;
            let most = tops.iter().map(force).fold(0.0, f64::max);
            if most < greatest {
                (greatest, best) = (most, products);
            }
            if greatest - bound <= GAP * self.measure(greatest) {
                break;
            }
            rows.extend(tops.iter().map(|top| self.row(top)));
            // The mean square of the unknowns is that of the forces B w, each at most |F + B w| and |F| together: with the best
            // unknowns no more than the greatest force found, and 1.
            let radius = 1.0 + greatest / self.force;
            let missing = 0.1 * GAP * self.measure(greatest) / self.force;
            let least = least_maximum(&rows, &unknowns, radius, missing);
            unknowns = least.unknowns;
            bound = f64::max(bound, least.bound * self.force);
            products = self.products(&(&self.map * &unknowns));
        }
        let gap = (greatest - bound).max(0.0) / self.measure(greatest);
        Ok((best, Proof { bound, gap }))
    }

    /// The force by which the gap is measured, N: the greatest one, or where the balance is so complete that its rounding
    /// exceeds the gap, the least one that is not.
    fn measure(&self, greatest: f64) -> f64 {
        greatest.max(ROUNDING / GAP * self.terms)
    }

    /// The force of a sample as a linear function of the independent unknowns, divided by the greatest force.
    fn row(&self, sample: &Sample) -> LinearForce {
        let mut row = plain(sample, self.carriers);
        scale(&mut row, self.force, &self.scales);
        let column = |factors: nalgebra::DVectorView<'_, f64>| {
            let each = row.columns.iter().zip(factors.iter());
            each.fold([0.0; 2], |sum, (column, w)| [sum[0] + column[0] * w, sum[1] + column[1] * w])
        };
        let columns = self.map.column_iter().map(|factors| column(factors.as_view())).collect();
        LinearForce { force: row.force, columns }
    }
}

fn plain(sample: &Sample, carriers: usize) -> LinearForce {
    let columns = sample.units[..carriers].iter().flat_map(|unit| unit.forces).collect();
    LinearForce { force: sample.force, columns }
}

fn scale(row: &mut LinearForce, force: f64, scales: &[f64]) {
    row.force = row.force.map(|f| f / force);
    for (column, scale) in row.columns.iter_mut().zip(scales) {
        *column = column.map(|f| f * scale / force);
    }
}

/// The least solution of least squares, and the map from independent unknowns of mean square 1 to all.
fn decomposed(rows: &[LinearForce], unknowns: usize) -> (DVector<f64>, DMatrix<f64>) {
    let mut matrix = DMatrix::zeros(2 * rows.len(), unknowns);
    let mut right = DVector::zeros(2 * rows.len());
    for (i, row) in rows.iter().enumerate() {
        for axis in 0..2 {
            right[2 * i + axis] = -row.force[axis];
            for (j, column) in row.columns.iter().enumerate() {
                matrix[(2 * i + axis, j)] = column[axis];
            }
        }
    }
    let decomposed = matrix.svd(true, true);
    let least = DEPENDENT * decomposed.singular_values.max();
    let solution = decomposed.solve(&right, least).unwrap_or_else(|_| DVector::zeros(unknowns));
    let values = decomposed.singular_values.iter().enumerate().filter(|(_, value)| **value > least);
    let columns: Vec<DVector<f64>> = decomposed
        .v_t
        .iter()
        .flat_map(|v_t| {
            values.clone().map(|(i, value)| v_t.row(i).transpose() * ((rows.len() as f64).sqrt() / value))
        })
        .collect();
    let map = if columns.is_empty() { DMatrix::zeros(unknowns, 0) } else { DMatrix::from_columns(&columns) };
    (solution, map)
}
