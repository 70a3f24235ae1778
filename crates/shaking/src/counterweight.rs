//! The counterweights that make the shaking force least.

use nalgebra::{DMatrix, DVector};

use crate::barrier::least_maximum;
use crate::barrier::{Row, solve};
use crate::data::Criterion;
use crate::samples::Sample;

/// Mass times radius (kg m, in the frames of the links) of the counterweights on the first `carriers` links that make the
/// shaking force least.
pub(crate) fn counterweights(samples: &[Sample], carriers: usize, criterion: Criterion) -> Vec<[f64; 2]> {
    let mut rows: Vec<Row> = samples
        .iter()
        .map(|sample| Row {
            force: sample.force,
            columns: sample.units[..carriers].iter().flat_map(|unit| unit.forces).collect(),
        })
        .collect();
    // Forces and columns of size 1, so that neither units nor lengths matter.
    let size = |value: [f64; 2]| value[0].hypot(value[1]);
    let force = rows.iter().map(|row| size(row.force)).fold(0.0, f64::max);
    let scales: Vec<f64> = (0..2 * carriers)
        .map(|i| rows.iter().map(|row| size(row.columns[i])).fold(0.0, f64::max))
        .map(|greatest| if greatest > 0.0 { force / greatest } else { 0.0 })
        .collect();
    if force == 0.0 {
        return vec![[0.0; 2]; carriers];
    }
    for row in &mut rows {
        row.force = row.force.map(|f| f / force);
        for (column, scale) in row.columns.iter_mut().zip(&scales) {
            *column = column.map(|f| f * scale / force);
        }
    }
    let least = least_squares(&rows, 2 * carriers);
    let found = match criterion {
        Criterion::LeastSquares => least,
        Criterion::LeastMaximum => least_maximum(&rows, least),
    };
    (0..carriers).map(|i| [found[2 * i] * scales[2 * i], found[2 * i + 1] * scales[2 * i + 1]]).collect()
}

fn least_squares(rows: &[Row], unknowns: usize) -> DVector<f64> {
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
    solve(matrix, &right)
}
