//! Methods with a fixed step, whose length a scene gives.

use assur_fixtures::scene;

use super::compiled;
use crate::{DynamicsError, Method, Transient, transient};

fn run_up(step: &str, integrator: &str) -> Result<Transient, DynamicsError> {
    let (linkage, loads) = compiled(
        &(scene("run-up").to_owned() + &format!("\nintegrator = \"{integrator}\"\nstep = {step}\n")),
    );
    transient(&linkage, &loads, &Method::default(), None)
}

/// E example 1 by D's own method of order 1: the measured error is the true one, and a tenth of the step has a tenth of it.
#[test]
fn the_error_of_fixed_steps_is_told() {
    let exact = (1000.0 * std::f64::consts::PI).sqrt();
    for steps in [["0.01", "0.001"], ["\"2 deg\"", "\"0.2 deg\""]] {
        let [coarse, fine] = steps.map(|step| {
            let found = run_up(step, "uniform").unwrap();
            let error = found.trajectory.statistics.error.unwrap();
            let end = (found.trajectory.end.speed - exact).abs() / exact;
            assert!(end <= error * 1.2, "{step}: {end} {error}");
            error
        });
        assert!((5.0..20.0).contains(&(coarse / fine)), "{steps:?}: {coarse} {fine}");
    }
    assert!(run_up("0.01", "rk4").unwrap().trajectory.statistics.error.unwrap() < 1e-6);
}
