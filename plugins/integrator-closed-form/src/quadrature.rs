//! `quadrature`: J constant and M of time or of speed (D's case 2): one integral gives the motion.

use assur_integrator::{
    Dependence, IntegrationError, Integrator, IntegratorPlugin, Motion, Request, Trajectory, drive,
};

use crate::impulse::Impulse;
use crate::speed::March;

/// The name it is registered under.
pub(crate) const NAME: &str = "quadrature";

/// The method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Quadrature;

impl Integrator for Quadrature {
    fn name(&self) -> &'static str {
        NAME
    }

    fn supports(&self, dependence: &Dependence) -> Result<(), String> {
        let one = !(dependence.moment_on_speed && dependence.moment_on_time);
        if dependence.inertia_constant && !dependence.moment_on_coordinate && one {
            return Ok(());
        }
        Err(format!(
            "the quadrature needs J constant and M constant, M(t) or M(w) (cases 1 and 2 of D), and here it is case {}: {}",
            dependence.case(),
            dependence.words()
        ))
    }

    fn solve(&self, motion: &mut dyn Motion, request: &Request) -> Result<Trajectory, IntegrationError> {
        let dependence = motion.dependence();
        let supported = self.supports(&dependence);
        supported.map_err(|reason| IntegrationError::Unsupported { integrator: NAME, reason })?;
        if !dependence.moment_on_speed {
            return drive(&mut Impulse::default(), motion, request);
        }
        request.check()?;
        March::new(motion, request).run()
    }
}

inventory::submit! {
    IntegratorPlugin {
        name: NAME,
        crate_name: env!("CARGO_PKG_NAME"),
        summary: "J constant, M(t) or M(w): speed and way by quadrature over time, time and way by quadrature over the speed",
        source: "D 3.21, case 2",
        order: 0,
        instance: || &Quadrature,
    }
}
