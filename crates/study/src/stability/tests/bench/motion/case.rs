//! A motion with its end in closed form.

use assur_integrator::{Dependence, EquationOfMotion, Event, EventKind, Reduced, State, Until};
use assur_problems::{Example, Place};

use crate::stability::tests::Law;
use assur_number::greater as worst;

pub(in super::super) static LAW: Law = Law {
    section: "Motions",
    along: "what the walk says: speed, margin, slope, width, or turns",
    expected: "steps * tolerance (1e-10) for methods that have one; rate^(p+1) duration step^p for those of \
               a fixed step and order p (duration / 1000; nothing where the acceleration is constant); \
               nothing for the closed form; each grown by the equation; and 16 eps a step, over the \
               distance where it is the difference of two numbers",
};

/// What is known of the motion.
#[derive(Debug, Clone, Copy)]
pub(super) enum Wanted {
    /// Where it ends.
    End(State),
    /// Where it stops for good; whether that is to be reported as an error, since the motion should have gone on.
    Stop { coordinate: f64, refused: bool, is_end: bool },
}

/// A motion, and what is expected of it.
pub(crate) struct Case {
    pub(super) place: &'static str,
    pub(super) distance: f64,
    /// Whether it is the first of its walk.
    pub(super) is_first: bool,
    pub(super) motion: Box<dyn Fn() -> Box<dyn EquationOfMotion>>,
    pub(super) initial: State,
    pub(super) until: Until,
    pub(super) wanted: Wanted,
    /// How long it lasts, s.
    pub(super) duration: f64,
    /// How often the same way is gone, each time in as many fixed steps.
    pub(super) repeats: f64,
    /// Fastest rate at which the acceleration changes, 1/s.
    pub(super) rate: f64,
    /// By how much the equation grows an error over the motion.
    pub(super) growth: f64,
    /// By how much it grows a rounding.
    pub(super) rounding: f64,
    /// A method that is not made for such an equation may say so.
    pub(super) explicit_may_refuse: bool,
    pub(super) max_steps: usize,
}

impl Case {
    /// A motion from a state to an end, of constant acceleration; everything else can be changed.
    pub(super) fn new<F>(place: &'static str, distance: f64, dependence: Dependence, formula: F) -> Self
    where
        F: Fn(Place, &State) -> Reduced + Clone + 'static,
    {
        Self {
            place,
            distance,
            is_first: false,
            motion: Box::new(move || Box::new(Example::new(dependence, formula.clone()))),
            initial: State::default(),
            until: Until::Time(1.0),
            wanted: Wanted::End(State::default()),
            duration: 1.0,
            repeats: 1.0,
            rate: 0.0,
            growth: 1.0,
            rounding: 1.0,
            explicit_may_refuse: false,
            max_steps: 20_000,
        }
    }

    pub(super) fn from(mut self, coordinate: f64, speed: f64) -> Self {
        self.initial = State { time: 0.0, coordinate, speed };
        self
    }

    pub(super) fn to(mut self, until: Until, end: State) -> Self {
        (self.until, self.wanted, self.duration) = (until, Wanted::End(end), end.time);
        self
    }

    pub(super) fn stops(mut self, until: Until, (coordinate, duration): (f64, f64)) -> Self {
        let refused = matches!(until, Until::Coordinate(_));
        (self.until, self.duration) = (until, duration);
        self.wanted = Wanted::Stop { coordinate, refused, is_end: matches!(until, Until::Rest) };
        self
    }

    pub(super) fn growing(mut self, rate: f64, growth: f64, rounding: f64) -> Self {
        (self.rate, self.growth, self.rounding) = (rate, growth, rounding);
        self
    }
}

/// The first of a walk is marked.
pub(super) fn walk(cases: impl Iterator<Item = Case>) -> Vec<Case> {
    let mut cases: Vec<Case> = cases.collect();
    if let Some(first) = cases.first_mut() {
        first.is_first = true;
    }
    cases
}

pub(super) fn constant(inertia: f64, moment: f64) -> Reduced {
    Reduced { inertia, inertia_derivative: 0.0, moment }
}

impl Wanted {
    pub(super) fn quantity(&self) -> &'static str {
        match self {
            Self::End(_) => "end",
            Self::Stop { refused: true, .. } => "place of the refusal",
            Self::Stop { .. } => "place of the stop",
        }
    }

    /// Largest deviation, in parts of time, way and speed.
    pub(super) fn apart(&self, found: &State, events: &[Event]) -> f64 {
        match *self {
            Self::End(end) => {
                let of = |found: f64, wanted: f64| (found - wanted).abs() / wanted.abs().max(1.0);
                let speed = (found.speed - end.speed).abs() / end.speed.abs().max(f64::MIN_POSITIVE);
                worst(worst(of(found.time, end.time), of(found.coordinate, end.coordinate)), speed)
            }
            Self::Stop { coordinate, refused, is_end } => {
                let rests = is_end || events.iter().any(|event| event.kind == EventKind::Rest);
                let apart = (found.coordinate - coordinate).abs() / coordinate.abs().max(1.0);
                if refused || rests { worst(apart, found.speed.abs()) } else { f64::INFINITY }
            }
        }
    }
}
