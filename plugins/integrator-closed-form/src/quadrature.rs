//! `quadrature`: J constant and M of time or of speed (D's case 2): one integral gives the motion.

use assur_integrator::{
    Cost, Dependence, IntegrationError, Integrator, IntegratorPlugin, Knob, Motion, Request, Steps,
    Suitability, Trajectory, inventory,
};

use crate::impulse::Impulse;
use crate::speed;

/// The method.
pub const QUADRATURE: IntegratorPlugin = IntegratorPlugin {
    name: "quadrature",
    crate_name: env!("CARGO_PKG_NAME"),
    summary: "J constant, M(t) or M(w): speed and displacement by quadrature over time, time and displacement by quadrature over the speed",
    source: "D 3.21, case 2",
    order: 0,
    knob: Knob::Tolerance,
    stiff: false,
    suitability: |dependence, _| suitability(*dependence),
    method: &Quadrature,
};

inventory::submit! { QUADRATURE }

fn suitability(dependence: Dependence) -> Result<Suitability, String> {
    let one = !(dependence.moment_on_speed && dependence.moment_on_time);
    if !dependence.inertia_constant || dependence.moment_on_coordinate || !one {
        return Err(format!(
            "the quadrature needs J constant and M constant, M(t) or M(w) (cases 1 and 2 of D), and here it is case {}: {}",
            dependence.case(),
            dependence.words()
        ));
    }
    let reason = if dependence.moment_on_speed {
        "t = J * integral of dw / M(w) gives the motion by one quadrature over the speed"
    } else {
        "the impulse of the moment gives the speed by one quadrature over time"
    };
    Ok(Suitability { cost: Cost::Quadrature, reason })
}

struct Quadrature;

impl Integrator for Quadrature {
    fn solve(&self, motion: &mut dyn Motion, request: &Request) -> Result<Trajectory, IntegrationError> {
        if motion.dependence().moment_on_speed {
            speed::run(motion, request)
        } else {
            Steps::<Impulse>::NEW.solve(motion, request)
        }
    }
}
