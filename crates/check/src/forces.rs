//! The checks of forces: loads, reduced quantities, equilibrium, agreement of methods, power.

use std::ops::ControlFlow;

use assur_force::{Loads, State, joint_reactions};
use assur_group::Wrench;

use crate::case::{Case, ROUNDINGS};
use crate::check::{Check, Collector};
use crate::subject::{Solved, Subject};
use crate::written::{Items, Writer, given};
use crate::{agreement, equilibrium, power};

/// Why a position is skipped where all methods fail.
const NO_ANSWER: &str = "no method finds reactions there: the position is singular";

pub(crate) fn checks<B>(
    subject: &Subject<'_>,
    loads: &Loads,
    step: &mut impl FnMut() -> ControlFlow<B>,
) -> ControlFlow<B, Vec<Check>> {
    let writer = Writer::new(subject);
    let mut written = Collector::new(
        "loads",
        "each load written out from the scene once more; limit: 64 rounding units of its terms",
    );
    let mut balance = equilibrium::collectors();
    let mut agreement = agreement::collector();
    let mut powers = power::collectors();
    for (index, state) in &subject.states {
        step()?;
        let Some(one) = &subject.solve(*index, state.coordinate) else { continue };
        let items = &writer.items(loads, state, &one.position.bodies);
        if items.values().all(|item| item.size == 0.0) {
            continue;
        }
        compare_loads(subject, items, loads, state, one, &mut written);
        let methods = subject.methods.iter();
        let answers: Vec<_> =
            methods.map(|method| subject.answer(method, loads, state, &one.position)).collect();
        let full = (0..answers.len()).find(|&i| subject.methods[i].gives_reactions && answers[i].is_some());
        let Some((full, reactions)) = full.and_then(|i| Some((i, answers[i].as_ref()?))) else {
            let [links, joints, guides] = &mut balance;
            let guides = Some(guides).filter(|_| !subject.linkage.mechanism.slides.is_empty());
            let all = [links, joints, &mut agreement].into_iter().chain(&mut powers[1..]).chain(guides);
            all.for_each(|collector| collector.leave_out(*index, NO_ANSWER));
            continue;
        };
        let joints = joint_reactions(subject.linkage, reactions);
        let case = Case { subject, loads, one, state, items, answers: &answers, full, reactions, joints };
        agreement::compare(&case, &mut agreement);
        equilibrium::compare(&case, &mut balance);
        power::compare(&case, &mut powers);
    }
    let all = [written].into_iter().chain(balance).chain([agreement]).chain(powers);
    ControlFlow::Continue(all.filter_map(Collector::into_check).collect())
}

fn compare_loads(
    subject: &Subject<'_>,
    items: &Items,
    loads: &Loads,
    state: &State,
    one: &Solved,
    collector: &mut Collector,
) {
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
        collector.offer(one.index, off / total, limit / total, || {
            let mechanism = &subject.linkage.mechanism;
            format!("{} on {}", key.0.name(mechanism), mechanism.links[key.1].name)
        });
    }
}
