//! Equally spaced samples: at once where the end is known, from stored polynomials where it is not.

use crate::{Dense, Equation, IntegrationError, Node, Request, Sample, State, Until};

/// Part of the motion for which a polynomial holds.
#[derive(Debug, Clone, Copy)]
struct Part {
    dense: Dense,
    /// Time to which it holds, s.
    until: f64,
    /// The speed is held: the acceleration is zero, whatever the equation says.
    held: bool,
}

#[derive(Debug)]
pub(crate) struct Recorder {
    start: f64,
    end: Option<f64>,
    count: usize,
    samples: Vec<Sample>,
    parts: Vec<Part>,
}

fn sample(state: &State, acceleration: f64) -> Sample {
    Sample { time: state.time, coordinate: state.coordinate, speed: state.speed, acceleration }
}

impl Recorder {
    pub(crate) fn new(request: &Request) -> Self {
        let end = match request.until {
            Until::Time(end) => Some(end),
            Until::Coordinate(_) | Until::Rest => None,
        };
        Self {
            start: request.initial.time,
            end,
            count: request.samples,
            samples: Vec::with_capacity(request.samples + 1),
            parts: Vec::with_capacity(if end.is_none() { 256 } else { 0 }),
        }
    }

    /// The initial instant.
    pub(crate) fn begin(&mut self, node: &Node) {
        self.samples.push(sample(&node.state, node.acceleration));
    }

    fn instant(&self, index: usize, end: f64) -> f64 {
        if index >= self.count {
            return end;
        }
        self.start + (end - self.start) * (index as f64 / self.count as f64)
    }

    /// Whether the inside of a step up to `time` is wanted.
    #[inline]
    pub(crate) fn wants(&self, time: f64) -> bool {
        let next = self.samples.len();
        next < self.count && self.end.is_none_or(|end| self.instant(next, end) <= time)
    }

    /// Takes the samples up to `until` from a step; the equation still is in the piece of that step.
    pub(crate) fn step(
        &mut self,
        equation: &mut Equation<'_>,
        dense: &Dense,
        until: f64,
        held: bool,
    ) -> Result<(), IntegrationError> {
        let Some(end) = self.end else {
            self.parts.push(Part { dense: *dense, until, held });
            return Ok(());
        };
        while self.samples.len() < self.count {
            let time = self.instant(self.samples.len(), end);
            if time > until {
                break;
            }
            self.samples.push(inside(equation, dense, time, held)?);
        }
        Ok(())
    }

    /// Takes the last sample from the end of the motion, and all before it that were left to the end.
    pub(crate) fn finish(
        &mut self,
        equation: &mut Equation<'_>,
        end: &Node,
    ) -> Result<Vec<Sample>, IntegrationError> {
        let parts = std::mem::take(&mut self.parts);
        let mut index = 0;
        let mut entered = None;
        while self.samples.len() < self.count {
            let time = self.instant(self.samples.len(), end.state.time);
            while index + 1 < parts.len() && parts[index].until < time {
                index += 1;
            }
            let Some(part) = parts.get(index) else {
                self.samples.push(sample(&end.state, end.acceleration));
                continue;
            };
            if entered != Some(index) && !part.held {
                let middle = 0.5 * (part.until - part.dense.time) / part.dense.step;
                let state = part.dense.at(middle);
                equation.enter(&state).map_err(|source| IntegrationError::Equation { at: state, source })?;
                entered = Some(index);
            }
            let found = inside(equation, &part.dense, time, part.held)?;
            self.samples.push(found);
        }
        self.samples.push(sample(&end.state, end.acceleration));
        Ok(std::mem::take(&mut self.samples))
    }
}

fn inside(
    equation: &mut Equation<'_>,
    dense: &Dense,
    time: f64,
    held: bool,
) -> Result<Sample, IntegrationError> {
    let mut state = dense.at(((time - dense.time) / dense.step).clamp(0.0, 1.0));
    state.time = time;
    if held {
        return Ok(sample(&state, 0.0));
    }
    let acceleration = equation
        .acceleration(time, state.coordinate, state.speed)
        .map_err(|source| IntegrationError::Equation { at: state, source })?;
    Ok(sample(&state, acceleration))
}
