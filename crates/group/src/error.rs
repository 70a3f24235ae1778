//! Why a group has no solution.

use assur_number::Real;
use assur_words::{Describe, Text, millimeters, number, text};

/// Why a group has no solution at one position. The chain adds the group, the position and the coordinate.
#[derive(Clone, Copy, PartialEq)]
pub enum GroupError {
    /// The links are too short, or too unequal, to meet.
    NoAssembly {
        /// Smallest change of one length that would close the group, m; 0 where that is not known, since the kind iterates.
        gap_m: f64,
    },
    /// The links can be placed, but derivatives or reactions are not determined there.
    Singular {
        /// The dimensionless determinant of the group.
        health: f64,
    },
    /// The iteration from the starting pose that the known places give came to a singular pose.
    SingularStart {
        /// The dimensionless determinant of the group.
        health: f64,
    },
    /// The count of the group is wrong: it needs three pairs for every two links.
    Unfit {
        /// Links of the group.
        links: usize,
        /// Its pairs, inner and outer together.
        pairs: usize,
    },
}

assur_words::errors!(GroupError, BuildError);

impl Describe for GroupError {
    fn describe(&self) -> Text {
        match *self {
            Self::NoAssembly { gap_m: 0.0 } => text!("group-no-assembly-found"),
            Self::NoAssembly { gap_m } => {
                text!("group-no-assembly", gap = millimeters(gap_m, 6))
            }
            Self::Singular { health } => text!("group-singular", determinant = determinant(health)),
            Self::SingularStart { health } => {
                text!("group-singular-start", determinant = determinant(health))
            }
            Self::Unfit { links, pairs } => {
                text!("group-wrong-count", links, needed = (3 * links).div_ceil(2), pairs)
            }
        }
    }
}

/// Numbers that outgrow all others have no determinant.
fn determinant(health: f64) -> Text {
    if health.is_finite() {
        text!("group-determinant", health = number(format_args!("{health:.3e}")))
    } else {
        text!("group-determinant-not-finite")
    }
}

/// Lengths that don't form a group of a kind.
#[derive(Clone, PartialEq)]
pub struct BuildError {
    /// What is wrong, with the numbers.
    pub what: Text,
    /// The link that is at fault, where it is one: its index among all links.
    pub link: Option<usize>,
}

impl Describe for BuildError {
    fn describe(&self) -> Text {
        self.what.clone()
    }
}

impl BuildError {
    /// An error with this description.
    pub fn new(what: Text) -> Self {
        Self { what, link: None }
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
    #[inline(always)]
    pub fn if_nan<T: Real>(result: T) -> Result<(), Self> {
        let is_number = result.at_least(f64::NEG_INFINITY);
        if is_number { Ok(()) } else { Err(Self::Singular { health: f64::NAN }) }
    }
}
