//! The balance of energy accepts a motion that keeps it, and no other.

use super::{Balance, INTERVALS};

/// T = sin² t, so that the power is sin 2t; from `jump` on another power acts, times `factor`.
fn balance(jump: f64, factor: f64, wrong: f64) -> Balance {
    let step = 2.0 / INTERVALS as f64;
    let mut found = Balance { step, kinetic: Vec::new(), power: Vec::new(), steps_over: Vec::new() };
    for i in 0..=INTERVALS {
        let t = i as f64 * step;
        let after = if t > jump { factor } else { 0.0 };
        found.kinetic.push((t.sin().powi(2) + after * (t - jump)) * wrong.powf(t));
        found.power.push((2.0 * t).sin() + after);
    }
    found
}

fn holds(found: &Balance) -> bool {
    let (residual, limit) = found.worst(1e-9);
    residual <= limit
}

#[test]
fn a_smooth_motion_is_proved_sharply() {
    let (residual, limit) = balance(3.0, 0.0, 1.0).worst(1e-9);
    assert!(residual < 1e-11 && limit < 3e-9, "{residual:e} {limit:e}");
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
    let seen = |steps_over: bool| {
        let kinetic = (0..=8).map(energy).collect();
        let found = Balance { step: 1.0, kinetic, power: vec![0.0; 9], steps_over: vec![steps_over; 9] };
        let (residual, limit) = found.worst(1e-9);
        let check = assur_check::Check::of("work", residual, limit, "", "");
        (check.judged, check.ok)
    };
    assert_eq!(seen(true), (false, false));
    assert_eq!(seen(false), (true, false));
}
