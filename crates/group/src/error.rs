//! Why a group has no solution.

use assur_number::Real;

/// Why a group has no solution at one position. The chain adds where: group, position, coordinate.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GroupError {
    /// The links are too short, or too unequal, to meet.
    #[error("no assembly: it misses by {:.6} mm", gap_m * 1e3)]
    NoAssembly {
        /// Least change of one length that would close the group, m. Positive.
        gap_m: f64,
    },
    /// Places exist, but derivatives or reactions are not determined there.
    #[error("singular position (dimensionless determinant {health:.3e})")]
    Singular {
        /// The dimensionless determinant of the group.
        health: f64,
    },
    /// Too large for the general solution, or not a group: it needs three pairs for each two links.
    #[error(
        "the general solution takes 2, 4, 6 or 8 links with three pairs for each two; this group has {links} links \
         and {pairs} pairs and needs a kind of its own"
    )]
    Unfit {
        /// Links of the group.
        links: usize,
        /// Its pairs, inner and outer.
        pairs: usize,
    },
}

/// Lengths that make no group of a kind.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{what}")]
pub struct BuildError {
    /// What is wrong, with the numbers.
    pub what: String,
}

impl BuildError {
    /// A fault in words.
    pub fn new(what: impl Into<String>) -> Self {
        Self { what: what.into() }
    }
}

/// A dimensionless determinant below this counts as zero: rounding alone gives some 1e-16.
pub const LEAST_HEALTH: f64 = 1e-15;

impl GroupError {
    /// Refuses a determinant that is zero or no number, in any lane.
    ///
    /// # Errors
    ///
    /// [`GroupError::Singular`].
    #[inline]
    pub fn if_singular<T: Real>(health: T) -> Result<(), Self> {
        let least = health.least();
        if least >= LEAST_HEALTH.max(4.0 * T::EPSILON) {
            Ok(())
        } else {
            Err(Self::Singular { health: least })
        }
    }

    /// Refuses a determinant of which rounding leaves less than about two digits, in any lane.
    ///
    /// For kinds whose determinant is the square root of what the lengths say (links stretched, folded, rod across the
    /// guide): a rounding of the lengths counts with `condition` / health², and a derivative or reaction would be a
    /// number, but a wrong one. `square` is condition², so that no root is needed.
    ///
    /// # Errors
    ///
    /// [`GroupError::Singular`].
    #[inline]
    pub fn if_lost<T: Real>(health: T, square: T) -> Result<(), Self> {
        /// So many roundings must stay below the determinant's square.
        const ROUNDINGS: f64 = 200.0;
        let h2 = health * health;
        let limit = T::from_f64(ROUNDINGS * T::EPSILON);
        let margin = h2 * h2 - limit * limit * square;
        if margin.least() >= 0.0 { Ok(()) } else { Err(Self::Singular { health: health.abs().least() }) }
    }

    /// Refuses a result that is no number, in any lane.
    ///
    /// # Errors
    ///
    /// [`GroupError::Singular`] with the health NaN.
    #[inline]
    pub fn if_nan<T: Real>(result: T) -> Result<(), Self> {
        let least = result.least();
        if least.is_nan() { Err(Self::Singular { health: least }) } else { Ok(()) }
    }
}
