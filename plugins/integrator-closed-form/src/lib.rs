//! `closed-form`: J and M constant (D's case 1), so that the motion is uniformly accelerated (D 3.12, 3.13), exactly,
//! over a whole piece of the equation in one step. Beside it `quadrature`, for M(t) and M(w).

use assur_integrator::{
    Attempt, Dense, Dependence, Equation, IntegrationError, Integrator, IntegratorPlugin, Motion,
    MotionError, Node, Pace, Request, Scale, Stepper, Trajectory, drive,
};

mod impulse;
mod quadrature;
mod speed;

pub use quadrature::Quadrature;

/// The method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ClosedForm;

impl Integrator for ClosedForm {
    fn name(&self) -> &'static str {
        "closed-form"
    }

    fn supports(&self, dependence: &Dependence) -> Result<(), String> {
        if dependence.case() == 1 {
            return Ok(());
        }
        Err(format!(
            "the closed form needs J and M constant (case 1 of D), and here it is case {}: {}",
            dependence.case(),
            dependence.words()
        ))
    }

    fn solve(&self, motion: &mut dyn Motion, request: &Request) -> Result<Trajectory, IntegrationError> {
        let supported = self.supports(&motion.dependence());
        supported.map_err(|reason| IntegrationError::Unsupported { integrator: self.name(), reason })?;
        drive(&mut Parabola::default(), motion, request)
    }
}

inventory::submit! {
    IntegratorPlugin {
        name: "closed-form",
        crate_name: env!("CARGO_PKG_NAME"),
        summary: "J and M constant: uniformly accelerated motion, exact",
        source: "D 3.12, 3.13",
        order: 0,
        instance: || &ClosedForm,
    }
}

/// The last stretch; the acceleration is the same at both ends.
#[derive(Debug, Default)]
struct Parabola {
    acceleration: f64,
}

impl Stepper for Parabola {
    const PARABOLIC: bool = true;

    fn pace(&self) -> Pace {
        Pace::Unlimited
    }

    fn attempt(
        &mut self,
        _: &mut Equation<'_>,
        from: &Node,
        h: f64,
        _: &Scale,
    ) -> Result<Attempt, MotionError> {
        self.acceleration = from.acceleration;
        Ok(Attempt { end: from.advanced(h), error: 0.0 })
    }

    fn finish(&mut self, _: &mut Equation<'_>) -> Result<f64, MotionError> {
        Ok(self.acceleration)
    }

    fn dense(&mut self, _: &mut Equation<'_>, from: &Node, to: &Node) -> Result<Dense, MotionError> {
        Ok(Dense::parabola(from, to.state.time - from.state.time))
    }
}

#[cfg(test)]
mod tests;
