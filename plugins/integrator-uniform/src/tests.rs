use std::f64::consts::SQRT_2;

use assur_integrator::{FixedStep, Request, State, Until};

use super::*;

fn request(until: Until, step: f64) -> Request {
    Request { fixed_step: Some(FixedStep::Time(step)), samples: 4, ..Request::new(State::default(), until) }
}

fn assert_close(found: f64, wanted: f64, allowed: f64) {
    assert!((found - wanted).abs() <= allowed, "{found} is not {wanted}: off by {:e}", found - wanted);
}

#[test]
fn d1_is_exact_at_any_step() {
    let initial = State { speed: 100.0, ..State::default() };
    for step in [0.3, 7.0, 200.0] {
        let request = Request { initial, ..request(Until::Turn, step) };
        let found = UNIFORM.solve(&mut assur_problems::d1(), &request).unwrap();
        assert_close(found.end.time, 50.0, 1e-10);
        assert_close(found.end.coordinate, 2500.0, 1e-8);
        assert_close(found.samples[1].coordinate, 100.0 * 12.5 - 12.5 * 12.5, 1e-9);
    }
}

#[test]
fn jumps_are_exact_because_each_piece_is_uniform() {
    let found = UNIFORM.solve(&mut assur_problems::jumps(), &request(Until::Coordinate(3.0), 0.4)).unwrap();
    assert_close(found.end.time, 3.0 - SQRT_2 + (10.0_f64.sqrt() - SQRT_2) / 4.0, 1e-12);
    assert_close(found.end.speed, 10.0_f64.sqrt(), 1e-12);
    assert_eq!(found.statistics.rejected, 0);
}

#[test]
fn without_a_step_it_takes_a_thousandth() {
    let request = Request::new(State::default(), Until::Time(2.0));
    let found = UNIFORM.solve(&mut assur_problems::e1(), &request).unwrap();
    assert!((999..=1001).contains(&found.statistics.steps), "{:?}", found.statistics);
}

/// Under a constant moment a step over the coordinate is exact, and there are as many steps as parts of the way.
#[test]
fn a_step_may_be_a_part_of_the_way() {
    let request = Request {
        fixed_step: Some(FixedStep::Coordinate(0.125)),
        ..Request::new(State { speed: 100.0, ..State::default() }, Until::Coordinate(100.0))
    };
    let found = UNIFORM.solve(&mut assur_problems::d1(), &request).unwrap();
    assert!((800..810).contains(&found.statistics.steps), "{:?}", found.statistics);
    assert_close(found.end.speed, (100.0_f64.powi(2) - 2.0 * 2.0 * 100.0).sqrt(), 1e-10);
}

#[test]
fn it_conforms() {
    assur_testkit::integrator_conformance("uniform");
}
