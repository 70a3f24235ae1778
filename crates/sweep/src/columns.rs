//! The families of columns: what each measure writes.

use assur_analysis::results::{Column, Owner, Quantity};
use assur_book::Unit;
use assur_book::catalogue::{self, PathStep};
use assur_mechanism::{Motion, PairId, Torque};

use crate::layout::{Builder, Find, Gathered, Value};
use crate::measured::{GREATEST, GREATEST_AT, LEAST, LEAST_AT, MEAN, RMS, TRAVEL};

/// Puts the least value of all groups and its coordinate.
pub(crate) fn groups(to: &mut Builder<'_>, name: &str, unit: Unit, what: Gathered) {
    if to.has_groups() {
        let (at, least) = (to.coordinate(), to.gather(what));
        to.put(name, unit, least, LEAST);
        to.put(&format!("{name}_at"), at, least, LEAST_AT);
    }
}

pub(crate) fn balancing(to: &mut Builder<'_>) {
    if to.balances {
        let (unit, at) = (to.unit(Quantity::Balancing, Owner::Input), to.coordinate());
        let [load, size] = [Gathered::Balancing, Gathered::BalancingSize].map(|of| to.gather(of));
        to.put("balancing_greatest", unit, size, GREATEST);
        to.put("balancing_greatest_at", at, size, GREATEST_AT);
        to.put("balancing_mean", unit, load, MEAN);
        to.put("balancing_mean_modulus", unit, size, MEAN);
    }
}

pub(crate) fn balancing_rms(to: &mut Builder<'_>) {
    if to.balances {
        let (unit, load) = (to.unit(Quantity::Balancing, Owner::Input), to.gather(Gathered::Balancing));
        to.put("balancing_rms", unit, load, RMS);
    }
}

/// Puts a number of the force of each pair and of the moment of each slide.
pub(crate) fn joints(to: &mut Builder<'_>, word: &str, find: Find) {
    for joint in to.joints() {
        let name = format!("reaction_{}", to.schema.name(Owner::Pair(joint.id)));
        let (is_slide, force) =
            (matches!(joint.id, PairId::Slide(_)), to.gather(Gathered::Force(joint.clone())));
        to.put(&format!("{name}_{word}"), Unit::FORCE, force, find);
        if is_slide {
            let moment = to.gather(Gathered::Moment(joint));
            to.put(&format!("{name}_moment_{word}"), Unit::MOMENT, moment, find);
        }
    }
}

pub(crate) fn extremes(to: &mut Builder<'_>) {
    for (nth, owner) in to.parts().into_iter().enumerate() {
        if !to.has(owner) {
            continue;
        }
        let (name, unit) = (to.schema.name(owner).into_owned(), to.unit(Quantity::Transfer(0), owner));
        let [x, y] = Column::vector(Quantity::Transfer(0), owner);
        let gathered = match owner {
            Owner::Slide(slide) => vec![(name.clone(), Gathered::Slide(slide))],
            Owner::Link(link) => vec![(format!("{name}_angle"), Gathered::Link(link))],
            _ => [("x", x), ("y", y)]
                .map(|(axis, of)| (format!("{name}_{axis}"), Gathered::Point(nth, of)))
                .into(),
        };
        for (name, what) in gathered {
            let of = to.gather(what);
            to.put(&format!("{name}_min"), unit, of, LEAST);
            to.put(&format!("{name}_max"), unit, of, GREATEST);
            if matches!(owner, Owner::Slide(_)) {
                to.put(&format!("{name}_travel"), unit, of, TRAVEL);
            }
        }
    }
}

pub(crate) fn distance(to: &mut Builder<'_>) {
    let (length, at) = (Unit::LENGTH, to.coordinate());
    for (nth, (_, point, _)) in to.layout.targets.clone().into_iter().enumerate() {
        let name = |what: &str| format!("{point}_distance_{}_{what}", nth + 1);
        to.put(&name("least"), length, nth, |found, nth| Some(found.distances.get(nth)?.min));
        to.put(&name("least_at"), at, nth, |found, nth| Some(found.distances.get(nth)?.at_min));
        to.put(&name("greatest"), length, nth, |found, nth| Some(found.distances.get(nth)?.max));
        to.put(&name("greatest_at"), at, nth, |found, nth| Some(found.distances.get(nth)?.at_max));
    }
}

pub(crate) fn stroke(to: &mut Builder<'_>) {
    for (nth, owner) in to.parts().into_iter().enumerate().skip(to.wanted.points.len()) {
        let name = format!("{}_stroke", to.schema.name(owner));
        let unit = to.unit(Quantity::Transfer(0), owner);
        to.put(&name, unit, nth, |found, nth| found.courses.get(nth)?.stroke);
    }
}

pub(crate) fn time_ratio(to: &mut Builder<'_>) {
    for (nth, owner) in to.parts().into_iter().enumerate().skip(to.wanted.points.len()) {
        let name = format!("{}_time_ratio", to.schema.name(owner));
        to.put(&name, Unit::NONE, nth, |found, nth| found.courses.get(nth)?.time_ratio);
    }
}

