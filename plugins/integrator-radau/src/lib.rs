//! `radau5`: Radau IIA of order 5, implicit and L-stable, for stiff motors (Hairer, Wanner, Solving Ordinary Differential
//! Equations II, IV.5 and IV.8).
//!
//! Since q' = w, the coordinates of the three stages follow from their speeds: Newton's method solves three equations
//! for the three speeds, whatever the mechanism.
//!
//! Steps end with order 5, but their inside is the collocation polynomial, of order 3: at a tight tolerance samples between steps are
//! less exact than the end (on a pendulum at 1e-9, 7e-8 of the energy against 5e-10 of the coordinate). Where the
//! equation is not stiff, the explicit methods are better and cheaper.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

use assur_integrator::{Cost, IntegratorPlugin, Knob, Steps, Suitability, inventory};
use assur_words::text;

mod collocation;

assur_words::resources!();

/// The method.
pub const RADAU5: IntegratorPlugin = IntegratorPlugin {
    name: "radau5",
    crate_name: env!("CARGO_PKG_NAME"),
    summary: text!("integrator-radau5"),
    source: text!("integrator-radau5.source"),
    order: 5,
    knob: Knob::Tolerance,
    stiff: true,
    suitability: |_, _| Ok(Suitability { cost: Cost::LastResort, reason: text!("integrator-radau5-suits") }),
    method: &Steps::<collocation::Collocation>::NEW,
};

inventory::submit! { RADAU5 }

#[cfg(test)]
mod tests;
