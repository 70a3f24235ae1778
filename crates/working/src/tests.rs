use assur_all as _;
use assur_force::{ForceAnalyzer, LoadState, Loads, Reactions, analyzers};
use assur_group::Wrench;
use assur_kinematics::Linkage;
use assur_mechanism::Motion;

use crate::{PositionOrSample, Task, Working};

mod energy;
mod evaluate;
mod fixtures;
mod general;
mod motion;
mod random;
mod text;
mod words;

/// Compiles a mechanism; its loads if it has any that can be worked.
pub(crate) fn compiled(mechanism: assur_mechanism::Mechanism) -> (Linkage, Option<Loads>) {
    let linkage = Linkage::compile(mechanism).unwrap();
    let moves = matches!(linkage.mechanism.motion, Some(Motion::Prescribed { .. }));
    let loads = (moves || linkage.mechanism.has_loads()).then(|| Loads::compile(&linkage).ok()).flatten();
    (linkage, loads)
}

pub(crate) fn worked(linkage: &Linkage, loads: Option<&Loads>, index: usize) -> Working {
    let state = LoadState::prescribed(&linkage.mechanism, linkage.mechanism.input.coordinate(index));
    Working::of(&Task {
        linkage,
        loads,
        state,
        place: PositionOrSample::Position(index),
        drive: None,
        analyzer: None,
    })
    .unwrap()
}

/// Every reaction and the balancing load are those of the independent analyzer.
pub(crate) fn forces_agree(name: &str, linkage: &Linkage, loads: &Loads, index: usize, working: &Working) {
    let mut position = linkage.position();
    linkage.solve_index(index, assur_group::Order::Second, &mut position).unwrap();
    let state = LoadState::prescribed(&linkage.mechanism, position.coordinate);
    let mut wrenches = vec![Wrench::ZERO; linkage.structure.links];
    loads.evaluate(&state, &position.bodies, &mut wrenches);
    let mut out = Reactions::new(linkage);
    let all = analyzers().unwrap();
    let method: &dyn ForceAnalyzer = all.iter().find(|p| p.name == "newton-euler").unwrap().instance;
    method.solve(linkage, &position, &mut wrenches, &mut out).unwrap();
    let size = out.pairs.iter().map(|r| r.fx.hypot(r.fy)).fold(0.0, f64::max);
    assert_eq!(working.reactions.len(), out.pairs.len(), "{name}, position {index}");
    for found in &working.reactions {
        let (pair, wanted) = (&linkage.structure.pairs[found.pair].pair, &out.pairs[found.pair]);
        let sign = if found.on == pair.a { 1.0 } else { -1.0 };
        for (force, wanted) in found.force.iter().zip([wanted.fx, wanted.fy]) {
            let force = sign * force.value();
            assert!(
                (force - wanted).abs() <= 1e-8 * size,
                "{name} {index}: pair {}: {force} {wanted}",
                found.pair
            );
        }
    }
    let found = working.balancing.unwrap();
    let unit = size * linkage.structure.scale.max(1.0);
    assert!((found - out.balancing).abs() <= 1e-8 * unit, "{name} {index}: {found} and {}", out.balancing);
}
