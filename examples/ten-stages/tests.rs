//! The stages against what `docs/course.md` tells and against each other.

use super::*;

#[test]
fn the_stages_agree_with_the_program() {
    main().unwrap();
    let linkage = stage_1().unwrap();
    let loads = Loads::compile(&linkage).unwrap();
    assert!(stage_3(&linkage).unwrap() < 1e-6);
    let found = stage_6(&linkage, &loads).unwrap();
    // The sums of the second and third equations against the compiled loads.
    for index in 0..48 {
        let q = linkage.mechanism.input.coordinate(index);
        let state = LoadState { coordinate: q, speed: 1.0, ..LoadState::default() };
        let reduced = loads.reduced(&state, &bodies(&linkage, q).unwrap());
        let own = stage_4(&linkage, &loads, index).unwrap();
        let theirs = [reduced.inertia, reduced.inertia_derivative, reduced.moment];
        for (own, their) in own.into_iter().zip(theirs) {
            assert!((own - their).abs() <= 1e-11 * (1.0 + their.abs()), "{index}: {own} {their}");
        }
    }
    assert!(stage_8(&linkage, &loads, &found).unwrap() < 1e-9);
    let balancing = stage_9(&linkage, &loads, &found).unwrap();
    assert!(stage_10(&linkage, &balancing, &found) < 1e-9);
}
