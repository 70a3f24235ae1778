//! Errors in the forces of joints. They are sums over the reactions of pairs, which act and react by construction: so an error
//! is planted in the sums.

use assur_force::joints;

use super::{Trial, Width, named};
use crate::case::{Case, largest};
use crate::check::Collector;
use crate::equilibrium;
use crate::forces::CHECKS;
use crate::written::{Writer, given};

#[test]
fn a_joint_whose_forces_are_unequal_by_twice_the_limit_is_caught() {
    let name = "forces of joints";
    let mut width = Width::default();
    for trial in Trial::all() {
        if width.is_complete() {
            break;
        }
        let state = trial.state();
        let subject = trial.subject(&|_| None, None);
        let one = subject.solve(trial.index, state.coordinate).unwrap();
        let bodies = &one.position.bodies;
        let items = Writer::new(&subject).items(&given(&trial.loads, &state, bodies), &state, bodies);
        let answers = [subject.answer(&subject.methods[0], &trial.loads, &state, &one.position, 1.0)];
        let [Some(reactions)] = &answers else { continue };
        let all = joints(trial.mechanism(), &trial.linkage.structure);
        width.add(&format!("{name}, seed {}", trial.seed), |error| {
            let mut joints: Vec<_> = all.iter().map(|joint| joint.reaction(&reactions.pairs)).collect();
            let victim = trial.index % joints.len();
            let by = error * largest(&reactions.pairs, trial.linkage.structure.scale);
            joints[victim].forces[0].1[trial.index % 2] += by;
            let (subject, loads, one, state, items) = (&subject, &trial.loads, &one, &state, &items);
            let (answers, full) = (&answers[..], 0);
            let case = Case { subject, loads, one, state, items, answers, full, reactions, joints };
            let mut collectors = CHECKS.map(|(name, reason)| Collector::new(name, reason));
            let [_, links, joints, guides, ..] = &mut collectors;
            equilibrium::compare(&case, [links, joints, guides]);
            named(collectors, name)
        });
    }
    // In joints of two links the sum is exactly zero.
    width.judge(name, 1e-9, 0.0);
}
