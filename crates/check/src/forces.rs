//! The checks of forces: loads, reduced quantities, equilibrium, agreement of methods, power.

use assur_force::{Joint, LoadState, Loads, joints};
use assur_group::Wrench;
use assur_words::{Text, text};

use crate::case::Case;
use crate::check::Collector;
use crate::check::ForceResiduals;
use crate::kinetics::ROUNDINGS;
use crate::subject::{Solved, Subject};
use crate::written::{Given, Items, Writer, given};
use crate::{agreement, equilibrium, friction, power};

/// Why a position is skipped where all methods fail.
const NO_ANSWER: Text = text!("check-no-answer");

/// The checks of forces in the states that were added.
pub(crate) struct Forces<'a> {
    subject: &'a Subject<'a>,
    loads: &'a Loads,
    writer: &'a Writer<'a>,
    joints: Vec<Joint>,
    written: Collector,
    balance: [Collector; 3],
    agreement: Collector,
    powers: [Collector; 4],
    friction: Collector,
    residuals: Vec<ForceResiduals>,
}

impl<'a> Forces<'a> {
    /// `writer`: writes out the loads of the subject.
    pub(crate) fn new(subject: &'a Subject<'a>, loads: &'a Loads, writer: &'a Writer<'a>) -> Self {
        Self {
            subject,
            loads,
            writer,
            joints: joints(&subject.linkage.mechanism, &subject.linkage.structure),
            written: Collector::new(text!("check-loads"), text!("check-loads.reason")),
            balance: equilibrium::collectors(),
            agreement: agreement::collector(),
            powers: power::collectors(),
            friction: friction::collector(),
            residuals: Vec::new(),
        }
    }

    pub(crate) fn add(&mut self, index: usize, state: &LoadState) {
        let (subject, loads) = (self.subject, self.loads);
        let Some(one) = &subject.solve(index, state.coordinate) else { return };
        let given = given(loads, state, &one.position.bodies);
        let is_finite = |load: &Wrench<f64>| load.fx.is_finite() && load.fy.is_finite() && load.m.is_finite();
        if !given.values().all(is_finite) {
            // Such a position has no forces to check.
            return;
        }
        let items = &self.writer.items(&given, state, &one.position.bodies);
        if items.values().all(|item| item.size == 0.0) {
            return;
        }
        compare_loads(subject, (items, &given), one, &mut self.written);
        let methods = subject.methods.iter();
        let answers: Vec<_> =
            methods.map(|method| subject.answer(method, loads, state, &one.position, 1.0)).collect();
        let full = (0..answers.len()).find(|&i| subject.methods[i].gives_reactions && answers[i].is_some());
        let Some((full, reactions)) = full.and_then(|i| Some((i, answers[i].as_ref()?))) else {
            let [links, joints, guides] = &mut self.balance;
            let guides = Some(guides).filter(|_| !subject.linkage.mechanism.slides.is_empty());
            let [_, lagrange, powers, drive] = &mut self.powers;
            let drive = Some(drive).filter(|_| subject.drive.is_some());
            let all =
                [links, joints, &mut self.agreement, lagrange, powers].into_iter().chain(guides).chain(drive);
            all.for_each(|collector| collector.leave_out(index, NO_ANSWER));
            return;
        };
        let joints = self.joints.iter().map(|joint| joint.reaction(&reactions.pairs)).collect();
        let case = Case { subject, loads, one, state, items, answers: &answers, full, reactions, joints };
        agreement::compare(&case, &mut self.agreement);
        let groups = equilibrium::compare(&case, &mut self.balance);
        friction::compare(&case, &mut self.friction);
        let [dynamics, global] = power::compare(&case, &mut self.powers);
        self.residuals.push(ForceResiduals { number: index, groups, dynamics, global });
    }

    /// What was collected, and the residuals of each state.
    pub(crate) fn finish(self) -> (impl Iterator<Item = Collector>, Vec<ForceResiduals>) {
        let all = [self.written]
            .into_iter()
            .chain(self.balance)
            .chain([self.agreement])
            .chain(self.powers)
            .chain([self.friction]);
        (all, self.residuals)
    }
}

fn compare_loads(
    subject: &Subject<'_>,
    (items, given): (&Items, &Given),
    one: &Solved,
    collector: &mut Collector,
) {
    let scale = subject.linkage.structure.scale;
    let total: f64 = items.values().map(|item| item.size).sum();
    let missing = given.keys().filter(|key| !items.contains_key(key));
    for key in items.keys().chain(missing) {
        let zero = Wrench::ZERO;
        let (mine, theirs) = (items.get(key), given.get(key).unwrap_or(&zero));
        let (own, size) = mine.map_or((zero, 0.0), |item| (item.wrench, item.size));
        let off = (own.fx - theirs.fx).hypot(own.fy - theirs.fy) + (own.m - theirs.m).abs() / scale;
        let limit = ROUNDINGS * f64::EPSILON * size;
        collector.offer(one.index, off / total, limit / total, || {
            let mechanism = &subject.linkage.mechanism;
            let link = &mechanism.links[key.1].name;
            text!("check-load-on", load = key.0.name(mechanism), link)
        });
    }
}
