//! Motions with a closed form.

use std::f64::consts::TAU;

use assur_integrator_dormand_prince::DOP853;

use super::*;

/// w' = (W - w)/T: w = W + (w0 - W) exp(-t/T), way = W t + T (w0 - W)(1 - exp(-t/T)).
#[test]
fn a_linear_characteristic_is_approached_exponentially() {
    for (settled, constant) in [(10.0, 0.3), (-4.0, 2.0), (150.0, 1e-5), (0.5, 40.0)] {
        for w0 in [0.0, 7.0, -3.0, 200.0] {
            for end in [0.1, 3.0, 500.0] {
                for tolerance in [1e-3, 1e-9, 1e-13] {
                    let mut motion = speed_law(|w| (settled - w) / constant);
                    let found = solve(&mut motion, &request(w0, Until::Time(1.0 + end), tolerance));
                    let d: f64 = w0 - settled;
                    let (fastest, far) =
                        (w0.abs().max(settled.abs()), settled.abs() * end + constant * d.abs());
                    // Roundings of panels that may be longer than needed.
                    let part = tolerance.max(2e-13);
                    assert_follows(&found, [part * fastest, part * far], |t| {
                        let gone = -(-t / constant).exp_m1();
                        [settled + d * (1.0 - gone), settled * t + constant * d * gone]
                    });
                    assert!(found.statistics.steps <= 5, "{:?}", found.statistics);
                }
            }
        }
    }
}

/// w' = -c w² (a fan): w = w0/(1 + c w0 t), way = ln(1 + c w0 t)/c.
#[test]
fn a_fan_slows_down_for_ever() {
    for tolerance in [1e-4, 1e-8, 1e-12] {
        for end in [0.5, 100.0, 1e6] {
            let (w0, c) = (20.0, 0.3);
            let mut motion = speed_law(|w| -c * w * w.abs());
            let found = solve(&mut motion, &request(w0, Until::Time(1.0 + end), tolerance));
            let way = (c * w0 * end).ln_1p() / c;
            let steps = found.statistics.steps as f64;
            assert_follows(&found, [tolerance * steps * w0, tolerance * steps * way], |t| {
                [w0 / (1.0 + c * w0 * t), (c * w0 * t).ln_1p() / c]
            });
            // Panels count the decades of the speed: fewer evaluations than half of those of steps in time.
            if end > 1e5 && tolerance < 1e-7 {
                let request = request(w0, Until::Time(1.0 + end), tolerance);
                let steps = DOP853.solve(&mut motion, &request).unwrap().statistics;
                let own = found.statistics;
                assert!(own.evaluations < steps.evaluations / 2, "{own:?} {steps:?}");
            }
        }
    }
    let error = refused(&mut speed_law(|w| -w), &request(5.0, Until::Turn, 1e-9));
    assert!(error.ends_with("creeps to rest without end"), "{error}");
}

/// w' = a (1 - (w/W)²): w = W tanh(t a/W), way = W²/a ln cosh(t a/W).
#[test]
fn a_fan_at_a_constant_moment_is_a_hyperbolic_tangent() {
    let (a, settled) = (12.0, 30.0);
    for tolerance in [1e-4, 1e-8, 1e-12] {
        for end in [1.0, 40.0, 1e4] {
            let mut motion = speed_law(|w| a * (1.0 - (w / settled) * (w / settled)));
            let found = solve(&mut motion, &request(0.0, Until::Time(1.0 + end), tolerance));
            let steps = found.statistics.steps as f64;
            assert_follows(&found, [tolerance * steps * settled, tolerance * steps * settled * end], |t| {
                let x = t * a / settled;
                // ln cosh x without overflow.
                let log = x + (-2.0 * x).exp().ln_1p() - std::f64::consts::LN_2;
                [settled * x.tanh(), settled * settled / a * log]
            });
        }
    }
}

/// From beside a speed that the motion leaves: w = W + d exp(t/T).
#[test]
fn a_speed_that_repels_is_left_exponentially() {
    let (settled, constant, d) = (8.0, 0.5, 1e-6);
    for tolerance in [1e-5, 1e-9, 1e-12] {
        let mut motion = speed_law(|w| (w - settled) / constant);
        let end = constant * 1e6_f64.ln();
        let found = solve(&mut motion, &request(settled + d, Until::Time(1.0 + end), tolerance));
        // The start itself is known to a rounding of 8 in 1e-6.
        let allowed = tolerance * found.statistics.steps as f64 * 9.0 + 4.0 * f64::EPSILON / d;
        assert_follows(&found, [allowed, allowed], |t| {
            let grown = d * (t / constant).exp();
            [settled + grown, settled * t + constant * (grown - d)]
        });
    }
}

