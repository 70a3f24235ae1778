//! Stretches of the motion: the panels that were passed, and rests.

use assur_integrator::{Sample, State, Stretch};

use crate::clock::Clock;
use crate::march::March;
use crate::panel::Panel;

/// A stretch of the motion.
#[derive(Debug, Clone)]
pub(crate) enum Part {
    /// Through a panel.
    Moving {
        /// Its polynomials; boxed, since a rest needs none.
        panel: Box<Panel>,
        /// Its times.
        clock: Clock,
        /// Time at its start, s.
        begin: f64,
        /// Time at its end, s.
        end: f64,
    },
    /// At rest from this state on, up to a time, s.
    Rest(State, f64),
}

impl Part {
    pub(crate) fn moving(panel: &Panel, clock: Clock, begin: f64, end: f64) -> Self {
        Self::Moving { panel: Box::new(*panel), clock, begin, end }
    }

    pub(crate) fn rest(state: State, end: f64) -> Self {
        Self::Rest(state, end)
    }

    /// Direction of motion; 0 at rest.
    pub(crate) fn direction(&self) -> f64 {
        match self {
            Self::Moving { panel, .. } => panel.length.signum(),
            Self::Rest(..) => 0.0,
        }
    }
}

impl Stretch for Part {
    fn end(&self) -> f64 {
        match self {
            Self::Moving { end, .. } | Self::Rest(_, end) => *end,
        }
    }

    fn at(&self, time: f64) -> State {
        match self {
            Self::Moving { panel, clock, .. } => {
                let (x, energy) = clock.at(time);
                State { time, coordinate: panel.coordinate(x), speed: panel.speed(x, energy) }
            }
            Self::Rest(state, _) => State { time, ..*state },
        }
    }

    fn middle(&self) -> Option<State> {
        match self {
            Self::Moving { begin, end, .. } => Some(self.at(0.5 * (begin + end))),
            Self::Rest(..) => None,
        }
    }
}

impl March<'_> {
    pub(crate) fn sample_here(&self) -> Sample {
        let State { time, coordinate, speed } = self.state;
        Sample { time, coordinate, speed, acceleration: self.acceleration }
    }
}
