//! Planted mistakes: each must be caught by a check, and the sound mechanism must pass.

use std::convert::Infallible;
use std::ops::ControlFlow;
use std::sync::Arc;

use assur_force::{AnalyzerPlugin, ForceAnalyzer, ForceError, LoadState, Loads, Reactions};
use assur_group::{Anchor, Order, Wrench};
use assur_kinematics::{ChainInput, Linkage, Position};
use assur_mechanism::{Direction, Friction, Mechanism, PairId, Spring, Surfaces, Value};

use super::mutants::{Mutant, SLIP, SLIPS, Slip};
use crate::{Chosen, Subject, methods};

/// Scenes that together have all five types, offset and moving guides, ternary links and every sort of load.
const SCENES: [&str; 7] =
    ["shaper", "guide-shaper", "slider-crank", "conveyor", "stephenson3", "press", "r-rtr-rrt"];

fn fixture(name: &str) -> Mechanism {
    let path = format!("{}/../../fixtures/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let mut mechanism = assur_scene::read(name, &std::fs::read_to_string(&path).unwrap()).unwrap();
    // A mistake in a formula shows in any few positions.
    mechanism.input.positions = mechanism.input.positions.min(7);
    mechanism
}

fn compiled(mechanism: &Mechanism) -> Linkage {
    Linkage::compile(mechanism.clone()).unwrap()
}

fn states(linkage: &Linkage) -> Vec<LoadState> {
    let input = &linkage.mechanism.input;
    (0..input.positions).map(|i| LoadState::prescribed(&linkage.mechanism, input.coordinate(i))).collect()
}

/// Names of the checks that fail; "no assembly" where a position can't be solved any more, which stops the program.
pub(super) fn failed(linkage: &Linkage, loads: &Loads, methods: Vec<AnalyzerPlugin>) -> Vec<String> {
    let all = Chosen::all(linkage.mechanism.input.positions);
    let states = states(linkage);
    let subject = Subject {
        linkage,
        loads: Some(loads),
        positions: all.clone(),
        states: all,
        state: &|index| Some(states[index]),
        drive: None,
        methods,
    };
    let ControlFlow::Continue((all, _)) = subject.checks(&mut |_, _| ControlFlow::<Infallible>::Continue(()));
    let mut failed: Vec<_> = all
        .iter()
        .filter(|check| check.finding.holds != Some(true))
        .map(|check| check.name.to_string())
        .collect();
    let mut position = linkage.position();
    let positions = 0..linkage.mechanism.input.positions;
    if positions.into_iter().any(|i| linkage.solve_index(i, Order::Second, &mut position).is_err()) {
        failed.push("no assembly".to_owned());
    }
    failed
}

/// Everything that a kernel calculates over the positions, to tell a mistake from one without effect.
pub(super) fn everything(linkage: &Linkage, loads: &Loads) -> Vec<f64> {
    let mut numbers = Vec::new();
    let mut position = linkage.position();
    let groups = assur_force::find("groups").unwrap().instance;
    for (index, state) in states(linkage).iter().enumerate() {
        if linkage.solve_index(index, Order::Second, &mut position).is_err() {
            continue;
        }
        for b in &position.bodies {
            numbers.extend([b.x, b.y, b.c, b.s, b.x1, b.y1, b.w1, b.x2, b.y2, b.w2]);
        }
        let mut wrenches = vec![Wrench::ZERO; position.bodies.len()];
        let mut reactions = Reactions::new(linkage);
        loads.evaluate(state, &position.bodies, &mut wrenches);
        if groups.solve(linkage, &position, &mut wrenches, &mut reactions).is_ok() {
            numbers.extend(reactions.pairs.iter().flat_map(|r| [r.fx, r.fy, r.m]));
        }
    }
    numbers
}

/// Whether two results differ by more than rounding.
pub(super) fn differs(sound: &[f64], other: &[f64]) -> bool {
    let off = sound.iter().zip(other).map(|(a, b)| (a - b).abs());
    sound.len() != other.len() || off.fold(0.0, f64::max) > 1e-9
}

#[test]
fn sound_mechanisms_pass() {
    for name in SCENES {
        let linkage = compiled(&fixture(name));
        let loads = Loads::compile(&linkage).unwrap();
        assert_eq!(failed(&linkage, &loads, methods(&linkage, None)), [""; 0], "{name}");
    }
}

#[test]
fn every_slip_in_a_closed_form_is_caught() {
    let mut planted = std::collections::BTreeMap::new();
    for name in SCENES {
        let mechanism = fixture(name);
        let sound = compiled(&mechanism);
        let loads = Loads::compile(&sound).unwrap();
        let numbers = everything(&sound, &loads);
        for (group, victim, slip) in cases(sound.structure.groups.len()) {
            let mut linkage = compiled(&mechanism);
            let groups = &mut Arc::get_mut(&mut linkage.chain).unwrap().groups;
            let kernel = groups.remove(group);
            let kind = sound.structure.groups[group].plugin.kind;
            groups.insert(group, Box::new(Mutant { sound: kernel, slip, victim }));
            if !differs(&numbers, &everything(&linkage, &loads)) {
                continue;
            }
            let caught = failed(&linkage, &loads, methods(&linkage, None));
            assert!(!caught.is_empty(), "{name}, group {group} {kind}, victim {victim}: {}", slip.name);
            let entry = planted.entry((slip.name, kind)).or_insert((0, std::collections::BTreeSet::new()));
            entry.0 += 1;
            entry.1.extend(caught);
        }
    }
    for ((slip, kind), (count, caught)) in &planted {
        println!("{kind} {slip}: {count} planted, caught by {caught:?}");
    }
    for slip in &SLIPS {
        let kinds = planted.keys().filter(|(name, _)| *name == slip.name).count();
        // The moment of a slide exists in four kinds, and a place has no x to lengthen where a link lies at the origin.
        assert!(kinds >= 3, "{} was planted in {kinds} kinds only", slip.name);
    }
}

fn cases(groups: usize) -> impl Iterator<Item = (usize, usize, Slip)> {
    let victims = (0..groups).flat_map(|group| (0..3).map(move |victim| (group, victim)));
    victims.flat_map(|(group, victim)| SLIPS.map(|slip| (group, victim, slip)))
}

/// A change of the scene that stands for a mistake in the compiled loads.
type Change = (&'static str, &'static str, fn(&mut Mechanism));

#[test]
fn every_slip_in_the_loads_is_caught() {
    let changes: [Change; 10] = [
        ("weights upwards", "shaper", |m| m.gravity = m.gravity.map(|g| g.map(|g| -g))),
        ("weights by 1e-6", "conveyor", |m| m.gravity = m.gravity.map(|g| g.map(|g| SLIP * g))),
        ("mass by 1e-6", "shaper", |m| m.links.iter_mut().for_each(|link| link.mass *= SLIP)),
        ("inertia negative", "conveyor", |m| m.links.iter_mut().for_each(|link| link.inertia *= -1.0)),
        ("force turned round", "stephenson3", |m| turn(m, std::f64::consts::PI)),
        ("force by 1e-6 rad", "guide-shaper", |m| turn(m, 1e-6)),
        ("stroke by 1e-6", "shaper", stretch),
        ("stiffness negative", "stephenson3", |m| springs(m).for_each(|s| s.stiffness *= -1.0)),
        ("damping forgotten", "stephenson3", |m| springs(m).for_each(|s| s.damping = 0.0)),
        ("friction turned round", "press", turn_friction),
    ];
    for (what, name, change) in changes {
        let mechanism = fixture(name);
        let linkage = compiled(&mechanism);
        let mut changed = mechanism;
        change(&mut changed);
        let loads = Loads::compile(&compiled(&changed)).unwrap();
        let caught = failed(&linkage, &loads, methods(&linkage, None));
        println!("{name}: {what}: caught by {caught:?}");
        assert!(caught.iter().any(|name| name == "loads"), "{name}: {what}: {caught:?}");
    }
}

/// Journals in all pins of a scene with a group of class III, IV.
fn with_journals(name: &str) -> Mechanism {
    let mut mechanism = fixture(name);
    let pins = mechanism.points.iter().enumerate().filter(|(_, point)| point.is_pin());
    mechanism.frictions = pins
        .map(|(id, point)| Friction {
            pair: PairId::Pin(id),
            coefficient: 0.3,
            surfaces: Surfaces::Journal { radius: 0.03, owner: point.places[0].link },
        })
        .collect();
    mechanism
}

/// A slip by its name.
type FrictionSlip = (&'static str, fn(&mut Friction));

#[test]
fn every_slip_in_the_friction_is_caught() {
    let changes: [FrictionSlip; 5] = [
        ("turned round", |one| one.coefficient *= -1.0),
        ("coefficient by 1e-6", |one| one.coefficient *= SLIP),
        ("coefficients of slides forgotten", |one| {
            one.coefficient *= f64::from(u8::from(matches!(one.surfaces, Surfaces::Journal { .. })));
        }),
        ("radius by 1e-6", |one| {
            if let Surfaces::Journal { radius, .. } = &mut one.surfaces {
                *radius *= SLIP;
            }
        }),
        ("length by 1e-6", |one| {
            if let Surfaces::Faces { length, .. } = &mut one.surfaces {
                *length *= SLIP;
            }
        }),
    ];
    for mechanism in [fixture("shaper-friction"), with_journals("triad"), with_journals("contour")] {
        let linkage = compiled(&mechanism);
        let loads = Loads::compile(&linkage).unwrap();
        let title = mechanism.title.clone();
        assert_eq!(failed(&linkage, &loads, methods(&linkage, None)), [""; 0], "{title:?}");
        for (what, change) in changes {
            let mut changed = mechanism.clone();
            changed.frictions.iter_mut().for_each(change);
            if changed == mechanism {
                continue;
            }
            let loads = Loads::compile(&compiled(&changed)).unwrap();
            let caught = failed(&linkage, &loads, methods(&linkage, None));
            assert!(
                caught.iter().any(|name| name == "friction of pairs"),
                "{title:?}: {what}: caught by {caught:?}"
            );
        }
    }
}

fn springs(mechanism: &mut Mechanism) -> impl Iterator<Item = &mut Spring> {
    mechanism.loads.iter_mut().filter_map(|load| load.kind.spring_mut())
}

fn turn_friction(mechanism: &mut Mechanism) {
    let contacts = mechanism.loads.iter_mut().filter_map(|load| load.kind.contact_mut());
    contacts.for_each(|contact| contact.friction *= -1.0);
}

fn turn(mechanism: &mut Mechanism, by: f64) {
    for force in mechanism.loads.iter_mut().filter_map(|load| load.kind.force_mut()) {
        if let Direction::Ground(angle) | Direction::Link(angle) = &mut force.direction {
            *angle += by;
        }
    }
}

fn stretch(mechanism: &mut Mechanism) {
    for law in mechanism.loads.iter_mut().filter_map(|load| load.kind.law_mut()) {
        if let Value::Stroke { forward, .. } = law {
            forward.rows.iter_mut().for_each(|row| row[1] *= SLIP);
        }
    }
}

/// A mistake in an answer.
type Lie = fn(&mut Reactions);

/// A sound method with a mistake in its answer.
#[derive(Debug)]
struct Liar {
    sound: &'static dyn ForceAnalyzer,
    slip: Lie,
}

impl ForceAnalyzer for Liar {
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
        (self.slip)(out);
        Ok(())
    }
}

fn longer(reaction: &mut Wrench<f64>) {
    (reaction.fx, reaction.fy) = (SLIP * reaction.fx, SLIP * reaction.fy);
}

#[test]
fn every_slip_in_a_method_is_caught() {
    let slips: [(&str, Lie); 5] = [
        ("sign of the balancing load", |r| r.balancing = -r.balancing),
        ("balancing load by 1e-6", |r| r.balancing *= SLIP),
        ("sign of the input's reaction", |r| r.pairs[0].fx = -r.pairs[0].fx),
        ("last reaction by 1e-6", |r| r.pairs.iter_mut().last().into_iter().for_each(longer)),
        ("no number", |r| r.pairs[1].fx = f64::NAN),
    ];
    for (number, (what, slip)) in slips.into_iter().enumerate() {
        for name in ["shaper", "conveyor", "slider-crank"] {
            let linkage = compiled(&fixture(name));
            let loads = Loads::compile(&linkage).unwrap();
            let sound = methods(&linkage, None);
            // A method that finds the balancing load alone can only be wrong in that.
            for liar in (0..sound.len()).filter(|&i| number < 2 || sound[i].gives_reactions) {
                let lying: &'static Liar = Box::leak(Box::new(Liar { sound: sound[liar].instance, slip }));
                let mut all = sound.clone();
                all[liar] = AnalyzerPlugin { instance: lying, ..sound[liar].clone() };
                let caught = failed(&linkage, &loads, all.clone());
                println!("{name}, {}: {what}: caught by {caught:?}", sound[liar].name);
                assert!(caught.iter().any(|name| name == "agreement of the methods"), "{name}: {what}");
                // Alone, a method that is wrong must be found out too.
                if liar == 0 {
                    let alone = failed(&linkage, &loads, vec![all[liar].clone()]);
                    assert!(!alone.is_empty(), "{name}: {what} by the only method");
                }
            }
        }
    }
}

#[test]
fn a_slip_in_the_input_is_caught() {
    for slip in [
        (|input| {
            if let ChainInput::Crank { own, .. } = input {
                *own = Anchor::new([1e-6, 0.0]);
            }
        }) as fn(&mut ChainInput<f64>),
        |input| {
            if let ChainInput::Crank { ground, .. } = input {
                ground[1] += 1e-6;
            }
        },
    ] {
        let mut linkage = compiled(&fixture("shaper"));
        let loads = Loads::compile(&linkage).unwrap();
        slip(&mut Arc::get_mut(&mut linkage.chain).unwrap().inputs[0]);
        let caught = failed(&linkage, &loads, methods(&linkage, None));
        assert!(caught.iter().any(|name| name == "closure PF0"), "{caught:?}");
    }
}
