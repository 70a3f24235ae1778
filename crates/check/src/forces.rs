//! The checks of forces: loads, reduced quantities, equilibrium, agreement of methods, power.

use assur_force::{Joint, LoadState, Loads, joints};
use assur_group::Wrench;
use assur_words::{Text, text};

use crate::check::{Collector, ForceResiduals};
use crate::subject::{Solved, Subject};
use crate::written::{Given, Items, Writer, given};
use crate::{agreement, case::Case, equilibrium, friction, kinetics::ROUNDINGS, power};

/// Why a position is skipped where all methods fail.
const NO_ANSWER: Text = text!("check-no-answer");

/// The checks, each with what is compared and where its limit comes from.
pub(crate) const CHECKS: [(Text, Text); 10] = [
    (text!("check-loads"), text!("check-loads.reason")),
    (text!("check-equilibrium"), text!("check-equilibrium.reason")),
    (text!("check-joints"), text!("check-joints.reason")),
    (text!("check-slides"), text!("check-slides.reason")),
    (text!("check-agreement"), text!("check-agreement.reason")),
    (text!("check-reduced"), text!("check-reduced.reason")),
    (text!("check-lagrange"), text!("check-lagrange.reason")),
    (text!("check-virtual-power"), text!("check-virtual-power.reason")),
    (text!("check-drive"), text!("check-drive.reason")),
    (text!("check-friction"), text!("check-friction.reason")),
];

/// The checks of forces in the states that were added.
pub(crate) struct Forces<'a> {
    subject: &'a Subject<'a>,
    loads: &'a Loads,
    writer: &'a Writer<'a>,
    joints: Vec<Joint>,
    collectors: [Collector; 10],
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
            collectors: CHECKS.map(|(name, reason)| Collector::new(name, reason)),
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
        let [loaded, links, joints, guides, agreeing, reduced, lagrange, powers, drive, rubbing] =
            &mut self.collectors;
        compare_loads(subject, (items, &given), one, loaded);
        let methods = subject.methods.iter();
        let answers: Vec<_> =
            methods.map(|method| subject.answer(method, loads, state, &one.position, 1.0)).collect();
        let full = (0..answers.len()).find(|&i| subject.methods[i].gives_reactions && answers[i].is_some());
        let Some((full, reactions)) = full.and_then(|i| Some((i, answers[i].as_ref()?))) else {
            let guides = Some(guides).filter(|_| !subject.linkage.mechanism.slides.is_empty());
            let drive = Some(drive).filter(|_| subject.drive.is_some());
            let all = [links, joints, agreeing, lagrange, powers].into_iter().chain(guides).chain(drive);
            all.for_each(|collector| collector.leave_out(index, NO_ANSWER));
            return;
        };
        let found = self.joints.iter().map(|joint| joint.reaction(&reactions.pairs)).collect();
        let answers = &answers;
        let case = Case { subject, loads, one, state, items, answers, full, reactions, joints: found };
        agreement::compare(&case, agreeing);
        let groups = equilibrium::compare(&case, [links, joints, guides]);
        friction::compare(&case, rubbing);
        let ([dynamics, global], remainder) = power::compare(&case, [reduced, lagrange, powers, drive]);
        self.residuals.push(ForceResiduals { number: index, groups, dynamics, remainder, global });
    }

    /// What was collected, and the residuals of each state.
    pub(crate) fn finish(self) -> (Vec<Collector>, Vec<ForceResiduals>) {
        (self.collectors.into(), self.residuals)
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
