//! Dormand and Prince's explicit methods: `dopri5`, order 5(4), and `dop853`, order 8(5,3).
//!
//! Coefficients: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.5 and II.6. Since the
//! first equation is q' = w, the slopes of the coordinate are the speeds of the stages, so that a stage holds two numbers, its
//! speed and its acceleration.

use assur_integrator::{
    Dependence, IntegrationError, Integrator, IntegratorPlugin, Motion, Request, Trajectory, drive,
};

mod dop853;
mod dop853_table;
mod dopri5;
mod dopri5_table;
mod stages;

#[cfg(test)]
mod tests;

/// The method of order 5(4).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Dopri5;

/// The method of order 8(5,3).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Dop853;

impl Integrator for Dopri5 {
    fn name(&self) -> &'static str {
        "dopri5"
    }

    fn supports(&self, _: &Dependence) -> Result<(), String> {
        Ok(())
    }

    fn solve(&self, motion: &mut dyn Motion, request: &Request) -> Result<Trajectory, IntegrationError> {
        drive(&mut dopri5::Stages::default(), motion, request)
    }
}

impl Integrator for Dop853 {
    fn name(&self) -> &'static str {
        "dop853"
    }

    fn supports(&self, _: &Dependence) -> Result<(), String> {
        Ok(())
    }

    fn solve(&self, motion: &mut dyn Motion, request: &Request) -> Result<Trajectory, IntegrationError> {
        drive(&mut dop853::Stages::default(), motion, request)
    }
}

inventory::submit! {
    IntegratorPlugin {
        name: "dopri5",
        crate_name: env!("CARGO_PKG_NAME"),
        summary: "Dormand-Prince 5(4), explicit, adaptive, dense output of order 4",
        source: "Hairer, Norsett, Wanner I, II.5",
        order: 5,
        instance: || &Dopri5,
    }
}

inventory::submit! {
    IntegratorPlugin {
        name: "dop853",
        crate_name: env!("CARGO_PKG_NAME"),
        summary: "Dormand-Prince 8(5,3), explicit, adaptive, dense output of order 7",
        source: "Hairer, Norsett, Wanner I, II.5 and II.6",
        order: 8,
        instance: || &Dop853,
    }
}
