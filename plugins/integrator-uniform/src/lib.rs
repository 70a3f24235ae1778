//! D's own method, `uniform`: in each small interval J and M are held, and the motion is uniformly accelerated (D 3.23,
//! with D 3.12 and 3.13). Order 1, a fixed step.

use assur_integrator::{
    Attempt, Cost, Dense, Equation, IntegratorPlugin, Knob, MotionError, Node, Pace, Scale, State, Stepper,
    Suitability, drive, inventory,
};

/// The method.
pub const UNIFORM: IntegratorPlugin = IntegratorPlugin {
    name: "uniform",
    crate_name: env!("CARGO_PKG_NAME"),
    summary: "uniformly accelerated intervals at a fixed step",
    source: "D 3.23",
    order: 1,
    knob: Knob::Step,
    stiff: false,
    suitability: |_, _| {
        Ok(Suitability {
            cost: Cost::LastResort,
            reason: "uniformly accelerated intervals of a fixed length",
        })
    },
    run: drive::<Interval>,
};

inventory::submit! { UNIFORM }

/// The end of the last interval.
#[derive(Debug, Default)]
struct Interval {
    end: State,
}

impl Stepper for Interval {
    const PARABOLIC: bool = true;

    /// On the real axis, as Euler's method.
    const STABLE: f64 = 2.0;

    fn pace(&self) -> Pace {
        Pace::Fixed
    }

    fn attempt(
        &mut self,
        _: &mut Equation<'_>,
        from: &Node,
        h: f64,
        _: &Scale,
    ) -> Result<Attempt, MotionError> {
        self.end = from.advanced(h);
        Ok(Attempt { end: self.end, error: 0.0 })
    }

    fn finish(&mut self, equation: &mut Equation<'_>) -> Result<f64, MotionError> {
        equation.acceleration(self.end.time, self.end.coordinate, self.end.speed)
    }

    fn dense(&mut self, _: &mut Equation<'_>, from: &Node, to: &Node) -> Result<Dense, MotionError> {
        Ok(Dense::parabola(from, to.state.time - from.state.time))
    }
}

#[cfg(test)]
mod tests;
