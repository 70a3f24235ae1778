//! Equally spaced samples of a motion that is known as stretches, for methods that don't go in time steps.

use crate::{Equation, IntegrationError, Request, Sample, State};

/// A stretch of a motion inside one smooth piece of the equation.
pub trait Stretch {
    /// Time at its end, s.
    fn end(&self) -> f64;

    /// State at a time inside it.
    fn at(&self, time: f64) -> State;

    /// A state well inside, by which the piece is chosen; `None` where the speed stays: the acceleration is zero there,
    /// whatever the equation says.
    fn middle(&self) -> Option<State>;
}

/// The samples of a motion from `first` to `last` along its stretches, which follow each other in time.
///
/// # Errors
///
/// [`IntegrationError::Equation`] where the equation fails at a sample.
pub fn samples<S: Stretch>(
    equation: &mut Equation<'_>,
    request: &Request,
    parts: &[S],
    [first, last]: [Sample; 2],
) -> Result<Vec<Sample>, IntegrationError> {
    let count = request.samples;
    let mut samples = Vec::with_capacity(count + 1);
    samples.push(first);
    let (mut index, mut entered) = (0, None);
    for k in 1..count {
        let time = first.time + (last.time - first.time) * (k as f64 / count as f64);
        while index + 1 < parts.len() && parts[index].end() < time {
            index += 1;
        }
        let Some(part) = parts.get(index) else { break };
        let failed = |state| move |source| IntegrationError::Equation { at: state, source };
        let state = part.at(time);
        let State { time, coordinate, speed } = state;
        let mut acceleration = 0.0;
        if let Some(middle) = part.middle() {
            if entered != Some(index) {
                equation.enter(&middle).map_err(failed(middle))?;
                entered = Some(index);
            }
            acceleration = equation.acceleration(time, coordinate, speed).map_err(failed(state))?;
        }
        samples.push(Sample { time, coordinate, speed, acceleration });
    }
    samples.resize(count, last);
    samples.push(last);
    Ok(samples)
}
