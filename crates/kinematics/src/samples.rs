//! The samples of one group along a branch.

use assur_group::{AssurGroup, Body, GroupError};
use assur_mechanism::GROUND;

use crate::branch::Branch;

/// A local minimum of the determinant above this can't belong to a zero between two samples.
const SUSPECT: f64 = 0.2;

/// A squared determinant whose interpolating parabola stays above this has no zero between the samples.
const CLEAR: f64 = 1e-4;

/// One group, placed at successive samples in its present way.
pub(crate) struct Samples<'a> {
    kernel: &'a dyn AssurGroup<f64>,
    /// Bodies of other groups that its outer pairs join.
    outer: Vec<usize>,
    /// Storage for all bodies of the mechanism.
    scratch: &'a mut [Body<f64>],
    /// The present way.
    pub(crate) way: u8,
    /// Absolute value of the determinant at each sample.
    pub(crate) health: Vec<f64>,
    /// Why it can't be placed at the sample after the last one.
    pub(crate) failure: Option<GroupError>,
}

impl<'a> Samples<'a> {
    pub(crate) fn new(kernel: &'a dyn AssurGroup<f64>, way: u8, scratch: &'a mut [Body<f64>]) -> Self {
        let frame = kernel.frame();
        let ends = frame.outer.iter().flat_map(|pair| [pair.a, pair.b]);
        let outer = ends.filter(|end| *end != GROUND && !frame.links.contains(end)).collect();
        Self { kernel, outer, scratch, way, health: Vec::new(), failure: None }
    }

    /// Places the group at all samples from one on, until it can't be assembled; earlier samples stay unchanged.
    pub(crate) fn place_from(&mut self, first: usize, branch: &mut Branch) {
        let links = &self.kernel.frame().links;
        self.health.truncate(first);
        self.failure = None;
        for &link in links {
            branch.poses[link].truncate(first);
            self.scratch[link] = *branch.poses[link].last().unwrap_or(&branch.start[link]);
        }
        for sample in self.health.len()..branch.samples {
            self.outer.iter().for_each(|&body| self.scratch[body] = branch.poses[body][sample]);
            // A kind that iterates starts from the previous sample, which the scratch still holds.
            match self.kernel.place(self.scratch, usize::from(self.way)) {
                Ok(found) => self.health.push(found.abs()),
                // At a change point itself a group may report "singular": the branch continues beyond it.
                Err(GroupError::Singular { .. }) => self.health.push(0.0),
                Err(failure) => {
                    self.failure = Some(failure);
                    break;
                }
            }
            for &link in links {
                branch.poses[link].push(self.scratch[link]);
            }
        }
    }

    /// Determinant below which, near a sample, nothing but rounding is left.
    pub(crate) fn resolution(&mut self, sample: usize, branch: &Branch) -> f64 {
        let links = self.outer.iter().chain(&self.kernel.frame().links);
        links.for_each(|&body| self.scratch[body] = branch.poses[body][sample]);
        self.kernel.resolution(self.scratch)
    }

    /// Where the squared determinant has a minimum near a sample, in samples from it; `None` if there is no minimum,
    /// or one that is certainly not zero.
    pub(crate) fn minimum_near(&self, sample: usize) -> Option<f64> {
        let (health, last) = (&self.health, self.health.len() - 1);
        let before = sample.checked_sub(1).map_or(f64::INFINITY, |before| health[before]);
        let after = health.get(sample + 1).copied().unwrap_or(f64::INFINITY);
        if health[sample] > before || health[sample] >= after || health[sample] > SUSPECT {
            return None;
        }
        if last < 2 {
            return Some(0.0);
        }
        let square = |sample: usize| health[sample] * health[sample];
        let bend = |sample: usize| square(sample - 1) - 2.0 * square(sample) + square(sample + 1);
        let middle = sample.clamp(1, last - 1);
        let (slope, curvature) = (0.5 * (square(middle + 1) - square(middle - 1)), bend(middle));
        if curvature <= 0.0 {
            return Some(0.0);
        }
        let least = square(middle) - 0.5 * slope * slope / curvature;
        // The neighboring samples show the error of the parabola.
        let is_inside = middle >= 2 && middle + 2 <= last;
        if is_inside {
            let change = [middle - 1, middle + 1].map(|other| (bend(other) - curvature).abs());
            if least - change[0].max(change[1]) > CLEAR {
                return None;
            }
        }
        let place = (middle as f64 - slope / curvature)
            .clamp(sample.saturating_sub(1) as f64, last.min(sample + 1) as f64);
        Some(place - sample as f64)
    }
}

/// The greatest difference between two poses of the same links, of directions (rad) or of places (parts of the
/// scale).
pub(crate) fn pose_distance<'a, 'b>(
    one: impl IntoIterator<Item = &'a Body<f64>>,
    other: impl IntoIterator<Item = &'b Body<f64>>,
    scale: f64,
) -> f64 {
    let apart = |(a, b): (&Body<f64>, &Body<f64>)| {
        let place = (a.x - b.x).hypot(a.y - b.y) / scale;
        place.max((a.c - b.c).hypot(a.s - b.s))
    };
    one.into_iter().zip(other).map(apart).fold(0.0, f64::max)
}
