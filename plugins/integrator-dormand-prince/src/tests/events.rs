//! Jumps, reversals, rest, held speeds.

use std::f64::consts::{PI, SQRT_2};

use assur_integrator::{EquationOfMotion, EventKind, MotionError, Piece, Reduced, Trajectory};

use super::*;

fn kinds(found: &Trajectory) -> Vec<EventKind> {
    found.events.iter().map(|event| event.kind).collect()
}

#[test]
fn jumps_are_stepped_onto() {
    for method in METHODS {
        let found =
            method.solve(&mut assur_problems::jumps(), &from_rest(Until::Coordinate(3.0), 1e-10)).unwrap();
        let end = 3.0 - SQRT_2 + (10.0_f64.sqrt() - SQRT_2) / 4.0;
        assert_close(found.end.time, end, 1e-10);
        assert_close(found.end.speed, 10.0_f64.sqrt(), 1e-10);
        assert_eq!(kinds(&found), [EventKind::Coordinate; 2]);
        assert_close(found.events[0].state.coordinate, 1.0, 0.0);
        assert_close(found.events[0].state.speed, 2.0, 1e-10);
        assert_close(found.events[1].state.time, 3.0 - SQRT_2, 1e-10);
        assert!(found.statistics.rejected <= 4, "{:?}", found.statistics);
        assert!(found.statistics.evaluations < 300, "{:?}", found.statistics);
    }
}

#[test]
fn samples_between_jumps_lie_on_the_parabolas() {
    let request = Request { samples: 30, ..from_rest(Until::Time(1.5), 1e-10) };
    for method in METHODS {
        let found = method.solve(&mut assur_problems::jumps(), &request).unwrap();
        for sample in found.samples {
            let t = sample.time;
            let wanted = if t < 1.0 { t * t } else { 1.0 + 2.0 * (t - 1.0) - 0.5 * (t - 1.0).powi(2) };
            assert_close(sample.coordinate, wanted, 1e-10);
        }
    }
}

#[test]
fn dry_friction_holds_at_last() {
    let initial = State { coordinate: 1.0, ..State::default() };
    for method in METHODS {
        let request = Request { tolerance: 1e-10, ..Request::new(initial, Until::Time(10.0)) };
        let found = method.solve(&mut assur_problems::friction_oscillator(), &request).unwrap();
        assert_eq!(kinds(&found), [EventKind::Reversal, EventKind::Rest]);
        assert_close(found.events[0].state.time, PI, 1e-9);
        assert_close(found.events[0].state.coordinate, -0.4, 1e-9);
        assert_close(found.events[1].state.time, 2.0 * PI, 1e-9);
        assert_close(found.end.coordinate, -0.2, 1e-9);
        assert_eq!(found.samples.last().map(|s| (s.time, s.speed, s.acceleration)), Some((10.0, 0.0, 0.0)));
    }
}

#[test]
fn a_reversal_without_a_jump_is_an_event() {
    let initial = State { coordinate: 2.0, ..State::default() };
    let period = assur_problems::pendulum_period(2.0);
    for method in METHODS {
        let request = Request { tolerance: 1e-10, ..Request::new(initial, Until::Time(1.2 * period)) };
        let found = method.solve(&mut assur_problems::pendulum(), &request).unwrap();
        assert_eq!(kinds(&found), [EventKind::Reversal; 2]);
        assert_close(found.events[0].state.time, 0.5 * period, 1e-8);
        assert_close(found.events[1].state.time, period, 1e-8);
    }
}

