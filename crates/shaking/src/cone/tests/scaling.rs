use crate::cone::{Scaling, inner, most};

#[test]
fn a_scaling_makes_slack_and_dual_one() {
    let (slack, dual) = ([1.3, 0.7, -0.4], [0.2, -0.05, 0.15]);
    let scaling = Scaling::of(slack, dual).unwrap();
    for (a, b) in scaling.times(dual).into_iter().zip(scaling.divided(slack)) {
        assert!((a - b).abs() < 1e-15, "{a} {b}");
    }
    for (a, b) in scaling.divided(scaling.times(slack)).into_iter().zip(slack) {
        assert!((a - b).abs() < 1e-15, "{a} {b}");
    }
}

#[test]
fn a_step_ends_on_the_cone() {
    let at = [1.3, 0.7, -0.4];
    for step in [[-1.0, 0.0, 0.0], [0.1, 2.0, -1.0], [-1.0, 0.5, 3.0], [1.0, -1.0, -1.0]] {
        let part = most(at, step);
        let end = [0, 1, 2].map(|i| at[i] + part * step[i]);
        assert!(inner(end).abs() < 1e-13 && end[0] > 0.0, "{step:?}: {end:?}");
    }
    assert!(most(at, [1.0, 0.5, 0.5]).is_infinite());
    assert!(Scaling::of([1.0, 1.0, 0.0], at).is_none());
}
