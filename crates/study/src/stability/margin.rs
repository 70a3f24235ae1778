//! How far a mechanism is from not assembling: the least change of each length at which assembly fails.
//!
//! The assembly of a group fails where its squared determinant, which is smooth in the coordinate, passes zero. So for
//! each changed length the minima of the squared determinants are sought over the coordinate, not on a grid only. At
//! the length where the least of them is zero, both the determinant and its derivative with respect to the coordinate
//! vanish.

mod length;
mod search;
mod survey;

use std::ops::ControlFlow;

use assur_kinematics::{Linkage, Misfit};
use assur_words::Text;
use serde::Serialize;

use super::nearest::Grid;
use length::Length;
use search::{Reach, SHORTEST, least};
use survey::{STRIDE, Survey};

/// The least change of one length at which the mechanism no longer assembles.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Margin {
    /// The length in words.
    pub length: Text,
    /// Its value, m.
    pub value: f64,
    /// Least increase at which assembly fails, m; `None`: none was found. 0 at a change point, and where a passive part fits no
    /// longer.
    pub increase: Option<f64>,
    /// Least decrease, m; `None`: none was found.
    pub decrease: Option<f64>,
    /// Increases were tried up to this one, m.
    pub increase_searched: f64,
    /// Decreases were tried up to this one, m.
    pub decrease_searched: f64,
}

impl Margin {
    /// The smaller of the two changes, m.
    pub fn least(&self) -> Option<f64> {
        match (self.increase, self.decrease) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        }
    }
}

/// Most lengths whose margins are searched: each trial decomposes the mechanism anew, and more would take minutes.
pub(crate) const MOST_LENGTHS: usize = 60;

/// Longest length that is tried, in sizes of the mechanism.
const FARTHEST: f64 = 100.0;

/// By this part a length is changed to see whether passive parts fit whatever it is: far more than what counts as fitting.
const SLIGHT: f64 = 1e-3;

/// Changes below this part of the size count as zero: lengths and positions are rounded.
const ZERO: f64 = 4e-12;

/// The lengths whose margins are searched: all, or none of a mechanism that has more than [`MOST_LENGTHS`].
pub(crate) fn lengths(linkage: &Linkage) -> Vec<Length> {
    let all = length::lengths(&linkage.mechanism);
    if all.len() > MOST_LENGTHS { Vec::new() } else { all }
}

/// The margins of the given lengths, the smallest first. `step` is called before each length, and may stop the search.
pub(crate) fn margins(
    linkage: &Linkage,
    lengths: &[Length],
    step: &mut impl FnMut() -> ControlFlow<()>,
) -> ControlFlow<(), Vec<Margin>> {
    let grid = Grid::of(linkage, STRIDE);
    let mut found = Vec::with_capacity(lengths.len());
    for length in lengths {
        step()?;
        found.push(margin(linkage, length, &grid));
    }
    let key = |margin: &Margin| margin.least().unwrap_or(f64::INFINITY);
    found.sort_by(|a, b| key(a).total_cmp(&key(b)));
    ControlFlow::Continue(found)
}

fn margin(linkage: &Linkage, length: &Length, grid: &Grid) -> Margin {
    let (words, value) = length.show(&linkage.mechanism);
    let scale = linkage.structure.scale.max(value.abs());
    let size = if value == 0.0 { scale } else { value.abs() };
    let longer = Reach { size, last: FARTHEST * scale, nothing: f64::INFINITY };
    let shorter = if length.ends_at_zero() {
        Reach { size, last: (1.0 - SHORTEST) * value, nothing: value }
    } else {
        longer
    };
    let found = |reach: Reach, sign: f64| {
        if !keeps_fit(linkage, length, sign * SLIGHT * size) {
            return Some(0.0);
        }
        let mut survey = Survey::of(linkage, length, grid);
        let change = least(reach, |change| survey.clearance(sign * change));
        change.map(|change| if change < ZERO * scale { 0.0 } else { change })
    };
    Margin {
        length: words,
        value,
        increase: found(longer, 1.0),
        decrease: found(shorter, -1.0),
        increase_searched: longer.last,
        decrease_searched: shorter.last,
    }
}

/// Whether the passive parts fit with a changed length too.
fn keeps_fit(linkage: &Linkage, length: &Length, change: f64) -> bool {
    let fits = |changed: Linkage| changed.misfits.iter().all(Misfit::fits);
    linkage.misfits.is_empty() || Linkage::compile(length.changed(&linkage.mechanism, change)).is_ok_and(fits)
}

#[cfg(test)]
mod tests;
