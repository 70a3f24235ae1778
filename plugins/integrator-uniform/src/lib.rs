//! D's own method, `uniform`: in each small interval J and M are constant, and the motion is uniformly accelerated (D
//! 3.23, with D 3.12 and 3.13). Order 1, a fixed step.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

use assur_integrator::{
    Attempt, Cost, IntegratorPlugin, Knob, MotionError, Pace, Step, Stepper, Steps, Suitability, inventory,
};
use assur_words::text;

assur_words::resources!();

/// The method.
pub const UNIFORM: IntegratorPlugin = IntegratorPlugin {
    name: "uniform",
    crate_name: env!("CARGO_PKG_NAME"),
    summary: text!("integrator-uniform"),
    source: text!("integrator-uniform.source"),
    order: 1,
    knob: Knob::Step,
    stiff: false,
    suitability: |_, _| Ok(Suitability { cost: Cost::LastResort, reason: text!("integrator-uniform-suits") }),
    method: &Steps::<Interval>::NEW,
};

inventory::submit! { UNIFORM }

/// The method stores nothing between intervals.
#[derive(Debug, Default)]
struct Interval;

impl Stepper for Interval {
    const PARABOLIC: bool = true;

    /// On the real axis, as Euler's method.
    const STABLE: f64 = 2.0;

    const PACE: Pace = Pace::Fixed;

    fn attempt(&mut self, step: Step<'_, '_>) -> Result<Attempt, MotionError> {
        Ok(Attempt { end: step.from.advanced(step.length), error: 0.0 })
    }
}

#[cfg(test)]
mod tests;
