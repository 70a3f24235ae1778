//! Steep motors, and many turns.

use std::f64::consts::TAU;

use assur_integrator::{Dependence, State, Until};
use assur_problems::{CONSTANT, coasting};

use super::case::{Case, constant, walk};
use crate::stability::DISTANCES;

pub(super) fn cases(most_turns: f64) -> Vec<Case> {
    let mut all = walk(DISTANCES.into_iter().map(steep));
    let counts = [1.0, 10.0, 100.0, 1000.0, 10_000.0].into_iter().filter(|count| *count <= most_turns);
    all.extend(walk(counts.map(turns)));
    all
}

/// w' = (10 - w)/d - 2 from rest: w = W (1 - exp(-t/d)) with W = 10 - 2 d, q = W (t - d (1 - exp(-t/d))).
fn steep(distance: f64) -> Case {
    let (most, rate) = (10.0 - 2.0 * distance, 1.0 / distance);
    let lost = -(-rate).exp_m1();
    let end = State { time: 1.0, coordinate: most * (1.0 - distance * lost), speed: most * lost };
    let dependence = Dependence { moment_on_speed: true, ..CONSTANT };
    let case = Case::new(
        "motor of that speed lost for a unit of load, from rest",
        distance,
        dependence,
        move |_, at| constant(1.0, rate * (10.0 - at.speed) - 2.0),
    );
    let case = case.from(0.0, 0.0).to(Until::Time(1.0), end).growing(rate, 1.0, 1.0);
    Case { explicit_may_refuse: true, max_steps: 5_000, ..case }
}

/// J = 2 + cos q without a moment, from w = 1 at q = 0: T is kept, so that each turn takes the integral of sqrt(J/3), which the
/// rule of equal parts gives to the last digit.
fn turns(turns: f64) -> Case {
    const PARTS: u32 = 64;
    let part = |i: u32| ((2.0 + (TAU * f64::from(i) / f64::from(PARTS)).cos()) / 3.0).sqrt();
    let turn = TAU / f64::from(PARTS) * (0..PARTS).map(part).sum::<f64>();
    let end = State { time: turns * turn, coordinate: turns * TAU, speed: 1.0 };
    let mut case = Case::new("coasting so many turns, J(q)", turns, CONSTANT, |_, _| constant(1.0, 0.0));
    case.motion = Box::new(|| Box::new(coasting()));
    // An error of the energy counts for the rest of the way: of the time it grows with it.
    let case = case.from(0.0, 1.0).to(Until::Coordinate(turns * TAU), end).growing(1.0, 1.0, 1.0);
    Case { repeats: turns, explicit_may_refuse: true, max_steps: 10_000_000, ..case }
}
