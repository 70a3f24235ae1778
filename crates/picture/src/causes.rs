//! The chosen reaction by cause: the shares of weight, inertia and each load, which sum to the total.

use assur_diagram::{JointForce, Share, Split};
use assur_figure::number::digits;
use assur_figure::{Ink, Key, Panel, Scale, Stroke};
use assur_words::{Text, name, quantity, text};

use crate::{Found, Look, Reaction, Results, curves, plots};

/// The share of one cause in a reaction.
#[derive(Debug, Clone)]
pub struct CauseShare {
    /// The cause.
    pub cause: Text,
    /// Projections, N; `None` for the balancing load.
    pub force: Option<[f64; 2]>,
    /// Moment of a slide, or the balancing load.
    pub scalar: Option<f64>,
}

/// The modulus of the chosen reaction, and its causes head to tail, with what their numbers stand for.
pub(crate) fn panels(results: &Results, look: &Look<'_>, found: &Found) -> (Vec<Panel>, Vec<Key>) {
    let Some(reaction) = found.reactions.get(look.reaction) else { return Default::default() };
    let plans = found.plans.at(look.position);
    let parts = plans.by_cause().map(|split| parts(split, reaction)).unwrap_or_default();
    let mut panels = curves(results, look, found, &[usize::MAX]);
    panels.extend(sum_of(&parts));
    let mut keys: Vec<Key> = drawn(&parts).map(|(number, part, force)| key(number, part, force)).collect();
    keys.extend(sum(&parts, Text::default()).force.filter(|_| !keys.is_empty()).map(|[x, y]| {
        let (told, size) = (text!("forces-sum"), quantity(digits(x.hypot(y), 5), "N"));
        plots::key([&told, &Text::default()], size, None, (Stroke::Solid, Ink::First))
    }));
    (panels, keys)
}

/// The shares that are drawn: number, share, force.
fn drawn(parts: &[CauseShare]) -> impl Iterator<Item = (usize, &CauseShare, [f64; 2])> {
    let numbered = parts.iter().enumerate();
    numbered.filter_map(|(number, part)| Some((number, part, part.force.filter(|[x, y]| x.hypot(*y) > 0.0)?)))
}

/// `2 inertia  311.2 N`.
fn key(number: usize, part: &CauseShare, [x, y]: [f64; 2]) -> Key {
    let (number, size) = (name((number + 1).to_string()), quantity(digits(x.hypot(y), 5), "N"));
    plots::key([&number, &part.cause], size, None, (Stroke::Solid, Ink::Second))
}

/// The shares of all causes in a reaction.
pub fn parts(split: &Split, reaction: &Reaction) -> Vec<CauseShare> {
    split.shares.iter().map(|share| part(share, reaction)).collect()
}

/// The share of a cause in a reaction.
pub fn part(share: &Share, reaction: &Reaction) -> CauseShare {
    let cause = share.cause.clone();
    let Some((pair, link)) = &reaction.of else {
        // Several drives have no load in common.
        let scalar = <[f64; 1]>::try_from(share.balancing_loads()).ok().map(|[load]| load);
        return CauseShare { cause, force: None, scalar };
    };
    let here = |force: &&JointForce| force.joint.id == pair.id && force.on.id == link.id;
    let found = share.reactions.iter().find(here);
    CauseShare { cause, force: found.map(|found| found.force), scalar: found.and_then(|found| found.moment) }
}

/// The sum of shares, as a cause of its own.
pub fn sum(parts: &[CauseShare], cause: Text) -> CauseShare {
    let mut sum = CauseShare { cause, force: None, scalar: None };
    for part in parts {
        if let Some([x, y]) = part.force {
            let [sx, sy] = sum.force.unwrap_or_default();
            sum.force = Some([sx + x, sy + y]);
        }
        if let Some(scalar) = part.scalar {
            sum.scalar = Some(sum.scalar.unwrap_or_default() + scalar);
        }
    }
    sum
}

/// The shares head to tail, and the total from the first corner to the last one.
fn sum_of(parts: &[CauseShare]) -> Option<Panel> {
    let mut at = [0.0; 2];
    let mut vectors = Vec::new();
    for (number, _, [x, y]) in drawn(parts) {
        let to = [at[0] + x, at[1] + y];
        let told = name((number + 1).to_string());
        vectors.push((plots::arrow([at, to], &told, Ink::Second), told));
        at = to;
    }
    let told = text!("forces-sum");
    vectors.push((plots::arrow([[0.0; 2], at], &told, Ink::First), told));
    (vectors.len() > 1).then(|| plots::vectors(vectors, Scale::of("F", "N"), None))
}

/// Curves of the chosen reaction, with the given series; for one that it does not have, the last one.
pub(crate) fn curves(results: &Results, look: &Look<'_>, found: &Found, which: &[usize]) -> Vec<Panel> {
    let Some(reaction) = found.reactions.get(look.reaction) else { return Vec::new() };
    let mut wanted: Vec<usize> =
        which.iter().map(|i| (*i).min(reaction.series.len() - 1)).map(|i| reaction.series[i]).collect();
    wanted.dedup();
    curves::stack(results, look, found, results.other.as_deref(), &wanted)
}
