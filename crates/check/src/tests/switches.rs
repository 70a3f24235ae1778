//! Loads by random formulas at and beside the zeros of their switches.

use std::convert::Infallible;
use std::ops::ControlFlow;

use assur_force::{LoadFault, LoadState, Loads};
use assur_formula::{Formula, Variables};
use assur_group::{Order, Wrench};
use assur_kinematics::Linkage;
use assur_mechanism::{Direction, Force, Input, Load, Mechanism, Moment, Motion, Place, Range, Value};
use assur_testkit::specimen::{Recipe, Rng, Terms, formula, scene_text};

use super::show;
use crate::{Check, Chosen, Subject, methods};

/// Random mechanisms that are tried.
const SEEDS: u64 = 150;

/// A random mechanism under one moment and one force by formulas whose switches are at the returned coordinate.
fn specimen(seed: u64) -> Option<(Mechanism, f64)> {
    let number = usize::try_from(seed).unwrap();
    let mut mechanism = Recipe::of(1 + number % 3).specimen(seed)?.mechanism;
    let mut rng = Rng::new(seed);
    let Input { from, positions, .. } = mechanism.input;
    // Zeros of sine and cosine are places where rounding tells.
    let quarter = std::f64::consts::FRAC_PI_2;
    let nice = ((from / quarter).floor() + 1.0) * quarter;
    let place = mechanism.input.coordinate(rng.below(positions));
    let at = if mechanism.input.period().is_some() && rng.chance(0.6) { nice } else { place };
    if seed % 5 == 4
        && let Some(Motion::Prescribed { speed, .. }) = &mut mechanism.motion
    {
        *speed = 0.0;
    }
    let LoadState { coordinate, speed, time, .. } = LoadState::prescribed(&mechanism, at);
    let mut linkage = Linkage::compile(mechanism.clone()).ok()?;
    linkage.solve(at, Order::Place, &mut linkage.position()).ok()?;
    linkage.mechanism.loads.clear();
    let variables = Variables { coordinate, speed, time, place: 0.5 };
    let motion = mechanism.motion.is_some();
    let link = 1 + rng.below(mechanism.links.len() - 1);
    let moment = formula(&mut rng, Terms { motion, place: false }, &variables);
    let value = Value::Formula { formula: moment, factor: 1.0, axis: None };
    mechanism.loads.push(Load::new("by formula", Moment { link, value, against_motion: false }));
    let full = matches!(mechanism.input.range, Range::Cycle(_));
    let size = formula(&mut rng, Terms { motion, place: full }, &variables);
    let axis = size.used().place.then(|| rng.angle());
    let along = Force {
        at: Place { link, at: [rng.signed(0.0, 0.4), rng.signed(0.0, 0.4)] },
        direction: Direction::Link(rng.angle()),
        value: Value::Formula { formula: size, factor: 1.0, axis },
    };
    mechanism.loads.push(Load::new("along", along));
    Some((mechanism, at))
}

/// The loads of a state, summed up link by link.
fn loads_at(linkage: &Linkage, loads: &Loads, state: &LoadState) -> Option<Vec<Wrench<f64>>> {
    let mut position = linkage.position();
    linkage.solve(state.coordinate, Order::Second, &mut position).ok()?;
    Some(loads.total(state, &position.bodies))
}

/// Every check of forces in some states.
fn checked(linkage: &Linkage, loads: &Loads, states: &[LoadState]) -> Vec<Check> {
    let subject = Subject {
        linkage,
        loads: Some(loads),
        positions: Chosen::all(1),
        states: Chosen::all(states.len()),
        state: &|index| states.get(index).copied(),
        drive: None,
        methods: methods(linkage, None),
    };
    let ControlFlow::Continue((all, _)) = subject.checks(&mut |_, _| ControlFlow::<Infallible>::Continue(()));
    all
}

