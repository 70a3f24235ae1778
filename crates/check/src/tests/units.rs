//! Limits have no unit: a mechanism in other units of length and mass has the same limits. A term of a limit that lacks a factor,
//! or has one too many, is of another dimension and shows here.

use std::convert::Infallible;
use std::ops::ControlFlow;

use assur_force::{LoadState, Loads};
use assur_kinematics::Linkage;
use assur_mechanism::{Balance, LawTable, LoadKind, Mechanism, Value};
use assur_testkit::specimen::Recipe;
use assur_words::Text;

use crate::{Check, Chosen, Subject, methods};

/// A unit of length and one of mass, as powers of two, by which all numbers are multiplied without rounding.
#[derive(Debug, Clone, Copy)]
struct Units {
    length: f64,
    mass: f64,
}

fn scaled(at: &mut [f64; 2], by: f64) {
    *at = at.map(|part| by * part);
}

fn table(table: &mut LawTable, by: f64) {
    table.rows.iter_mut().for_each(|row| row[1] *= by);
}

/// The size of a load; its argument is an angle, a time or an angular speed.
fn value(value: &mut Value, by: f64) {
    match value {
        Value::Constant(size) => *size *= by,
        Value::Table { table: rows, .. } => table(rows, by),
        Value::Stroke { forward, back, .. } => {
            table(forward, by);
            table(back, by);
        }
        Value::Formula { factor, .. } => *factor *= by,
    }
}

/// The same mechanism in other units.
fn in_units(mechanism: &Mechanism, Units { length, mass }: Units) -> Mechanism {
    let mut m = mechanism.clone();
    let (force, moment) = (mass * length, mass * length * length);
    for link in &mut m.links {
        link.mass *= mass;
        link.inertia *= moment;
        scaled(&mut link.center, length);
    }
    m.points.iter_mut().flat_map(|point| &mut point.places).for_each(|place| scaled(&mut place.at, length));
    for slide in &mut m.slides {
        scaled(&mut slide.point, length);
        scaled(&mut slide.through, length);
    }
    m.assembly.iter_mut().for_each(|(_, at)| scaled(at, length));
    m.gravity.iter_mut().for_each(|g| scaled(g, length));
    for load in &mut m.loads {
        match &mut load.kind {
            LoadKind::Force(one) => {
                scaled(&mut one.at.at, length);
                value(&mut one.value, force);
            }
            LoadKind::Moment(one) => value(&mut one.value, moment),
            LoadKind::Brake(brake) => {
                brake.radius *= length;
                value(&mut brake.force, force);
            }
            LoadKind::Spring(spring) => {
                spring.ends.iter_mut().for_each(|end| scaled(&mut end.at, length));
                (spring.stiffness, spring.damping) = (mass * spring.stiffness, mass * spring.damping);
                spring.length *= length;
            }
            LoadKind::Contact(contact) => {
                scaled(&mut contact.center.at, length);
                contact.radius *= length;
                value(&mut contact.force, force);
            }
        }
    }
    if let Some(Balance::Force { at, .. }) = &mut m.balance {
        scaled(&mut at.at, length);
    }
    m
}

/// The checks of all positions.
fn found(mechanism: Mechanism) -> Vec<Check> {
    let linkage = Linkage::compile(mechanism).unwrap();
    let loads = Loads::compile(&linkage).unwrap();
    let input = &linkage.mechanism.input;
    let all = Chosen::all(input.positions);
    let subject = Subject {
        linkage: &linkage,
        loads: Some(&loads),
        positions: all.clone(),
        states: all,
        state: &|index| Some(LoadState::prescribed(&linkage.mechanism, input.coordinate(index))),
        drive: None,
        methods: methods(&linkage, None),
    };
    let ControlFlow::Continue((all, _)) = subject.checks(&mut |_, _| ControlFlow::<Infallible>::Continue(()));
    all
}

#[test]
fn limits_are_the_same_in_all_units() {
    let units = [Units { length: 1024.0, mass: 1.0 }, Units { length: 1.0 / 512.0, mass: 4096.0 }];
    // What is left of the equation of motion is told in N m.
    let place = |check: &Check| {
        let place = &check.finding.place;
        if place.identity() == Some("check-remainder") { Text::default() } else { place.clone() }
    };
    let mut compared = std::collections::BTreeMap::new();
    for seed in 0..80 {
        let number = usize::try_from(seed).unwrap();
        let mechanism = Recipe::of(1 + number % 5).specimen(seed).unwrap().mechanism;
        // A coordinate that is a length has tolerances in meters.
        if !mechanism.input.is_angle() {
            continue;
        }
        let here = found(mechanism.clone());
        let there = found(in_units(&mechanism, units[number % 2]));
        for (one, other) in here.iter().zip(&there) {
            assert_eq!((&one.name, place(one)), (&other.name, place(other)), "seed {seed}");
            // Both are zero where nothing moves.
            let apart = (one.finding.bound - other.finding.bound).abs();
            assert!(apart <= 1e-6 * one.finding.bound, "seed {seed}, {}: {one:?} and {other:?}", one.name);
            *compared.entry(one.name.to_string()).or_insert(0) += 1;
        }
    }
    assert!(compared.len() >= 13 && compared.values().all(|count| *count > 20), "{compared:?}");
}
