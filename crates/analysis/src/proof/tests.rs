//! The balance of energy accepts a motion that keeps it, and no other.

mod twice;

pub(crate) use twice::twice_the_limit;

use super::{Balance, Between, OF_MOTION};

const INTERVALS: usize = super::INTERVALS[1];

/// T = sin² t, so that the power is sin 2t; from `jump` on another power acts, times `factor`.
fn balance(jump: f64, factor: f64, wrong: f64) -> Balance {
    let step = 2.0 / INTERVALS as f64;
    let between = (0..INTERVALS).map(|i| {
        let [before, after] = [i, i + 1].map(|i| i as f64 * step > jump);
        if before == after { Between::Smooth } else { Between::Change }
    });
    let (kinetic, power, rounding) = (Vec::new(), Vec::new(), vec![0.0; INTERVALS + 1]);
    let by_speed = vec![0.0; INTERVALS + 1];
    let between = between.collect();
    let mut found = Balance { step, kinetic, power, rounding, unresolved: 0.0, by_speed, between };
    for i in 0..=INTERVALS {
        let t = i as f64 * step;
        let after = if t > jump { factor } else { 0.0 };
        found.kinetic.push((t.sin().powi(2) + after * (t - jump)) * wrong.powf(t));
        found.power.push((2.0 * t).sin() + after);
    }
    found
}

fn holds(found: &Balance) -> bool {
    let found = found.worst(1e-9);
    found.error <= found.bound
}

#[test]
fn a_smooth_motion_is_proved_sharply() {
    let found = balance(3.0, 0.0, 1.0).worst(1e-9);
    assert!(found.error < 1e-11 && found.bound < 3e-9, "{found:?}");
}

#[test]
fn a_jump_anywhere_between_two_points_is_allowed_for() {
    for i in 0..40 {
        assert!(holds(&balance(1.0 + 1e-4 * f64::from(i), 0.7, 1.0)), "{i}");
    }
}

#[test]
fn a_motion_that_gains_energy_is_refused() {
    assert!(!holds(&balance(3.0, 0.0, 1.0 + 1e-7)));
    assert!(!holds(&balance(1.0, 0.7, 1.01)));
}

#[test]
fn what_lies_between_two_points_proves_nothing() {
    // A moment that acts within the first step alone: the energy is there, the quadrature sees no power.
    let energy = |i: usize| if i == 0 { 0.0 } else { 1.0 };
    let seen = |between: Between| {
        let kinetic = (0..=8).map(energy).collect();
        let (power, rounding, by_speed, between) =
            (vec![0.0; 9], vec![0.0; 9], vec![0.0; 9], vec![between; 8]);
        let found = Balance { step: 1.0, kinetic, power, rounding, unresolved: 0.0, by_speed, between };
        found.worst(1e-9).holds
    };
    assert_eq!(seen(Between::Unseen), None);
    assert_eq!(seen(Between::Smooth), Some(false));
}

#[test]
fn after_a_pole_the_accuracy_of_the_speed_proves_nothing_and_before_it_all() {
    // The reduced inertia grows to 1e9 times that of the fastest place in the middle of the motion.
    let seen = |gain_at: usize| {
        let kinetic = (0..=16).map(|i| if i > gain_at { 1.01 } else { 1.0 }).collect();
        let by_speed = (0..=16).map(|i| if i > 8 { 1e9 } else { 1.0 }).collect();
        let (power, rounding, between) = (vec![0.0; 17], vec![0.0; 17], vec![Between::Smooth; 16]);
        let found = Balance { step: 1.0, kinetic, power, rounding, unresolved: 0.0, by_speed, between };
        found.worst(1e-9)
    };
    let found = seen(12);
    assert_eq!((found.holds, found.bound > 0.1, found.why), (None, true, OF_MOTION));
    assert_eq!(seen(2).holds, Some(false));
}