#[test]
fn a_speed_at_which_nothing_acts_stays() {
    for (settled, w0) in [(8.0, 8.0), (8.0, 8.0 + 1e-15), (0.1 + 0.2, 0.3), (1e5 / 3.0, 1e5 / 3.0)] {
        let mut motion = speed_law(|w| 1e3 * (settled - w));
        let found = solve(&mut motion, &request(w0, Until::Time(5.0), 1e-9));
        assert_follows(&found, [1e-15 * w0, 1e-14 * w0], |t| [w0, w0 * t]);
        let found = solve(&mut motion, &request(w0, Until::Coordinate(-2.0 + 3.0 * w0), 1e-9));
        assert!((found.end.time - 4.0).abs() < 1e-13, "{:?}", found.end);
        let error = refused(&mut motion, &request(w0, Until::Rest, 1e-9));
        assert!(error.starts_with("rest is never reached"), "{error}");
    }
}

/// The moment is the small difference of large ones, and hardly depends on the speed: near the end it is rounding.
#[test]
fn a_moment_of_roundings_neither_hangs_nor_blows_up() {
    let (big, slope) = (1e6 / 3.0, 1e-3);
    let e = |w: f64| (big + slope * (100.0 - w)) - big;
    let found = solve(&mut speed_law(e), &request(40.0, Until::Time(1.0 + 3e4), 1e-7));
    // big is rounded to 6e-11, and with it the moment: the speed that is approached is known to 6e-8.
    assert_follows(&found, [1e-5, 1.0], |t| {
        let gone = -(-slope * t).exp_m1();
        [40.0 + 60.0 * gone, 100.0 * t - 60.0 / slope * gone]
    });
}

/// A way of -2 pi at -20 rad/s, sped up or slowed down by what rounding leaves of a balance.
#[test]
fn a_moment_of_roundings_leaves_the_speed_to_a_place() {
    for acceleration in [1e-16, -1e-16] {
        let end = -2.0 - TAU;
        let found = solve(&mut speed_law(|_| acceleration), &request(-20.0, Until::Coordinate(end), 1e-10));
        let time = found.end.time - 1.0;
        assert!((time / (TAU / 20.0) - 1.0).abs() < 1e-14, "{time}");
        assert!((found.end.speed + 20.0).abs() < 1e-14);
    }
}

#[test]
fn places_rest_and_reversal_are_met() {
    // w = -2 + 12 exp(-t): rest at ln 6 after 10 - 2 ln 6, then back.
    let motion = || speed_law(|w| -2.0 - w);
    let rest = 6.0_f64.ln();
    let found = solve(&mut motion(), &request(10.0, Until::Turn, 1e-10));
    assert!((found.end.time - 1.0 - rest).abs() < 1e-14 * 20.0, "{:?}", found.end);
    assert!((found.end.coordinate + 2.0 - (10.0 - 2.0 * rest)).abs() < 1e-13, "{:?}", found.end);
    let found = solve(&mut motion(), &request(10.0, Until::Time(9.0), 1e-10));
    let kinds: Vec<_> = found.events.iter().map(|event| event.kind).collect();
    assert_eq!(kinds, [assur_integrator::EventKind::Reversal]);
    assert_follows(&found, [1e-13, 1e-12], |t| [-2.0 + 12.0 * (-t).exp(), -2.0 * t - 12.0 * (-t).exp_m1()]);
    // Way at ln 2: 6 - 2 ln 2; and after the reversal a place behind the start, t with -2 t + 12 = -100.
    let there = Until::Coordinate(-2.0 + 6.0 - 2.0 * 2.0_f64.ln());
    let found = solve(&mut motion(), &request(10.0, there, 1e-10));
    assert!((found.end.time - 1.0 - 2.0_f64.ln()).abs() < 1e-13, "{:?}", found.end);
    let found = solve(&mut motion(), &request(10.0, Until::Coordinate(-102.0), 1e-10));
    assert!((found.end.time - 57.0).abs() < 1e-11, "{:?}", found.end);
    let limited = Request { time_limit: 4.0, ..request(10.0, Until::Coordinate(-102.0), 1e-10) };
    let error = refused(&mut motion(), &limited);
    assert!(error.ends_with("reached the time limit"), "{error}");
    // Creeping to rest, 5 rad in all.
    let error = refused(&mut speed_law(|w| -w), &request(5.0, Until::Coordinate(3.1), 1e-9));
    assert!(error.starts_with("coordinate 3.1 is never reached"), "{error}");
    let found = solve(&mut speed_law(|w| -w), &request(5.0, Until::Coordinate(2.9), 1e-9));
    assert!((found.end.time - 1.0 - 50.0_f64.ln()).abs() < 1e-11, "{:?}", found.end);
}
