use assur_integrator::{Dependence, EquationOfMotion, EventKind, Piece, Reduced, Request, Until};
use assur_problems::{CONSTANT, Example};

use super::*;
use crate::QUADRATURE;

const BY_TIME: Dependence = Dependence { moment_on_time: true, ..CONSTANT };

fn inertia(moment: f64) -> Reduced {
    Reduced { inertia: 0.5, inertia_derivative: 0.0, moment }
}

fn start(speed: f64) -> State {
    State { time: 0.0, coordinate: 0.3, speed }
}

/// M = J (2 t - 3) up to t = 4, then J (13 - 2 t): a table over time with a kink.
struct Table {
    late: bool,
}

impl EquationOfMotion for Table {
    fn dependence(&self) -> Dependence {
        BY_TIME
    }

    fn enter(&mut self, state: &State) -> Result<Piece, MotionError> {
        self.late = state.time >= 4.0;
        let time = if self.late { [4.0, f64::INFINITY] } else { [f64::NEG_INFINITY, 4.0] };
        Ok(Piece { time, ..Piece::UNBOUNDED })
    }

    fn reduced(&mut self, state: &State) -> Result<Reduced, MotionError> {
        Ok(inertia(0.5 * if self.late { 13.0 - 2.0 * state.time } else { 2.0 * state.time - 3.0 }))
    }
}

#[test]
fn a_table_is_exact_in_a_step_for_each_piece() {
    let request = Request { samples: 60, ..Request::new(start(7.0), Until::Time(6.0)) };
    let found = QUADRATURE.solve(&mut Table { late: false }, &request).unwrap();
    for sample in &found.samples {
        let t = sample.time;
        // w = 7 - 3 t + t^2, q its integral; from t = 4 on with 11 + 5 s - s^2, s = t - 4.
        let (w, q) = if t <= 4.0 {
            (7.0 + t * (t - 3.0), 0.3 + t * (7.0 + t * (t / 3.0 - 1.5)))
        } else {
            let s = t - 4.0;
            (11.0 + s * (5.0 - s), 0.3 + 28.0 + 64.0 / 3.0 - 24.0 + s * (11.0 + s * (2.5 - s / 3.0)))
        };
        assert!(
            (sample.speed - w).abs() < 1e-13 * 20.0 && (sample.coordinate - q).abs() < 1e-13 * 60.0,
            "{t}"
        );
    }
    // The first step is short, as nothing is known; each further one as long as it may.
    assert!(found.statistics.steps <= 8, "{:?}", found.statistics);
}

#[test]
fn a_moment_that_swings_keeps_the_tolerance() {
    // w = 1 + (m/k)(1 - cos k t), q = 0.3 + t (1 + m/k) - (m/k^2) sin k t.
    let (m, k) = (40.0, 7.0);
    for tolerance in [1e-5, 1e-8, 1e-11] {
        let mut motion = Example::new(BY_TIME, move |_, at| inertia(0.5 * m * (k * at.time).sin()));
        let request = Request { tolerance, samples: 200, ..Request::new(start(1.0), Until::Time(10.0)) };
        let found = QUADRATURE.solve(&mut motion, &request).unwrap();
        for sample in &found.samples {
            let t = sample.time;
            let w = 1.0 + m / k * (1.0 - (k * t).cos());
            let q = 0.3 + t * (1.0 + m / k) - m / (k * k) * (k * t).sin();
            // Errors of the steps add up; the speed is at most 12.4, the way 68.
            let steps = found.statistics.steps as f64;
            assert!((sample.speed - w).abs() < tolerance * steps * 12.4, "{tolerance:e} {t}");
            assert!((sample.coordinate - q).abs() < tolerance * steps * 68.0, "{tolerance:e} {t}");
        }
    }
}

#[test]
fn places_and_rest_are_met() {
    // w = 9 - t^2: rest at 3, after 18 rad; it turns back there, as the moment goes on.
    let motion = || Example::new(BY_TIME, |_, at| inertia(-at.time));
    let found = QUADRATURE.solve(&mut motion(), &Request::new(start(9.0), Until::Turn)).unwrap();
    assert!((found.end.time - 3.0).abs() < 1e-9, "{:?}", found.end);
    assert!((found.end.coordinate - 18.3).abs() < 1e-12, "{:?}", found.end);
    let until = Until::Coordinate(0.3 + 9.0 - 1.0 / 3.0);
    let found = QUADRATURE.solve(&mut motion(), &Request::new(start(9.0), until)).unwrap();
    assert!((found.end.time - 1.0).abs() < 1e-12, "{:?}", found.end);
    let found = QUADRATURE.solve(&mut motion(), &Request::new(start(9.0), Until::Time(4.0))).unwrap();
    assert!(found.events.iter().any(|event| event.kind == EventKind::Reversal));
    assert!((found.end.speed + 7.0).abs() < 1e-12, "{:?}", found.end);
}

#[test]
fn it_is_the_motion_of_constant_moments_too_and_of_no_others() {
    let request = Request::new(State { time: 0.0, coordinate: 0.0, speed: 100.0 }, Until::Turn);
    let found = QUADRATURE.solve(&mut assur_problems::d1(), &request).unwrap();
    assert!((found.end.time - 50.0).abs() < 1e-9 && (found.end.coordinate - 2500.0).abs() < 1e-8);
    let error = QUADRATURE.solve(&mut assur_problems::e1(), &request).unwrap_err().to_string();
    assert!(
        error.contains("needs J constant and M constant, M(t) or M(w)")
            && error.ends_with("case 2: J constant, M(q)"),
        "{error}"
    );
}

#[test]
fn the_nested_form_is_the_same_polynomial() {
    let power = [0.3, -1.1, 2.7, 0.4, -3.0, 1.9, 0.8, -0.6];
    let dense = Dense { time: 0.0, step: 1.0, coordinate: nested(power), speed: nested(power) };
    for x in [0.0, 0.1, 0.37, 0.5, 0.93, 1.0] {
        assert!((dense.at(x).coordinate - polynomial(&power, x)).abs() < 1e-14, "{x}");
    }
}
