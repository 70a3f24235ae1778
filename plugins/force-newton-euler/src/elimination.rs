//! Sparse equations: Gaussian elimination of as many as unknowns, and the solution of least norm of fewer.
//!
//! Of least norm: the unknowns are forces in N: moments are divided by the size of the mechanism. Of A x = b, with Aᵀ = Q R, the
//! solution is Q R⁻ᵀ b; what lies outside of the columns of Q is open. The equations are orthogonalized one after the other, short ones
//! first (Gram and Schmidt, twice each, so that rounding leaves them orthogonal): those of a link meet only those that share a
//! joint with it, so Q stays sparse.

/// An equation: its unknowns in ascending order, each with its factor; the right side stands last, as if it were the unknown
/// after all others.
pub(crate) type SparseRow = Vec<(usize, f64)>;

/// The solution of as many equations as unknowns, and the ratio of least to greatest pivot, zero where there is no solution.
///
/// The unknowns are eliminated as they are numbered, each by the equation in which its factor is greatest.
pub(crate) fn eliminated(mut rows: Vec<SparseRow>) -> (Vec<f64>, f64) {
    let count = rows.len();
    let mut x = vec![f64::NAN; count];
    let mut beginning = Beginning { first: vec![None; count + 1], next: vec![None; count] };
    rows.iter().enumerate().for_each(|(id, row)| beginning.add(id, row));
    let mut pivots = Vec::with_capacity(count);
    let (mut least, mut greatest) = (f64::INFINITY, 0.0_f64);
    let mut difference = SparseRow::new();
    for unknown in 0..count {
        let size = |id: usize| rows[id][0].1.abs();
        let Some(pivot) = beginning.with(unknown).max_by(|a, b| size(*a).total_cmp(&size(*b))) else {
            return (x, 0.0);
        };
        (least, greatest) = (least.min(size(pivot)), greatest.max(size(pivot)));
        pivots.push(pivot);
        let mut at = beginning.first[unknown];
        while let Some(id) = at {
            at = beginning.next[id];
            if id != pivot {
                eliminate(&rows[id], &rows[pivot], &mut difference);
                std::mem::swap(&mut rows[id], &mut difference);
                beginning.add(id, &rows[id]);
            }
        }
    }
    for (unknown, pivot) in pivots.into_iter().enumerate().rev() {
        let (own, others) = (rows[pivot][0].1, &rows[pivot][1..]);
        let term = |(of, factor): &(usize, f64)| x.get(*of).map_or(*factor, |x| -factor * x);
        x[unknown] = others.iter().map(term).sum::<f64>() / own;
    }
    (x, if greatest > 0.0 { least / greatest } else { 0.0 })
}

/// The equations by the unknown with which they begin: one for each unknown, and for each equation another one.
struct Beginning {
    first: Vec<Option<usize>>,
    next: Vec<Option<usize>>,
}

impl Beginning {
    fn add(&mut self, id: usize, row: &SparseRow) {
        let unknown = row.first().map_or(self.next.len(), |(unknown, _)| *unknown);
        self.next[id] = self.first[unknown].replace(id);
    }

    fn with(&self, unknown: usize) -> impl Iterator<Item = usize> {
        std::iter::successors(self.first[unknown], |id| self.next[*id])
    }
}

/// An equation less the multiple of the pivot's equation that removes the unknown with which both begin.
fn eliminate(row: &SparseRow, pivot: &SparseRow, difference: &mut SparseRow) {
    let factor = row[0].1 / pivot[0].1;
    let (mut row, mut pivot) = (row[1..].iter().peekable(), pivot[1..].iter().peekable());
    difference.clear();
    loop {
        let (own, other) =
            (row.peek().map_or(usize::MAX, |one| one.0), pivot.peek().map_or(usize::MAX, |one| one.0));
        let unknown = own.min(other);
        if unknown == usize::MAX {
            return;
        }
        let own = row.next_if(|one| one.0 == unknown).map_or(0.0, |one| one.1);
        let other = pivot.next_if(|one| one.0 == unknown).map_or(0.0, |one| one.1);
        difference.push((unknown, own - factor * other));
    }
}

/// An unknown (or a sum of some) is open if more than this part of it, squared, lies outside of what the equations say: rounding
/// leaves some 1e-15.
const OPEN: f64 = 1e-12;

#[derive(Debug)]
pub(crate) struct LeastNorm {
    pub(crate) solution: Vec<f64>,
    /// Ratio of least to greatest pivot.
    pub(crate) health: f64,
    /// By unknown: its parts in the orthonormal directions that the equations determine.
    determined: Vec<SparseRow>,
}

/// Solves equations in this number of unknowns; the right side of each stands after the last unknown.
pub(crate) fn of_least_norm(rows: &[SparseRow], unknowns: usize) -> LeastNorm {
    let mut order: Vec<usize> = (0..rows.len()).collect();
    order.sort_by_key(|row| rows[*row].len());
    // Each with the part of the solution along it.
    let mut directions: Vec<(SparseRow, f64)> = Vec::with_capacity(rows.len());
    let (mut least, mut greatest) = (f64::INFINITY, 0.0_f64);
    let mut solution = vec![0.0; unknowns];
    let mut determined = vec![SparseRow::new(); unknowns];
    for row in order {
        let (mut parts, mut right) = (vec![0.0; unknowns], 0.0);
        for &(unknown, factor) in &rows[row] {
            *parts.get_mut(unknown).unwrap_or(&mut right) += factor;
        }
        for (direction, along) in directions.iter().chain(&directions) {
            let shared: f64 = direction.iter().map(|&(unknown, part)| parts[unknown] * part).sum();
            if shared != 0.0 {
                for &(unknown, part) in direction {
                    parts[unknown] -= shared * part;
                }
                right -= shared * along;
            }
        }
        let pivot = parts.iter().map(|part| part * part).sum::<f64>().sqrt();
        (least, greatest) = (least.min(pivot), greatest.max(pivot));
        let unit = parts.into_iter().map(|part| part / pivot).enumerate();
        let (direction, along): (SparseRow, f64) =
            (unit.filter(|(_, part)| *part != 0.0).collect(), right / pivot);
        for &(unknown, part) in &direction {
            solution[unknown] += along * part;
            determined[unknown].push((directions.len(), part));
        }
        directions.push((direction, along));
    }
    LeastNorm { solution, health: least / greatest, determined }
}

impl LeastNorm {
    /// Whether the sum of some unknowns is open.
    pub(crate) fn is_open(&self, unknowns: &[usize]) -> bool {
        let mut sums = std::collections::BTreeMap::new();
        for (direction, part) in unknowns.iter().flat_map(|unknown| &self.determined[*unknown]) {
            *sums.entry(direction).or_insert(0.0) += part;
        }
        let all = unknowns.len() as f64;
        all - sums.values().map(|sum: &f64| sum * sum).sum::<f64>() > OPEN * all
    }
}