#[test]
fn an_excursion_beyond_a_jump_inside_a_step_is_seen() {
    // Thrown up to q = 1.01, with a jump at q = 1: w0²/2 = 1, deceleration 1; above q = 1 it is 2.
    let top = 1.01;
    let w0 = (2.0_f64 * 1.0 + 2.0 * 2.0 * (top - 1.0)).sqrt();
    let mut motion = Example::new(assur_problems::BY_COORDINATE, |place, _| Reduced {
        inertia: 1.0,
        inertia_derivative: 0.0,
        moment: if place.segment == 0 { -1.0 } else { -2.0 },
    })
    .with_breaks(vec![1.0]);
    for method in METHODS {
        let initial = State { speed: w0, ..State::default() };
        let request = Request { tolerance: 1e-9, ..Request::new(initial, Until::Turn) };
        let found = method.solve(&mut motion, &request).unwrap();
        assert_close(found.end.coordinate, top, 1e-9);
    }
}

/// Friction of 1 on a mass of 1, pulled by a moment that grows with time: it starts at t = 2.
#[test]
fn a_growing_moment_releases_a_held_mechanism() {
    let dependence = Dependence { moment_on_time: true, ..assur_problems::CONSTANT };
    for method in METHODS {
        let mut motion = Example::new(dependence, |place, at| Reduced {
            inertia: 1.0,
            inertia_derivative: 0.0,
            moment: 0.5 * at.time - place.direction,
        })
        .directed();
        let found = method.solve(&mut motion, &from_rest(Until::Time(3.0), 1e-10)).unwrap();
        assert_eq!(kinds(&found), [EventKind::Rest, EventKind::Release]);
        assert_close(found.events[1].state.time, 2.0, 1e-12);
        // w = (t-2)²/4, q = (t-2)³/12.
        assert_close(found.end.speed, 0.25, 1e-10);
        assert_close(found.end.coordinate, 1.0 / 12.0, 1e-10);
    }
}

/// A moment of +1 below the speed 2 and -1 above it, as a governor.
struct Governor {
    above: bool,
}

impl EquationOfMotion for Governor {
    fn dependence(&self) -> Dependence {
        Dependence { moment_on_speed: true, ..assur_problems::CONSTANT }
    }

    fn enter(&mut self, state: &State) -> Result<Piece, MotionError> {
        self.above = state.speed > 2.0;
        let speed = if self.above { [2.0, f64::INFINITY] } else { [f64::NEG_INFINITY, 2.0] };
        Ok(Piece { speed, ..Piece::UNBOUNDED })
    }

    fn reduced(&mut self, _: &State) -> Result<Reduced, MotionError> {
        Ok(Reduced { inertia: 1.0, inertia_derivative: 0.0, moment: if self.above { -1.0 } else { 1.0 } })
    }
}

#[test]
fn a_jump_over_speed_holds_the_speed() {
    for method in METHODS {
        let found =
            method.solve(&mut Governor { above: false }, &from_rest(Until::Coordinate(6.0), 1e-9)).unwrap();
        // q = 2 at t = 2 with w = 2, then 4 more at speed 2.
        assert_eq!(kinds(&found), [EventKind::Speed, EventKind::Held]);
        assert_close(found.end.time, 4.0, 1e-10);
        assert_close(found.end.speed, 2.0, 0.0);
        assert_close(found.end.coordinate, 6.0, 1e-12);
    }
}

/// A moment that jumps from 1 to -3 at t = 1 on a mass of 1.
struct Switched {
    late: bool,
}

impl EquationOfMotion for Switched {
    fn dependence(&self) -> Dependence {
        Dependence { moment_on_time: true, ..assur_problems::CONSTANT }
    }

    fn enter(&mut self, state: &State) -> Result<Piece, MotionError> {
        self.late = state.time >= 1.0;
        let time = if self.late { [1.0, f64::INFINITY] } else { [0.0, 1.0] };
        Ok(Piece { time, ..Piece::UNBOUNDED })
    }

    fn reduced(&mut self, _: &State) -> Result<Reduced, MotionError> {
        Ok(Reduced { inertia: 1.0, inertia_derivative: 0.0, moment: if self.late { -3.0 } else { 1.0 } })
    }
}

