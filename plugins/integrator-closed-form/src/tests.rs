use assur_integrator::{EventKind, Request, State, Until};

use super::*;

fn assert_close(found: f64, wanted: f64, allowed: f64) {
    assert!((found - wanted).abs() <= allowed, "{found} is not {wanted}: off by {:e}", found - wanted);
}

const BRAKED: State = State { time: 0.0, coordinate: 0.0, speed: 100.0 };

#[test]
fn d1_takes_one_step() {
    let found = CLOSED_FORM.solve(&mut assur_problems::d1(), &Request::new(BRAKED, Until::Turn)).unwrap();
    assert_close(found.end.time, 50.0, 0.0);
    assert_close(found.end.coordinate, 2500.0, 0.0);
    assert_eq!((found.statistics.steps, found.statistics.rejected), (1, 0));
    for (index, sample) in found.samples.iter().enumerate() {
        let t = 0.5 * index as f64;
        assert_close(sample.coordinate, 100.0 * t - t * t, 1e-10);
        assert_close(sample.acceleration, -2.0, 1e-15);
    }
}

#[test]
fn friction_rests_for_good_and_a_moment_reverses() {
    let request = Request::new(BRAKED, Until::Time(60.0));
    let found = CLOSED_FORM.solve(&mut assur_problems::d1_friction(), &request).unwrap();
    assert_eq!(found.events.iter().map(|event| event.kind).collect::<Vec<_>>(), [EventKind::Rest]);
    assert_close(found.end.coordinate, 2500.0, 0.0);
    assert_close(found.end.time, 60.0, 0.0);
    let found = CLOSED_FORM.solve(&mut assur_problems::d1(), &request).unwrap();
    assert_eq!(found.events.iter().map(|event| event.kind).collect::<Vec<_>>(), [EventKind::Reversal]);
    assert_close(found.end.coordinate, 2400.0, 1e-9);
}

#[test]
fn what_never_comes_is_an_error() {
    let request = Request::new(BRAKED, Until::Coordinate(2501.0));
    let error = CLOSED_FORM.solve(&mut assur_problems::d1(), &request).unwrap_err().to_string();
    assert!(error.starts_with("coordinate 2501 is never reached"), "{error}");
    let error = CLOSED_FORM.solve(&mut assur_problems::e1(), &request).unwrap_err().to_string();
    assert_eq!(
        error,
        "integrator `closed-form` does not support this equation: the closed form needs J and M constant (case 1 of D), \
         and here it is case 2: J constant, M(q)"
    );
}

#[test]
fn both_conform() {
    for name in ["closed-form", "quadrature"] {
        assur_testkit::integrator_conformance(name);
    }
}