/// The greatest magnitudes of both derivatives of a point, slide or link with respect to the coordinate.
pub(crate) const FIRST: Find = |found, nth| Some(found.courses.get(nth)?.derivatives[0]);
pub(crate) const SECOND: Find = |found, nth| Some(found.courses.get(nth)?.derivatives[1]);

/// Puts a number of the course of each point, slide and link.
pub(crate) fn parts(to: &mut Builder<'_>, word: &str, quantity: Quantity, find: Find) {
    for (nth, owner) in to.parts().into_iter().enumerate() {
        let (name, unit) = (format!("{}_{word}", to.schema.name(owner)), to.unit(quantity, owner));
        to.put(&name, unit, nth, find);
    }
}

pub(crate) fn shaking(to: &mut Builder<'_>) {
    to.put("shaking_force_greatest", Unit::FORCE, 0, |found, _| Some(found.shaking.as_ref()?.greatest_force));
    to.put("shaking_force_rms", Unit::FORCE, 0, |found, _| Some(found.shaking.as_ref()?.rms_force));
    to.put("shaking_moment_greatest", Unit::MOMENT, 0, |found, _| {
        Some(found.shaking.as_ref()?.greatest_moment)
    });
}

pub(crate) fn regime(to: &mut Builder<'_>) {
    let mechanism = to.mechanism;
    if !matches!(mechanism.motion, Some(Motion::Steady { .. })) {
        return;
    }
    let drive = mechanism.drive.as_ref();
    if drive.is_some_and(|drive| drive.flywheel.is_some()) {
        to.put("flywheel", Unit::INERTIA, 0, |found, _| Some(found.regime()?.flywheel));
    }
    match drive.map(|drive| &drive.torque) {
        Some(Torque::Motor { .. }) => {
            to.put("ratio", Unit::NONE, 0, |found, _| found.regime()?.figures.ratio);
        }
        Some(Torque::Balance | Torque::Constant(_)) => {
            to.put("torque", Unit::MOMENT, 0, |found, _| found.regime()?.figures.torque);
        }
        _ => {}
    }
    let speed = to.unit(Quantity::Velocity, Owner::Input);
    let figures: [(_, _, Find); 6] = [
        ("mean_speed", speed, |found, _| Some(found.regime()?.figures.mean_speed)),
        ("unevenness", Unit::NONE, |found, _| Some(found.regime()?.figures.unevenness)),
        ("speed_min", speed, |found, _| Some(found.regime()?.figures.speed_min)),
        ("speed_max", speed, |found, _| Some(found.regime()?.figures.speed_max)),
        ("excess_work", Unit::JOULE, |found, _| Some(found.regime()?.figures.excess_work)),
        ("required_power", Unit::POWER, |found, _| Some(found.regime()?.figures.required_power)),
    ];
    for (name, unit, find) in figures {
        to.put(name, unit, 0, find);
    }
}

pub(crate) fn friction(to: &mut Builder<'_>) {
    fn total(all: &[[f64; 2]]) -> f64 {
        all.iter().fold(0.0, |sum, [from, to]| sum + (to - from))
    }
    if to.mechanism.frictions.is_empty() {
        return;
    }
    let along = to.coordinate();
    to.put("efficiency", Unit::NONE, 0, |found, _| found.friction.as_ref()?.efficiency);
    to.put("friction_work", Unit::JOULE, 0, |found, _| {
        found.friction.as_ref()?.friction_work.values().copied().sum()
    });
    to.put("friction_margin", Unit::NONE, 0, |found, _| Some(1.0 - found.friction.as_ref()?.certificate));
    to.put("self_braking", along, 0, |found, _| Some(total(&found.friction.as_ref()?.self_braking)));
    to.put("dead_angles", along, 0, |found, _| Some(total(&found.friction.as_ref()?.dead_angles)));
}

pub(crate) fn end(to: &mut Builder<'_>) {
    if matches!(to.mechanism.motion, Some(Motion::Transient { .. })) {
        let (at, speed) = (to.coordinate(), to.unit(Quantity::Velocity, Owner::Input));
        to.put("end_time", Unit::SECOND, 0, |found, _| Some(found.last?.state.time));
        to.put("end_coordinate", at, 0, |found, _| Some(found.last?.state.coordinate));
        to.put("end_speed", speed, 0, |found, _| Some(found.last?.state.speed));
    }
}

/// The columns of the positions under a key of the JSON, as they are.
pub(crate) fn plain(to: &mut Builder<'_>, key: &str) {
    let Some(schema) = to.results.clone() else { return };
    let is_there = |column: &&Column| {
        let path = catalogue::path(&schema, **column).unwrap_or_default();
        path.first().is_some_and(|step| *step == PathStep::Key(key.into()))
    };
    for column in schema.columns().iter().filter(is_there) {
        for (word, find) in [("min", LEAST), ("max", GREATEST), ("mean", MEAN), ("rms", RMS)] {
            if let Some(name) = catalogue::csv_of(&schema, *column, word) {
                let of = to.gather(Gathered::Plain(*column));
                to.layout.values.push(Value { name, of, find });
            }
        }
    }
}
