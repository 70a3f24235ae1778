//! `closed-form`: J and M constant (D's case 1), so the motion is uniformly accelerated (D 3.12, 3.13), exactly, over a
//! whole piece of the equation in one step. Also `quadrature`, for M(t) and M(w).

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

use assur_integrator::{
    Attempt, Cost, CountedEquation, Dependence, EquationOfMotion, IntegrationError, Integrator,
    IntegratorPlugin, Knob, MotionError, Pace, Request, State, Step, Stepper, Steps, Suitability, Trajectory,
    inventory,
};
use assur_words::{Describe, Text, number, text};

use crate::impulse::Impulse;

mod impulse;
mod speed;

assur_words::resources!();

/// The method.
pub const CLOSED_FORM: IntegratorPlugin = IntegratorPlugin {
    name: "closed-form",
    crate_name: env!("CARGO_PKG_NAME"),
    summary: text!("integrator-closed-form"),
    source: text!("integrator-closed-form.source"),
    order: 0,
    knob: Knob::None,
    stiff: false,
    suitability: |dependence, _| match dependence.case() {
        1 => Ok(Suitability { cost: Cost::ClosedForm, reason: text!("integrator-closed-form-suits") }),
        case => {
            Err(text!("integrator-closed-form-unfit", case = number(case), equation = dependence.describe()))
        }
    },
    method: &Steps::<Parabola>::NEW,
};

inventory::submit! { CLOSED_FORM }

/// Uniformly accelerated motion over a whole piece; the acceleration is the same at both ends.
#[derive(Debug, Default)]
struct Parabola {
    acceleration: f64,
}

impl Stepper for Parabola {
    const PARABOLIC: bool = true;

    const PACE: Pace = Pace::Unlimited;

    fn attempt(&mut self, step: Step<'_, '_>) -> Result<Attempt, MotionError> {
        self.acceleration = step.from.acceleration;
        Ok(Attempt { end: step.from.advanced(step.length), error: 0.0 })
    }

    fn finish(&mut self, _: &mut CountedEquation<'_>, _: &State) -> Result<f64, MotionError> {
        Ok(self.acceleration)
    }
}

/// The method.
pub const QUADRATURE: IntegratorPlugin = IntegratorPlugin {
    name: "quadrature",
    crate_name: env!("CARGO_PKG_NAME"),
    summary: text!("integrator-quadrature"),
    source: text!("integrator-quadrature.source"),
    order: 0,
    knob: Knob::Tolerance,
    stiff: false,
    suitability: |dependence, _| suitability(*dependence),
    method: &Quadrature,
};

inventory::submit! { QUADRATURE }

fn suitability(dependence: Dependence) -> Result<Suitability, Text> {
    let one = !(dependence.moment_on_speed && dependence.moment_on_time);
    if !dependence.inertia_constant || dependence.moment_on_coordinate || !one {
        return Err(text!(
            "integrator-quadrature-unfit",
            case = number(dependence.case()),
            equation = dependence.describe()
        ));
    }
    let reason = if dependence.moment_on_speed {
        text!("integrator-quadrature-over-speed")
    } else {
        text!("integrator-quadrature-over-time")
    };
    Ok(Suitability { cost: Cost::Quadrature, reason })
}

struct Quadrature;

impl Integrator for Quadrature {
    fn solve(
        &self,
        motion: &mut dyn EquationOfMotion,
        request: &Request,
    ) -> Result<Trajectory, IntegrationError> {
        if motion.dependence().moment_on_speed {
            speed::run(motion, request)
        } else {
            Steps::<Impulse>::NEW.solve(motion, request)
        }
    }
}

#[cfg(test)]
mod tests;
