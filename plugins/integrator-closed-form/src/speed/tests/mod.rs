use assur_integrator::{
    Dependence, EquationOfMotion, IntegrationError, Reduced, Request, State, Trajectory, Until,
};
use assur_problems::{CONSTANT, Example, Place};

use crate::QUADRATURE;

mod closed;
mod pieces;
mod steps;

const BY_SPEED: Dependence = Dependence { moment_on_speed: true, ..CONSTANT };

/// w' = e(w), J = 0.5 kg m².
fn speed_law(e: impl Fn(f64) -> f64) -> Example<impl Fn(Place, &State) -> Reduced> {
    Example::new(BY_SPEED, move |_, at| reduced(e(at.speed)))
}

fn reduced(acceleration: f64) -> Reduced {
    Reduced { inertia: 0.5, inertia_derivative: 0.0, moment: 0.5 * acceleration }
}

fn request(speed: f64, until: Until, tolerance: f64) -> Request {
    let initial = State { time: 1.0, coordinate: -2.0, speed };
    Request { tolerance, samples: 40, ..Request::new(initial, until) }
}

fn solve(motion: &mut dyn EquationOfMotion, request: &Request) -> Trajectory {
    QUADRATURE.solve(motion, request).unwrap()
}

fn refused(motion: &mut dyn EquationOfMotion, request: &Request) -> String {
    match QUADRATURE.solve(motion, request) {
        Err(error @ IntegrationError::NotReached { .. }) => error.to_string(),
        other => panic!("{other:?}"),
    }
}

/// Speed and way since the start against formulas of the time since the start.
fn assert_follows(found: &Trajectory, allowed: [f64; 2], wanted: impl Fn(f64) -> [f64; 2]) {
    for sample in &found.samples {
        let [w, way] = wanted(sample.time - 1.0);
        let off = [(sample.speed - w).abs(), (sample.coordinate + 2.0 - way).abs()];
        assert!(off[0] <= allowed[0] && off[1] <= allowed[1], "{sample:?}: wanted {w} {way}, off {off:?}");
    }
}
