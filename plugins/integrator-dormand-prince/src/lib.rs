//! Dormand and Prince's explicit methods: `dopri5`, order 5(4), and `dop853`, order 8(5,3).
//!
//! Coefficients: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.5 and II.6. Since the
//! first equation is q' = w, the slopes of the coordinate are the speeds of the stages, so that a stage holds two numbers, its
//! speed and its acceleration.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

use assur_integrator::{
    Cost, CountedEquation, IntegratorPlugin, Knob, MotionError, State, Step, Steps, Suitability, inventory,
};
use assur_words::{Text, text};

mod dop853;
mod dop853_table;
mod dopri5;

assur_words::resources!();

#[cfg(test)]
mod tests;

/// Tolerance above which steps of order 5 need fewer evaluations than steps of order 8.
const LOOSE: f64 = 1e-4;

fn steps(fits: bool, reason: Text) -> Suitability {
    Suitability { cost: if fits { Cost::Steps } else { Cost::OtherSteps }, reason }
}

/// The method of order 5(4).
pub const DOPRI5: IntegratorPlugin = IntegratorPlugin {
    name: "dopri5",
    crate_name: env!("CARGO_PKG_NAME"),
    summary: text!("integrator-dopri5"),
    source: text!("integrator-dopri5.source"),
    order: 5,
    knob: Knob::Tolerance,
    stiff: false,
    suitability: |_, tolerance| Ok(steps(tolerance > LOOSE, text!("integrator-dopri5-suits"))),
    method: &Steps::<dopri5::Dopri5>::NEW,
};

/// The method of order 8(5,3).
pub const DOP853: IntegratorPlugin = IntegratorPlugin {
    name: "dop853",
    crate_name: env!("CARGO_PKG_NAME"),
    summary: text!("integrator-dop853"),
    source: text!("integrator-dop853.source"),
    order: 8,
    knob: Knob::Tolerance,
    stiff: false,
    suitability: |_, tolerance| {
        let reason = text!("integrator-dop853-suits");
        Ok(steps(tolerance <= LOOSE, reason))
    },
    method: &Steps::<dop853::Dop853>::NEW,
};

inventory::submit! { DOPRI5 }
inventory::submit! { DOP853 }

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
