//! The pruned plan gives the numbers of the full solution, bit for bit, and solves less.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use assur_all as _;
use assur_analysis::{Calculation, Options, unwatched};
use assur_mechanism::{Mechanism, Output, PairId};
use assur_testkit::specimen::Rng;

mod cost;
mod numbers;
mod probe;
mod same;

fn text(name: &str) -> String {
    assur_fixtures::scene(name).to_owned()
}

fn mechanism(text: &str) -> Mechanism {
    assur_scene::read("test", text).unwrap()
}

fn study(mechanism: Mechanism) -> Calculation {
    Calculation::of(mechanism, &Options::default(), &mut unwatched).unwrap()
}

/// The full solution: every group, up to PF2, with the forces of every group.
fn full(mechanism: &Mechanism) -> Calculation {
    let mut study = study(Mechanism { output: None, ..mechanism.clone() });
    assert!(!study.plan.is_partial());
    study.plan.groups_carrying.fill(true);
    study.plan.order = assur_group::Order::Second;
    study
}

/// A random part of what can be asked for; often nothing of a kind.
fn output(mechanism: &Mechanism, rng: &mut Rng) -> Output {
    let mut some = |count: usize, first: usize| -> Vec<usize> {
        let share = if rng.chance(0.4) { 0.0 } else { rng.unit() };
        (first..count).filter(|_| rng.chance(share)).collect()
    };
    let links = some(mechanism.links.len(), 1);
    let points = some(mechanism.points.len(), 0);
    let slides = some(mechanism.slides.len(), 0);
    let pins = some(mechanism.points.len(), 0).into_iter();
    let pins = pins.filter(|id| mechanism.points[*id].is_pin()).map(PairId::Pin).collect::<Vec<_>>();
    let guides = some(mechanism.slides.len(), 0).into_iter().map(PairId::Slide);
    Output { links, points, slides, reactions: pins.into_iter().chain(guides).collect() }
}
