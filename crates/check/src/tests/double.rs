//! Differences in 16 digits against those in 32.

use assur_kinematics::Linkage;
use assur_number::Dd;

use crate::elements::elements;
use crate::subject::Subject;
use crate::surroundings::{Differences, Surroundings};
use crate::test_pf::{Comparison, Deviation};
use crate::{Chosen, methods};

/// In ordinary positions both judge, and agree: the difference of both is within the limit of the coarser.
#[test]
fn ordinary_positions_are_judged_in_double_and_agree_with_32_digits() {
    for name in ["shaper", "guide-shaper", "slider-crank", "conveyor", "stephenson3", "press", "r-rtr-rrt"] {
        let linkage =
            Linkage::compile(assur_scene::read(name, assur_fixtures::scene(name)).unwrap()).unwrap();
        let count = linkage.mechanism.input.positions;
        let subject = Subject {
            linkage: &linkage,
            loads: None,
            positions: Chosen::all(count),
            states: Chosen::all(0),
            state: &|_| None,
            drive: None,
            methods: methods(&linkage, None),
        };
        let all = elements(&linkage);
        let mut double = Differences::<f64>::of(&subject).unwrap();
        let mut double_double = Differences::<Dd>::of(&subject).unwrap();
        let mut judged = 0;
        for index in 0..count {
            let one = subject.solve(index, linkage.mechanism.input.coordinate(index)).unwrap();
            let deviations =
                |around: Surroundings| Comparison::of(&subject, &all, &one, around).deviations(&all, true);
            let coarse = deviations(double.around(&all, &one).unwrap());
            if !coarse.iter().all(Deviation::is_judged_in_double) {
                continue;
            }
            judged += 1;
            for (coarse, fine) in coarse.iter().zip(deviations(double_double.around(&all, &one).unwrap())) {
                assert!(fine.off <= fine.limit, "{name} {index}: off by {:e} of {:e}", fine.off, fine.limit);
                let apart = (coarse.off - fine.off).abs();
                assert!(apart <= coarse.limit, "{name} {index}: {apart:e} of {:e}", coarse.limit);
            }
        }
        println!("{name}: {judged} of {count} judged in double");
        assert!(10 * judged >= 9 * count, "{name}: only {judged} of {count} are judged in double");
    }
}
