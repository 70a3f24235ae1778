//! Starts: from rest and nearly so, next to an unstable equilibrium, in a stable one.

use std::f64::consts::PI;

use assur_integrator::{State, Until};
use assur_problems::{BY_COORDINATE, CONSTANT};

use super::case::{Case, constant, walk};
use crate::stability::DISTANCES;

pub(super) fn cases() -> Vec<Case> {
    let speeds = || DISTANCES.into_iter().chain([0.0]);
    let mut all = walk(speeds().map(uniform));
    all.extend(walk(speeds().map(falling_moment)));
    all.extend(walk(DISTANCES.into_iter().map(upright)));
    all.extend(walk([0.0].into_iter().map(equilibrium)));
    all
}

/// J = 0.4, M = 0.8: w² = w0² + 4 q, and the time from the mean speed.
fn uniform(w0: f64) -> Case {
    let speed = (w0 * w0 + 4.0).sqrt();
    let end = State { time: 2.0 / (w0 + speed), coordinate: 1.0, speed };
    let case = Case::new("start with that speed, constant moment", w0, CONSTANT, |_, _| constant(0.4, 0.8));
    case.from(0.0, w0).to(Until::Coordinate(1.0), end)
}

/// A moment that falls linearly along the coordinate: q = e/r² (1 - cos r t) + w0/r sin r t.
fn falling_moment(w0: f64) -> Case {
    const RATE: f64 = 3.0;
    const START: f64 = 20.0;
    let time: f64 = 0.4;
    let (s, c) = (RATE * time).sin_cos();
    // 1 - cos without cancellation.
    let versed = 2.0 * (0.5 * RATE * time).sin().powi(2);
    let coordinate = START / (RATE * RATE) * versed + w0 / RATE * s;
    let end = State { time, coordinate, speed: START / RATE * s + w0 * c };
    let case =
        Case::new("start with that speed, moment falling along the way", w0, BY_COORDINATE, |_, at| {
            constant(0.1, 0.1 * (START - RATE * RATE * at.coordinate))
        });
    case.from(0.0, w0).to(Until::Time(time), end).growing(RATE, 1.0, 1.0)
}

/// A pendulum at rest so far from upright: to the bottom in K(cos(d/2)), by the arithmetic-geometric mean of 1 and sin(d/2).
fn upright(distance: f64) -> Case {
    /// What the f64 of pi leaves over.
    const REST: f64 = 1.224_646_799_147_353_2e-16;
    let from = PI - distance;
    let away = (PI - from) + REST;
    let (mut a, mut g) = (1.0, (0.5 * away).sin());
    for _ in 0..12 {
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    let end = State { time: 0.5 * PI / a, coordinate: 0.0, speed: -2.0 * (0.5 * away).cos() };
    let case = Case::new("rest so near to an unstable equilibrium", distance, BY_COORDINATE, |_, at| {
        constant(2.0, -2.0 * at.coordinate.sin())
    });
    // An error of the coordinate counts in parts of the distance: it grows as the motion itself does.
    case.from(from, 0.0).to(Until::Coordinate(0.0), end).growing(1.0, 1.0 / away, 1.0 / away)
}

/// The same hanging: nothing moves it.
fn equilibrium(_: f64) -> Case {
    let case = Case::new("rest in a stable equilibrium", 0.0, BY_COORDINATE, |_, at| {
        constant(2.0, -2.0 * at.coordinate.sin())
    });
    case.from(0.0, 0.0).stops(Until::Coordinate(1.0), (0.0, 1.0)).growing(1.0, 1.0, 1.0)
}
