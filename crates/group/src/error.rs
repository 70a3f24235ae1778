//! Why a group has no solution.

use assur_number::Real;

/// Why a group has no solution at one position. The chain adds the group, the position and the coordinate.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GroupError {
    /// The links are too short, or too unequal, to meet.
    #[error("no assembly: it misses by {:.6} mm", gap_m * 1e3)]
    NoAssembly {
        /// Smallest change of one length that would close the group, m. Positive.
        gap_m: f64,
    },
    /// The links can be placed, but derivatives or reactions are not determined there.
    #[error("singular position ({})", determinant(*health))]
    Singular {
        /// The dimensionless determinant of the group.
        health: f64,
    },
    /// The iteration from the starting pose that the known places give came to a singular pose.
    #[error(
        "the starting guess is singular ({}): give `[assembly]` more points", determinant(*health)
    )]
    SingularStart {
        /// The dimensionless determinant of the group.
        health: f64,
    },
    /// The group has too many links for the general solution, or its count is wrong: it needs three pairs for every
    /// two links.
    #[error("{}", unfit(*links, *pairs))]
    Unfit {
        /// Links of the group.
        links: usize,
        /// Its pairs, inner and outer together.
        pairs: usize,
    },
}

/// Numbers that outgrow all others have no determinant.
fn determinant(health: f64) -> String {
    if health.is_finite() {
        format!("dimensionless determinant {health:.3e}")
    } else {
        "its determinant has no finite value".to_owned()
    }
}

fn unfit(links: usize, pairs: usize) -> String {
    if links.is_multiple_of(2) && 2 * pairs != 3 * links {
        return format!("{links} links need {} pairs, the group has {pairs}", 3 * links / 2);
    }
    format!(
        "the general solution takes 2, 4, 6 or 8 links with three pairs for each two; this group has {links} links \
         and {pairs} pairs and needs a kind of its own"
    )
}

/// Lengths that don't form a group of a kind.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{what}")]
pub struct BuildError {
    /// What is wrong, with the numbers.
    pub what: String,
    /// The link that is at fault, where it is one: its index among all links.
    pub link: Option<usize>,
}

impl BuildError {
    /// An error with this description.
    pub fn new(what: impl Into<String>) -> Self {
        Self { what: what.into(), link: None }
    }

    /// The link that is at fault, by its index among all links.
    #[must_use]
    pub fn of_link(self, link: usize) -> Self {
        Self { link: Some(link), ..self }
    }
}

/// A dimensionless determinant below this counts as zero: rounding alone produces about 1e-16.
pub const LEAST_HEALTH: f64 = 1e-15;

impl GroupError {
    /// Returns an error for a determinant that is zero or NaN in any lane.
    ///
    /// # Errors
    ///
    /// [`GroupError::Singular`] for a determinant that is zero or NaN.
    #[inline(always)]
    pub fn if_singular<T: Real>(health: T) -> Result<(), Self> {
        let is_regular = health.at_least(LEAST_HEALTH.max(4.0 * T::EPSILON));
        if is_regular { Ok(()) } else { Err(Self::Singular { health: health.least() }) }
    }

    /// Returns an error for a determinant that is zero or NaN, or of which rounding leaves fewer than about two correct
    /// digits, in any lane.
    ///
    /// For kinds whose determinant is the square root of a difference of lengths (zero for links stretched or folded,
    /// or a rod perpendicular to the guide). Its relative rounding error is `condition` / health²; derivatives and
    /// reactions would be finite but wrong. `square` is condition², which avoids a square root.
    ///
    /// # Errors
    ///
    /// [`GroupError::Singular`] if fewer digits are left.
    #[inline(always)]
    pub fn if_lost<T: Real>(health: T, square: T) -> Result<(), Self> {
        /// The squared determinant must exceed this number of rounding errors.
        const ROUNDINGS: f64 = 200.0;
        let h2 = health * health;
        let limit = T::from_f64(ROUNDINGS * T::EPSILON);
        let margin = h2 * h2 - limit * limit * square;
        let is_regular = margin.at_least(LEAST_HEALTH.max(4.0 * T::EPSILON).powi(4));
        if is_regular { Ok(()) } else { Err(Self::Singular { health: health.abs().least() }) }
    }

    /// Returns an error for a result that is NaN in any lane.
    ///
    /// # Errors
    ///
    /// [`GroupError::Singular`] with the health NaN.
    #[inline(always)]
    pub fn if_nan<T: Real>(result: T) -> Result<(), Self> {
        let is_number = result.at_least(f64::NEG_INFINITY);
        if is_number { Ok(()) } else { Err(Self::Singular { health: f64::NAN }) }
    }
}
