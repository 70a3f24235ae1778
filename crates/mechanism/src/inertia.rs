//! The moment of inertia of a link, which may vary with the coordinate.

use std::ops::MulAssign;

use assur_formula::Formula;

/// The moment of inertia of a link about its center of mass, kg m².
#[derive(Debug, Clone, PartialEq)]
pub enum Inertia {
    /// Of a rigid link; 0: none.
    Constant(f64),
    /// Of a link pinned to the ground: it stands for parts that move with the link, so that it varies with the input
    /// coordinate (D fig. 3.17).
    Varying(VaryingInertia),
}

/// A moment of inertia by a formula over the input coordinate.
#[derive(Debug, Clone, PartialEq)]
pub struct VaryingInertia {
    /// The formula, over the coordinate alone and without switches.
    pub formula: Formula,
    /// SI value of a result of 1, kg m².
    pub factor: f64,
}

impl VaryingInertia {
    /// The greatest moment of inertia, kg m²: that of one given as a number (docs/ranges.md).
    pub const MOST: f64 = 1e15;

    /// The moment of inertia at a coordinate, kg m², and its derivative with respect to the coordinate. Where it is not positive, or beyond
    /// [`MOST`](Self::MOST), neither is a number.
    pub fn at(&self, coordinate: f64) -> [f64; 2] {
        let found = self.formula.with_slope(coordinate).map(|number| self.factor * number);
        if found[0] > 0.0 && found[0] <= Self::MOST { found } else { [f64::NAN; 2] }
    }
}

impl Inertia {
    /// None.
    pub const NONE: Self = Self::Constant(0.0);

    /// Whether there is none.
    pub fn is_none(&self) -> bool {
        matches!(self, Self::Constant(inertia) if *inertia == 0.0)
    }

    /// The part of it that is the same everywhere, kg m²: nothing of one that varies.
    pub fn constant(&self) -> f64 {
        match self {
            Self::Constant(inertia) => *inertia,
            Self::Varying(_) => 0.0,
        }
    }

    /// How it varies; `None` where it doesn't.
    pub fn varying(&self) -> Option<&VaryingInertia> {
        match self {
            Self::Constant(_) => None,
            Self::Varying(law) => Some(law),
        }
    }

    /// The moment of inertia at a coordinate, kg m², and its derivative with respect to the coordinate.
    pub fn at(&self, coordinate: f64) -> [f64; 2] {
        match self {
            Self::Constant(inertia) => [*inertia, 0.0],
            Self::Varying(law) => law.at(coordinate),
        }
    }
}

impl Default for Inertia {
    fn default() -> Self {
        Self::NONE
    }
}

impl From<f64> for Inertia {
    fn from(inertia: f64) -> Self {
        Self::Constant(inertia)
    }
}

impl MulAssign<f64> for Inertia {
    fn mul_assign(&mut self, factor: f64) {
        match self {
            Self::Constant(inertia) => *inertia *= factor,
            Self::Varying(law) => law.factor *= factor,
        }
    }
}
