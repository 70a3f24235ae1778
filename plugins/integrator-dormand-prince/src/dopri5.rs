//! One step of Dormand-Prince 5(4).

use assur_integrator::{
    Attempt, Control, Dense, Equation, MotionError, Node, Pace, Scale, State, Stepper, cubic,
};

use crate::dopri5_table::{A2, A3, A4, A5, A6, B, C, D, E};
use crate::stages::{Slope, weighted};

/// The seven stages of the last step.
#[derive(Debug, Clone, Default)]
pub(crate) struct Stages {
    k: [Slope; 7],
    h: f64,
}

impl Stages {
    #[inline]
    fn stage<const N: usize>(
        &mut self,
        equation: &mut Equation<'_>,
        from: &State,
        c: f64,
        weights: &[f64; N],
    ) -> Result<State, MotionError> {
        let [dq, dw] = weighted(weights, &self.k);
        let state = State {
            time: from.time + c * self.h,
            coordinate: from.coordinate + self.h * dq,
            speed: from.speed + self.h * dw,
        };
        self.k[N] = [state.speed, equation.acceleration(state.time, state.coordinate, state.speed)?];
        Ok(state)
    }
}

impl Stepper for Stages {
    fn pace(&self) -> Pace {
        // Hairer's beta = 0.04 of the code DOPRI5: proportional 1/5 - 0.75 beta.
        Pace::Adaptive(Control {
            proportional: 0.17,
            integral: 0.04,
            safety: 0.9,
            shrink: 0.2,
            grow: 10.0,
            order: 5.0,
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
        let end = self.stage(equation, start, C[5], &B)?;
        let [q, w] = weighted(&E, &self.k);
        Ok(Attempt { end, error: scale.norm(&end, h * q, h * w) })
    }

    fn finish(&mut self, _: &mut Equation<'_>) -> Result<f64, MotionError> {
        Ok(self.k[6][1])
    }

    fn dense(&mut self, _: &mut Equation<'_>, from: &Node, to: &Node) -> Result<Dense, MotionError> {
        let h = self.h;
        let mut dense = Dense::steady(&from.state, h);
        let (first, last) = (self.k[0], self.k[6]);
        cubic(&mut dense.coordinate, from.state.coordinate, to.state.coordinate, h * first[0], h * last[0]);
        cubic(&mut dense.speed, from.state.speed, to.state.speed, h * first[1], h * last[1]);
        let [q, w] = weighted(&D, &self.k);
        dense.coordinate[4] = h * q;
        dense.speed[4] = h * w;
        Ok(dense)
    }
}
