//! Bit for bit.

use assur_analysis::unwatched;
use assur_mechanism::{Mechanism, Motion};
use assur_testkit::specimen::{Recipe, Rng};

use crate::probe::probe;
use crate::same::Count;
use crate::{full, mechanism, output, study, text};

/// Compares random parts with the whole; the parts by kernels that leave NaN where the plan wants no derivatives.
fn compare(mechanism: &Mechanism, parts: usize, rng: &mut Rng, count: &mut Count) {
    let whole = full(mechanism).analyze(&mut unwatched).unwrap();
    for _ in 0..parts {
        let output = Some(output(mechanism, rng));
        let mut part = study(Mechanism { output, ..mechanism.clone() });
        let _ = probe(&mut part);
        count.analyses(&part.analyze(&mut unwatched).unwrap(), &whole);
    }
    let mut all = study(Mechanism { output: None, ..mechanism.clone() });
    let _ = probe(&mut all);
    count.analyses(&all.analyze(&mut unwatched).unwrap(), &whole);
}

#[test]
fn shipped_scenes() {
    let mut rng = Rng::new(1);
    let mut names: Vec<_> = assur_fixtures::SCENES.iter().map(|(name, _)| *name).collect();
    names.sort_unstable();
    assert!(names.len() > 15);
    for name in names {
        let mechanism = mechanism(&text(name));
        let found = matches!(mechanism.motion, Some(Motion::Transient { .. } | Motion::Steady { .. }));
        let mut count = Count::default();
        compare(&mechanism, if found { 2 } else { 12 }, &mut rng, &mut count);
        assert!(count.0 > 100, "{name}: {} numbers", count.0);
    }
}

#[test]
fn random_mechanisms() {
    let mut rng = Rng::new(2);
    let mut count = Count::default();
    for seed in 0..60 {
        let groups = 1 + rng.below(5);
        let Some(specimen) = Recipe::of(groups).specimen(seed) else { continue };
        compare(&specimen.mechanism, 4, &mut rng, &mut count);
        // The same at rest: statics, where the loads allow it.
        let mut still = Mechanism { motion: None, balance: None, ..specimen.mechanism };
        still.loads.retain(|load| load.kind.force().is_some() && !load.kind.is_against_motion());
        still.loads.retain(|load| matches!(load.kind.law(), Some(assur_mechanism::Value::Constant(_))));
        compare(&still, 4, &mut rng, &mut count);
        // Only the first loads, so that some groups carry none; massless links.
        still.gravity = None;
        still.loads.truncate(1);
        still.links.iter_mut().for_each(|link| (link.mass, link.inertia) = (0.0, 0.0.into()));
        compare(&still, 4, &mut rng, &mut count);
    }
    assert!(count.0 > 50_000, "{} numbers", count.0);
}
