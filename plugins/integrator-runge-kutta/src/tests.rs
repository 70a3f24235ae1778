use assur_integrator::{FixedStep, Request, Until};

use super::*;

fn assert_close(found: f64, wanted: f64, allowed: f64) {
    assert!((found - wanted).abs() <= allowed, "{found} is not {wanted}: off by {:e}", found - wanted);
}

#[test]
fn the_order_is_four() {
    let period = assur_problems::pendulum_period(1.0);
    let initial = State { coordinate: 1.0, ..State::default() };
    let solve = |parts: f64| {
        let step = Some(FixedStep::Time(period / parts));
        let request = Request { fixed_step: step, samples: 3, ..Request::new(initial, Until::Time(period)) };
        RK4.solve(&mut assur_problems::pendulum(), &request).unwrap()
    };
    let error = |parts| solve(parts).end.speed.abs();
    assert_close((error(100.0) / error(200.0)).log2(), 4.0, 0.2);
    // Samples, at thirds of the period, fall between the steps: the dense output must not be worse.
    let by_energy = |parts| {
        let sample = solve(parts).samples[1];
        (0.5 * sample.speed * sample.speed - sample.coordinate.cos() + 1.0_f64.cos()).abs()
    };
    assert!((by_energy(100.0) / by_energy(200.0)).log2() > 3.5);
}

#[test]
fn a_stiff_motor_at_a_long_step_is_reported() {
    let initial = State { speed: 9.9, ..State::default() };
    let request =
        Request { fixed_step: Some(FixedStep::Time(1e-3)), ..Request::new(initial, Until::Coordinate(6.0)) };
    let error = RK4.solve(&mut assur_problems::motor(1e6), &request).unwrap_err().to_string();
    assert!(error.starts_with("the fixed step 1e-3 s is unstable at t = 0.0"), "{error}");
    // The steepness over J(0) = 1.3 kg m²: lambda = 769 231 1/s.
    assert!(error.contains("h*lambda = 769.2"), "{error}");
    assert!(error.contains("take a step below 3.62e-6 s, or an implicit method"), "{error}");
}

#[test]
fn it_conforms() {
    assur_testkit::integrator_conformance("rk4");
}
