//! The results that are asked for first: structure, strokes, greatest loads, the drive, whether the checks hold.

use assur_analysis::results::{Analysis, Column, Owner, Part, Quantity, Table, Turn};
use assur_book::{Fact, ROUNDING, Unit, catalogue};
use assur_geometry::{CrankCondition, crank_conditions, overview};
use assur_kinematics::Linkage;
use assur_mechanism::GROUND;
use assur_motor::FlywheelSize;
use assur_words::{Text, count, joined, list, name, number, text};

use super::{drive::flywheel_shaft, forces::force, friction::facts as friction_facts, regime};

/// Relative size of a change that is rounding.
const CONSTANT: f64 = 1e-9;

/// What a group of facts is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum About {
    /// Groups and class.
    Structure,
    /// Strokes, time ratios, angles, speeds.
    Motion,
    /// Reactions and the balancing load.
    Forces,
    /// The regime and the drive.
    Regime,
    /// What has no solution, and whether the checks hold.
    Checks,
}

/// All results that are asked for first, each with what it is about.
pub fn results(analysis: &Analysis, linkage: &Linkage) -> Vec<(About, Fact)> {
    let place = Unit::coordinate(analysis.input.kind);
    let of_forces = if is_over_time(analysis) { Unit::SECOND } else { place };
    let mut forces = reactions(analysis, linkage, of_forces);
    forces.extend(balancing(analysis, linkage, of_forces));
    forces.extend(analysis.friction.iter().flat_map(|cycle| friction_facts(cycle, place)));
    let main = [
        "fact-mean-speed",
        "fact-unevenness",
        "fact-required-power",
        "fact-power-taken",
        "fact-motor",
        "fact-rated-power",
        "fact-gear-ratio",
        "fact-driving-moment",
        "fact-braking-moment",
        "fact-flywheel",
    ];
    let mut regime = end_of_motion(analysis);
    regime.extend(regime::facts(analysis).into_iter().filter(|fact| main.contains(&fact.id)));
    regime.extend(analysis.dynamics.iter().flat_map(|found| &found.flywheel_places).map(flywheel));
    let all = [
        (About::Structure, structure(analysis)),
        (About::Structure, cranks(linkage)),
        (About::Structure, change_points(linkage, place).into_iter().collect()),
        (About::Checks, lost(analysis, linkage)),
        (About::Motion, motion(analysis, linkage, place)),
        (About::Forces, forces),
        (About::Regime, regime),
        (About::Checks, checks_fact(analysis).into_iter().collect()),
    ];
    all.into_iter().flat_map(|(about, facts)| facts.into_iter().map(move |fact| (about, fact))).collect()
}

/// Whether the forces belong to the samples of a motion from an initial state.
fn is_over_time(analysis: &Analysis) -> bool {
    analysis.integration.is_some()
}

/// A flywheel in the form in which it is ordered.
fn flywheel(size: &FlywheelSize) -> Fact {
    let [inertia, mass] =
        [(size.inertia, Unit::INERTIA), (size.mass, Unit::KILOGRAM)].map(|(of, unit)| unit.show(of));
    let [diameter, width] = [size.diameter, size.width].map(|side| Unit::LENGTH.show(side));
    let told = text!("fact-flywheel-sizes", inertia, mass, diameter, width);
    Fact::text("fact-flywheel-of", told).of("shaft", flywheel_shaft(size.shaft))
}

/// The results that are asked for first, one below the other.
pub fn summary(analysis: &Analysis, linkage: &Linkage) -> Vec<Fact> {
    results(analysis, linkage).into_iter().map(|(_, fact)| fact).collect()
}

fn structure(analysis: &Analysis) -> Vec<Fact> {
    let structure = &analysis.structure;
    let class = name(assur_structure::roman(structure.class));
    vec![
        Fact::text("fact-formula", Text::from(&structure.formula)),
        Fact::text("fact-class", list([class, text!("fact-mobility", number = number(structure.mobility))])),
    ]
}

/// Whether the crank of each four-bar turns fully, and how long it may be.
fn cranks(linkage: &Linkage) -> Vec<Fact> {
    let named = |link: usize| Text::from(&linkage.mechanism.links[link].name);
    let fact = |found: CrankCondition| {
        let [least, most] = found.turning.map(|length| Unit::LENGTH.show(length));
        let crank = Unit::LENGTH.show(found.crank);
        let told = match (found.holds(), found.turning[0] > 0.0) {
            _ if found.turning[0] > found.turning[1] => text!("fact-crank-never", crank),
            (true, false) => text!("fact-crank-turns", crank, most),
            (false, false) => text!("fact-crank-stops", crank, most),
            (true, true) => text!("fact-long-crank-turns", crank, least, most),
            (false, true) => text!("fact-long-crank-stops", crank, least, most),
        };
        let [coupler, rocker] = found.links.map(named);
        Fact::text("fact-crank-condition", told).of("coupler", coupler).of("rocker", rocker)
    };
    crank_conditions(&linkage.mechanism).into_iter().map(fact).collect()
}

