//! Transfer functions: closed forms in several numbers, the general solution, numerical differentiation.

pub(crate) mod differences;
mod lanes;
mod newton;

use std::hint::black_box;

use assur_group::{Body, Number, Order};
use assur_kinematics::{Chain, Linkage, Position};
use assur_number::{Dd, F64x4, Real};

use super::entry::{Contestant, Entry, Field, Verdict};
use super::work::Work;
use super::{ChartError, Options, Row, Setting, Stage, Unit};

use differences::{Differences, Stencil};
use lanes::InLanes;
use newton::{General, Places};

/// All that can give transfer functions.
pub(crate) fn field<'a>(work: &'a Work<'a>, options: Options) -> Result<Field<'a>, ChartError> {
    let (mechanism, structure) = (&work.linkage.mechanism, &work.linkage.structure);
    let single = Chain::<f32>::compile(mechanism, structure)?;
    let lanes = Chain::<F64x4>::compile(mechanism, structure)?;
    let row = |method: &str, setting| Row::new(Stage::Kinematics, Unit::Position, method, setting);
    let number = |name| Setting::word("number", name);
    let mut entries = vec![
        Entry::new(row("closed-form", number("f64")), work.len(), Closed::new(work)),
        Entry::new(row("closed-form", number("f32")), work.len(), Plain::new(work, single)),
        Entry::new(row("closed-form", number("f64x4")), work.len(), InLanes::new(work, lanes)),
    ];
    for (places, name) in [(Places::Closed, "general-derivatives"), (Places::Newton, "newton")] {
        let double = Chain::<f64>::compile(mechanism, structure)?;
        entries.push(Entry::new(row(name, number("f64")), work.len(), General::new(work, double, places)));
        let single = Chain::<f32>::compile(mechanism, structure)?;
        entries.push(Entry::new(row(name, number("f32")), work.len(), General::new(work, single, places)));
    }
    for stencil in Stencil::ALL {
        for step in options.decades(-1, -10) {
            let row = row(stencil.name, Setting::number("step", step));
            entries.push(Entry::new(row, work.len(), Differences::new(work, stencil, step)));
        }
    }
    Ok(Field { reference: work.reference.clone(), entries })
}

/// Group solutions in one position.
fn groups_of(linkage: &Linkage) -> u64 {
    linkage.groups().len() as u64
}

/// The ten numbers of each body, exactly, in extended precision.
fn extended<T: Real>(bodies: &[Body<T>]) -> Vec<[Dd; 10]> {
    bodies.iter().map(|body| body.numbers().map(|x| Dd::from_f64(x.to_f64()))).collect()
}

/// The program's own positions.
struct Closed<'a> {
    work: &'a Work<'a>,
    position: Position,
}

impl<'a> Closed<'a> {
    fn new(work: &'a Work<'a>) -> Self {
        Self { work, position: work.linkage.position() }
    }
}

impl Contestant for Closed<'_> {
    fn run(&mut self) {
        for q in &self.work.coordinates {
            let _ = black_box(self.work.linkage.solve(*q, Order::Second, &mut self.position));
        }
    }

    fn judge(&mut self) -> Verdict {
        let Self { work, position } = self;
        work.verdict(groups_of(work.linkage), |_, q| {
            work.linkage.solve(q, Order::Second, position).map_err(|error| error.to_string())?;
            Ok(extended(&position.bodies))
        })
    }
}

/// The closed forms in another number.
struct Plain<'a, T: Number> {
    work: &'a Work<'a>,
    chain: Chain<T>,
    bodies: Vec<Body<T>>,
    health: Vec<T>,
}

impl<'a, T: Number> Plain<'a, T> {
    fn new(work: &'a Work<'a>, chain: Chain<T>) -> Self {
        Self { work, bodies: chain.bodies(), health: vec![T::ZERO; chain.groups.len()], chain }
    }

    fn solve(&mut self, q: f64) -> Result<(), String> {
        let ways = self.work.linkage.ways.at(q);
        self.chain
            .solve(T::from_f64(q), ways, Order::Second, &mut self.bodies, &mut self.health)
            .map_err(|error| failure(self.work.linkage, q, &error))
    }
}

impl<T: Number> Contestant for Plain<'_, T> {
    fn run(&mut self) {
        let work = self.work;
        for q in &work.coordinates {
            let _ = black_box(self.solve(*q));
        }
    }

    fn judge(&mut self) -> Verdict {
        let work = self.work;
        work.verdict(groups_of(work.linkage), |_, q| {
            self.solve(q)?;
            Ok(extended(&self.bodies))
        })
    }
}

/// What a chain says, with group and coordinate.
fn failure(linkage: &Linkage, q: f64, error: &assur_kinematics::ChainError) -> String {
    let group = linkage.structure.group_name(&linkage.mechanism, error.group);
    format!("{group}, coordinate {q:.9}: {}", error.source)
}
