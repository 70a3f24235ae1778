//! Stops: a reversal, a motor that its load stalls, dry friction.

use std::f64::consts::PI;

use assur_integrator::{Dependence, State, Until};
use assur_problems::{BY_COORDINATE, CONSTANT, Example, friction_oscillator};

use super::case::{Case, constant, walk};
use crate::stability::DISTANCES;

pub(super) fn cases() -> Vec<Case> {
    let mut all = walk(DISTANCES.into_iter().map(reversal));
    all.extend(walk(DISTANCES.into_iter().map(|margin| stall(margin, Until::Rest))));
    all.extend(walk(DISTANCES.into_iter().map(|margin| stall(margin, Until::Time(1e3)))));
    all.extend(walk(DISTANCES.into_iter().map(|margin| stall(margin, Until::Coordinate(2.0)))));
    all.extend(walk([0.3].into_iter().map(friction)));
    all
}

/// Against the motion with e = -2: turns after w0/2 and comes to -1 with w² = w0² + 4.
fn reversal(w0: f64) -> Case {
    let speed = (w0 * w0 + 4.0).sqrt();
    let end = State { time: 0.5 * (w0 + speed), coordinate: -1.0, speed: -speed };
    let case = Case::new("reversal from that speed", w0, CONSTANT, |_, _| constant(0.4, -0.8));
    case.from(0.0, w0).to(Until::Coordinate(-1.0), end)
}

/// A motor 1 - w against dry friction 1 + a: w = (1 + a) exp(-t) - a stops at t = ln(1 + 1/a), q = 1 - a t.
fn stall(margin: f64, until: Until) -> Case {
    let load = 1.0 + margin;
    let a = load - 1.0;
    let time = (1.0 / a).ln_1p();
    let place = match until {
        Until::Turn | Until::Rest => "motor stalled by a load so much greater, to its rest",
        Until::Time(_) => "motor stalled by a load so much greater, and after",
        Until::Coordinate(_) => "motor stalled by a load so much greater, before the end wanted",
    };
    let dependence = Dependence { moment_on_speed: true, ..CONSTANT };
    let formula = move |at: assur_problems::Place, state: &State| {
        constant(1.0, (1.0 - state.speed) - load * at.direction)
    };
    let mut case = Case::new(place, margin, dependence, formula);
    case.motion = Box::new(move || Box::new(Example::new(dependence, formula).directed()));
    // The place is hardly moved by an error of the speed, the time by error/a.
    let case = case.from(0.0, 1.0).stops(until, (1.0 - a * time, time)).growing(1.0, 1.0, 1.0 / a);
    if matches!(until, Until::Rest) { case } else { Case { duration: time.max(1.0), ..case } }
}

/// A spring against dry friction: two swings, and held at -0.2 after 2 pi.
fn friction(distance: f64) -> Case {
    let mut case =
        Case::new("spring and dry friction, two swings", distance, BY_COORDINATE, |_, _| constant(1.0, 0.0));
    case.motion = Box::new(|| Box::new(friction_oscillator()));
    case.from(1.0, 0.0).stops(Until::Time(10.0), (-0.2, 2.0 * PI)).growing(1.0, 1.0, 1.0)
}