/// Where two modes of a group meet.
fn change_points(linkage: &Linkage, place: Unit) -> Option<Fact> {
    let mut at: Vec<f64> = linkage.change_points().map(|point| point.coordinate).collect();
    at.sort_by(f64::total_cmp);
    at.dedup_by(|one, other| (*one - *other).abs() <= CONSTANT * linkage.structure.scale.max(1.0));
    (!at.is_empty()).then(|| Fact::text("fact-change-points", count(at.len())).at(&at, place))
}

fn end_of_motion(analysis: &Analysis) -> Vec<Fact> {
    let kind = analysis.input.kind;
    let facts = analysis.integration.as_ref().map(|found| {
        let time = Fact::number("fact-end-time", found.end.time, Unit::SECOND)
            .at(&[found.end.coordinate], Unit::coordinate(kind));
        let turns = found.turns.map(|turns| Fact::number("fact-turns", turns, Unit::si("rev")));
        [Some(time), turns, Some(Fact::number("fact-end-speed", found.end.speed, Unit::rates_of(kind)[0]))]
    });
    facts.into_iter().flatten().flatten().collect()
}

/// The value of greatest modulus of a quantity: between the positions too where it was looked for there, else at the positions that are
/// kept, or at the samples of a motion over time.
fn farthest(analysis: &Analysis, column: Column) -> Option<Turn> {
    analysis.peaks.of(column).filter(|_| !is_over_time(analysis)).or_else(|| {
        let (table, over) = rows(analysis);
        let value = |row| Some(Turn::at(table.get(row, over)?, table.get(row, column)?));
        let found: Vec<Turn> = (0..table.len()).filter_map(value).collect();
        Turn::statistic(&found).farthest().map(|best| found[best.number])
    })
}

/// Whether a quantity with this extreme is the same everywhere.
fn is_constant(analysis: &Analysis, column: Column, turn: Turn) -> bool {
    let (table, _) = rows(analysis);
    let apart = |row| (table.get(row, column).unwrap_or(f64::NAN) - turn.value).abs();
    table.len() > 1 && (0..table.len()).all(|row| apart(row) <= CONSTANT * turn.value.abs())
}

/// The table over which a quantity reaches its extremes, and the column of their places.
fn rows(analysis: &Analysis) -> (&Table, Column) {
    if is_over_time(analysis) {
        (&analysis.trajectory, Column::TIME)
    } else {
        (&analysis.positions, Column::COORDINATE)
    }
}

/// An extreme of a quantity with its place; one that is not finite grows without limit towards that place.
fn extreme(
    analysis: &Analysis,
    id: &'static str,
    column: Column,
    turn: Turn,
    [unit, place]: [Unit; 2],
) -> Fact {
    let fact = if turn.value.is_finite() {
        let is_constant = is_constant(analysis, column, turn);
        Fact { is_constant, ..Fact::number(id, turn.value, unit) }.at(&[turn.at], place)
    } else {
        Fact::text(id, text!("fact-unlimited", place = place.show_all(&[turn.at])))
    };
    fact.about(column)
}

