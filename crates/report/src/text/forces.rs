//! Reduction, reactions with their causes, and the balancing load.

use assur_analysis::results::{Column as Values, Owner, Part, Quantity, Table};
use assur_mechanism::{Balance, GROUND, LinkId, PairId, Place};

use super::Source;
use super::layout::{Column, Page};
use super::motion::{column, each, keys, modulus};
use super::number::{short, single};
use super::units::{ANGLE, FORCE, KILOGRAM, LENGTH, MOMENT};

pub(super) fn write(source: &Source<'_>, page: &mut Page) {
    reduction(source, page);
    reactions(source, page);
    balancing(source, page);
    causes(source, page);
}

fn reduction(source: &Source<'_>, page: &mut Page) {
    let table = &source.analysis.positions;
    let of = |quantity| Values::of(quantity, Owner::Input);
    let [inertia, moment] = [Quantity::ReducedInertia, Quantity::ReducedMoment].map(of);
    if table.is_empty() || table.schema().find(inertia).is_none() {
        return;
    }
    let (units, keys) = (source.units.reduced, keys(source));
    page.section("Reduction to the input link");
    let columns = vec![
        column(source, "J", units[0], inertia),
        column(source, "dJ/dq", units[1], of(Quantity::ReducedInertiaDerivative)),
        column(source, "Q", units[2], moment),
    ];
    let caption = "Inertia J, its derivative dJ/dq, and Q of all loads but the balancing one";
    page.table(caption, &keys, vec![columns]);
    let owners = table.schema().owners(Quantity::ReducedInertia).into_iter();
    let links = owners.filter(|owner| matches!(owner, Owner::Link(_)));
    let share = |owner| {
        column(source, table.schema().name(owner), units[0], Values::of(Quantity::ReducedInertia, owner))
    };
    let shares: Vec<_> = links.map(share).collect();
    if shares.len() > 1 {
        page.table(
            "Shares of the links in J (E eq. 8); flywheel and rotor are not in J",
            &keys,
            vec![shares],
        );
    }
    // E eqs. 4-6.
    let dynamics = source.analysis.dynamics.as_ref();
    let Some(point) = dynamics.and_then(|found| found.reduction_point.as_ref()) else { return };
    let radius = point.radius;
    let caption = format!(
        "The same reduced to point {} of the input link: force F = Q/r along its motion, mass m = J/r², r = {} mm",
        point.name,
        short(1e3 * radius)
    );
    let scaled = |values, by: f64| each(table, values).into_iter().map(move |value| Some(value? / by));
    let columns = vec![
        Column::numbers("m", KILOGRAM, scaled(inertia, radius * radius)),
        Column::numbers("F", FORCE, scaled(moment, radius)),
    ];
    page.table(&caption, &keys, vec![columns]);
}

/// All pairs that have reactions, each with the links that are shown: of two links the first that moves (the force on
/// the other is opposite), of more links all.
pub(super) fn shown(table: &Table) -> Vec<(PairId, Vec<LinkId>)> {
    let mut pairs: Vec<(PairId, Vec<LinkId>)> = Vec::new();
    for owner in table.schema().owners(Quantity::Force) {
        let Owner::PairOn(pair, link) = owner else { continue };
        match pairs.last_mut() {
            Some((last, links)) if *last == pair => links.push(link),
            _ => pairs.push((pair, vec![link])),
        }
    }
    for (_, links) in &mut pairs {
        if let [first, second] = links[..] {
            *links = vec![if first == GROUND { second } else { first }];
        }
    }
    pairs
}

/// Whether any row has reactions.
pub(super) fn has_reactions(table: &Table) -> bool {
    let first = table.schema().select(|column| column.quantity == Quantity::Force).first().copied();
    first.is_some_and(|column| table.has(column))
}

/// The force of a pair on a link.
pub(super) fn force(pair: PairId, link: LinkId) -> Values {
    Values::of(Quantity::Force, Owner::PairOn(pair, link))
}

fn reactions(source: &Source<'_>, page: &mut Page) {
    let table = &source.analysis.positions;
    if !has_reactions(table) {
        return;
    }
    let (schema, keys) = (table.schema(), keys(source));
    page.section("Reactions");
    page.paragraph(
        "The force that the pair exerts on the named link (the other link gets the opposite): projections, modulus R, \
         direction from the x axis. Slides: M is the moment on the sliding link about its point; s is where along the guide, \
         from that point, the force alone would do the same.",
    );
    for (pair, links) in shown(table) {
        let groups = links.iter().map(|link| of_pair(source, pair, *link)).collect();
        let links: Vec<_> = links.into_iter().map(|link| schema.link(link)).collect();
        let name = schema.name(Owner::Pair(pair));
        page.table(&format!("{name} on {}", links.join(", ")), &keys, groups);
    }
    greatest(source, page);
}

fn of_pair(source: &Source<'_>, pair: PairId, link: LinkId) -> Vec<Column> {
    let table = &source.analysis.positions;
    let values = force(pair, link);
    let [x, y] = [Part::X, Part::Y].map(|part| each(table, values.part(part)));
    let directions = x.into_iter().zip(y).map(|(x, y)| direction([x?, y?]));
    let mut columns = components(source, "", values);
    columns.push(Column::numbers("direction", ANGLE, directions));
    if matches!(pair, PairId::Slide(_)) {
        let of = |quantity| Values::of(quantity, Owner::Pair(pair));
        columns.push(column(source, "M", MOMENT, of(Quantity::Moment)));
        columns.push(column(source, "s", LENGTH, of(Quantity::Offset)));
    }
    columns
}

