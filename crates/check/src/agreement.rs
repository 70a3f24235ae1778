//! Agreement of the methods: every reaction and the balancing load.

use assur_force::{AnalyzerPlugin, Reactions};
use assur_words::{Text, text};

use crate::case::{Case, largest};
use crate::numbers::{SAFETY, SAMPLES, SPACING, rounding_of};
use crate::{check::Collector, kinetics::ROUNDINGS};

/// Numbers of one result: the balancing load, then three for each pair.
type Numbers = Vec<f64>;

/// Compares the results of all methods with that of the method whose results all checks use.
pub(crate) fn compare(case: &Case<'_>, collector: &mut Collector) {
    for (i, other) in case.answers.iter().enumerate().filter(|(i, _)| *i != case.full) {
        if let Some(other) = other {
            compare_with(case, other, &case.subject.methods[i], collector);
        }
    }
}

fn compare_with(case: &Case<'_>, other: &Reactions, method: &AnalyzerPlugin, collector: &mut Collector) {
    let scale = case.subject.linkage.structure.scale;
    let units = units(case);
    let [mine, theirs] = [case.reactions, other].map(numbers);
    let difference: Numbers = mine.iter().zip(&theirs).map(|(a, b)| a - b).collect();
    let off = sizes(&difference, scale, units);
    let own = |method: &AnalyzerPlugin| method.instance.condition(case.subject.linkage, &case.one.position);
    let own = own(&case.subject.methods[case.full]).max(own(method));
    let usual = ROUNDINGS * f64::EPSILON * case.condition() * own;
    let shown = if method.gives_reactions { off.len() } else { 1 };
    // Loads may be such that more is lost than the conditions tell; then the rounding is measured.
    let measured = off[..shown].iter().any(|off| *off > usual).then(|| {
        let both = [&case.subject.methods[case.full], method].map(|method| rounding(case, method));
        both.map(|rounding| rounding.map(|numbers| sizes(&numbers, scale, units)))
    });
    let links = 1..case.subject.linkage.structure.links;
    let spread = links.map(|link| case.subject.spread(link)).fold(1.0, f64::max);
    let gained = measured.as_ref().and_then(|_| gained_by_friction(case));
    let gained = gained.map(|numbers| sizes(&numbers, scale, units));
    for (k, off) in off[..shown].iter().enumerate() {
        let gained = usual * gained.as_ref().map_or(0.0, |gained| gained[k]);
        let limit = match &measured {
            None => usual,
            Some([Some(one), Some(other)]) => usual + gained + SAFETY * (one[k] + other[k]),
            // Nothing can be measured beyond the end of the assembly; what the rounding of the coordinate makes of the
            // determinant, and that of the places of the directions of links, is known.
            Some(_) => usual * spread / case.one.health,
        };
        collector.offer(case.one.index, *off, limit, || number_name(case, k, method.wording.clone()));
    }
}

/// Units of the balancing load and of the reactions. The scale of a balancing moment is that of the largest reaction.
fn units(case: &Case<'_>) -> [f64; 2] {
    let linkage = case.subject.linkage;
    let scale = linkage.structure.scale;
    let load = case.items.values().map(|item| item.size).fold(0.0, f64::max);
    let unit = largest(&case.reactions.pairs, scale).max(load);
    let lever = if linkage.mechanism.balances_by_moment() { scale } else { 1.0 };
    [case.reactions.balancing.abs().max(unit * lever), unit]
}

/// Standard deviation of the rounding of each number, from results at closely spaced coordinates around the position.
/// The formulas of the loads are not changed, only the position.
fn rounding(case: &Case<'_>, method: &AnalyzerPlugin) -> Option<Numbers> {
    let (subject, unit) = (case.subject, case.subject.linkage.coordinate_unit());
    let row = |i: usize| {
        let shift = (i as f64 - 3.0) * SPACING * unit;
        let at = subject.solve(case.one.index, case.one.position.coordinate + shift)?;
        let answer = subject.answer(method, case.loads, case.state, &at.position, 1.0)?;
        Some(numbers(&answer))
    };
    let rows = (0..SAMPLES).map(row).collect::<Option<Vec<_>>>()?;
    let number = |k: usize| rounding_of(&std::array::from_fn(|i| rows[i][k]));
    Some((0..rows[0].len()).map(number).collect())
}

/// By how much each number changes where all coefficients of friction grow in proportion: by as much as that, rounding of the
/// response to friction shows in it, 1/(1 - k) times with one pair and W = k in z = |a + W z|. `None` without friction.
fn gained_by_friction(case: &Case<'_>) -> Option<Numbers> {
    let Case { subject, loads, state, reactions, .. } = case;
    let method = &subject.methods[case.full];
    reactions.friction.as_ref()?;
    // Beside jamming there is no solution with greater coefficients.
    let less = subject.answer(method, loads, state, &case.one.position, 1.0 - GROWTH)?;
    let changes = numbers(reactions).into_iter().zip(numbers(&less));
    Some(changes.map(|(all, less)| (all - less) / GROWTH).collect())
}

/// Change of the coefficients for a difference, small beside the distance to jamming wherever a limit can judge.
const GROWTH: f64 = 1e-7;

fn numbers(reactions: &Reactions) -> Numbers {
    let pairs = reactions.pairs.iter().flat_map(|r| [r.fx, r.fy, r.m]);
    std::iter::once(reactions.balancing).chain(pairs).collect()
}

/// The balancing load and each reaction in their units.
fn sizes(numbers: &[f64], scale: f64, units: [f64; 2]) -> Vec<f64> {
    let pairs = numbers[1..].chunks_exact(3).map(|r| (r[0].hypot(r[1]) + r[2].abs() / scale) / units[1]);
    std::iter::once(numbers[0].abs() / units[0]).chain(pairs).collect()
}

fn number_name(case: &Case<'_>, k: usize, method: Text) -> Text {
    let linkage = case.subject.linkage;
    match k.checked_sub(1) {
        None => text!("check-balancing-by", method),
        Some(pair) => {
            let pair = linkage.structure.pair_name(&linkage.mechanism, pair);
            text!("check-pair-by", pair, method)
        }
    }
}
