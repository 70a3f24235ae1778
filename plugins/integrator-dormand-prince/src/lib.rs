//! Dormand and Prince's explicit methods: `dopri5`, order 5(4), and `dop853`, order 8(5,3).
//!
//! Coefficients: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.5 and II.6. Since the
//! first equation is q' = w, the slopes of the coordinate are the speeds of the stages, so that a stage holds two numbers, its
//! speed and its acceleration.

use assur_integrator::{Cost, IntegratorPlugin, Knob, Steps, Suitability, inventory};
use assur_words::{Text, text};

mod dop853;
mod dop853_table;
mod dopri5;
mod stages;

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
