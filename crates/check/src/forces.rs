//! The checks of forces: loads, reduced quantities, equilibrium, agreement of methods, power.

use std::ops::ControlFlow;

use assur_force::{Loads, joint_reactions};
use assur_group::Wrench;

use crate::agreement::Agreement;
use crate::equilibrium::Equilibrium;
use crate::power::Power;
use crate::subject::{Solved, Subject};
use crate::worst::{Check, Worst};
use crate::written::{Items, Writer, given};

/// Roundings of a sum of the terms of one load, in units of the last place.
const ROUNDINGS: f64 = 64.0;

/// Roundings of the solution of one group or of the system of all, in units of the last place of its largest force, for each
/// unit of the condition.
pub(crate) const SOLUTION: f64 = 64.0;

/// Why a position is left out where all methods refuse it.
pub(crate) const NO_ANSWER: &str = "no method finds reactions there: the position is singular";

pub(crate) fn checks<B>(
    subject: &Subject<'_>,
    loads: &Loads,
    solved: &[Solved],
    step: &mut impl FnMut() -> ControlFlow<B>,
) -> ControlFlow<B, Vec<Check>> {
    let writer = Writer::new(subject);
    let mut written = Worst::new(
        "loads",
        "each load written out from the scene once more; limit: 64 rounding units of its terms",
    );
    let mut agreement = Agreement::new(subject, loads);
    let mut equilibrium = Equilibrium::new(subject);
    let mut power = Power::new(subject);
    for one in solved {
        step()?;
        let Some(state) = subject.states.get(one.index) else { continue };
        let items = writer.items(loads, state, &one.position.bodies);
        if items.values().all(|item| item.size == 0.0) {
            continue;
        }
        compare_loads(subject, &items, loads, one, &mut written);
        let answers = subject.answers(loads, one);
        let full = (0..answers.len()).find(|&i| subject.methods[i].gives_reactions && answers[i].is_some());
        let Some(reactions) = full.and_then(|i| answers[i].as_ref()) else {
            agreement.leave_out(one.index);
            equilibrium.leave_out(one.index);
            power.leave_out(one.index);
            continue;
        };
        let load = items.values().map(|item| item.size).fold(0.0, f64::max);
        agreement.add(one, state, &answers, full.unwrap_or(0), load);
        let joints = joint_reactions(subject.linkage, reactions);
        equilibrium.add(one, &items, reactions, &joints);
        power.add(one, state, loads, &items, reactions, &joints);
    }
    let first = [written.into_check()];
    let rest = equilibrium.into_checks().into_iter().chain([agreement.into_check()]);
    ControlFlow::Continue(first.into_iter().chain(rest).flatten().chain(power.into_checks()).collect())
}

fn compare_loads(subject: &Subject<'_>, items: &Items, loads: &Loads, one: &Solved, worst: &mut Worst) {
    let Some(state) = subject.states.get(one.index) else { return };
    let scale = subject.linkage.structure.scale;
    let total: f64 = items.values().map(|item| item.size).sum();
    let given = given(loads, state, &one.position.bodies);
    let keys: std::collections::BTreeSet<_> = items.keys().chain(given.keys()).copied().collect();
    for key in keys {
        let zero = Wrench::ZERO;
        let (mine, theirs) = (items.get(&key), given.get(&key).unwrap_or(&zero));
        let (own, size) = mine.map_or((zero, 0.0), |item| (item.wrench, item.size));
        let off = (own.fx - theirs.fx).hypot(own.fy - theirs.fy) + (own.m - theirs.m).abs() / scale;
        let limit = ROUNDINGS * f64::EPSILON * size;
        worst.offer(one.index, off / total, limit / total, || {
            let mechanism = &subject.linkage.mechanism;
            format!("{} on {}", key.0.name(mechanism), mechanism.links[key.1].name)
        });
    }
}

/// The largest force of an answer; moments of slides count by the typical length.
pub(crate) fn largest(reactions: &[Wrench<f64>], scale: f64) -> f64 {
    reactions.iter().map(|r| r.fx.hypot(r.fy) + r.m.abs() / scale).fold(0.0, f64::max)
}
