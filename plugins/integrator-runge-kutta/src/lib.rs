//! `rk4`: the classical Runge-Kutta method of order 4 at a fixed step, the improvement that D 3.23 names.

use assur_integrator::{
    Attempt, Cost, Dense, Equation, IntegratorPlugin, Knob, MotionError, Node, Pace, Scale, State, Stepper,
    Suitability, drive, inventory,
};

/// The method.
pub const RK4: IntegratorPlugin = IntegratorPlugin {
    name: "rk4",
    crate_name: env!("CARGO_PKG_NAME"),
    summary: "classical Runge-Kutta at a fixed step",
    source: "D 3.23; Kutta 1901",
    order: 4,
    knob: Knob::Step,
    stiff: false,
    suitability: |_, _| {
        Ok(Suitability { cost: Cost::LastResort, reason: "steps of order 4 at a fixed length" })
    },
    run: drive::<Classical>,
};

inventory::submit! { RK4 }

/// The end of the last step.
#[derive(Debug, Default)]
struct Classical {
    end: State,
}

impl Stepper for Classical {
    /// On the real axis 2.785, on the imaginary one 2.83.
    const STABLE: f64 = 2.785;

    fn pace(&self) -> Pace {
        Pace::Fixed
    }

    fn attempt(
        &mut self,
        equation: &mut Equation<'_>,
        from: &Node,
        h: f64,
        _: &Scale,
    ) -> Result<Attempt, MotionError> {
        let State { time, coordinate, speed } = from.state;
        let half = 0.5 * h;
        let (w1, a1) = (speed, from.acceleration);
        let w2 = speed + half * a1;
        let a2 = equation.acceleration(time + half, coordinate + half * w1, w2)?;
        let w3 = speed + half * a2;
        let a3 = equation.acceleration(time + half, coordinate + half * w2, w3)?;
        let w4 = speed + h * a3;
        let a4 = equation.acceleration(time + h, coordinate + h * w3, w4)?;
        self.end = State {
            time: time + h,
            coordinate: coordinate + h / 6.0 * (w1 + 2.0 * (w2 + w3) + w4),
            speed: speed + h / 6.0 * (a1 + 2.0 * (a2 + a3) + a4),
        };
        Ok(Attempt { end: self.end, error: 0.0 })
    }

    fn finish(&mut self, equation: &mut Equation<'_>) -> Result<f64, MotionError> {
        equation.acceleration(self.end.time, self.end.coordinate, self.end.speed)
    }

    fn dense(&mut self, _: &mut Equation<'_>, from: &Node, to: &Node) -> Result<Dense, MotionError> {
        Ok(Dense::hermite(from, to))
    }
}

#[cfg(test)]
mod tests;