/// How far slides and links of the ground go, and how fast.
fn motion(analysis: &Analysis, linkage: &Linkage, place: Unit) -> Vec<Fact> {
    let Ok(found) = overview(linkage) else { return travels(analysis, linkage, place) };
    let mechanism = &linkage.mechanism;
    let slides = found.slides.iter().map(|(id, at)| (Owner::Slide(*id), &mechanism.slides[*id].name, at));
    let links = found.links.iter().map(|(id, at)| (Owner::Link(*id), &mechanism.links[*id].name, at));
    let mut facts = Vec::new();
    for (owner, of, course) in slides.chain(links) {
        let Some(stroke) = &course.stroke else { continue };
        let pf1 = &course.pf1;
        let is_slide = matches!(owner, Owner::Slide(_));
        let (id, unit) = if is_slide { ("fact-stroke", Unit::LENGTH) } else { ("fact-swing", Unit::ANGLE) };
        let place_of = Column::of(Quantity::Transfer(0), owner);
        let of = |fact: Fact| fact.of("slide", Text::from(of));
        let size = Fact::number(id, stroke.stroke, unit).at(&stroke.dead_points, place);
        facts.push(of(size).about(place_of));
        let ratio = stroke.time_ratio.map(|ratio| Fact::number("fact-time-ratio", ratio, Unit::NONE));
        facts.extend(ratio.map(|fact| of(fact).about(place_of)));
        let speed = Column::of(Quantity::Velocity, owner);
        facts.push(if let Some(turn) = farthest(analysis, speed) {
            let unit = Unit::rates(!is_slide)[0];
            of(extreme(analysis, "fact-fastest", speed, turn, [unit, place]))
        } else {
            let [value, at] =
                if pf1.max.abs() >= pf1.min.abs() { [pf1.max, pf1.at_max] } else { [pf1.min, pf1.at_min] };
            let unit = Unit::transfer(!is_slide, analysis.input.kind, 1);
            let fact = of(Fact::number("fact-greatest-pf1", value, unit)).at(&[at], place);
            fact.about(Column::of(Quantity::Transfer(1), owner))
        });
    }
    facts.extend(found.transmission.map(|(group, angle, at)| {
        let fact = Fact::number("fact-transmission", angle, Unit::ANGLE).of("group", number(group + 1));
        let fact = Fact { is_constant: found.constant_transmission, ..fact };
        fact.at(&[at], place).about(Column::of(Quantity::Condition, Owner::Group(group)))
    }));
    facts
}

/// How far slides and links go in the positions that are calculated: a mechanism that can't be assembled everywhere has no strokes.
fn travels(analysis: &Analysis, linkage: &Linkage, place: Unit) -> Vec<Fact> {
    let (table, input) = (&analysis.positions, &linkage.mechanism.input);
    let is_output = |column: &Column| match column.owner {
        Owner::Link(link) => !input.places(link),
        Owner::Slide(slide) => linkage.mechanism.slides[slide].on == GROUND,
        _ => false,
    };
    let mut facts = Vec::new();
    for column in table.schema().columns().iter().filter(|column| is_output(column)) {
        let is_angle = matches!(column.owner, Owner::Link(_));
        let owner = table.schema().named(column.owner).map(Text::from).unwrap_or_default();
        let of = |fact: Fact| fact.of("slide", owner.clone()).about(*column);
        if column.quantity == Quantity::Transfer(0) {
            let ends = |row| Some(Turn::at(table.get(row, Column::COORDINATE)?, table.get(row, *column)?));
            let turns: Vec<Turn> = (0..table.len()).filter_map(ends).collect();
            let found = Turn::statistic(&turns);
            let Some((least, most)) = found.least().zip(found.greatest()) else { continue };
            let travel = Fact::number("fact-travel", most.value - least.value, Unit::place(is_angle));
            facts.push(of(travel.at(&[turns[least.number].at, turns[most.number].at], place)));
        } else if column.quantity == Quantity::Velocity
            && let Some(turn) = farthest(analysis, *column)
        {
            let units = [Unit::rates(is_angle)[0], place];
            facts.push(of(extreme(analysis, "fact-fastest", *column, turn, units)));
        }
    }
    facts
}

/// Without what is rounding beside the greatest reaction, of a moment over the size of the mechanism.
fn reactions(analysis: &Analysis, linkage: &Linkage, place: Unit) -> Vec<Fact> {
    let schema = rows(analysis).0.schema();
    let named = |owner| schema.named(owner).map(Text::from).unwrap_or_default();
    let mut facts = Vec::new();
    let pairs = catalogue::reactions(schema);
    let moduli =
        pairs.iter().filter_map(|(pair, link)| farthest(analysis, force(*pair, *link).part(Part::Modulus)));
    let moduli = moduli.map(|turn| turn.value.abs()).filter(|value| value.is_finite());
    let floor = ROUNDING * moduli.fold(0.0, f64::max);
    for links in pairs.chunk_by(|one, other| one.0 == other.0) {
        let pair = links[0].0;
        let of_pair = |id: &'static str, column: Column, unit: Unit| {
            let lever = if unit == Unit::MOMENT { linkage.structure.scale } else { 1.0 };
            let turn = farthest(analysis, column).filter(|turn| turn.value.abs() > floor * lever)?;
            let fact = extreme(analysis, id, column, turn, [unit, place]);
            Some(fact.of("pair", named(Owner::Pair(pair))))
        };
        for &(_, link) in links {
            let column = force(pair, link).part(Part::Modulus);
            let fact = of_pair("fact-greatest-reaction", column, Unit::FORCE);
            facts.extend(fact.map(|fact| fact.of("link", named(Owner::Link(link)))));
        }
        let moment = Column::of(Quantity::Moment, Owner::Pair(pair));
        facts.extend(of_pair("fact-greatest-moment", moment, Unit::MOMENT));
    }
    facts
}

