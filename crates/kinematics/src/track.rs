//! Follows a group that iterates between two neighboring samples, in steps so short that its pose can't jump.

use assur_group::{Body, GroupError};
use assur_number::elementary;

use crate::{Chain, branch::Branch, dependence::Dependence, wide::Assembly};

/// Longest step of a pose, rad or parts of the scale: far less than what lies between two modes whose determinants have the
/// same sign.
pub(crate) const LONGEST: f64 = 0.02;

/// Steps of the coordinate shorter than this part of a sample's are none: the range ends there.
const SHORTEST: f64 = 1e-13;

/// Most steps between two samples: beyond, links run to infinity, where no mechanism passes.
const MOST_STEPS: usize = 400;

/// One group of a chain.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Tracker<'a> {
    pub(crate) chain: &'a Chain<f64>,
    pub(crate) dependence: &'a Dependence,
    pub(crate) group: usize,
    /// A typical length of the mechanism, m.
    pub(crate) scale: f64,
}

/// Where a group can't be followed any further: the last coordinate at which it can be placed, and why.
pub(crate) type Torn = (f64, GroupError);

/// All bodies, with the groups placed that determine the motion of a group.
pub(crate) fn placed_before(
    (chain, dependence): (&Chain<f64>, &Dependence),
    group: usize,
    q: f64,
    branch: &Branch,
) -> Result<Vec<Body<f64>>, GroupError> {
    let mut bodies = branch.start.clone();
    branch.guess(q, &mut bodies);
    chain.set_input(q, &mut bodies);
    for ancestor in dependence.ancestors(group, |_| false) {
        chain.groups[ancestor].place(&mut bodies, usize::from(branch.way(ancestor, q)))?;
    }
    Ok(bodies)
}

impl Tracker<'_> {
    /// The poses of the links at the coordinate `to`, followed from their poses at `from`.
    pub(crate) fn follow(
        &self,
        way: u8,
        (from, start): (f64, Vec<Body<f64>>),
        to: f64,
        branch: &Branch,
    ) -> Result<Vec<Body<f64>>, Torn> {
        let (mut at, mut pose) = (from, start);
        let whole = to - from;
        let mut step = whole;
        let mut reason = GroupError::NoAssembly { gap_m: 0.0 };
        let mut steps = 0;
        while (to - at).abs() > 0.0 {
            steps += 1;
            let next = if (to - at).abs() <= step.abs() { to } else { at + step };
            let found = self.place(way, next, &pose, branch);
            let is_near = |found: &Vec<Body<f64>>| {
                pose_distance(found.iter().copied(), pose.iter().copied(), self.scale) <= LONGEST
            };
            match found {
                Ok(found) if is_near(&found) => {
                    (at, pose) = (next, found);
                    step *= 2.0;
                    if steps <= MOST_STEPS {
                        continue;
                    }
                }
                Err(error @ GroupError::NoAssembly { .. }) => reason = error,
                Ok(_) | Err(_) => {}
            }
            step *= 0.5;
            if step.abs() <= SHORTEST * whole.abs() || ((at + step) - at).abs() <= 0.0 || steps > MOST_STEPS {
                return Err((at, reason));
            }
        }
        Ok(pose)
    }

    /// Places the groups that determine the motion of the group, and the group from a pose; returns its links.
    fn place(
        &self,
        way: u8,
        q: f64,
        pose: &[Body<f64>],
        branch: &Branch,
    ) -> Result<Vec<Body<f64>>, GroupError> {
        let mut bodies = placed_before((self.chain, self.dependence), self.group, q, branch)?;
        let kernel = &self.chain.groups[self.group];
        let links = &kernel.frame().links;
        links.iter().zip(pose).for_each(|(&link, body)| bodies[link] = *body);
        kernel.place(&mut bodies, usize::from(way))?;
        Ok(links.iter().map(|&link| bodies[link]).collect())
    }
}

/// The greatest difference between two poses of the same links, of directions (rad) or of places (parts of the
/// scale).
pub(crate) fn pose_distance(
    one: impl IntoIterator<Item = Body<f64>>,
    other: impl IntoIterator<Item = Body<f64>>,
    scale: f64,
) -> f64 {
    let apart = |(a, b): (Body<f64>, Body<f64>)| {
        let place = elementary::hypot(a.x - b.x, a.y - b.y) / scale;
        place.max(elementary::hypot(a.c - b.c, a.s - b.s))
    };
    one.into_iter().zip(other).map(apart).fold(0.0, f64::max)
}
