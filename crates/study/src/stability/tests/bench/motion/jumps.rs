//! Jumps in loads: rows of a table, a narrow pulse, a load that comes later.

use assur_integrator::{Dependence, EquationOfMotion, MotionError, Piece, Reduced, State, Until};
use assur_problems::{BY_COORDINATE, CONSTANT, Example, jumps};

use super::case::{Case, constant, walk};
use crate::stability::DISTANCES;

pub(super) fn cases() -> Vec<Case> {
    let mut all = walk([1.0].into_iter().map(rows));
    all.extend(walk(DISTANCES.into_iter().map(pulse)));
    all.extend(walk(DISTANCES.into_iter().map(later)));
    all
}

/// As the problem says: passes q = 2 at 3 - sqrt 2 with w² = 2, and q = 3 after (sqrt 10 - sqrt 2)/4 more.
fn rows(distance: f64) -> Case {
    let time = 3.0 - 2.0_f64.sqrt() + 0.25 * (10.0_f64.sqrt() - 2.0_f64.sqrt());
    let end = State { time, coordinate: 3.0, speed: 10.0_f64.sqrt() };
    let mut case = Case::new("moment that jumps twice", distance, BY_COORDINATE, |_, _| constant(1.0, 0.0));
    case.motion = Box::new(|| Box::new(jumps()));
    case.from(0.0, 0.0).to(Until::Coordinate(3.0), end)
}

/// From q = -1 with w = 1 through a moment 1/d between 0 and d, which makes w² = 3: a method that steps over it is wrong.
fn pulse(width: f64) -> Case {
    let after = 3.0_f64.sqrt();
    let time = 1.0 + 2.0 * width / (1.0 + after) + (1.0 - width) / after;
    let end = State { time, coordinate: 1.0, speed: after };
    let formula = move |at: assur_problems::Place, _: &State| {
        constant(1.0, if at.segment == 1 { 1.0 / width } else { 0.0 })
    };
    let mut case = Case::new("moment in a pulse of that width", width, BY_COORDINATE, formula);
    case.motion =
        Box::new(move || Box::new(Example::new(BY_COORDINATE, formula).with_breaks(vec![0.0, width])));
    // The way through the pulse is the difference of two coordinates, its time of two times.
    case.from(-1.0, 1.0).to(Until::Coordinate(1.0), end).growing(0.0, 1.0, 1.0 / width)
}

/// At rest until a moment 1 comes after that time, then q = (t - d)²/2.
fn later(start: f64) -> Case {
    let way = 1.0 - start;
    let end = State { time: 1.0, coordinate: 0.5 * way * way, speed: way };
    let dependence = Dependence { moment_on_time: true, ..CONSTANT };
    let mut case =
        Case::new("rest until a moment comes at that time", start, dependence, |_, _| constant(1.0, 0.0));
    case.motion = Box::new(move || Box::new(Later { start, acts: false }));
    case.from(0.0, 0.0).to(Until::Time(1.0), end)
}

/// A moment 1 from an instant on.
#[derive(Debug)]
struct Later {
    start: f64,
    acts: bool,
}

impl EquationOfMotion for Later {
    fn dependence(&self) -> Dependence {
        Dependence { moment_on_time: true, ..CONSTANT }
    }

    fn enter(&mut self, state: &State) -> Result<Piece, MotionError> {
        self.acts = state.time >= self.start;
        let time = if self.acts { [self.start, f64::INFINITY] } else { [f64::NEG_INFINITY, self.start] };
        Ok(Piece { time, ..Piece::UNBOUNDED })
    }

    fn reduced(&mut self, _: &State) -> Result<Reduced, MotionError> {
        Ok(constant(1.0, if self.acts { 1.0 } else { 0.0 }))
    }
}
