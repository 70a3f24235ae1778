//! A sparse linear system: the matrix of a large group has four to eight entries in a row.

use assur_number::Real;

/// A pivot must have at least this part of the greatest entry of its row.
const THRESHOLD: f64 = 0.1;

/// One step of the elimination.
#[derive(Debug, Clone)]
struct Step<T> {
    row: usize,
    column: usize,
    pivot: T,
    /// The other entries of the pivot's row.
    upper: Vec<(usize, T)>,
    /// By what the pivot's row was multiplied where it was subtracted from another.
    lower: Vec<(usize, T)>,
}

/// LU factors of a sparse matrix: of the pivots that are great enough the one that fills least is taken (Markowitz).
#[derive(Debug, Clone)]
pub(crate) struct SparseLu<T> {
    steps: Vec<Step<T>>,
    /// Smallest pivot / greatest pivot, absolute values: 0 for a singular matrix.
    pub(crate) health: f64,
    /// Whether the determinant is positive.
    pub(crate) is_positive: bool,
}

impl<T: Real> SparseLu<T> {
    /// Factors a matrix given by the entries of its rows.
    pub(crate) fn new(mut rows: Vec<Vec<(usize, T)>>) -> Self {
        let count = rows.len();
        let mut left: Vec<usize> = (0..count).collect();
        let mut steps = Vec::with_capacity(count);
        let (mut least, mut greatest) = (f64::INFINITY, 0.0_f64);
        while let Some((place, column)) = choose(&rows, &left) {
            let row = left.swap_remove(place);
            let mut own = std::mem::take(&mut rows[row]);
            let Some(at) = own.iter().position(|(c, _)| *c == column) else { break };
            let (_, pivot) = own.swap_remove(at);
            (least, greatest) = (least.min(pivot.abs().least()), greatest.max(pivot.abs().greatest()));
            let mut lower = Vec::new();
            for &other in &left {
                let Some(at) = rows[other].iter().position(|(c, _)| *c == column) else { continue };
                let factor = rows[other].swap_remove(at).1 / pivot;
                subtract(&mut rows[other], factor, &own);
                lower.push((other, factor));
            }
            steps.push(Step { row, column, pivot, upper: own, lower });
        }
        let is_whole = steps.len() == count && greatest > 0.0 && greatest.is_finite();
        let health = if is_whole { least / greatest } else { 0.0 };
        let is_positive = is_positive(&steps);
        Self { steps, health, is_positive }
    }

    pub(crate) fn solve(&self, right: &[T]) -> Vec<T> {
        let mut y = right.to_vec();
        for step in &self.steps {
            let known = y[step.row];
            step.lower.iter().for_each(|(row, factor)| y[*row] -= *factor * known);
        }
        let mut x = vec![T::ZERO; right.len()];
        for step in self.steps.iter().rev() {
            let sum = step.upper.iter().fold(y[step.row], |sum, (column, entry)| sum - *entry * x[*column]);
            x[step.column] = sum / step.pivot;
        }
        x
    }
}

/// The place in the list of rows, and the column, of the next pivot.
fn choose<T: Real>(rows: &[Vec<(usize, T)>], left: &[usize]) -> Option<(usize, usize)> {
    let mut in_column = vec![0_usize; rows.len()];
    left.iter().flat_map(|&row| &rows[row]).for_each(|(column, _)| in_column[*column] += 1);
    let mut best: Option<((usize, f64), (usize, usize))> = None;
    for (place, &row) in left.iter().enumerate() {
        let size = |entry: &T| entry.abs().least();
        let most = rows[row].iter().map(|(_, entry)| size(entry)).fold(0.0, f64::max);
        for (column, entry) in
            rows[row].iter().filter(|(_, entry)| size(entry) > 0.0 && size(entry) >= THRESHOLD * most)
        {
            let fill = (rows[row].len() - 1) * (in_column[*column] - 1);
            let is_better =
                best.is_none_or(|((least, great), _)| fill < least || fill == least && size(entry) > great);
            if is_better {
                best = Some(((fill, size(entry)), (place, *column)));
            }
        }
    }
    best.map(|(_, found)| found)
}

/// Subtracts a multiple of a row from another.
fn subtract<T: Real>(row: &mut Vec<(usize, T)>, factor: T, other: &[(usize, T)]) {
    for &(column, entry) in other {
        let change = factor * entry;
        match row.iter_mut().find(|(c, _)| *c == column) {
            Some((_, own)) => *own -= change,
            None => row.push((column, -change)),
        }
    }
}

/// The sign of the determinant: that of the pivots, and that of the order in which they were taken.
fn is_positive<T: Real>(steps: &[Step<T>]) -> bool {
    let mut to = vec![0; steps.len()];
    for step in steps {
        if step.row < to.len() {
            to[step.row] = step.column;
        }
    }
    let mut seen = vec![false; to.len()];
    let mut is_even = true;
    for start in 0..to.len() {
        let mut next = start;
        let mut length = 0;
        while next < to.len() && !seen[next] {
            seen[next] = true;
            next = to[next];
            length += 1;
        }
        // A cycle of even length is an odd permutation.
        is_even ^= length > 0 && length % 2 == 0;
    }
    let negative = steps.iter().filter(|step| step.pivot.to_f64() < 0.0).count();
    is_even == (negative % 2 == 0)
}
