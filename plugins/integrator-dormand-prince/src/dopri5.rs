//! One step of Dormand-Prince 5(4).

use assur_integrator::{Attempt, Control, Dense, Equation, MotionError, Node, Pace, State, Step, Stepper};

use crate::dopri5_table::{A, C, D, E};
use crate::stages::Stages;

/// The seven stages of the last step.
#[derive(Debug, Default)]
pub(crate) struct Dopri5(Stages<7>);

impl Stepper for Dopri5 {
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

    fn attempt(&mut self, step: Step<'_, '_>) -> Result<Attempt, MotionError> {
        let stages = &mut self.0;
        stages.begin(&step);
        let Step { equation, from, length: h, scale } = step;
        let mut end = from.state;
        for (c, weights) in C.into_iter().zip(A) {
            end = stages.stage(equation, c, weights)?;
        }
        let [q, w] = stages.weighted(&E);
        Ok(Attempt { end, error: scale.norm(&end, h * q, h * w) })
    }

    fn finish(&mut self, _: &mut Equation<'_>, _: &State) -> Result<f64, MotionError> {
        Ok(self.0.k[6][1])
    }

    fn dense(&mut self, _: &mut Equation<'_>, from: &Node, to: &Node) -> Result<Dense, MotionError> {
        let h = self.0.h;
        let mut dense = Dense::cubic(from, to, h);
        let [q, w] = self.0.weighted(&D);
        dense.coordinate[4] = h * q;
        dense.speed[4] = h * w;
        Ok(dense)
    }
}
