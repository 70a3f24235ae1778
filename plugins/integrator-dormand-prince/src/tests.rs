//! Order conditions, convergence, worked examples, events and failures.

use assur_integrator::problems::{self, Example};
use assur_integrator::{Dependence, State, Until};

use super::*;

mod answers;
mod conditions;
mod events;
mod failures;

/// Both methods.
const METHODS: [&dyn Integrator; 2] = [&Dopri5, &Dop853];

fn from_rest(until: Until, tolerance: f64) -> Request {
    Request { tolerance, samples: 8, ..Request::new(State::default(), until) }
}

fn assert_close(found: f64, wanted: f64, allowed: f64) {
    assert!((found - wanted).abs() <= allowed, "{found} is not {wanted}: off by {:e}", found - wanted);
}
