//! Reduction, reactions, and the balancing load.

use assur_mechanism::{Balance, Place};

use super::Source;
use super::layout::{Column, Page};
use super::motion::{column, keys};
use super::number::single;
use super::units::{ANGLE, FORCE, LENGTH, MOMENT, Unit};
use assur_analysis::results::{PairReaction, PositionResult};

pub(super) fn write(source: &Source<'_>, page: &mut Page) {
    reduction(source, page);
    reactions(source, page);
    balancing(source, page);
}

fn reduction(source: &Source<'_>, page: &mut Page) {
    if !source.analysis.positions.iter().any(|position| position.reduced.is_some()) {
        return;
    }
    let units = source.units.reduced;
    page.section("Reduction to the input link");
    page.caption("Inertia J, its derivative dJ/dq, and Q of all loads but the balancing one");
    let columns = vec![
        column(source, "J", units[0], |p| Some(p.reduced?.inertia)),
        column(source, "dJ/dq", units[1], |p| Some(p.reduced?.inertia_derivative)),
        column(source, "Q", units[2], |p| Some(p.reduced?.moment)),
    ];
    page.table(&keys(source), vec![columns]);
    super::point::write(source, page);
}

/// Force of a pair on one of its links in one position.
fn force(position: &PositionResult, pair: usize, link: usize) -> Option<[f64; 2]> {
    let (_, reaction) = position.reactions.as_ref()?.0.get(pair)?;
    reaction.forces.get(link).map(|(_, force)| *force)
}

/// Which links of a pair are shown: of two the first that moves (the other has the opposite), of more all.
pub(super) fn shown(source: &Source<'_>, reaction: &PairReaction) -> Vec<usize> {
    let ground = source.mechanism.links.first().map_or("", |link| link.name.as_str());
    match &reaction.forces[..] {
        [(first, _), _] => vec![usize::from(&**first == ground)],
        forces => (0..forces.len()).collect(),
    }
}

fn reactions(source: &Source<'_>, page: &mut Page) {
    let Some(first) = source.analysis.positions.iter().find_map(|position| position.reactions.as_ref())
    else {
        return;
    };
    let keys = keys(source);
    page.section("Reactions");
    page.paragraph(
        "The force that the pair exerts on the named link (the other link gets the opposite): projections, modulus R, \
         direction from the x axis. Slides: M is the moment on the sliding link about its point; s is where along the guide, \
         from that point, the force alone would do the same.",
    );
    for (pair, (name, reaction)) in first.iter().enumerate() {
        let groups: Vec<_> =
            shown(source, reaction).into_iter().map(|link| of_pair(source, pair, link, reaction)).collect();
        let links: Vec<_> =
            shown(source, reaction).into_iter().map(|link| &*reaction.forces[link].0).collect();
        page.caption(&format!("{name} on {}", links.join(", ")));
        page.table(&keys, groups);
    }
    greatest(source, first, page);
}

fn of_pair(source: &Source<'_>, pair: usize, link: usize, reaction: &PairReaction) -> Vec<Column> {
    let f = move |p: &PositionResult| force(p, pair, link);
    let of = |i: usize| {
        move |p: &PositionResult| p.reactions.as_ref()?.0.get(i).map(|(_, r)| (r.moment, r.offset))
    };
    let mut columns = vec![
        column(source, "Rx", FORCE, move |p| f(p).map(|f| f[0])),
        column(source, "Ry", FORCE, move |p| f(p).map(|f| f[1])),
        column(source, "R", FORCE, move |p| f(p).map(|f| f[0].hypot(f[1]))),
        column(source, "direction", ANGLE, move |p| f(p).and_then(direction)),
    ];
    if reaction.moment.is_some() {
        columns.push(column(source, "M", MOMENT, move |p| of(pair)(p).and_then(|(moment, _)| moment)));
        columns.push(column(source, "s", LENGTH, move |p| of(pair)(p).and_then(|(_, offset)| offset)));
    }
    columns
}

/// Angle of a force; a force of nothing has none. A component that is rounding does not count.
fn direction(force: [f64; 2]) -> Option<f64> {
    let modulus = force[0].hypot(force[1]);
    let [x, y] = force.map(|part| if part.abs() <= 1e-12 * modulus { 0.0 } else { part });
    (modulus > 1e-9).then(|| y.atan2(x))
}

/// A coordinate with its unit.
fn place(source: &Source<'_>, position: &PositionResult) -> Vec<String> {
    let unit = source.units.coordinate;
    vec![position.index.to_string(), single(position.coordinate * unit.factor)]
}

fn greatest(source: &Source<'_>, first: &assur_analysis::results::Named<PairReaction>, page: &mut Page) {
    let coordinate = format!("{}, {}", source.analysis.input.link, source.units.coordinate.name);
    let head = ["pair", "on", "greatest R, N", "position", &coordinate, "RMS of R, N"];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    for (name, reaction) in first.iter() {
        for link in shown(source, reaction) {
            let on = &*reaction.forces[link].0;
            let all = &source.analysis.cycle.reaction_extremes;
            let Some(found) = all.iter().find(|one| one.joint == name && one.on == on) else { continue };
            rows.push(vec![
                name.to_owned(),
                on.to_owned(),
                single(found.greatest),
                found.index.to_string(),
                single(found.coordinate * source.units.coordinate.factor),
                single(found.rms),
            ]);
        }
    }
    page.caption("Reactions over the cycle: greatest, and root mean square");
    page.rows(&rows);
}

fn balancing(source: &Source<'_>, page: &mut Page) {
    let size = |p: &PositionResult| p.balancing;
    if !source.analysis.positions.iter().any(|position| position.balancing.is_some()) {
        return;
    }
    let moment = source.analysis.input.balancing_is_moment;
    let (name, sign, unit): (_, _, Unit) =
        if moment { ("moment", "Mb", MOMENT) } else { ("force", "Fb", FORCE) };
    page.section(&format!("Balancing {name}"));
    page.caption(&bears(source, name));
    page.table(&keys(source), vec![vec![column(source, sign, unit, size)]]);
    if let Some(position) = greatest_of(source.analysis.positions.iter(), size) {
        let [index, coordinate] = [0, 1].map(|i| place(source, position)[i].clone());
        page.caption(&format!(
            "Greatest: {} {} in position {index} ({coordinate} {})",
            single(position.balancing.unwrap_or_default()),
            unit.name,
            source.units.coordinate.name
        ));
    }
}

/// Which link bears the balancing load.
fn bears(source: &Source<'_>, name: &str) -> String {
    let link = match source.mechanism.balance {
        Some(Balance::Moment(id) | Balance::Force { at: Place { link: id, .. }, .. }) => id,
        None => source.mechanism.input.link,
    };
    format!("The {name} on `{}` that keeps the mechanism in its motion", source.mechanism.links[link].name)
}

/// The position with the greatest modulus, the first of those that are alike but for rounding: a cycle often has two.
fn greatest_of<'p>(
    positions: impl Iterator<Item = &'p PositionResult>,
    size: impl Fn(&PositionResult) -> Option<f64>,
) -> Option<&'p PositionResult> {
    let mut best: Option<(&PositionResult, f64)> = None;
    for position in positions {
        let Some(modulus) = size(position).map(f64::abs) else { continue };
        if best.is_none_or(|(_, most)| modulus > most * (1.0 + 1e-9)) {
            best = Some((position, modulus));
        }
    }
    best.map(|(position, _)| position)
}
