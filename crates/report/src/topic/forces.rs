//! Reduction, reactions with their causes, loads and the balancing load.

use assur_analysis::results::{Owner, Part, Quantity, Statistic, Table as Results};
use assur_book::{Column, Document, Group, Table, Unit, catalogue, link_name, zero_if_rounding};
use assur_mechanism::{Balance, LinkId, PairId, Place};
use assur_words::{Text, name, number, text};

use super::{Source, Values, each};

/// Inertia, its derivative and the moment of the loads, reduced to the input link and to a point.
pub(super) fn reduction(source: &Source<'_>, page: &mut Document) {
    let table = &source.positions;
    let of = |quantity| Values::of(quantity, Owner::Input);
    let [inertia, moment] = [Quantity::ReducedInertia, Quantity::ReducedMoment].map(of);
    if table.is_empty() || table.schema().find(inertia).is_none() {
        return;
    }
    page.heading(text!("report-reduction"));
    let columns =
        [inertia, of(Quantity::ReducedInertiaDerivative), moment].map(|values| source.column(values));
    page.table(Table::over(text!("report-reduced"), source.keys(), columns.into()));
    let share = |owner| source.headed(source.name(owner), Values::of(Quantity::ReducedInertia, owner));
    let links = source.owners(Quantity::ReducedInertia, |owner| matches!(owner, Owner::Link(_)));
    if links.len() > 1 {
        let shares = links.into_iter().map(share).collect();
        page.table(Table::over(text!("report-shares"), source.keys(), shares));
    }
    // E eqs. 4-6.
    let dynamics = source.analysis.dynamics.as_ref();
    let Some(point) = dynamics.and_then(|found| found.reduction_point.as_ref()) else { return };
    let radius = point.radius;
    let (to, r) = (Text::from(&point.point), Unit::LENGTH.show(radius));
    let scaled = |values, by: f64| each(table, values).into_iter().map(move |value| Some(value? / by));
    let columns = vec![
        Column::numbers(name("m"), Unit::KILOGRAM, scaled(inertia, radius * radius)),
        Column::numbers(name("F"), Unit::FORCE, scaled(moment, radius)),
    ];
    page.table(Table::over(text!("report-reduced-to-point", point = to, radius = r), source.keys(), columns));
}

/// Whether any row has reactions.
pub(super) fn has_reactions(table: &Results) -> bool {
    let first = table.schema().select(|column| column.quantity == Quantity::Force).first().copied();
    first.is_some_and(|column| table.has(column))
}

pub(super) fn force(pair: PairId, link: LinkId) -> Values {
    Values::of(Quantity::Force, Owner::PairOn(pair, link))
}

/// The reactions in the pairs: in each position, and over the cycle.
pub(super) fn reactions(source: &Source<'_>, page: &mut Document) {
    if !has_reactions(&source.positions) {
        return;
    }
    page.heading(text!("report-reactions"));
    page.paragraph(text!("report-reactions-text"));
    reactions_at_positions(source, page);
    greatest(source, page);
}

/// The reactions in the shown positions.
pub fn reactions_at_positions(source: &Source<'_>, page: &mut Document) {
    let groups = catalogue::reactions(source.positions.schema())
        .into_iter()
        .map(|(pair, link)| of_pair(source, pair, link));
    page.table(source.table(text!("report-reactions-table"), text!("head-pair-on"), groups));
}

/// `B on rod`.
fn pair_on(source: &Source<'_>, pair: PairId, link: LinkId) -> Text {
    catalogue::owner(source.positions.schema(), force(pair, link))
}

fn of_pair(source: &Source<'_>, pair: PairId, link: LinkId) -> Group {
    let table = &source.positions;
    let values = force(pair, link);
    let [x, y] = [Part::X, Part::Y].map(|part| each(table, values.part(part)));
    let directions = x.into_iter().zip(y).map(|(x, y)| direction([x?, y?]));
    let mut columns = components(source, values);
    columns.push(Column::numbers(text!("head-direction"), Unit::ANGLE, directions));
    if matches!(pair, PairId::Slide(_)) {
        let of = |quantity| Values::of(quantity, Owner::Pair(pair));
        columns.extend([Quantity::Moment, Quantity::Offset].map(|quantity| source.column(of(quantity))));
    }
    Group { owner: pair_on(source, pair, link), columns }
}

/// Angle of a force, rad; a zero force has none. A component that is rounding counts as zero.
pub fn direction(force: [f64; 2]) -> Option<f64> {
    let modulus = force[0].hypot(force[1]);
    let [x, y] = force.map(|part| zero_if_rounding(part, modulus));
    (modulus > 1e-9).then(|| y.atan2(x))
}

fn greatest(source: &Source<'_>, page: &mut Document) {
    let all = &source.analysis.cycle.reaction_extremes;
    let of = |(pair, link)| all.iter().find(|one| one.joint.id == pair && one.on.id == link);
    let found = catalogue::reactions(source.analysis.positions.schema()).into_iter().filter_map(of);
    let table = Table::each(text!("report-greatest-reactions"), found)
        .column(text!("head-pair"), |found| Text::from(&found.joint))
        .column(text!("head-on"), |found| Text::from(&found.on))
        .measured(text!("head-greatest-force"), Unit::FORCE, |found| found.greatest)
        .column(text!("head-position"), |found| number(found.index))
        .measured(source.coordinate_head(), source.coordinate(), |found| found.coordinate)
        .measured(text!("head-rms-force"), Unit::FORCE, |found| found.rms);
    page.table(table.table());
}

