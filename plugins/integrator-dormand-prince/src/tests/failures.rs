//! Honest failure: what, where, what to do.

use assur_integrator::{EquationOfMotion, MotionError, Piece, Reduced};

use super::*;

#[test]
fn stiffness_is_suspected_with_its_number() {
    let initial = State { speed: 9.9, ..State::default() };
    for method in METHODS {
        let request =
            Request { max_steps: 300, tolerance: 1e-6, ..Request::new(initial, Until::Coordinate(6.0)) };
        let error = method.solve(&mut assur_problems::motor(1e6), &request).unwrap_err();
        let IntegrationError::TooManySteps { steps: 300, stiffness: Some(product), at, .. } = error else {
            panic!("{error}");
        };
        assert!((1.5..10.0).contains(&product), "{product}");
        assert!(at.time > 0.0 && at.time < 0.1);
        assert!(error.to_string().contains("probably stiff (h*lambda = "), "{error}");
        assert!(error.to_string().contains("use an implicit method"), "{error}");
    }
}

/// The mechanism ends at q = 1.
struct Wall;

impl EquationOfMotion for Wall {
    fn dependence(&self) -> Dependence {
        assur_problems::BY_COORDINATE
    }

    fn enter(&mut self, _: &State) -> Result<Piece, MotionError> {
        Ok(Piece::UNBOUNDED)
    }

    fn reduced(&mut self, state: &State) -> Result<Reduced, MotionError> {
        if state.coordinate > 1.0 {
            return Err(MotionError::Mechanism(assur_words::name("no assembly")));
        }
        Ok(Reduced { inertia: 1.0, inertia_derivative: 0.0, moment: 1.0 })
    }
}

#[test]
fn a_failing_equation_is_reported_where_it_fails() {
    for method in METHODS {
        let error = method.solve(&mut Wall, &from_rest(Until::Time(10.0), 1e-9)).unwrap_err();
        let IntegrationError::EndOfRange { at, .. } = &error else { panic!("{error}") };
        assert_close(at.coordinate, 1.0, 1e-6);
        assert!(error.to_string().contains("no assembly"), "{error}");
        assert!(error.to_string().contains("t = 1.41421"), "{error}");
    }
}

#[test]
fn an_end_that_never_comes_is_an_error() {
    let friction = Request::new(State { speed: 1.0, ..State::default() }, Until::Coordinate(10.0));
    let limited = Request { time_limit: 3.0, ..from_rest(Until::Coordinate(1e9), 1e-6) };
    for method in METHODS {
        let error = method.solve(&mut assur_problems::d1_friction(), &friction).unwrap_err().to_string();
        assert_eq!(
            error,
            "coordinate 10 is never reached: the motion got to t = 0.500000000 s, q = 0.250000000, \
             w = 0.000000000 and rests there for good"
        );
        let error = method.solve(&mut assur_problems::e1(), &limited).unwrap_err().to_string();
        assert!(error.contains("reached the time limit"), "{error}");
    }
}

#[test]
fn impossible_requests_are_refused() {
    for (request, words) in [
        (from_rest(Until::Time(-1.0), 1e-6), "must be after the start"),
        (from_rest(Until::Time(1.0), 0.0), "tolerance"),
        (Request { samples: 0, ..from_rest(Until::Time(1.0), 1e-6) }, "at least 1"),
        (from_rest(Until::Coordinate(0.0), 1e-6), "already there"),
    ] {
        let error = DOP853.solve(&mut assur_problems::e1(), &request).unwrap_err().to_string();
        assert!(error.contains(words), "{error}");
    }
}
