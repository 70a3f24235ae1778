//! `closed-form`: J and M constant (D's case 1), so the motion is uniformly accelerated (D 3.12, 3.13), exactly, over a
//! whole piece of the equation in one step. Also `quadrature`, for M(t) and M(w).

use assur_integrator::{
    Attempt, Cost, Dense, Equation, IntegratorPlugin, Knob, MotionError, Node, Pace, State, Step, Stepper,
    Steps, Suitability, inventory,
};

mod impulse;
mod quadrature;
mod speed;

pub use quadrature::QUADRATURE;

/// The method.
pub const CLOSED_FORM: IntegratorPlugin = IntegratorPlugin {
    name: "closed-form",
    crate_name: env!("CARGO_PKG_NAME"),
    summary: "J and M constant: uniformly accelerated motion, exact",
    source: "D 3.12, 3.13",
    order: 0,
    knob: Knob::None,
    stiff: false,
    suitability: |dependence, _| match dependence.case() {
        1 => Ok(Suitability {
            cost: Cost::ClosedForm,
            reason: "uniformly accelerated motion has a closed form, exact",
        }),
        case => Err(format!(
            "the closed form needs J and M constant (case 1 of D), and here it is case {case}: {}",
            dependence.words()
        )),
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

    fn pace(&self) -> Pace {
        Pace::Unlimited
    }

    fn attempt(&mut self, step: Step<'_, '_>) -> Result<Attempt, MotionError> {
        self.acceleration = step.from.acceleration;
        Ok(Attempt { end: step.from.advanced(step.length), error: 0.0 })
    }

    fn finish(&mut self, _: &mut Equation<'_>, _: &State) -> Result<f64, MotionError> {
        Ok(self.acceleration)
    }

    fn dense(&mut self, _: &mut Equation<'_>, from: &Node, to: &Node) -> Result<Dense, MotionError> {
        Ok(Dense::parabola(from, to.state.time - from.state.time))
    }
}

#[cfg(test)]
mod tests;
