//! Gaussian elimination of sparse equations.

/// An equation: its unknowns in ascending order, each with its factor; the right side stands last, as if it were the unknown
/// after all others.
pub(crate) type SparseRow = Vec<(usize, f64)>;

/// The solution of as many equations as unknowns, and the ratio of least to greatest pivot, zero where there is no solution.
///
/// The unknowns are eliminated as they are numbered, each by the equation in which its factor is greatest.
pub(crate) fn solve(mut rows: Vec<SparseRow>) -> (Vec<f64>, f64) {
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
