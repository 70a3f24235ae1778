//! Reduction, reactions with their causes, and the balancing load.

use assur_analysis::results::{Named, PairReaction, PositionResult};
use assur_mechanism::{Balance, Place};

use super::Source;
use super::layout::{Column, Page};
use super::motion::{column, keys};
use super::number::{short, single};
use super::units::{ANGLE, FORCE, KILOGRAM, LENGTH, MOMENT};

pub(super) fn write(source: &Source<'_>, page: &mut Page) {
    reduction(source, page);
    reactions(source, page);
    balancing(source, page);
    causes(source, page);
}

fn reduction(source: &Source<'_>, page: &mut Page) {
    if !source.analysis.positions.iter().any(|position| position.reduced.is_some()) {
        return;
    }
    let (units, keys) = (source.units.reduced, keys(source));
    page.section("Reduction to the input link");
    let columns = vec![
        column(source, "J", units[0], |p| Some(p.reduced?.inertia)),
        column(source, "dJ/dq", units[1], |p| Some(p.reduced?.inertia_derivative)),
        column(source, "Q", units[2], |p| Some(p.reduced?.moment)),
    ];
    let caption = "Inertia J, its derivative dJ/dq, and Q of all loads but the balancing one";
    page.table(caption, &keys, vec![columns]);
    // E eqs. 4-6.
    let dynamics = source.analysis.dynamics.as_ref();
    let Some(point) = dynamics.and_then(|found| found.reduction_point.as_ref()) else { return };
    let radius = point.radius;
    let caption = format!(
        "The same reduced to point {} of the input link: force F = Q/r along its motion, mass m = J/r², r = {} mm",
        point.name,
        short(1e3 * radius)
    );
    let columns = vec![
        column(source, "m", KILOGRAM, |p| Some(p.reduced?.inertia / (radius * radius))),
        column(source, "F", FORCE, |p| Some(p.reduced?.moment / radius)),
    ];
    page.table(&caption, &keys, vec![columns]);
}

/// Force of a pair on one of its links; pairs and links by their places in the lists.
fn force(reactions: &Named<PairReaction>, pair: usize, link: usize) -> Option<[f64; 2]> {
    reactions.0.get(pair)?.1.forces.get(link).map(|(_, force)| *force)
}

/// Its modulus.
pub(super) fn modulus(reactions: &Named<PairReaction>, pair: usize, link: usize) -> Option<f64> {
    force(reactions, pair, link).map(|[x, y]| x.hypot(y))
}

/// A pair and the links on which its force is shown: indices in the lists of reactions and forces, and names.
type Shown<'r> = (usize, &'r str, Vec<(usize, &'r str)>);

/// All pairs, each with the links that are shown: of two links the first that moves (the force on the other is
/// opposite), of more links all.
pub(super) fn shown<'r>(source: &Source<'_>, reactions: &'r Named<PairReaction>) -> Vec<Shown<'r>> {
    let ground = source.mechanism.links.first().map_or("", |link| link.name.as_str());
    let links = |reaction: &'r PairReaction| match &reaction.forces[..] {
        [(first, _), _] => {
            let moving = usize::from(&**first == ground);
            vec![(moving, &*reaction.forces[moving].0)]
        }
        forces => forces.iter().map(|(name, _)| &**name).enumerate().collect(),
    };
    reactions.iter().enumerate().map(|(pair, (name, reaction))| (pair, name, links(reaction))).collect()
}

fn reactions(source: &Source<'_>, page: &mut Page) {
    let first = source.analysis.positions.iter().find_map(|position| position.reactions.as_ref());
    let Some(first) = first else { return };
    let keys = keys(source);
    page.section("Reactions");
    page.paragraph(
        "The force that the pair exerts on the named link (the other link gets the opposite): projections, modulus R, \
         direction from the x axis. Slides: M is the moment on the sliding link about its point; s is where along the guide, \
         from that point, the force alone would do the same.",
    );
    for (pair, name, links) in shown(source, first) {
        let slide = first.0[pair].1.moment.is_some();
        let groups = links.iter().map(|(link, _)| of_pair(source, pair, *link, slide)).collect();
        let links: Vec<_> = links.into_iter().map(|(_, name)| name).collect();
        page.table(&format!("{name} on {}", links.join(", ")), &keys, groups);
    }
    greatest(source, first, page);
}

fn of_pair(source: &Source<'_>, pair: usize, link: usize, slide: bool) -> Vec<Column> {
    let f = |p: &PositionResult| force(p.reactions.as_ref()?, pair, link);
    let mut columns = vec![
        column(source, "Rx", FORCE, |p| f(p).map(|f| f[0])),
        column(source, "Ry", FORCE, |p| f(p).map(|f| f[1])),
        column(source, "R", FORCE, |p| f(p).map(|f| f[0].hypot(f[1]))),
        column(source, "direction", ANGLE, |p| f(p).and_then(direction)),
    ];
    if slide {
        columns.push(column(source, "M", MOMENT, |p| p.reactions.as_ref()?.0.get(pair)?.1.moment));
        columns.push(column(source, "s", LENGTH, |p| p.reactions.as_ref()?.0.get(pair)?.1.offset));
    }
    columns
}

