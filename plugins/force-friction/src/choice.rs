//! Which of several solutions is taken, and up to which part of the coefficients there is any.

use assur_group::Wrench;

use crate::branches::{Branch, Found};
use crate::chain::Chain;

/// The part of the coefficients at which a path begins, at most.
const START: f64 = 1e-3;

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

fn followed(chain: &Chain<'_>, loads: &[Wrench<f64>], found: &Found) -> Option<usize> {
    let radius = found.certificates.iter().copied().filter(|radius| radius.is_finite()).fold(0.0, f64::max);
    let first = START.min(0.01 / radius.max(1e-300));
    let at = |part: f64| chain.solutions(loads, part).ok().filter(|found| !found.branches.is_empty());
    let mut now = Node { part: first, moduli: at(first)?.branches.first()?.moduli.clone() };
    let mut before: Option<Node> = None;
    let mut step = 1.0 / 32.0;
    for _ in 0..MOST {
        let part = (now.part + step).min(1.0);
        let expected = expected(before.as_ref(), &now, part);
        let all = at(part);
        let nearest = all.as_ref().and_then(|all| nearest(&all.branches, &expected));
        let Some((index, all)) = nearest.zip(all.as_ref()) else {
            step *= 0.5;
            if step < SHORTEST {
                return None;
            }
            continue;
        };
        if part >= 1.0 {
            return Some(index);
        }
        let next = Node { part, moduli: all.branches[index].moduli.clone() };
        before = Some(std::mem::replace(&mut now, next));
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

/// The solution that goes on a path: near to what is expected, and much nearer than any other.
fn nearest(branches: &[Branch], expected: &[f64]) -> Option<usize> {
    let size = expected.iter().fold(0.0_f64, |most, z| most.max(z.abs()));
    let far = |branch: &Branch| {
        branch.moduli.iter().zip(expected).fold(0.0_f64, |most, (z, other)| most.max((z - other).abs()))
    };
    let mut order: Vec<(f64, usize)> = branches.iter().map(far).zip(0..).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (nearest, index) = *order.first()?;
    let alone = order.get(1).is_none_or(|(other, _)| nearest <= 0.1 * other);
    (nearest <= 0.05 * size && alone).then_some(index)
}

/// The upper end of the interval from 0 of the parts of the coefficients for which there is a solution.
pub(crate) fn limit(chain: &Chain<'_>, loads: &[Wrench<f64>]) -> f64 {
    let exists = |part: f64| chain.solutions(loads, part).is_ok_and(|found| !found.branches.is_empty());
    let (mut holding, mut failing) = (0.0, START);
    while failing < 1.0 && exists(failing) {
        (holding, failing) = (failing, (failing * RATIO).min(1.0));
    }
    assur_number::search::bisect(holding, failing, 0.0, exists)[0]
}
