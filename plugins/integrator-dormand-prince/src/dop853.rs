//! One step of Dormand-Prince 8(5,3).

use assur_integrator::{
    Attempt, Control, CountedEquation, Dense, MotionError, Node, Pace, Scale, State, Step, Stepper,
};

use crate::Stages;
use crate::dop853_table::{A, A_DENSE, B, B3, C, C_DENSE, D, E5};

/// The twelve stages of the last step, the slope at its end, and the three of the dense output.
#[derive(Debug, Default)]
pub(crate) struct Dop853(Stages<16>);

impl Dop853 {
    /// Error of order 5, corrected by the one of order 3, over the tolerance (Hairer, Norsett, Wanner I, II.10).
    fn error(&self, end: &State, scale: &Scale) -> f64 {
        let (k, b) = (&self.0.k, self.0.weighted(&B));
        let five = self.0.weighted(&E5);
        let three = |i: usize| b[i] - B3[0] * k[0][i] - B3[1] * k[8][i] - B3[2] * k[11][i];
        let five = scale.norm(end, five[0], five[1]);
        let three = scale.norm(end, three(0), three(1));
        let size = (five * five + 0.01 * three * three).sqrt();
        if size > 0.0 { self.0.h * five * five / size } else { 0.0 }
    }
}

impl Stepper for Dop853 {
    // Tried on Andrews' mechanism from 1e-4 to 1e-12: plain control (1/8, 0, 0.9) rejects up to 30 of 100 steps and at
    // 1e-7 is off by 5e-4; these keep the error below the tolerance with one rejection in ten steps.
    const PACE: Pace = Pace::Adaptive(Control {
        proportional: 0.7 / 8.0,
        integral: 0.4 / 8.0,
        safety: 0.85,
        shrink: 0.333,
        grow: 6.0,
        order: 8.0,
    });

    fn attempt(&mut self, step: Step<'_, '_>) -> Result<Attempt, MotionError> {
        let stages = &mut self.0;
        stages.begin(&step);
        let Step { equation, scale, .. } = step;
        for (c, weights) in C.into_iter().zip(A) {
            stages.stage(equation, c, weights)?;
        }
        let end = stages.state(1.0, &B);
        Ok(Attempt { end, error: self.error(&end, &scale) })
    }

    fn finish(&mut self, equation: &mut CountedEquation<'_>, end: &State) -> Result<f64, MotionError> {
        let acceleration = equation.acceleration(end)?;
        self.0.k[12] = [end.speed, acceleration];
        Ok(acceleration)
    }

    fn dense(
        &mut self,
        equation: &mut CountedEquation<'_>,
        from: &Node,
        to: &Node,
    ) -> Result<Dense, MotionError> {
        let stages = &mut self.0;
        for (c, weights) in C_DENSE.into_iter().zip(A_DENSE) {
            stages.stage(equation, c, weights)?;
        }
        let h = stages.h;
        let mut dense = Dense::cubic(from, to, h);
        for (index, weights) in D.iter().enumerate() {
            let [q, w] = stages.weighted(weights);
            dense.coordinate[4 + index] = h * q;
            dense.speed[4 + index] = h * w;
        }
        Ok(dense)
    }
}