/// The greatest difference of two sums of loads, and their size.
fn apart(one: &[Wrench<f64>], other: &[Wrench<f64>]) -> [f64; 2] {
    let size = |w: Wrench<f64>| w.fx.abs() + w.fy.abs() + w.m.abs();
    let difference = |(a, b): (&Wrench<f64>, &Wrench<f64>)| {
        [size(Wrench { fx: a.fx - b.fx, fy: a.fy - b.fy, m: a.m - b.m }), size(*a)]
    };
    one.iter().zip(other).map(difference).fold([0.0; 2], |[off, most], [a, b]| [off.max(a), most.max(b)])
}

/// What is wrong with a mechanism whose loads switch at a coordinate.
fn fault(mechanism: &Mechanism, at: f64) -> Result<bool, String> {
    let linkage = Linkage::compile(mechanism.clone()).map_err(|error| error.to_string())?;
    let loads = match Loads::compile(&linkage) {
        Ok(loads) => loads,
        // A draft may have a force on a point that does not move.
        Err(error) => {
            let is_no_load = matches!(error.fault, LoadFault::NoStroke(_) | LoadFault::InfiniteStroke(_));
            return if is_no_load { Ok(false) } else { Err(error.to_string()) };
        }
    };
    let state = |off: f64| LoadState::prescribed(mechanism, at + off);
    let beside = [0.0, -4e-16, 4e-16, -1e-13, 1e-13, -1e-9, 1e-9, -1e-3, 1e-3].map(state);
    let all = checked(&linkage, &loads, &beside);
    if all.iter().any(|check| check.finding.holds != Some(true) && check.finding.holds.is_some()) {
        return Err(show(&all));
    }
    // The value on the switch continues that just ahead, in the direction of the motion.
    let on = state(0.0);
    let leads = if on.speed == 0.0 { on.acceleration } else { on.speed };
    if on.speed == 0.0 && leads != 0.0 {
        // A motion from rest has no time in positions that it never passes.
        return Ok(true);
    }
    let sense = if leads == 0.0 { mechanism.input.sign() } else { leads.signum() };
    let near = |distance: f64| loads_at(&linkage, &loads, &state(sense * distance));
    let (Some(here), Some(ahead), Some(further)) = (near(0.0), near(1e-7), near(1e-6)) else {
        return Ok(false);
    };
    let ([off, size], [change, _]) = (apart(&here, &ahead), apart(&further, &ahead));
    // A power of 0.3 of the distance changes by a factor of 2 between both, and of 2 to the place itself.
    if off > 3.0 * change + 1e-7 * (1.0 + size) {
        return Err(format!("on the switch {here:?}, ahead {ahead:?}, further {further:?}"));
    }
    Ok(true)
}

/// Every check holds, and every load has the value just ahead, where random formulas of the whole language switch.
#[test]
fn checks_hold_at_the_switches_of_random_formulas() {
    let (mut compared, mut faults) = (0, Vec::new());
    for seed in 0..SEEDS {
        let Some((mechanism, at)) = specimen(seed) else { continue };
        match fault(&mechanism, at) {
            Ok(done) => compared += usize::from(done),
            Err(what) => faults.push(format!("seed {seed} at {at:?}\n{what}\n{}", scene_text(&mechanism))),
        }
    }
    assert!(faults.is_empty(), "{} faults, the first:\n{}", faults.len(), faults.join("\n======\n"));
    assert!(compared > 100, "only {compared} were compared");
}

/// Formulas that bend or end at zero, on the second moving link of each shipped mechanism.
#[test]
fn checks_hold_where_a_formula_is_zero() {
    let formulas = ["10*abs(sin(q))", "5*sqrt(abs(cos(q)))", "10*max(0, sin(3*q))", "7*abs(sin(q))^1.5"];
    for (name, text) in assur_fixtures::SCENES {
        let mechanism = assur_scene::read("scene.toml", text).unwrap();
        for formula in formulas {
            let mut mechanism = mechanism.clone();
            let (link, formula) = (2.min(mechanism.links.len() - 1), Formula::read(formula).unwrap());
            let value = Value::Formula { formula, factor: 1.0, axis: None };
            mechanism.loads.push(Load::new("zero", Moment { link, value, against_motion: false }));
            let all = crate::checks(&Linkage::compile(mechanism).unwrap());
            assert!(super::hold(&all), "{name}\n{}", show(&all));
        }
    }
}
