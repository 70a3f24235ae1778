//! The greatest forces over the cycle and the least maximum, against dense positions and another method.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use assur_all as _;
use assur_force::LoadState;
use assur_kinematics::Linkage;
use assur_mechanism::{Mechanism, Motion, Range};
use assur_shaking::{AtPosition, Criterion, Shaking, shaking};
use assur_testkit::specimen::Recipe;

fn found(mechanism: Mechanism) -> Shaking {
    let linkage = Linkage::compile(mechanism).unwrap();
    shaking(&linkage, &|q| LoadState::prescribed(&linkage.mechanism, q)).unwrap()
}

/// Random mechanisms with a cycle, a mass beyond the crank and a prescribed motion; the crank can carry a counterweight.
fn specimens(groups: usize, wanted: usize) -> Vec<Mechanism> {
    let fits = |mechanism: &Mechanism| {
        matches!(mechanism.input.range, Range::Cycle(_))
            && mechanism.input.is_angle()
            && matches!(mechanism.motion, Some(Motion::Prescribed { .. }))
            && mechanism.links.iter().skip(2).any(|link| link.mass > 0.0)
    };
    let drawn = (0..).filter_map(|seed| Recipe::of(groups).specimen(seed));
    drawn.map(|specimen| specimen.mechanism).filter(fits).take(wanted).collect()
}

fn modulus([x, y]: [f64; 2]) -> f64 {
    x.hypot(y)
}

fn greatest(positions: &[AtPosition], of: impl Fn(&AtPosition) -> f64) -> f64 {
    positions.iter().map(of).fold(0.0, f64::max)
}

/// None of 20,000 positions has a greater force or moment, and the greatest ones are not far above them.
#[test]
fn nothing_between_the_samples_is_greater() {
    for groups in 1..=4 {
        for mut mechanism in specimens(groups, 2) {
            mechanism.input.positions = 20_000;
            let found = found(mechanism);
            let judge = |what: &str, shown: f64, dense: f64| {
                // Rounding of sums of inertia loads.
                assert!(dense <= shown * (1.0 + 1e-11), "{groups} {what}: {dense:?} above {shown:?}");
                assert!(dense >= shown * (1.0 - 1e-4), "{groups} {what}: {dense:?} far below {shown:?}");
            };
            judge("force", found.before.greatest_force, greatest(&found.positions, |at| modulus(at.force)));
            judge("moment", found.before.greatest_moment, greatest(&found.positions, |at| at.moment.abs()));
            for (i, balance) in found.balances.iter().enumerate() {
                let shown = balance.after.greatest_force;
                if shown > 1e-6 * found.before.greatest_force {
                    judge("balanced", shown, greatest(&found.positions, |at| modulus(at.balanced[i])));
                }
            }
        }
    }
}

#[test]
fn the_least_maximum_is_proved() {
    for groups in 1..=5 {
        for mechanism in specimens(groups, 5) {
            let found = found(mechanism);
            for balance in &found.balances {
                assert_eq!(balance.proof.is_some(), balance.criterion == Criterion::LeastMaximum);
                let Some(proof) = balance.proof else { continue };
                assert!(proof.gap <= 1e-9, "{groups} groups: {proof:?} of {:?}", balance.after);
                // The bound is one for all counterweights: for none, and for those of least squares.
                assert!(proof.bound <= found.before.greatest_force);
            }
            for pair in found.balances.chunks(2) {
                let [squares, maximum] = pair else { panic!() };
                assert!(maximum.proof.unwrap().bound <= squares.after.greatest_force);
                assert!(maximum.after.greatest_force <= squares.after.greatest_force);
            }
            // More counterweights are no worse.
            if let [_, one, _, all] = &found.balances[..] {
                // Where one balances all, rounding is left.
                let [all, one, before] =
                    [&all.after, &one.after, &found.before].map(|size| size.greatest_force);
                assert!(all <= one * (1.0 + 1e-9) + 1e-12 * before, "{groups} groups: {all} {one} {before}");
            }
        }
    }
}

/// The least of a convex function of one variable, by golden sections.
fn least(ends: [f64; 2], of: &dyn Fn(f64) -> f64) -> f64 {
    assur_number::search::least(ends[0], ends[1], 40, of).1
}

/// The counterweight on the crank by golden sections of golden sections, over 1,500 positions.
#[test]
fn the_crank_by_another_method() {
    let mut judged = 0;
    for mut mechanism in specimens(2, 6) {
        mechanism.input.positions = 1500;
        let Some(Motion::Prescribed { speed, acceleration }) = mechanism.motion else { panic!() };
        let found = found(mechanism);
        // A mass turns with the crank: w² r outward, -e r across. Only its angle against the coordinate is left open.
        let greatest = |x: f64, y: f64| {
            greatest(&found.positions, |at| {
                let (sin, cos) = at.coordinate.sin_cos();
                let (outward, across) = (speed * speed, -acceleration);
                let (a, b) = (outward * x - across * y, across * x + outward * y);
                modulus([at.force[0] + cos * a - sin * b, at.force[1] + sin * a + cos * b])
            })
        };
        let shown = &found.balances[1];
        if shown.after.greatest_force < 1e-6 * found.before.greatest_force {
            continue;
        }
        judged += 1;
        let size = 4.0 * found.before.greatest_force / speed.powi(2).hypot(acceleration);
        let by_hand = least([-size, size], &|x| least([-size, size], &|y| greatest(x, y)));
        let deviation = shown.after.greatest_force / by_hand - 1.0;
        // The positions miss the greatest force by a little.
        assert!((-1e-9..2e-4).contains(&deviation), "{} by hand {by_hand}", shown.after.greatest_force);
    }
    assert!(judged >= 3, "{judged}");
}