#[test]
fn a_jump_in_time_is_met_exactly() {
    for method in METHODS {
        let found = method.solve(&mut Switched { late: false }, &from_rest(Until::Time(2.0), 1e-10)).unwrap();
        assert_eq!(kinds(&found), [EventKind::Time, EventKind::Reversal]);
        assert_close(found.events[0].state.time, 1.0, 0.0);
        assert_close(found.events[1].state.time, 4.0 / 3.0, 1e-12);
        assert_close(found.end.speed, -2.0, 1e-12);
    }
}

#[test]
fn a_coordinate_behind_is_reached_too() {
    for method in METHODS {
        let initial = State { speed: 1.0, ..State::default() };
        let request = Request::new(initial, Until::Coordinate(-1.5));
        let found = method.solve(&mut assur_problems::d1(), &request).unwrap();
        // -2 t²/2 + t = -1.5
        assert_close(found.end.time, 0.5 * (1.0 + 7.0_f64.sqrt()), 1e-9);
        assert_close(found.end.coordinate, -1.5, 0.0);
    }
}

/// An end by coordinate without inner samples needs no dense output: stages and one slope a step, and no more.
#[test]
fn one_sample_costs_no_dense_output() {
    let until = Until::Coordinate(2.0 * PI);
    let initial = State { speed: 3.0, ..State::default() };
    let cost = |samples| {
        let request = Request { samples, tolerance: 1e-9, ..Request::new(initial, until) };
        DOP853.solve(&mut assur_problems::coasting(), &request).unwrap().statistics
    };
    let (one, two) = (cost(1), cost(2));
    assert_eq!(one.steps, two.steps);
    // Three stages in every step but the last, which needs them to meet the end; and the sample itself.
    assert!(two.evaluations >= one.evaluations + 3 * (one.steps - 2), "{one:?} {two:?}");
}

/// A motion that stops without end is no rest, whatever the errors of the steps: w' = -3 w, and a link that runs to infinity
/// while the input stands still, J = 1/(1 - q)².
#[test]
fn a_speed_that_decays_without_end_is_no_rest() {
    let dependence = Dependence { moment_on_speed: true, ..assur_problems::VARIABLE };
    let initial = State { speed: 1.0, ..State::default() };
    let decays = |_, at: &State| Reduced { inertia: 1.0, inertia_derivative: 0.0, moment: -3.0 * at.speed };
    let runs_away = |_, at: &State| {
        let left = 1.0 - at.coordinate;
        Reduced { inertia: left.powi(-2), inertia_derivative: 2.0 * left.powi(-3), moment: 0.0 }
    };
    for method in METHODS {
        for until in [Until::Turn, Until::Rest, Until::Coordinate(1.0)] {
            let request = Request { tolerance: 1e-8, ..Request::new(initial, until) };
            let error =
                method.solve(&mut Example::new(dependence, decays), &request).unwrap_err().to_string();
            assert!(error.ends_with("creeps to rest without end"), "{until:?}: {error}");
            let error =
                method.solve(&mut Example::new(dependence, runs_away), &request).unwrap_err().to_string();
            // Where J has its pole, rounding decides whether the motion creeps up to it or is thrown beyond.
            assert!(error.ends_with("without end"), "{until:?}: {error}");
        }
    }
}

/// A sample on a jump has the acceleration after it; the last sample the one before.
#[test]
fn a_sample_on_a_jump_is_of_the_side_after() {
    for method in METHODS {
        let request = Request { samples: 4, ..from_rest(Until::Time(2.0), 1e-9) };
        let found = method.solve(&mut Switched { late: false }, &request).unwrap();
        let accelerations: Vec<f64> = found.samples.iter().map(|sample| sample.acceleration).collect();
        assert_eq!(accelerations, [1.0, 1.0, -3.0, -3.0, -3.0]);
        let until_jump = Request { samples: 4, ..from_rest(Until::Time(1.0), 1e-9) };
        let found = method.solve(&mut Switched { late: false }, &until_jump).unwrap();
        assert_close(found.samples.last().unwrap().acceleration, 1.0, 0.0);
    }
}
