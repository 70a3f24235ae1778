//! `radau5`: Radau IIA of order 5, implicit and L-stable, for stiff motors (Hairer, Wanner, Solving Ordinary Differential
//! Equations II, IV.5 and IV.8).
//!
//! Since q' = w, the coordinates of the three stages follow from their speeds; what Newton's method solves are three
//! equations in the three speeds, whatever the mechanism.
//!
//! Steps end with order 5, but their inside is the collocation polynomial, of order 3: at a tight tolerance samples between steps are
//! less exact than the end (on a pendulum at 1e-9, 7e-8 of the energy against 5e-10 of the coordinate). Where the
//! equation is not stiff, the explicit methods are better and cheaper.

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
