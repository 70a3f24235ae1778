//! Equally spaced samples from the panels that were passed.

use assur_integrator::{IntegrationError, Sample, State};

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

    fn end(&self) -> f64 {
        match self {
            Self::Moving { end, .. } | Self::Rest(_, end) => *end,
        }
    }

    /// Direction of motion; 0 at rest.
    pub(crate) fn direction(&self) -> f64 {
        match self {
            Self::Moving { panel, .. } => panel.length.signum(),
            Self::Rest(..) => 0.0,
        }
    }

    /// State at a time.
    pub(crate) fn at(&self, time: f64) -> State {
        match self {
            Self::Moving { panel, clock, .. } => {
                let (x, energy) = clock.at(time);
                State { time, coordinate: panel.coordinate(x), speed: panel.speed(x, energy) }
            }
            Self::Rest(state, _) => State { time, ..*state },
        }
    }

    /// A state well inside, to choose the piece by.
    fn middle(&self) -> State {
        match self {
            Self::Moving { begin, end, .. } => self.at(0.5 * (begin + end)),
            Self::Rest(state, _) => *state,
        }
    }
}

impl March<'_> {
    pub(crate) fn sample_here(&self) -> Sample {
        let State { time, coordinate, speed } = self.state;
        Sample { time, coordinate, speed, acceleration: self.acceleration }
    }

    pub(crate) fn samples(&mut self, first: Sample) -> Result<Vec<Sample>, IntegrationError> {
        let count = self.request.samples;
        let mut samples = Vec::with_capacity(count + 1);
        samples.push(first);
        let parts = std::mem::take(&mut self.parts);
        let (mut index, mut entered) = (0, None);
        for k in 1..count {
            let time = first.time + (self.state.time - first.time) * (k as f64 / count as f64);
            while index + 1 < parts.len() && parts[index].end() < time {
                index += 1;
            }
            let Some(part) = parts.get(index) else { break };
            let failed = |state| move |source| IntegrationError::Equation { at: state, source };
            let state = part.at(time);
            let moving = matches!(part, Part::Moving { .. });
            if moving && entered != Some(index) {
                let middle = part.middle();
                self.equation.enter(&middle).map_err(failed(middle))?;
                entered = Some(index);
            }
            let State { time, coordinate, speed } = state;
            let acceleration = if moving {
                self.equation.acceleration(time, coordinate, speed).map_err(failed(state))?
            } else {
                0.0
            };
            samples.push(Sample { time, coordinate, speed, acceleration });
        }
        samples.resize(count, self.sample_here());
        samples.push(self.sample_here());
        Ok(samples)
    }
}
