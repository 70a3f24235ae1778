//! The points of a sweep, by their number.

use assur_scene::edit::decimal;
use sobol_burley::parts::{hash, owen_scramble_rev, sobol_rev};

use crate::axis::Axis;

/// Most parameters of a sample: Sobol sequences of more dimensions are not available.
pub(crate) const MOST_SAMPLED: usize = sobol_burley::NUM_DIMENSIONS as usize;

/// The points of a sweep.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Points {
    /// Every value of each parameter with every value of the others; the last parameter changes fastest.
    #[default]
    Grid,
    /// Points of a Sobol sequence with Owen scrambling: they fill the ranges evenly, and any first part of them does.
    Sample {
        /// How many.
        count: usize,
        /// Another seed gives other points, which are as good.
        seed: u32,
    },
    /// Row by row: the first values of all parameters, then the second ones; all have equally many.
    Table,
}

impl Points {
    /// How many there are of parameters with these numbers of values; `None` beyond the greatest number.
    pub(crate) fn count(self, mut counts: impl Iterator<Item = usize>) -> Option<usize> {
        match self {
            Self::Grid => counts.try_fold(1_usize, usize::checked_mul),
            Self::Sample { count, .. } => Some(count),
            Self::Table => counts.min(),
        }
    }

    /// The value of each parameter at a point, in the unit of its range.
    pub(crate) fn numbers(self, axes: &[Axis], index: usize, out: &mut [f64]) {
        match self {
            Self::Grid => {
                let mut rest = index;
                for (axis, out) in
                    axes.iter().zip(&mut *out).rev().filter(|(axis, _)| axis.follows().is_none())
                {
                    *out = axis.value(rest % axis.count());
                    rest /= axis.count();
                }
            }
            Self::Table => {
                for (axis, out) in axes.iter().zip(&mut *out) {
                    *out = axis.value(index);
                }
            }
            Self::Sample { seed, .. } => {
                for ((axis, out), dimension) in
                    axes.iter().zip(&mut *out).filter(|(axis, _)| axis.follows().is_none()).zip(0..)
                {
                    *out = axis.from + (axis.to - axis.from) * fraction(index, dimension, seed);
                }
            }
        }
        for (index, axis) in axes.iter().enumerate() {
            if let Some(following) = axis.follows() {
                out[index] = decimal(following.factor * out[following.leader] + following.added);
            }
        }
    }
}

/// One coordinate of a point of the unit cube, from 0 (included) to 1.
///
/// The crate's sequence has 2^16 points; each further 2^16 points are the same sequence in a scrambling of their own.
fn fraction(index: usize, dimension: u32, seed: u32) -> f64 {
    const LENGTH: usize = 1 << 16;
    let [within, block] =
        [index % LENGTH, index / LENGTH].map(|part| u32::try_from(part).unwrap_or(u32::MAX));
    let scramble = hash(hash(hash(seed) ^ block).wrapping_add(dimension));
    let reversed = owen_scramble_rev(sobol_rev(within.reverse_bits(), dimension), scramble);
    f64::from(reversed.reverse_bits()) / (f64::from(u32::MAX) + 1.0)
}

#[cfg(test)]
mod tests;
