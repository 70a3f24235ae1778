//! Explicit stages, shared by both methods.

use assur_integrator::{CountedEquation, MotionError, State, Step};

/// A stage: its slopes, which are its speed and its acceleration.
pub(crate) type Slope = [f64; 2];

/// The stages of the last step, at most `N`.
#[derive(Debug, Clone)]
pub(crate) struct Stages<const N: usize> {
    pub(crate) k: [Slope; N],
    /// State at the start.
    pub(crate) from: State,
    /// Length, s.
    pub(crate) h: f64,
}

impl<const N: usize> Default for Stages<N> {
    fn default() -> Self {
        Self { k: [[0.0; 2]; N], from: State::default(), h: 0.0 }
    }
}

impl<const N: usize> Stages<N> {
    /// Begins a step; its first stage is its start.
    pub(crate) fn begin(&mut self, step: &Step<'_, '_>) {
        (self.from, self.h) = (step.from.state, step.length);
        self.k[0] = [self.from.speed, step.from.acceleration];
    }

    /// Sum of the slopes with these weights; the weights end where the stages that they use end.
    #[inline]
    pub(crate) fn weighted(&self, weights: &[f64]) -> Slope {
        let mut sum = [0.0; 2];
        for (weight, slope) in weights.iter().zip(&self.k) {
            sum[0] += weight * slope[0];
            sum[1] += weight * slope[1];
        }
        sum
    }

    /// The state after the part `c` of the step, with the weighted sum of the slopes.
    #[inline]
    pub(crate) fn state(&self, c: f64, weights: &[f64]) -> State {
        let [dq, dw] = self.weighted(weights);
        State {
            time: self.from.time + c * self.h,
            coordinate: self.from.coordinate + self.h * dq,
            speed: self.from.speed + self.h * dw,
        }
    }

    /// Computes the stage that follows those which `weights` uses, at the part `c` of the step.
    #[inline]
    pub(crate) fn stage(
        &mut self,
        equation: &mut CountedEquation<'_>,
        c: f64,
        weights: &[f64],
    ) -> Result<State, MotionError> {
        let state = self.state(c, weights);
        self.k[weights.len()] = [state.speed, equation.acceleration(&state)?];
        Ok(state)
    }
}
