//! Every adaptive method on 200 motions: the error at the end is at most ten times the tolerance, or the result says that it
//! is not. References: formulas, or another method to 1e-13.

use assur_all as _;
use assur_integrator::{AUTO, IntegrationError, Knob, Request, State, Trajectory, choose, integrators};
use assur_testkit::Rng;

mod families;

use families::{Case, FAMILIES};

/// Motions in all.
const MOTIONS: usize = 200;

/// Tolerances, in turn.
const TOLERANCES: [f64; 7] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9];

/// Tolerance of a reference that no formula gives.
const TIGHT: f64 = 1e-13;

fn request(case: &Case, tolerance: f64) -> Request {
    Request { tolerance, samples: 20, max_steps: 2_000_000, ..Request::new(case.initial, case.until) }
}

/// The motion by another method than `method`, tightly.
fn reference(case: &Case, method: &str) -> Result<State, IntegrationError> {
    if let Some(exact) = case.exact {
        return Ok(exact);
    }
    let other = if ["dop853", AUTO].contains(&method) { "dopri5" } else { "dop853" };
    let request = request(case, TIGHT);
    Ok(assur_integrator::find(other)?.solve(&mut *(case.motion)(), &request)?.end)
}

/// Errors of speed and coordinate at the end over the largest speed and the travel.
fn error(found: &Trajectory, wanted: &State) -> f64 {
    let largest = |value: fn(&assur_integrator::Sample) -> f64| {
        found.samples.iter().map(|sample| value(sample).abs()).fold(f64::MIN_POSITIVE, f64::max)
    };
    let start = found.samples[0].coordinate;
    let travel = found.samples.iter().map(|sample| (sample.coordinate - start).abs()).fold(1e-300, f64::max);
    let speed = (found.end.speed - wanted.speed).abs() / largest(|sample| sample.speed);
    speed.max((found.end.coordinate - wanted.coordinate).abs() / travel)
}

/// The error at the end in tolerances, and what the result itself says of it.
fn ratios(case: &Case, method: &str, tolerance: f64) -> (f64, f64) {
    let wanted = reference(case, method).unwrap_or_else(|why| panic!("reference of {}: {why}", case.family));
    let found = assur_integrator::solve(method, &mut *(case.motion)(), &request(case, tolerance))
        .unwrap_or_else(|why| panic!("{} by {method}: {why}", case.family))
        .trajectory;
    let estimate = found.statistics.error.unwrap_or(0.0) / tolerance;
    (error(&found, &wanted) / tolerance, estimate)
}

#[test]
fn the_error_at_the_end_is_at_most_ten_tolerances_or_told() {
    let registered = integrators().unwrap();
    let methods = registered.iter().filter(|plugin| plugin.knob == Knob::Tolerance);
    let methods: Vec<&str> = methods.map(|plugin| plugin.name).chain([AUTO]).collect();
    let mut beyond = 0;
    for seed in 0..MOTIONS {
        let case = FAMILIES[seed % FAMILIES.len()](&mut Rng::new(seed as u64));
        let tolerance = TOLERANCES[seed / FAMILIES.len() % TOLERANCES.len()];
        let dependence = (case.motion)().dependence();
        for method in methods.iter().filter(|name| choose(name, &dependence, tolerance).is_ok()) {
            let (found, estimate) = ratios(&case, method, tolerance);
            let Case { family, .. } = case;
            assert!(
                found <= 10.0 || estimate > 10.0,
                "{family}, seed {seed}, {method} at {tolerance:e}: off by {found} tolerances, estimated are {estimate}"
            );
            beyond += usize::from(found > 10.0);
        }
    }
    assert!(beyond <= MOTIONS / 50, "{beyond} runs are off by more, and only say so");
}
