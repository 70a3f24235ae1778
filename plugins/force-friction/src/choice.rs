//! Which of several solutions is taken, and up to which part of the coefficients there is any.

use assur_group::Wrench;

use crate::branches::{Branch, Found};
use crate::chain::Chain;

/// The part of the coefficients at which a path begins, at most.
const START: f64 = 1e-3;

/// A solution goes on a path where its moduli are as expected but for this part of them.
const NEAR: f64 = 0.02;

/// Relative difference up to which the end of a path is one of the solutions that are known.
const SAME: f64 = 1e-6;

/// Shortest step along a path, as part of the coefficients: where it does not suffice the path ends.
const SHORTEST: f64 = 1e-9;

/// Most steps of a path.
const MOST: usize = 2000;

/// Ratio of two parts of the coefficients between which no interval without solutions is looked for.
const RATIO: f64 = 1.03;

/// The index of the solution that is taken: the one that follows by continuity from small coefficients, else that of the least
/// balancing load; `None` where there is none.
pub(crate) fn taken(chain: &Chain<'_>, loads: &[Wrench<f64>], found: &Found) -> Option<usize> {
    if found.branches.len() < 2 {
        return (!found.branches.is_empty()).then_some(0);
    }
    let size = |branch: &Branch| branch.balancing.abs();
    let least = (0..found.branches.len())
        .min_by(|&a, &b| size(&found.branches[a]).total_cmp(&size(&found.branches[b])));
    followed(chain, loads, found).or(least)
}

/// A point of a path: the part of the coefficients, and the moduli.
struct Node {
    part: f64,
    moduli: Vec<f64>,
}

/// A part of the coefficients with certainly one solution, as great as the spectral radii promise, and its moduli.
fn start(chain: &Chain<'_>, loads: &[Wrench<f64>], found: &Found) -> Option<Node> {
    let radius = found.certificates.iter().copied().filter(|radius| radius.is_finite()).fold(0.0, f64::max);
    let parts = [0.9 / radius.max(1.0), START.min(0.01 / radius.max(1e-300))];
    parts.into_iter().find_map(|part| {
        let mut found = chain.solutions(loads, part).ok().filter(|found| found.proved)?;
        let only = found.branches.pop().filter(|_| found.branches.is_empty())?;
        Some(Node { part, moduli: only.moduli })
    })
}

fn followed(chain: &Chain<'_>, loads: &[Wrench<f64>], found: &Found) -> Option<usize> {
    let mut now = start(chain, loads, found)?;
    let mut before: Option<Node> = None;
    let mut step = 1.0 / 32.0;
    for _ in 0..MOST {
        let part = (now.part + step).min(1.0);
        let expected = expected(before.as_ref(), &now, part);
        let Some(moduli) = chain.near(loads, part, &expected, NEAR) else {
            step *= 0.5;
            if step < SHORTEST {
                return None;
            }
            continue;
        };
        if part >= 1.0 {
            return nearest(&found.branches, &moduli);
        }
        before = Some(std::mem::replace(&mut now, Node { part, moduli }));
        step *= 1.5;
    }
    None
}

/// The moduli that a path will have, straight on.
fn expected(before: Option<&Node>, now: &Node, part: f64) -> Vec<f64> {
    let Some(before) = before else { return now.moduli.clone() };
    let share = (part - now.part) / (now.part - before.part);
    now.moduli.iter().zip(&before.moduli).map(|(now, before)| now + share * (now - before)).collect()
}

/// The solution that has these moduli.
fn nearest(branches: &[Branch], moduli: &[f64]) -> Option<usize> {
    let size = moduli.iter().fold(0.0_f64, |most, z| most.max(z.abs()));
    let far = |branch: &Branch| {
        branch.moduli.iter().zip(moduli).fold(0.0_f64, |most, (z, other)| most.max((z - other).abs()))
    };
    let (far, index) = branches.iter().map(far).zip(0..).min_by(|a, b| a.0.total_cmp(&b.0))?;
    (far <= SAME * size).then_some(index)
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
