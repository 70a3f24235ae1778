//! `rk4`: the classical Runge-Kutta method of order 4 at a fixed step, the improvement that D 3.23 names.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

use assur_integrator::{
    Attempt, Cost, IntegratorPlugin, Knob, MotionError, Pace, State, Step, Stepper, Steps, Suitability,
    inventory,
};
use assur_words::text;

assur_words::resources!();

/// The method.
pub const RK4: IntegratorPlugin = IntegratorPlugin {
    name: "rk4",
    crate_name: env!("CARGO_PKG_NAME"),
    summary: text!("integrator-rk4"),
    source: text!("integrator-rk4.source"),
    order: 4,
    knob: Knob::Step,
    stiff: false,
    suitability: |_, _| Ok(Suitability { cost: Cost::LastResort, reason: text!("integrator-rk4-suits") }),
    method: &Steps::<Classical>::NEW,
};

inventory::submit! { RK4 }

/// The method stores nothing between steps.
#[derive(Debug, Default)]
struct Classical;

impl Stepper for Classical {
    /// On the real axis 2.785, on the imaginary one 2.83.
    const STABLE: f64 = 2.785;

    const PACE: Pace = Pace::Fixed;

    fn attempt(&mut self, step: Step<'_, '_>) -> Result<Attempt, MotionError> {
        let Step { equation, from, length: h, .. } = step;
        let start = from.state;
        // The state to which the slopes at a stage lead.
        let after = |h: f64, w: f64, a: f64| State {
            time: start.time + h,
            coordinate: start.coordinate + h * w,
            speed: start.speed + h * a,
        };
        let half = 0.5 * h;
        let (w1, a1) = (start.speed, from.acceleration);
        let second = after(half, w1, a1);
        let (w2, a2) = (second.speed, equation.acceleration(&second)?);
        let third = after(half, w2, a2);
        let (w3, a3) = (third.speed, equation.acceleration(&third)?);
        let fourth = after(h, w3, a3);
        let (w4, a4) = (fourth.speed, equation.acceleration(&fourth)?);
        let end = State {
            time: start.time + h,
            coordinate: start.coordinate + h / 6.0 * (w1 + 2.0 * (w2 + w3) + w4),
            speed: start.speed + h / 6.0 * (a1 + 2.0 * (a2 + a3) + a4),
        };
        Ok(Attempt { end, error: 0.0 })
    }
}

#[cfg(test)]
mod tests;
