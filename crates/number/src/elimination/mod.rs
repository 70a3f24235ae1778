//! Gaussian elimination, dense and sparse.
//!
//! Least squares and null spaces are other questions: they are asked of orthogonal decompositions.

mod dense;
mod sparse;

pub use dense::{Factored, Lu, factor, substitute};
pub use sparse::SparseLu;

/// The sizes of the pivots.
#[derive(Debug, Clone, Copy)]
struct Pivots {
    least: f64,
    greatest: f64,
}

impl Pivots {
    const NONE: Self = Self { least: f64::INFINITY, greatest: 0.0 };

    #[inline(always)]
    fn add<T: crate::Real>(&mut self, pivot: T) {
        let size = pivot.abs();
        self.least = self.least.min(size.least());
        self.greatest = self.greatest.max(size.greatest());
    }

    /// Least / greatest; 0 for a singular matrix.
    #[inline(always)]
    fn ratio(self) -> f64 {
        if self.greatest > 0.0 && self.greatest.is_finite() { self.least / self.greatest } else { 0.0 }
    }
}
