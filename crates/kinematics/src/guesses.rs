//! Starting poses for the groups that iterate: those found when the assembly was followed.

use assur_group::Body;
use assur_structure::Structure;

/// Poses of the links of iterating groups at equally spaced coordinates.
#[derive(Debug, Clone)]
pub(crate) struct Guesses {
    /// Coordinate of the first sample, rad or m.
    pub(crate) low: f64,
    /// Distance between neighboring samples, rad or m.
    pub(crate) step: f64,
    /// Whether the samples cover a whole period, so that the last one repeats the first.
    pub(crate) periodic: bool,
    /// Each link with its pose at every sample.
    pub(crate) poses: Vec<(usize, Vec<Body<f64>>)>,
}

/// Links of the groups whose solution is iterated from a starting pose.
pub fn iterated(structure: &Structure) -> Vec<usize> {
    let iterating = structure.groups.iter().filter(|group| group.plugin.iterates);
    iterating.flat_map(|group| group.frame.links.iter().copied()).collect()
}

impl Guesses {
    /// The links with their poses at the sample closest to a coordinate.
    pub(crate) fn at(&self, coordinate: f64) -> impl Iterator<Item = (usize, &Body<f64>)> {
        self.poses.iter().map(move |(link, poses)| {
            let last = (poses.len() - 1) as f64;
            let mut place = (coordinate - self.low) / self.step;
            if self.periodic {
                place = place.rem_euclid(last);
            }
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "clamped to the samples"
            )]
            let nearest = place.round().clamp(0.0, last) as usize;
            (*link, &poses[nearest])
        })
    }

    /// Sets the links to their poses at the sample closest to a coordinate.
    pub(crate) fn put(&self, coordinate: f64, bodies: &mut [Body<f64>]) {
        self.at(coordinate).for_each(|(link, pose)| bodies[link] = *pose);
    }
}
