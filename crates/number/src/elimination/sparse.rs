//! A sparse linear system: the matrix of a large group has four to eight entries in a row.

use super::{Factored, Pivots};
use crate::Real;

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
pub struct SparseLu<T> {
    steps: Vec<Step<T>>,
    /// What the matrix is known by.
    pub factored: Factored,
}

impl<T: Real> SparseLu<T> {
    /// Factors a matrix given by the entries of its rows.
    pub fn new(rows: Vec<Vec<(usize, T)>>) -> Self {
        let count = rows.len();
        let mut left = Left::of(rows);
        let mut steps = Vec::with_capacity(count);
        let mut pivots = Pivots::NONE;
        while let Some(step) = left.eliminate() {
            pivots.add(step.pivot);
            steps.push(step);
        }
        let is_whole = steps.len() == count;
        let health = if is_whole { pivots.ratio() } else { 0.0 };
        let is_positive = is_whole && is_positive(&steps);
        Self { steps, factored: Factored { health, is_positive } }
    }

    /// The solution for a right-hand side; not finite for a singular matrix.
    pub fn solve(&self, right: &[T]) -> Vec<T> {
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

/// An entry that may be a pivot.
#[derive(Debug, Clone, Copy)]
struct Candidate {
    column: usize,
    /// Most entries that it adds.
    fill: usize,
    size: f64,
}

impl Candidate {
    fn is_better(&self, than: Option<&Self>) -> bool {
        than.is_none_or(|best| self.fill < best.fill || self.fill == best.fill && self.size > best.size)
    }
}

/// What is left of the matrix. A step changes few rows: what the choice of a pivot asks of the others is kept.
struct Left<T> {
    rows: Vec<Vec<(usize, T)>>,
    /// The rows that are left.
    order: Vec<usize>,
    /// By column, the rows left that have an entry there.
    columns: Vec<Vec<usize>>,
    /// By row, its best pivot.
    best: Vec<Option<Candidate>>,
}

impl<T: Real> Left<T> {
    fn of(rows: Vec<Vec<(usize, T)>>) -> Self {
        let count = rows.len();
        let mut columns = vec![Vec::new(); count];
        for (row, entries) in rows.iter().enumerate() {
            for (column, _) in entries {
                columns[*column].push(row);
            }
        }
        let mut left = Self { rows, order: (0..count).collect(), columns, best: vec![None; count] };
        for row in 0..count {
            left.best[row] = left.best_of(row);
        }
        left
    }

    /// The best pivot of a row.
    fn best_of(&self, row: usize) -> Option<Candidate> {
        let row = &self.rows[row];
        let size = |entry: &T| entry.abs().least();
        let most = row.iter().map(|(_, entry)| size(entry)).fold(0.0, f64::max);
        let mut best = None;
        for (column, size) in row.iter().map(|(column, entry)| (*column, size(entry))) {
            let fill = (row.len() - 1) * (self.columns[column].len() - 1);
            let candidate = Candidate { column, fill, size };
            if size > 0.0 && size >= THRESHOLD * most && candidate.is_better(best.as_ref()) {
                best = Some(candidate);
            }
        }
        best
    }

    /// The place in the order, and the column, of the next pivot.
    fn choose(&self) -> Option<(usize, usize)> {
        let mut found: Option<(usize, &Candidate)> = None;
        for (place, &row) in self.order.iter().enumerate() {
            if let Some(candidate) = &self.best[row]
                && candidate.is_better(found.map(|(_, best)| best))
            {
                found = Some((place, candidate));
            }
        }
        found.map(|(place, candidate)| (place, candidate.column))
    }

    /// Takes the row of the next pivot, and subtracts it from the others.
    fn eliminate(&mut self) -> Option<Step<T>> {
        let (place, column) = self.choose()?;
        let row = self.order.swap_remove(place);
        let mut upper = std::mem::take(&mut self.rows[row]);
        for (column, _) in &upper {
            self.columns[*column].retain(|other| *other != row);
        }
        let (_, pivot) = upper.swap_remove(upper.iter().position(|(c, _)| *c == column)?);
        let mut changed = std::mem::take(&mut self.columns[column]);
        let mut lower = Vec::with_capacity(changed.len());
        for &other in &changed {
            let entries = &mut self.rows[other];
            let Some(at) = entries.iter().position(|(c, _)| *c == column) else { continue };
            let factor = entries.swap_remove(at).1 / pivot;
            subtract(entries, factor, &upper, |column| self.columns[column].push(other));
            lower.push((other, factor));
        }
        changed.extend(upper.iter().flat_map(|(column, _)| &self.columns[*column]));
        changed.sort_unstable();
        changed.dedup();
        for row in changed {
            self.best[row] = self.best_of(row);
        }
        Some(Step { row, column, pivot, upper, lower })
    }
}

/// Subtracts a multiple of a row from another; tells in which columns entries are new.
fn subtract<T: Real>(
    row: &mut Vec<(usize, T)>,
    factor: T,
    other: &[(usize, T)],
    mut adds: impl FnMut(usize),
) {
    for &(column, entry) in other {
        let change = factor * entry;
        if let Some((_, own)) = row.iter_mut().find(|(c, _)| *c == column) {
            *own -= change;
        } else {
            row.push((column, -change));
            adds(column);
        }
    }
}

/// The sign of the determinant of a regular matrix: that of the pivots, and that of the order in which they were taken.
fn is_positive<T: Real>(steps: &[Step<T>]) -> bool {
    let mut column_of = vec![0; steps.len()];
    for step in steps {
        column_of[step.row] = step.column;
    }
    let mut is_even = steps.iter().filter(|step| step.pivot.to_f64() < 0.0).count() % 2 == 0;
    for row in 0..column_of.len() {
        while column_of[row] != row {
            let column = column_of[row];
            column_of.swap(row, column);
            is_even = !is_even;
        }
    }
    is_even
}