/// Angle of a force; a zero force has none. A component that is rounding counts as zero.
fn direction(force: [f64; 2]) -> Option<f64> {
    let modulus = force[0].hypot(force[1]);
    let [x, y] = force.map(|part| if part.abs() <= 1e-12 * modulus { 0.0 } else { part });
    (modulus > 1e-9).then(|| y.atan2(x))
}

fn greatest(source: &Source<'_>, first: &Named<PairReaction>, page: &mut Page) {
    let unit = source.units.coordinate;
    let coordinate = format!("{}, {}", source.analysis.input.link, unit.name);
    let mut rows = Vec::new();
    for (_, name, links) in shown(source, first) {
        for (_, on) in links {
            let all = &source.analysis.cycle.reaction_extremes;
            let Some(found) = all.iter().find(|one| one.joint == name && one.on == on) else { continue };
            rows.push(vec![
                name.to_owned(),
                on.to_owned(),
                single(found.greatest),
                found.index.to_string(),
                single(found.coordinate * unit.factor),
                single(found.rms),
            ]);
        }
    }
    page.caption("Reactions over the cycle: greatest, and root mean square");
    page.rows(&["pair", "on", "greatest R, N", "position", &coordinate, "RMS of R, N"], &rows);
}

fn balancing(source: &Source<'_>, page: &mut Page) {
    let Some(position) = greatest_balancing(&source.analysis.positions) else { return };
    let moment = source.analysis.input.balancing_is_moment;
    let (name, sign, unit) = if moment { ("moment", "Mb", MOMENT) } else { ("force", "Fb", FORCE) };
    page.section(&format!("Balancing {name}"));
    let link = match source.mechanism.balance {
        Some(Balance::Moment(id) | Balance::Force { at: Place { link: id, .. }, .. }) => id,
        None => source.mechanism.input.link,
    };
    let link = &source.mechanism.links[link].name;
    let caption = format!("The {name} on `{link}` that keeps the mechanism in its motion");
    page.table(&caption, &keys(source), vec![vec![column(source, sign, unit, |p| p.balancing)]]);
    let coordinate = source.units.coordinate;
    page.caption(&format!(
        "Greatest: {} {} in position {} ({} {})",
        single(position.balancing.unwrap_or_default()),
        unit.name,
        position.index,
        single(position.coordinate * coordinate.factor),
        coordinate.name
    ));
}

/// The position with the greatest modulus, the first of those that are equal up to rounding: a cycle often has two.
fn greatest_balancing(positions: &[PositionResult]) -> Option<&PositionResult> {
    let with = positions.iter().filter_map(|position| Some((position, position.balancing?.abs())));
    let greater = |best: (_, f64), next: (_, f64)| if next.1 > best.1 * (1.0 + 1e-9) { next } else { best };
    with.reduce(greater).map(|(position, _)| position)
}

/// The share of each cause.
fn causes(source: &Source<'_>, page: &mut Page) {
    let positions = &source.analysis.positions;
    let found = positions.iter().find_map(|p| Some((p.reactions.as_ref()?, p.by_cause.as_ref()?)));
    let Some((reactions, by_cause)) = found else { return };
    page.section("Reactions by cause");
    page.paragraph(
        "What each cause alone would do in the same position: projections and modulus of the force on the named link. \
         Projections sum to those of the whole; moduli do not.",
    );
    let causes: Vec<&str> = by_cause.reactions_by_cause.iter().map(|(name, _)| name).collect();
    for (pair, name, links) in shown(source, reactions) {
        for (link, on) in links {
            let share = |cause: &&str| {
                components(source, cause, |p| {
                    force(p.by_cause.as_ref()?.reactions_by_cause.get(cause)?, pair, link)
                })
            };
            let mut groups: Vec<_> = causes.iter().map(share).collect();
            groups.push(components(source, "whole", |p| force(p.reactions.as_ref()?, pair, link)));
            page.table(&format!("{name} on {on}"), &keys(source), groups);
        }
    }
    let unit = if source.analysis.input.balancing_is_moment { MOMENT } else { FORCE };
    let share = |cause: &&str| {
        let load = |p: &PositionResult| p.by_cause.as_ref()?.balancing_by_cause.get(cause).copied();
        vec![column(source, *cause, unit, load)]
    };
    let mut groups: Vec<_> = causes.iter().map(share).collect();
    groups.push(vec![column(source, "whole", unit, |p| p.balancing)]);
    page.table("Balancing load", &keys(source), groups);
}

/// Projections and modulus.
fn components(
    source: &Source<'_>,
    name: &str,
    force: impl Fn(&PositionResult) -> Option<[f64; 2]>,
) -> Vec<Column> {
    vec![
        column(source, format!("{name} Rx"), FORCE, |p| force(p).map(|f| f[0])),
        column(source, "Ry", FORCE, |p| force(p).map(|f| f[1])),
        column(source, "R", FORCE, |p| force(p).map(|f| f[0].hypot(f[1]))),
    ]
}
