//! Where kinds of groups that iterate begin: the places that the walk over the cycle found.

use assur_group::Body;
use assur_structure::Structure;

/// Places of the links of such groups at equally spaced coordinates.
#[derive(Debug, Clone)]
pub(crate) struct Seeds {
    links: Vec<usize>,
    low: f64,
    step: f64,
    /// Whether the samples cover whole cycles.
    periodic: bool,
    /// For each coordinate, one for each of `links`.
    samples: Vec<Vec<Body<f64>>>,
}

/// Links of the groups that iterate from a former place.
pub fn iterated(structure: &Structure) -> Vec<usize> {
    structure
        .groups
        .iter()
        .filter(|group| group.plugin.iterates)
        .flat_map(|group| group.frame.links.clone())
        .collect()
}

impl Seeds {
    /// Keeps the links of a grid of positions; `None` where no link needs it.
    pub(crate) fn keep(
        links: &[usize],
        low: f64,
        step: f64,
        periodic: bool,
        grid: &[Vec<Body<f64>>],
    ) -> Option<Self> {
        let samples: Vec<_> =
            grid.iter().map(|bodies| links.iter().map(|&link| bodies[link]).collect()).collect();
        let links = links.to_vec();
        (!links.is_empty() && !samples.is_empty()).then_some(Self { links, low, step, periodic, samples })
    }

    /// Puts the links where the walk found them at the sample closest to a coordinate.
    pub(crate) fn put(&self, coordinate: f64, bodies: &mut [Body<f64>]) {
        let last = self.samples.len() - 1;
        let mut place = (coordinate - self.low) / self.step;
        if self.periodic {
            place = place.rem_euclid(last as f64);
        }
        let at = place.round().clamp(0.0, last as f64);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the samples")]
        let sample = &self.samples[at as usize];
        for (&link, body) in self.links.iter().zip(sample) {
            bodies[link] = *body;
        }
    }
}
