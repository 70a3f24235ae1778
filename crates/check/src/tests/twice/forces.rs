//! Errors in the answers of a method, and in the load of the drive.

use assur_force::{AnalyzerPlugin, ForceAnalyzer, ForceError, LoadState, Reactions};
use assur_group::{Order, PairGeometry, Wrench};
use assur_kinematics::{Linkage, Position};
use assur_mechanism::PairId;

use super::{Trial, Width, named};
use crate::case::largest;
use crate::check::Check;
use crate::forces::Forces;
use crate::subject::{InputLoad, Subject};
use crate::written::Writer;

/// A number of an answer.
#[derive(Debug, Clone, Copy)]
enum Victim {
    Balancing,
    /// A force in a pair, along the ground's x or y.
    Pair(usize, usize),
    /// A force in the pair of a slide, along its guide.
    Along(usize),
    /// A moment in a pair.
    Moment(usize),
}

/// A sound method with an error in one number of its answers, in parts of the largest reaction.
#[derive(Debug)]
struct Wrong {
    sound: &'static dyn ForceAnalyzer,
    victim: Victim,
    error: f64,
}

impl ForceAnalyzer for Wrong {
    fn supports(&self, linkage: &Linkage) -> Result<(), assur_words::Text> {
        self.sound.supports(linkage)
    }

    fn solve(
        &self,
        linkage: &Linkage,
        position: &Position,
        loads: &mut [Wrench<f64>],
        out: &mut Reactions,
    ) -> Result<(), ForceError> {
        self.sound.solve(linkage, position, loads, out)?;
        let scale = linkage.structure.scale;
        let by = self.error * largest(&out.pairs, scale);
        match self.victim {
            Victim::Balancing if linkage.mechanism.balances_by_moment() => out.balancing += by * scale,
            Victim::Balancing => out.balancing += by,
            Victim::Pair(pair, 0) => out.pairs[pair].fx += by,
            Victim::Pair(pair, _) => out.pairs[pair].fy += by,
            Victim::Along(index) => {
                let pair = &linkage.structure.pairs[index].pair;
                let PairGeometry::Slide { angle, .. } = pair.geometry else { panic!("a pin") };
                let (s, c) = angle.sin_cos();
                let along = position.bodies[pair.b].turned([c, s]);
                out.pairs[index].add_at([0.0; 2], along.map(|part| by * part), 0.0);
            }
            Victim::Moment(pair) => out.pairs[pair].m += by * scale,
        }
        Ok(())
    }
}

fn wrong(sound: &AnalyzerPlugin, victim: Victim, error: f64) -> AnalyzerPlugin {
    AnalyzerPlugin {
        instance: Box::leak(Box::new(Wrong { sound: sound.instance, victim, error })),
        ..sound.clone()
    }
}

fn checked<'a>(
    trial: &'a Trial,
    subject: &'a Subject<'a>,
    writer: &'a Writer<'a>,
    name: &str,
) -> Option<Check> {
    let mut forces = Forces::new(subject, &trial.loads, writer);
    forces.add(trial.index, &trial.state());
    named(forces.finish().0, name)
}

/// Plants an error in a number of a method's answers: the first method, or for `others` the second one. `victim`: the
/// number; `None` where the mechanism has no such one.
fn planted(name: &str, others: bool, victim: impl Fn(&Trial) -> Option<Victim>) -> Width {
    let mut width = Width::default();
    for trial in Trial::all() {
        if width.is_complete() {
            break;
        }
        let Some(victim) = victim(trial) else { continue };
        let writer = Writer::new(&trial.subject(&|_| None, None));
        width.add(&format!("{name}, seed {}, {victim:?}", trial.seed), |error| {
            let state = |_| Some(trial.state());
            let mut subject = trial.subject(&state, None);
            let method = if others { 1 + trial.index % (subject.methods.len() - 1) } else { 0 };
            if method > 0 && !subject.methods[method].gives_reactions && !matches!(victim, Victim::Balancing)
            {
                return None;
            }
            subject.methods[method] = wrong(&subject.methods[method], victim, error);
            checked(trial, &subject, &writer, name)
        });
    }
    width
}

/// A pair, of the pins or of the slides.
fn pair(trial: &Trial, of: impl Fn(&PairId) -> bool) -> Option<usize> {
    let pairs = trial.linkage.structure.pairs.iter().enumerate();
    let all: Vec<usize> = pairs.filter(|(_, named)| of(&named.source)).map(|(pair, _)| pair).collect();
    (!all.is_empty()).then(|| all[trial.seed % all.len()])
}

fn slide(trial: &Trial) -> Option<usize> {
    pair(trial, |source| matches!(source, PairId::Slide(_)))
}

#[test]
fn a_reaction_that_is_wrong_by_twice_the_limit_is_caught() {
    let name = "equilibrium of links";
    let force = |trial: &Trial| Some(Victim::Pair(pair(trial, |_| true)?, trial.index % 2));
    planted(name, false, force).judge(name, 1e-9, 5e-4);
    planted(name, false, |trial| Some(Victim::Moment(slide(trial)?))).judge(
        "equilibrium, moments",
        1e-9,
        0.002,
    );
}

#[test]
fn a_slide_that_pulls_along_by_twice_the_limit_is_caught() {
    let name = "slides push across";
    planted(name, false, |trial| Some(Victim::Along(slide(trial)?))).judge(name, 1e-9, 1e-4);
}

#[test]
fn methods_that_differ_by_twice_the_limit_are_caught() {
    let name = "agreement of the methods";
    let force = |trial: &Trial| Some(Victim::Pair(pair(trial, |_| true)?, trial.index % 2));
    planted(name, true, force).judge(name, 1e-9, 5e-4);
    planted(name, true, |trial| Some(Victim::Moment(slide(trial)?))).judge("agreement, moments", 1e-9, 5e-4);
    planted(name, true, |_| Some(Victim::Balancing)).judge("agreement, balancing load", 1e-9, 5e-4);
}

#[test]
fn a_balancing_load_that_is_wrong_by_twice_the_limit_is_caught() {
    for name in ["equilibrium of links", "Lagrange-d'Alembert", "virtual power"] {
        let what = format!("{name}, balancing load");
        planted(name, false, |_| Some(Victim::Balancing)).judge(&what, 1e-9, 5e-4);
    }
}

/// The equation of motion says which load at the input the prescribed motion needs.
#[test]
fn a_drive_that_is_wrong_by_twice_the_limit_is_caught() {
    let name = "drive against force analysis";
    let mut width = Width::default();
    for trial in Trial::all() {
        if width.is_complete() {
            break;
        }
        let writer = Writer::new(&trial.subject(&|_| None, None));
        if trial.mechanism().balance.is_some() {
            continue;
        }
        width.add(&format!("{name}, seed {}", trial.seed), |error| {
            let linkage = &trial.linkage;
            let needed = |state: &LoadState| {
                let mut position = linkage.position();
                linkage.solve(state.coordinate, Order::Second, &mut position).unwrap();
                let found = trial.loads.reduced(state, &position.bodies);
                let of_inertia =
                    found.inertia * state.acceleration + 0.5 * found.inertia_derivative * state.speed.powi(2);
                let value = (1.0 + error) * (of_inertia - found.moment);
                InputLoad { value, error: 0.0, accuracy: [0.0; 2] }
            };
            let state = |_| Some(trial.state());
            let subject = trial.subject(&state, Some(&needed));
            checked(trial, &subject, &writer, name)
        });
    }
    width.judge(name, 1e-9, 5e-4);
}
