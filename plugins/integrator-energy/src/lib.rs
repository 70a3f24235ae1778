//! `energy`: the energy form, w = √((J0 w0² + 2 A)/J) with A the work along the coordinate (E eq. 1), for M(q) only.
//!
//! J and Q are fitted by Chebyshev polynomials over panels of the coordinate; the work is the integral of one of
//! them, and no further evaluation of the mechanism is needed: the time t = ∫ dq/w is a quadrature of the polynomials. Where the
//! motion starts from rest or turns, 1/w has an integrable singularity, which a cosine substitution removes: there is no
//! division by a speed of zero. There are no steps in time, so nothing drifts: the energy balance holds by construction.

use assur_integrator::{Cost, IntegratorPlugin, Knob, Suitability, inventory};

mod clock;
mod march;
mod panel;

/// The method.
pub const ENERGY: IntegratorPlugin = IntegratorPlugin {
    name: "energy",
    crate_name: env!("CARGO_PKG_NAME"),
    summary: "energy form: speed from the work, quadrature in the coordinate; M(q) only",
    source: "E eq. 1",
    order: 0,
    knob: Knob::Tolerance,
    stiff: false,
    suitability: |dependence, _| {
        if dependence.is_work_of_coordinate() {
            let reason =
                "the work along the coordinate gives the speed by one quadrature, without steps in time";
            return Ok(Suitability { cost: Cost::Quadrature, reason });
        }
        Err(format!(
            "the energy form needs a moment that depends on the coordinate alone, and here it is case {} of D: {}",
            dependence.case(),
            dependence.words()
        ))
    },
    method: &march::Energy,
};

inventory::submit! { ENERGY }

#[cfg(test)]
mod tests;
