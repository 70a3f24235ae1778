//! The results that are asked for first: structure, strokes, greatest loads, the drive, whether the checks hold.

use assur_analysis::results::{Analysis, Column, Owner, Quantity};
use assur_book::{Fact, Unit};
use assur_diagram::Extreme;
use assur_geometry::output_strokes;
use assur_kinematics::Linkage;
use assur_words::{Text, count, joined, list, name, number, text};

use super::forces::greatest_reactions;
use super::units::{FORCE, LENGTH, MOMENT, POWER, SECOND, TURN};
use super::{Units, regime};

/// The results that are asked for first. Greatest values are those of the positions of the scene, strokes are found between
/// them.
pub fn summary(analysis: &Analysis, linkage: &Linkage) -> Vec<Fact> {
    let place = Units::of(analysis.input.angular).coordinate;
    let mut facts = structure(analysis);
    facts.extend(end_of_motion(analysis));
    facts.extend(strokes(linkage, place));
    facts.extend(reactions(analysis, linkage, place));
    facts.extend(balancing(analysis, linkage, place));
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
    facts.extend(regime::facts(analysis).into_iter().filter(|fact| main.contains(&fact.id)));
    facts.extend(lost(analysis));
    facts.extend(checks(analysis));
    facts
}

fn structure(analysis: &Analysis) -> Vec<Fact> {
    let structure = &analysis.structure;
    vec![
        Fact::text("fact-formula", Text::from(&structure.formula)),
        Fact::text("fact-class", name(assur_structure::roman(structure.class))),
        Fact::text("fact-mobility", number(structure.mobility)),
    ]
}

fn end_of_motion(analysis: &Analysis) -> Vec<Fact> {
    let units = Units::of(analysis.input.angular);
    let facts = analysis.integration.as_ref().map(|found| {
        let time = Fact::number("fact-end-time", found.end.time, SECOND)
            .at(&[found.end.coordinate], units.coordinate);
        let turns = found.turns.map(|turns| Fact::number("fact-turns", turns, TURN));
        [Some(time), turns, Some(Fact::number("fact-end-speed", found.end.speed, units.rates[0]))]
    });
    facts.into_iter().flatten().flatten().collect()
}

/// A mechanism that can't be assembled everywhere has no strokes.
fn strokes(linkage: &Linkage, place: Unit) -> Vec<Fact> {
    let of = |(slide, stroke): (usize, assur_geometry::Stroke)| {
        let name = Text::from(&linkage.mechanism.slides[slide].name);
        let size = Fact::number("fact-stroke", stroke.stroke, LENGTH).at(&stroke.dead_points, place);
        let ratio = stroke.time_ratio.map(|ratio| Fact::number("fact-time-ratio", ratio, Unit::NONE));
        [Some(size), ratio].into_iter().flatten().map(move |fact| fact.of("slide", name.clone()))
    };
    output_strokes(linkage).unwrap_or_default().into_iter().flat_map(of).collect()
}

fn reactions(analysis: &Analysis, linkage: &Linkage, place: Unit) -> Vec<Fact> {
    let mut facts = Vec::new();
    let all: Vec<&Extreme> = greatest_reactions(analysis).collect();
    for of_pair in all.chunk_by(|one, next| one.joint == next.joint) {
        for found in of_pair.iter().filter(|one| one.greatest > 0.0) {
            let fact = Fact::number("fact-greatest-reaction", found.greatest, FORCE);
            let fact = fact.of("pair", (&found.joint).into()).of("link", (&found.on).into());
            facts.push(fact.at(&[found.coordinate], place));
        }
        let joint = &of_pair[0].joint;
        let moments = &analysis.survey.greatest_moments;
        let found = moments.iter().find(|(guide, (_, moment))| *guide == joint.id && *moment != 0.0);
        if let Some((_, (number, moment))) = found {
            let at = linkage.mechanism.input.coordinate(*number);
            let fact = Fact::number("fact-greatest-moment", *moment, MOMENT);
            facts.push(fact.of("pair", joint.into()).at(&[at], place));
        }
    }
    facts
}

fn balancing(analysis: &Analysis, linkage: &Linkage, place: Unit) -> Vec<Fact> {
    let input = &linkage.mechanism.input;
    let greatest = analysis.survey.greatest_balancing.filter(|(_, load)| *load != 0.0);
    let Some((number, greatest)) = greatest else { return Vec::new() };
    let (id, mean_id, unit) = if analysis.input.balancing_is_moment {
        ("fact-greatest-balancing-moment", "fact-mean-balancing-moment", MOMENT)
    } else {
        ("fact-greatest-balancing-force", "fact-mean-balancing-force", FORCE)
    };
    let mut facts = vec![Fact::number(id, greatest, unit).at(&[input.coordinate(number)], place)];
    let table = &analysis.positions;
    let found = table.schema().find(Column::BALANCING).filter(|_| linkage.mechanism.balance.is_none());
    let Some(load) = found.filter(|_| analysis.dynamics.is_none()) else { return facts };
    let loads: Vec<f64> = table.each(load).flatten().collect();
    // Equal steps over a whole cycle; a part of a cycle has no mean of this kind. The mean moment of a regime is that of
    // its works, which the positions give to the step of the positions only.
    if input.is_cycle() && loads.len() == table.len() {
        facts.push(Fact::number(mean_id, loads.iter().sum::<f64>() / loads.len() as f64, unit));
    }
    let speed = Column::of(Quantity::Velocity, Owner::Input);
    let power = |row: usize| Some((row, table.at(row, load)? * table.get(row, speed)?));
    let greatest =
        (0..table.len()).filter_map(power).max_by(|one, other| one.1.abs().total_cmp(&other.1.abs()));
    facts.extend(greatest.map(|(row, power)| {
        let at = input.coordinate(table.numbers()[row]);
        Fact::number("fact-greatest-power", power, POWER).at(&[at], place)
    }));
    facts
}

/// What has no solution, so that nothing after it speaks of everything.
fn lost(analysis: &Analysis) -> Vec<Fact> {
    let failures = analysis.survey.failures;
    let positions = (failures > 0).then(|| Fact::text("fact-lost-positions", count(failures)));
    let motion = analysis.no_motion.as_ref();
    let motion = motion.map(|_| Fact::text("fact-wanted-motion", text!("fact-not-found")));
    [positions, motion].into_iter().flatten().collect()
}

fn checks(analysis: &Analysis) -> Option<Fact> {
    let checks = &analysis.checks;
    if checks.is_empty() {
        return None;
    }
    let failed: Vec<_> =
        checks.iter().filter(|check| check.failed()).map(|check| check.name.clone()).collect();
    if !failed.is_empty() {
        return Some(Fact::text("fact-checks-fail", list(failed)));
    }
    let judged = checks.iter().filter(|check| check.verdict().is_some()).count();
    let whole = analysis.survey.failures == 0 && analysis.no_motion.is_none();
    let id = if whole { "fact-checks-hold" } else { "fact-checks-hold-partly" };
    Some(Fact::text(id, joined(" / ", [judged, checks.len()].map(count))))
}
