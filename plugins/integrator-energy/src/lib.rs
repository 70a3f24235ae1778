//! `energy`: the energy form, w = √((J0 w0² + 2 A)/J) with A the work along the coordinate (E eq. 1), for M(q) only.
//!
//! J and Q are fitted by Chebyshev polynomials over panels of the coordinate; the work is the integral of one of
//! them, and no further evaluation of the mechanism is needed: the time t = ∫ dq/w is a quadrature of the polynomials. Where the
//! motion starts from rest or turns, 1/w has an integrable singularity, which a cosine substitution removes: there is no
//! division by a speed of zero. There are no steps in time, so nothing drifts: the energy balance holds by construction.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

use assur_integrator::{Cost, IntegratorPlugin, Knob, Suitability, inventory};
use assur_words::{Describe, number, text};

mod clock;
mod march;

assur_words::resources!();

/// The method.
pub const ENERGY: IntegratorPlugin = IntegratorPlugin {
    name: "energy",
    crate_name: env!("CARGO_PKG_NAME"),
    summary: text!("integrator-energy"),
    source: text!("integrator-energy.source"),
    order: 0,
    knob: Knob::Tolerance,
    stiff: false,
    suitability: |dependence, _| {
        if !dependence.moment_on_speed && !dependence.moment_on_time {
            let reason = text!("integrator-energy-suits");
            return Ok(Suitability { cost: Cost::Quadrature, reason });
        }
        Err(text!(
            "integrator-energy-unfit",
            case = number(dependence.case()),
            equation = dependence.describe()
        ))
    },
    method: &march::Energy,
};

inventory::submit! { ENERGY }

#[cfg(test)]
mod tests;