fn balancing(analysis: &Analysis, linkage: &Linkage, place: Unit) -> Vec<Fact> {
    let (table, _) = rows(analysis);
    let schema = table.schema();
    if !schema.drives.is_empty() {
        let of_drive = |owner: Owner| {
            let column = Column::of(Quantity::Balancing, owner);
            let units = [catalogue::unit(schema, column), place];
            let fact =
                extreme(analysis, "fact-greatest-load-of-drive", column, farthest(analysis, column)?, units);
            Some(fact.of("drive", schema.named(owner).map(Text::from).unwrap_or_default()))
        };
        return schema.owners(Quantity::Balancing).into_iter().filter_map(of_drive).collect();
    }
    let reduced = table.schema().owners(Quantity::ReducedLoad).into_iter();
    let reduced = reduced.filter_map(|owner| farthest(analysis, Column::of(Quantity::ReducedLoad, owner)));
    // Beside the loads that it balances it may be rounding.
    let floor = ROUNDING * reduced.fold(0.0, |most: f64, turn| most.max(turn.value.abs()));
    let turn = farthest(analysis, Column::BALANCING).filter(|turn| turn.value.abs() > floor);
    let Some(turn) = turn else { return Vec::new() };
    let is_moment = analysis.input.balancing_is_moment;
    let unit = Unit::load(is_moment);
    let ids = if is_moment {
        ["fact-greatest-balancing-moment", "fact-mean-balancing-moment", "fact-rms-balancing-moment"]
    } else {
        ["fact-greatest-balancing-force", "fact-mean-balancing-force", "fact-rms-balancing-force"]
    };
    let mut facts = vec![extreme(analysis, ids[0], Column::BALANCING, turn, [unit, place])];
    // The mean moment of a regime is that of its works.
    let means = analysis.peaks.balancing.filter(|_| linkage.mechanism.balance.is_none());
    let means = means.filter(|_| analysis.dynamics.is_none());
    for (id, value) in ids[1..].iter().zip(means.iter().flat_map(|means| [means.mean, means.rms])) {
        let is_sure = means.is_some_and(|means| means.are_sure());
        let error = means.map_or(0.0, |means| means.error);
        let unsure = || text!("fact-unsure", value = unit.show(value), error = unit.show(error));
        let fact = if is_sure { Fact::number(id, value, unit) } else { Fact::text(id, unsure()) };
        facts.push(fact.about(Column::BALANCING));
    }
    let power = analysis.peaks.power.filter(|_| means.is_some());
    let units = [Unit::POWER, place];
    facts.extend(power.map(|turn| extreme(analysis, "fact-greatest-power", Column::BALANCING, turn, units)));
    facts
}

/// What has no solution, so that nothing after it speaks of everything.
fn lost(analysis: &Analysis, linkage: &Linkage) -> Vec<Fact> {
    let (all, solved) = (linkage.mechanism.input.positions, analysis.survey.rows);
    let of_all = |found: usize| text!("fact-of-all", found = number(found), all = number(all));
    let forceless = (solved + analysis.survey.failures).saturating_sub(all);
    let positions = [
        (solved < all).then(|| Fact::text("fact-solved-positions", of_all(solved))),
        (forceless > 0).then(|| Fact::text("fact-forceless-positions", of_all(forceless))),
    ];
    let motion = analysis.no_motion.as_ref();
    let motion = motion.map(|_| Fact::text("fact-wanted-motion", text!("fact-not-found")));
    positions.into_iter().chain([motion]).flatten().collect()
}

/// How many checks hold, or which of them fail; `None` before they are done.
pub fn checks_fact(analysis: &Analysis) -> Option<Fact> {
    let checks = &analysis.checks;
    if checks.is_empty() {
        return None;
    }
    let failed: Vec<_> =
        checks.iter().filter(|check| check.finding.failed()).map(|check| check.name.clone()).collect();
    if !failed.is_empty() {
        return Some(Fact::text("fact-checks-fail", list(failed)));
    }
    let judged = checks.iter().filter(|check| check.finding.holds.is_some()).count();
    let whole = analysis.survey.failures == 0 && analysis.no_motion.is_none();
    let id = if whole { "fact-checks-hold" } else { "fact-checks-hold-partly" };
    Some(Fact::text(id, joined(" / ", [judged, checks.len()].map(count))))
}
