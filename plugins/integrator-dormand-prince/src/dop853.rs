//! One step of Dormand-Prince 8(5,3).

use assur_integrator::{
    Attempt, Control, Dense, Equation, MotionError, Node, Pace, Scale, State, Stepper, cubic,
};

use crate::dop853_table::{
    A2, A3, A4, A5, A6, A7, A8, A9, A10, A11, A12, A14, A15, A16, B, B3, C, C_DENSE, D, E5,
};
use crate::stages::{Slope, weighted};

/// The twelve stages of the last step, the slope at its end, and the three of the dense output.
#[derive(Debug, Clone, Default)]
pub(crate) struct Stages {
    k: [Slope; 16],
    h: f64,
    end: State,
}

impl Stages {
    #[inline]
    fn stage<const N: usize>(
        &mut self,
        equation: &mut Equation<'_>,
        from: &State,
        c: f64,
        weights: &[f64; N],
    ) -> Result<(), MotionError> {
        let [dq, dw] = weighted(weights, &self.k);
        let (t, w) = (from.time + c * self.h, from.speed + self.h * dw);
        self.k[N] = [w, equation.acceleration(t, from.coordinate + self.h * dq, w)?];
        Ok(())
    }

    /// Error of order 5, corrected by the one of order 3, over the tolerance (Hairer, Norsett, Wanner I, II.10).
    fn error(&self, b: &Slope, scale: &Scale) -> f64 {
        let five = weighted(&E5, &self.k);
        let three = |i: usize| b[i] - B3[0] * self.k[0][i] - B3[1] * self.k[8][i] - B3[2] * self.k[11][i];
        let five = scale.norm(&self.end, five[0], five[1]);
        let three = scale.norm(&self.end, three(0), three(1));
        let size = (five * five + 0.01 * three * three).sqrt();
        if size > 0.0 { self.h * five * five / size } else { 0.0 }
    }
}

impl Stepper for Stages {
    fn pace(&self) -> Pace {
        // Tried on Andrews' mechanism from 1e-4 to 1e-12: plain control (1/8, 0, 0.9) rejects up to 30 of 100 steps and at
        // 1e-7 is off by 5e-4; these keep the error below the tolerance with one rejection in ten steps.
        Pace::Adaptive(Control {
            proportional: 0.7 / 8.0,
            integral: 0.4 / 8.0,
            safety: 0.85,
            shrink: 0.333,
            grow: 6.0,
            order: 8.0,
        })
    }

    fn attempt(
        &mut self,
        equation: &mut Equation<'_>,
        from: &Node,
        h: f64,
        scale: &Scale,
    ) -> Result<Attempt, MotionError> {
        let start = &from.state;
        self.h = h;
        self.k[0] = [start.speed, from.acceleration];
        self.stage(equation, start, C[0], &A2)?;
        self.stage(equation, start, C[1], &A3)?;
        self.stage(equation, start, C[2], &A4)?;
        self.stage(equation, start, C[3], &A5)?;
        self.stage(equation, start, C[4], &A6)?;
        self.stage(equation, start, C[5], &A7)?;
        self.stage(equation, start, C[6], &A8)?;
        self.stage(equation, start, C[7], &A9)?;
        self.stage(equation, start, C[8], &A10)?;
        self.stage(equation, start, C[9], &A11)?;
        self.stage(equation, start, C[10], &A12)?;
        let b = weighted(&B, &self.k);
        self.end = State {
            time: start.time + h,
            coordinate: start.coordinate + h * b[0],
            speed: start.speed + h * b[1],
        };
        Ok(Attempt { end: self.end, error: self.error(&b, scale) })
    }

    fn finish(&mut self, equation: &mut Equation<'_>) -> Result<f64, MotionError> {
        let State { time, coordinate, speed } = self.end;
        self.k[12] = [speed, equation.acceleration(time, coordinate, speed)?];
        Ok(self.k[12][1])
    }

    fn dense(&mut self, equation: &mut Equation<'_>, from: &Node, to: &Node) -> Result<Dense, MotionError> {
        let (h, start) = (self.h, &from.state);
        self.stage(equation, start, C_DENSE[0], &A14)?;
        self.stage(equation, start, C_DENSE[1], &A15)?;
        self.stage(equation, start, C_DENSE[2], &A16)?;
        let mut dense = Dense::steady(start, h);
        let (first, last) = (self.k[0], self.k[12]);
        cubic(&mut dense.coordinate, start.coordinate, to.state.coordinate, h * first[0], h * last[0]);
        cubic(&mut dense.speed, start.speed, to.state.speed, h * first[1], h * last[1]);
        for (index, weights) in D.iter().enumerate() {
            let [q, w] = weighted(weights, &self.k);
            dense.coordinate[4 + index] = h * q;
            dense.speed[4 + index] = h * w;
        }
        Ok(dense)
    }
}
