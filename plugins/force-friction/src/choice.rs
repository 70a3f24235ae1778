//! Which of several solutions is taken, and up to which part of the coefficients there is any.

use assur_friction::{PathPoint, is_same, path};
use assur_group::Wrench;

use crate::branches::{Branch, Solutions};
use crate::chain::Chain;

/// The part of the coefficients at which a path begins, at most.
const START: f64 = 1e-3;

/// Ratio of two parts of the coefficients between which no interval without solutions is looked for.
const RATIO: f64 = 1.03;

/// The index of the solution that is taken: the one that follows by continuity from small coefficients, else that of the least
/// balancing load; `None` where there is none.
pub(crate) fn taken(chain: &Chain<'_>, loads: &[Wrench<f64>], found: &Solutions) -> Option<usize> {
    if found.branches.len() < 2 {
        return (!found.branches.is_empty()).then_some(0);
    }
    let size = |branch: &Branch| branch.balancing.abs();
    let least = (0..found.branches.len())
        .min_by(|&a, &b| size(&found.branches[a]).total_cmp(&size(&found.branches[b])));
    followed(chain, loads, found).or(least)
}

/// A part of the coefficients with certainly one solution, as great as the spectral radii promise, and its moduli.
fn start(chain: &Chain<'_>, loads: &[Wrench<f64>], found: &Solutions) -> Option<PathPoint> {
    let radius = found.certificates.iter().copied().filter(|radius| radius.is_finite()).fold(0.0, f64::max);
    let parts = [0.9 / radius.max(1.0), START.min(0.01 / radius.max(1e-300))];
    parts.into_iter().find_map(|part| {
        let mut found = chain.solutions(loads, part).ok().filter(|found| found.proved)?;
        let only = found.branches.pop().filter(|_| found.branches.is_empty())?;
        Some(PathPoint { part, moduli: only.moduli })
    })
}

fn followed(chain: &Chain<'_>, loads: &[Wrench<f64>], found: &Solutions) -> Option<usize> {
    let moduli = path(start(chain, loads, found)?, |part, expected| chain.near(loads, part, expected))?;
    found.branches.iter().position(|branch| is_same(&branch.moduli, &moduli))
}

/// The upper end of the interval from 0 of the parts of the coefficients for which there is a solution.
pub(crate) fn limit(chain: &Chain<'_>, loads: &[Wrench<f64>]) -> f64 {
    let exists = |part: f64| chain.solutions(loads, part).is_ok_and(|found| !found.branches.is_empty());
    let whole = chain.solutions(loads, 1.0).ok();
    let (mut holding, mut failing) = match whole.and_then(|found| start(chain, loads, &found)) {
        Some(node) if node.part > START => (node.part, (node.part * RATIO).min(1.0)),
        _ => (0.0, START),
    };
    while failing < 1.0 && exists(failing) {
        (holding, failing) = (failing, (failing * RATIO).min(1.0));
    }
    assur_number::search::bisect(holding, failing, 0.0, exists)[0]
}
