//! A solution as segments that follow each other in time, and the equally spaced samples of it.

use crate::{CountedEquation, IntegrationError, Node, Sample, State};

/// The motion inside one smooth piece of the equation, as a function of time.
pub trait Curve {
    /// State at a time of the segment that begins with the state `from`.
    fn at(&self, from: &State, time: f64) -> State;
}

/// A part of the motion inside one smooth piece.
#[derive(Debug, Clone)]
pub(crate) struct Segment<C> {
    /// State at its start.
    pub(crate) from: State,
    /// Time at its end, s.
    pub(crate) end: f64,
    /// The motion in it; `None` where the speed is held constant regardless of the equation.
    pub(crate) curve: Option<C>,
}

impl<C: Curve> Segment<C> {
    fn at(&self, time: f64) -> State {
        match &self.curve {
            Some(curve) => curve.at(&self.from, time),
            None => self.from.coasting_until(time),
        }
    }

    fn node(&self, equation: &mut CountedEquation<'_>, time: f64) -> Result<Node, IntegrationError> {
        let state = self.at(time);
        let acceleration = match self.curve {
            Some(_) => {
                equation.acceleration(&state).map_err(|source| IntegrationError::equation(&state, source))?
            }
            None => 0.0,
        };
        Ok(Node { state, acceleration })
    }

    /// Enters the smooth piece of the equation that holds the segment, by a state well inside.
    fn enter(&self, equation: &mut CountedEquation<'_>) -> Result<(), IntegrationError> {
        if self.curve.is_some() {
            let middle = self.at(0.5 * (self.from.time + self.end));
            equation.enter(&middle).map_err(|source| IntegrationError::equation(&middle, source))?;
        }
        Ok(())
    }
}

/// The samples of a motion from `first` to `last`: `count` equally spaced ones after the first, the last at the end.
///
/// Segments that contain no sample may be missing.
///
/// # Errors
///
/// [`IntegrationError::Equation`] where the equation fails at a sample.
pub(crate) fn samples<C: Curve>(
    equation: &mut CountedEquation<'_>,
    segments: &[Segment<C>],
    count: usize,
    [first, last]: [Node; 2],
) -> Result<Vec<Sample>, IntegrationError> {
    let mut samples = Vec::with_capacity(count + 1);
    samples.push(Sample::from(first));
    let (mut index, mut entered) = (0, None);
    for k in 1..count {
        let time = instant(first.state.time, last.state.time, k, count);
        while index + 1 < segments.len() && segments[index].end <= time {
            index += 1;
        }
        let Some(segment) = segments.get(index) else { break };
        if entered != Some(index) {
            segment.enter(equation)?;
            entered = Some(index);
        }
        samples.push(Sample::from(segment.node(equation, time)?));
    }
    samples.resize(count, Sample::from(last));
    samples.push(Sample::from(last));
    Ok(samples)
}

/// Time of the sample `k` of `count`, s.
pub(crate) fn instant(start: f64, end: f64, k: usize, count: usize) -> f64 {
    start + (end - start) * (k as f64 / count as f64)
}
