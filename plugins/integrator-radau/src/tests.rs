use std::f64::consts::TAU;

use assur_integrator::{Request, State, Until};

use nalgebra::Matrix3;

use super::*;
use crate::collocation::{A, C, E, GAMMA};

fn assert_close(found: f64, wanted: f64, allowed: f64) {
    assert!((found - wanted).abs() <= allowed, "{found} is not {wanted}: off by {:e}", found - wanted);
}

#[test]
fn the_table_is_radau_collocation() {
    for k in 0..3 {
        let found = A * C.map(|c| c.powi(k));
        let wanted = C.map(|c| c.powi(k + 1) / f64::from(k + 1));
        assert_close((found - wanted).amax(), 0.0, 1e-15);
    }
    for k in 0..5 {
        let found = (A * C.map(|c| c.powi(k)))[2];
        assert_close(found, 1.0 / f64::from(k + 1), 1e-15);
    }
}

/// γ solves det(A - 1/γ) = 0, and the error vanishes for a solution of degree 3.
#[test]
fn the_error_estimate_has_order_three() {
    let shifted = A - Matrix3::identity() / GAMMA;
    assert_close(shifted.determinant(), 0.0, 1e-15);
    // E z + h y' with z = y(c h) - y(0): zero for y = t, t², t³, not for t⁴.
    let estimate = |power: i32| {
        let slope = if power == 1 { 1.0 } else { 0.0 };
        slope + E.dot(&C.map(|c| c.powi(power)))
    };
    for power in 1..4 {
        assert_close(estimate(power), 0.0, 1e-14);
    }
    assert!(estimate(4).abs() > 1e-3);
}

#[test]
fn a_stiff_turn_costs_few_evaluations() {
    let initial = State { speed: 9.0, ..State::default() };
    for steepness in [1e6, 1e9] {
        let request =
            Request { tolerance: 1e-6, samples: 10, ..Request::new(initial, Until::Coordinate(TAU)) };
        let found = RADAU5.solve(&mut assur_problems::motor(steepness), &request).unwrap();
        assert!(found.statistics.evaluations < 500, "{:?}", found.statistics);
        // On the slow manifold w = 10 - (2 + sin q + J' w²/2)/k to first order in 1/k; at a whole turn 10 - 2/k.
        assert_close(found.end.speed, 10.0 - 2.0 / steepness, 1e-5);
        // The first transient lasts 1/k; after it a turn at speed 10.
        assert_close(found.end.time, 0.1 * TAU, 1e-5);
    }
}

#[test]
fn pendulum_meets_the_tolerance() {
    let initial = State { coordinate: 2.0, ..State::default() };
    let period = assur_problems::pendulum_period(2.0);
    for tolerance in [1e-4, 1e-6, 1e-8] {
        let request = Request { tolerance, samples: 1, ..Request::new(initial, Until::Time(period)) };
        let found = RADAU5.solve(&mut assur_problems::pendulum(), &request).unwrap();
        assert_close(found.end.coordinate, 2.0, 10.0 * tolerance * 4.0);
        assert!(found.statistics.jacobians >= found.statistics.steps);
    }
}

#[test]
fn it_conforms() {
    assur_testkit::integrator_conformance("radau5");
}
