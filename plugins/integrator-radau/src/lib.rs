//! `radau5`: Radau IIA of order 5, implicit and L-stable, for stiff motors (Hairer, Wanner, Solving Ordinary Differential
//! Equations II, IV.5 and IV.8).
//!
//! Since q' = w, the coordinates of the three stages follow from their speeds; what Newton's method solves are three
//! equations in the three speeds, whatever the mechanism.

use assur_integrator::{
    Dependence, IntegrationError, Integrator, IntegratorPlugin, Motion, Request, Trajectory, drive,
};

mod collocation;
mod linear;
mod table;

/// The method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Radau5;

impl Integrator for Radau5 {
    fn name(&self) -> &'static str {
        "radau5"
    }

    fn supports(&self, _: &Dependence) -> Result<(), String> {
        Ok(())
    }

    fn solve(&self, motion: &mut dyn Motion, request: &Request) -> Result<Trajectory, IntegrationError> {
        drive(&mut collocation::Collocation::default(), motion, request)
    }
}

inventory::submit! {
    IntegratorPlugin {
        name: "radau5",
        crate_name: env!("CARGO_PKG_NAME"),
        summary: "Radau IIA of order 5, implicit, adaptive, dense output of order 3; for stiff motors",
        source: "Hairer, Wanner II, IV.5 and IV.8",
        order: 5,
        instance: || &Radau5,
    }
}

#[cfg(test)]
mod tests;
