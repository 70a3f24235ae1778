//! Errors in the compiled loads: they are compiled from a scene that is changed by a small factor.

use std::cell::RefCell;

use assur_force::Loads;
use assur_kinematics::Linkage;
use assur_mechanism::{LawTable, LoadKind, Mechanism, Spring, Value};

use super::{Trial, Width, named};
use crate::check::Check;
use crate::forces::Forces;
use crate::subject::Subject;
use crate::written::Writer;

/// A mechanism whose loads are compiled with changes, while what judges them stays as it is.
struct Changed<'a> {
    trial: &'a Trial,
    subject: Subject<'a>,
    writer: Writer<'a>,
}

impl<'a> Changed<'a> {
    fn of(trial: &'a Trial) -> Self {
        let subject = trial.subject(&|_| None, None);
        let writer = Writer::new(&subject);
        Self { trial, subject, writer }
    }

    /// The check of a name with the loads of another mechanism, which has the same positions.
    fn check(&self, changed: &Linkage, name: &str) -> Option<Check> {
        let loads = Loads::varied(changed, Some((self.trial.mechanism(), &self.trial.loads))).unwrap();
        let mut forces = Forces::new(&self.subject, &loads, &self.writer);
        forces.add(self.trial.index, &self.trial.state());
        named(forces.finish().0, name)
    }
}

/// A change of the scene by a factor; whether there is anything to change.
type Change = fn(&mut Mechanism, f64) -> bool;

fn table(table: &mut LawTable, factor: f64) {
    table.rows.iter_mut().for_each(|row| row[1] *= factor);
}

fn value(value: &mut Value, factor: f64) {
    match value {
        Value::Constant(size) => *size *= factor,
        Value::Table { table: rows, .. } => table(rows, factor),
        Value::Stroke { forward, back, .. } => {
            table(forward, factor);
            table(back, factor);
        }
        Value::Formula { factor: own, .. } => *own *= factor,
    }
}

fn weights(m: &mut Mechanism, factor: f64) -> bool {
    m.gravity.iter_mut().flatten().for_each(|g| *g *= factor);
    m.gravity.is_some() && m.links.iter().any(|link| link.mass > 0.0)
}

fn masses(m: &mut Mechanism, factor: f64) -> bool {
    m.links.iter_mut().for_each(|link| link.mass *= factor);
    m.links.iter().any(|link| link.mass > 0.0)
}

fn inertias(m: &mut Mechanism, factor: f64) -> bool {
    m.links.iter_mut().for_each(|link| link.inertia *= factor);
    m.motion.is_some() && m.links.iter().any(|link| !link.inertia.is_none())
}

/// Changes the laws of all loads of a kind; whether there is one.
fn laws(m: &mut Mechanism, factor: f64, kind: fn(&LoadKind) -> bool) -> bool {
    let of_kind = m.loads.iter_mut().map(|load| &mut load.kind).filter(|load| kind(load));
    of_kind.filter_map(assur_mechanism::LoadKind::law_mut).map(|law| value(law, factor)).count() > 0
}

fn forces(m: &mut Mechanism, factor: f64) -> bool {
    laws(m, factor, |load| load.force().is_some())
}

fn moments(m: &mut Mechanism, factor: f64) -> bool {
    laws(m, factor, |load| load.moment().is_some() || load.brake().is_some())
}

fn springs(m: &mut Mechanism, factor: f64) -> bool {
    let springs = m.loads.iter_mut().filter_map(|load| load.kind.spring_mut());
    let change = |spring: &mut Spring| {
        spring.stiffness *= factor;
        spring.damping *= factor;
    };
    springs.map(change).count() > 0
}

fn contacts(m: &mut Mechanism, factor: f64) -> bool {
    laws(m, factor, |load| load.contact().is_some())
}

fn planted(name: &str, change: Change) -> Width {
    let mut width = Width::default();
    for trial in Trial::all() {
        if width.is_complete() {
            break;
        }
        if !change(&mut trial.mechanism().clone(), 1.0) {
            continue;
        }
        let judge = Changed::of(trial);
        let changed = RefCell::new(Linkage::compile(trial.mechanism().clone()).unwrap());
        width.add(&format!("{name}, seed {}", trial.seed), |error| {
            let changed = &mut *changed.borrow_mut();
            changed.mechanism = trial.mechanism().clone();
            change(&mut changed.mechanism, 1.0 + error);
            judge.check(changed, name)
        });
    }
    width
}

#[test]
fn a_load_that_is_greater_by_twice_the_limit_is_caught() {
    let changes: [(&str, Change); 7] = [
        ("weights", weights),
        ("masses", masses),
        ("moments of inertia", inertias),
        ("forces", forces),
        ("moments", moments),
        ("springs", springs),
        ("contacts", contacts),
    ];
    for (what, change) in changes {
        planted("loads", change).judge(&format!("loads, {what}"), 1e-8, 5e-4);
    }
}

#[test]
fn a_reduced_quantity_that_is_greater_by_twice_the_limit_is_caught() {
    for (what, change) in
        [("J of masses", masses as Change), ("Q of weights", weights), ("Q of moments", moments)]
    {
        planted("reduced quantities", change).judge(&format!("reduced quantities, {what}"), 1e-8, 5e-4);
    }
}