/// The balancing load in each position, and the greatest one.
pub(super) fn balancing(source: &Source<'_>, page: &mut Document) {
    if source.kind.is_time() {
        return loads_of_drives(source, page);
    }
    let greatest = source.analysis.survey.of(Values::BALANCING).and_then(Statistic::farthest);
    let Some(greatest) = greatest else { return };
    let number = greatest.number;
    let is_moment = source.analysis.input.balancing_is_moment;
    page.heading(if is_moment { text!("report-balancing-moment") } else { text!("report-balancing-force") });
    balancing_at_positions(source, page);
    page.paragraph(text!(
        "report-greatest-balancing",
        load = Unit::load(is_moment).show(greatest.value),
        position = assur_words::number(number),
        at = source.coordinate().show(source.mechanism.input.coordinate(number))
    ));
}

/// Over time the load of each drive.
fn loads_of_drives(source: &Source<'_>, page: &mut Document) {
    let drives = source.owners(Quantity::Balancing, |owner| matches!(owner, Owner::Drive(_)));
    if source.positions.is_empty() || drives.is_empty() {
        return;
    }
    page.heading(text!("report-loads-of-drives"));
    balancing_at_positions(source, page);
}

/// The balancing load in the shown positions.
pub fn balancing_at_positions(source: &Source<'_>, page: &mut Document) {
    if source.kind.is_time() {
        let drives = source.owners(Quantity::Balancing, |owner| matches!(owner, Owner::Drive(_)));
        let load =
            |owner: &Owner| source.headed(source.name(*owner), Values::of(Quantity::Balancing, *owner));
        let caption = text!("report-loads-of-drives-table");
        return page.table(Table::over(caption, source.keys(), drives.iter().map(load).collect()));
    }
    let link = match source.mechanism.balance {
        Some(Balance::Moment(id) | Balance::Force { at: Place { link: id, .. }, .. }) => {
            link_name(source.mechanism, id)
        }
        None => assur_book::driven_link(source.mechanism),
    };
    let caption = if source.analysis.input.balancing_is_moment {
        text!("report-balancing-moment-on", link)
    } else {
        text!("report-balancing-force-on", link)
    };
    page.table(Table::over(caption, source.keys(), vec![source.column(Values::BALANCING)]));
}

/// The share of each cause.
pub(super) fn causes(source: &Source<'_>, page: &mut Document) {
    let schema = source.positions.schema();
    if schema.causes.is_empty() {
        return;
    }
    page.heading(text!("report-causes"));
    page.paragraph(text!("report-causes-text"));
    let causes = || schema.causes.iter().enumerate().map(|(cause, of)| (Some(cause), Text::from(of)));
    let all = || causes().chain([(None, text!("report-whole"))]);
    for (pair, link) in catalogue::reactions(source.positions.schema()) {
        let share = |(cause, owner)| Group {
            owner,
            columns: components(source, Values { cause, ..force(pair, link) }),
        };
        let caption = pair_on(source, pair, link);
        page.table(source.table(caption, text!("head-cause"), all().map(share)));
    }
    for owner in schema.owners(Quantity::Balancing) {
        let share =
            |(cause, head)| source.headed(head, Values { cause, ..Values::of(Quantity::Balancing, owner) });
        let caption = match owner {
            Owner::Drive(_) => text!("report-load-of-drive", drive = source.name(owner)),
            _ => text!("report-balancing"),
        };
        page.table(Table::over(caption, source.keys(), all().map(share).collect()));
    }
}

/// The heads of projections and modulus of a reaction.
pub fn force_heads() -> [Column; 3] {
    let force = Values::of(Quantity::Force, Owner::Input);
    let head = |part| Column::short(catalogue::head(force.part(part)), Unit::FORCE);
    [Part::X, Part::Y, Part::Modulus].map(head)
}

/// Projections and modulus.
fn components(source: &Source<'_>, force: Values) -> Vec<Column> {
    [Part::X, Part::Y, Part::Modulus].map(|part| source.column(force.part(part))).into()
}

/// The loads, the inertia loads of the links, and the shaking force.
pub(super) fn loads(source: &Source<'_>, page: &mut Document) {
    let schema = source.positions.schema();
    let (loads, links) = (schema.owners(Quantity::Load), schema.owners(Quantity::InertiaForce));
    let shaking = wrench(source, Quantity::ShakingForce, Quantity::ShakingMoment, Owner::Input);
    if source.positions.is_empty() || loads.is_empty() && links.is_empty() {
        return;
    }
    page.heading(text!("report-loads"));
    let load = |owner: &Owner| source.headed(source.name(*owner), Values::of(Quantity::Load, *owner));
    let columns: Vec<_> = loads.iter().map(load).collect();
    if !columns.is_empty() {
        page.table(Table::over(text!("report-loads-table"), source.keys(), columns));
    }
    inertia_loads(source, page);
    if !links.is_empty() {
        page.table(Table::over(text!("report-shaking-table"), source.keys(), shaking));
    }
}

/// Principal vectors and principal moments of the inertia loads of the links.
pub fn inertia_loads(source: &Source<'_>, page: &mut Document) {
    let group = |owner| Group {
        owner: source.name(owner),
        columns: wrench(source, Quantity::InertiaForce, Quantity::InertiaMoment, owner),
    };
    let links = source.owners(Quantity::InertiaForce, |_| true);
    page.table(source.table(text!("report-inertia-table"), text!("head-link"), links.into_iter().map(group)));
}

/// Projections of a force, and a moment.
fn wrench(source: &Source<'_>, force: Quantity, moment: Quantity, owner: Owner) -> Vec<Column> {
    let [x, y] = Values::vector(force, owner);
    [x, y, Values::of(moment, owner)].map(|values| source.column(values)).into()
}
