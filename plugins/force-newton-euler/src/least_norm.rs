//! Fewer sparse equations than unknowns: the solution of least norm.
//!
//! Of least norm: the unknowns are forces in N: moments are divided by the size of the mechanism. Of A x = b, with Aᵀ = Q R, the
//! solution is Q R⁻ᵀ b; what lies outside of the columns of Q is open. The equations are orthogonalized one after the other, short ones
//! first (Gram and Schmidt, twice each, so that rounding leaves them orthogonal): those of a link meet only those that share a
//! joint with it, so Q stays sparse.

/// An equation: its unknowns in ascending order, each with its factor.
pub(crate) type SparseRow = Vec<(usize, f64)>;

#[derive(Debug)]
pub(crate) struct LeastNorm {
    pub(crate) solution: Vec<f64>,
    /// Ratio of least to greatest pivot.
    pub(crate) health: f64,
    /// By unknown: its parts in the orthonormal directions that the equations determine.
    determined: Vec<SparseRow>,
}

/// Solves equations with their right sides in this number of unknowns.
pub(crate) fn of_least_norm(rows: &[SparseRow], rights: &[f64], unknowns: usize) -> LeastNorm {
    let mut order: Vec<usize> = (0..rows.len()).collect();
    order.sort_by_key(|row| rows[*row].len());
    // Each with the part of the solution along it.
    let mut directions: Vec<(SparseRow, f64)> = Vec::with_capacity(rows.len());
    let (mut least, mut greatest) = (f64::INFINITY, 0.0_f64);
    let mut solution = vec![0.0; unknowns];
    let mut determined = vec![SparseRow::new(); unknowns];
    for row in order {
        let (mut parts, mut right) = (vec![0.0; unknowns], rights[row]);
        for &(unknown, factor) in &rows[row] {
            parts[unknown] += factor;
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
        all - sums.values().map(|sum: &f64| sum * sum).sum::<f64>() > assur_number::ROUNDING * all
    }
}