/// Angle of a force; a zero force has none. A component that is rounding counts as zero.
fn direction(force: [f64; 2]) -> Option<f64> {
    let modulus = force[0].hypot(force[1]);
    let [x, y] = force.map(|part| if part.abs() <= 1e-12 * modulus { 0.0 } else { part });
    (modulus > 1e-9).then(|| y.atan2(x))
}

fn greatest(source: &Source<'_>, page: &mut Page) {
    let unit = source.units.coordinate;
    let coordinate = format!("{}, {}", source.analysis.input.link, unit.name);
    let schema = source.analysis.positions.schema();
    let mut rows = Vec::new();
    for (pair, links) in shown(&source.analysis.positions) {
        let name = schema.name(Owner::Pair(pair));
        for on in links.into_iter().map(|link| schema.link(link)) {
            let all = &source.analysis.cycle.reaction_extremes;
            let Some(found) = all.iter().find(|one| one.joint == name && one.on == on) else { continue };
            rows.push(vec![
                name.to_string(),
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
    let Some((number, greatest)) = source.analysis.survey.greatest_balancing else { return };
    let moment = source.analysis.input.balancing_is_moment;
    let (name, sign, unit) = if moment { ("moment", "Mb", MOMENT) } else { ("force", "Fb", FORCE) };
    page.section(&format!("Balancing {name}"));
    let link = match source.mechanism.balance {
        Some(Balance::Moment(id) | Balance::Force { at: Place { link: id, .. }, .. }) => id,
        None => source.mechanism.input.link,
    };
    let link = &source.mechanism.links[link].name;
    let caption = format!("The {name} on `{link}` that keeps the mechanism in its motion");
    page.table(&caption, &keys(source), vec![vec![column(source, sign, unit, Values::BALANCING)]]);
    let coordinate = source.units.coordinate;
    page.caption(&format!(
        "Greatest: {} {} in position {} ({} {})",
        single(greatest),
        unit.name,
        number,
        single(source.mechanism.input.coordinate(number) * coordinate.factor),
        coordinate.name
    ));
}

/// The share of each cause.
fn causes(source: &Source<'_>, page: &mut Page) {
    let table = &source.analysis.positions;
    let schema = table.schema();
    if schema.causes.is_empty() {
        return;
    }
    page.section("Reactions by cause");
    page.paragraph(
        "What each cause alone would do in the same position: projections and modulus of the force on the named link. \
         Projections sum to those of the whole; moduli do not.",
    );
    let causes = || schema.causes.iter().enumerate().map(|(cause, name)| (Some(cause), name.as_str()));
    let all = || causes().chain([(None, "whole")]);
    for (pair, links) in shown(table) {
        for link in links {
            let share = |(cause, name): (_, &str)| {
                components(source, &format!("{name} "), Values { cause, ..force(pair, link) })
            };
            let title = format!("{} on {}", schema.name(Owner::Pair(pair)), schema.link(link));
            page.table(&title, &keys(source), all().map(share).collect());
        }
    }
    let unit = if source.analysis.input.balancing_is_moment { MOMENT } else { FORCE };
    let share = |(cause, name)| vec![column(source, name, unit, Values { cause, ..Values::BALANCING })];
    page.table("Balancing load", &keys(source), all().map(share).collect());
}

/// Projections and modulus; `name`: in front of the first head.
fn components(source: &Source<'_>, name: &str, force: Values) -> Vec<Column> {
    vec![
        column(source, format!("{name}Rx"), FORCE, force.part(Part::X)),
        column(source, "Ry", FORCE, force.part(Part::Y)),
        Column::numbers("R", FORCE, modulus(&source.analysis.positions, force)),
    ]
}

pub(super) fn write_loads(source: &Source<'_>, page: &mut Page) {
    let schema = source.analysis.positions.schema();
    let (loads, links) = (schema.owners(Quantity::Load), schema.owners(Quantity::InertiaForce));
    if source.analysis.positions.is_empty() || loads.is_empty() && links.is_empty() {
        return;
    }
    let keys = keys(source);
    page.section("Loads and inertia loads");
    let load = |owner: &Owner| {
        let values = Values::of(Quantity::Load, *owner);
        let unit = if assur_book::catalogue::unit(schema, values) == "N m" { MOMENT } else { FORCE };
        vec![column(source, schema.name(*owner), unit, values)]
    };
    let caption = "Loads: a force along its direction, a moment counter-clockwise, the tension of a spring";
    page.table(caption, &keys, loads.iter().map(load).collect());
    let inertia = |owner: &Owner| {
        let name = schema.name(*owner);
        wrench(source, &format!("{name} "), Quantity::InertiaForce, Quantity::InertiaMoment, *owner)
    };
    let caption = "Inertia loads: principal vector -m a at the center of mass, principal moment -I e";
    page.table(caption, &keys, links.iter().map(inertia).collect());
    if !links.is_empty() {
        let shaking = wrench(source, "", Quantity::ShakingForce, Quantity::ShakingMoment, Owner::Input);
        page.table("Shaking force on the ground, and shaking moment about the origin", &keys, vec![shaking]);
    }
}

/// Projections of a force, and a moment.
fn wrench(source: &Source<'_>, name: &str, force: Quantity, moment: Quantity, owner: Owner) -> Vec<Column> {
    let force = Values::of(force, owner);
    vec![
        column(source, format!("{name}Fx"), FORCE, force.part(Part::X)),
        column(source, format!("{name}Fy"), FORCE, force.part(Part::Y)),
        column(source, format!("{name}M"), MOMENT, Values::of(moment, owner)),
    ]
}
