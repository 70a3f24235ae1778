//! Known answers, and the order seen by halving the tolerance's step.

use std::f64::consts::PI;

use assur_integrator::{
    CountedEquation, EquationOfMotion, Node, Request, Scale, State, Step, Stepper, Until,
};
use proptest::prelude::*;

use super::{METHODS, assert_close, from_rest};
use crate::dop853::Dop853;
use crate::dopri5::Dopri5;
use crate::{DOP853, DOPRI5};

#[test]
fn e1_reaches_its_speed_after_five_turns() {
    for method in METHODS {
        let request = from_rest(Until::Coordinate(10.0 * PI), 1e-10);
        let found = method.solve(&mut assur_problems::e1(), &request).unwrap();
        assert_close(found.end.speed, (1000.0 * PI).sqrt(), 1e-9 * 56.0);
        assert_close(found.end.coordinate, 10.0 * PI, 0.0);
    }
}

#[test]
fn d1_stops_after_fifty_seconds() {
    let initial = State { speed: 100.0, ..State::default() };
    for method in METHODS {
        let found = method.solve(&mut assur_problems::d1(), &Request::new(initial, Until::Turn)).unwrap();
        assert_close(found.end.time, 50.0, 1e-12);
        assert_close(found.end.coordinate, 2500.0, 1e-10);
        assert_close(found.end.speed, 0.0, 0.0);
        assert_eq!(found.samples.len(), 101);
        assert_close(found.samples[50].speed, 50.0, 1e-10);
    }
}

#[test]
fn pendulum_returns_after_its_period() {
    let initial = State { coordinate: 2.0, ..State::default() };
    let period = assur_problems::pendulum_period(2.0);
    for method in METHODS {
        for tolerance in [1e-4, 1e-6, 1e-8, 1e-10] {
            let request = Request { tolerance, samples: 2, ..Request::new(initial, Until::Time(period)) };
            let found = method.solve(&mut assur_problems::pendulum(), &request).unwrap();
            // Relative to the travel of 4 rad and the largest speed of 2 sin 1: what users see.
            assert_close(found.end.coordinate, 2.0, 10.0 * tolerance * 4.0);
            assert_close(found.end.speed, 0.0, 10.0 * tolerance * 1.68);
            assert_close(found.samples[1].coordinate, -2.0, 10.0 * tolerance * 4.0);
        }
    }
}

/// Error of one step of length h from a state of the pendulum, against a finer solution, at the end and inside.
fn step_errors<S: Stepper>(h: f64) -> [f64; 2] {
    let start = State { time: 0.0, coordinate: 1.0, speed: 0.5 };
    let exact = |time: f64| {
        let request = Request { tolerance: 1e-14, samples: 1, ..Request::new(start, Until::Time(time)) };
        DOP853.solve(&mut assur_problems::pendulum(), &request).unwrap().end
    };
    let mut stepper = S::default();
    let mut motion = assur_problems::pendulum();
    motion.enter(&start).unwrap();
    let mut equation = CountedEquation::new(&mut motion);
    let from = Node { state: start, acceleration: -1.0_f64.sin() };
    let scale = Scale::new(1e-3, &start);
    let end = stepper.attempt(Step { equation: &mut equation, from, length: h, scale }).unwrap().end;
    let acceleration = stepper.finish(&mut equation, &end).unwrap();
    let to = Node { state: end, acceleration };
    let inside = stepper.dense(&mut equation, &from, &to).unwrap().at(0.4);
    let off = |found: State| (found.speed - exact(found.time).speed).abs();
    [off(end), off(inside)]
}

#[test]
fn errors_of_a_step_fall_with_the_order() {
    let (long, short) = (step_errors::<Dopri5>(0.4), step_errors::<Dopri5>(0.2));
    let order = |i: usize| (long[i] / short[i]).log2();
    assert!(order(0) > 5.5 && order(1) > 4.5, "{} {}", order(0), order(1));
    let (long, short) = (step_errors::<Dop853>(1.6), step_errors::<Dop853>(0.8));
    let order = |i: usize| (long[i] / short[i]).log2();
    assert!(order(0) > 8.0 && order(1) > 7.0, "{} {}", order(0), order(1));
}

#[test]
fn kinetic_energy_is_kept_with_variable_inertia() {
    let initial = State { speed: 3.0, ..State::default() };
    for method in METHODS {
        let request = Request { tolerance: 1e-11, ..Request::new(initial, Until::Time(10.0)) };
        let found = method.solve(&mut assur_problems::coasting(), &request).unwrap();
        for sample in found.samples {
            let energy = (2.0 + sample.coordinate.cos()) * sample.speed * sample.speed;
            assert_close(energy, 27.0, 27.0 * 1e-9);
        }
    }
}

#[test]
fn andrews_mechanism_reaches_the_published_end() {
    use assur_problems::Andrews;
    let request = Request { tolerance: 1e-8, samples: 4, ..Request::new(Andrews::START, Until::Time(0.03)) };
    let found = DOP853.solve(&mut Andrews, &request).unwrap();
    assert_close(found.end.coordinate, Andrews::END.coordinate, 1e-7 * 15.8);
    assert_close(found.end.speed, Andrews::END.speed, 1e-7 * 1140.0);
    assert!(found.statistics.evaluations < 1000, "{:?}", found.statistics);
    assert!(found.statistics.rejected * 4 < found.statistics.steps, "{:?}", found.statistics);
}

#[test]
fn samples_satisfy_the_equation_at_equal_times() {
    let initial = State { coordinate: 1.0, ..State::default() };
    for method in METHODS {
        let found =
            method.solve(&mut assur_problems::pendulum(), &Request::new(initial, Until::Time(7.0))).unwrap();
        assert_eq!(found.samples.len(), 101);
        for (index, sample) in found.samples.iter().enumerate() {
            assert_close(sample.time, 0.07 * index as f64, 1e-14);
            assert_close(sample.acceleration, -sample.coordinate.sin(), 1e-15);
            // ENERGY of the sample: w²/2 - cos q.
            let energy = 0.5 * sample.speed * sample.speed - sample.coordinate.cos();
            assert_close(energy, -1.0_f64.cos(), 1e-7);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn both_methods_agree(q in -3.0..3.0_f64, w in -3.0..3.0_f64, end in 0.1..20.0_f64) {
        let initial = State { time: 0.0, coordinate: q, speed: w };
        let request = Request { tolerance: 1e-10, samples: 3, ..Request::new(initial, Until::Time(end)) };
        let five = DOPRI5.solve(&mut assur_problems::coasting(), &request).unwrap();
        let eight = DOP853.solve(&mut assur_problems::coasting(), &request).unwrap();
        for (a, b) in five.samples.iter().zip(&eight.samples) {
            prop_assert!((a.coordinate - b.coordinate).abs() < 1e-7, "{a:?} {b:?}");
            prop_assert!((a.speed - b.speed).abs() < 1e-7, "{a:?} {b:?}");
        }
    }
}
