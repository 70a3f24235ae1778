//! Order conditions, convergence, worked examples, events and failures.

use assur_integrator::{Dependence, IntegrationError, Request, State, Until};
use assur_problems::Example;

use super::*;

mod answers;
mod conditions;
mod events;
mod failures;

/// Both methods.
const METHODS: [&IntegratorPlugin; 2] = [&DOPRI5, &DOP853];

fn from_rest(until: Until, tolerance: f64) -> Request {
    Request { tolerance, samples: 8, ..Request::new(State::default(), until) }
}

fn assert_close(found: f64, wanted: f64, allowed: f64) {
    assert!((found - wanted).abs() <= allowed, "{found} is not {wanted}: off by {:e}", found - wanted);
}

#[test]
fn both_are_registered() {
    let names: Vec<&str> =
        assur_integrator::integrators().unwrap().iter().map(|plugin| plugin.name).collect();
    assert_eq!(names, ["dop853", "dopri5"]);
    for name in names {
        assert_eq!(assur_integrator::find(name).unwrap().name, name);
    }
    let error = assur_integrator::find("euler").unwrap_err().to_string();
    assert_eq!(error, "no integrator is called `euler`; there are: dop853, dopri5");
}

#[test]
fn both_conform() {
    for method in METHODS {
        assur_testkit::integrator_conformance(method.name);
    }
}
