//! One step of Dormand-Prince 5(4).

use assur_integrator::{
    Attempt, Control, CountedEquation, Dense, MotionError, Node, Pace, State, Step, Stepper,
};

use crate::Stages;

/// The seven stages of the last step.
#[derive(Debug, Default)]
pub(crate) struct Dopri5(Stages<7>);

impl Stepper for Dopri5 {
    // Hairer's beta = 0.04 of the code DOPRI5: proportional 1/5 - 0.75 beta.
    const PACE: Pace = Pace::Adaptive(Control {
        proportional: 0.17,
        integral: 0.04,
        safety: 0.9,
        shrink: 0.2,
        grow: 10.0,
        order: 5.0,
    });

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

    fn finish(&mut self, _: &mut CountedEquation<'_>, _: &State) -> Result<f64, MotionError> {
        Ok(self.0.k[6][1])
    }

    fn dense(&mut self, _: &mut CountedEquation<'_>, from: &Node, to: &Node) -> Result<Dense, MotionError> {
        let h = self.0.h;
        let mut dense = Dense::cubic(from, to, h);
        let [q, w] = self.0.weighted(&D);
        dense.coordinate[4] = h * q;
        dense.speed[4] = h * w;
        Ok(dense)
    }
}

/// Nodes of stages 2 to 7.
pub(crate) const C: [f64; 6] = [1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0];

/// Weights of stages 2 to 7; the last stage is the solution of order 5.
pub(crate) const A: [&[f64]; 6] = [
    &[1.0 / 5.0],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
    &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
    &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];

/// Weights of the error: order 5 less order 4.
pub(crate) const E: [f64; 7] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339_200.0, 22.0 / 525.0, -1.0 / 40.0];

/// Weights of the fifth coefficient of the dense output.
pub(crate) const D: [f64; 7] = [
    -12_715_105_075.0 / 11_282_082_432.0,
    0.0,
    87_487_479_700.0 / 32_700_410_799.0,
    -10_690_763_975.0 / 1_880_347_072.0,
    701_980_252_875.0 / 199_316_789_632.0,
    -1_453_857_185.0 / 822_651_844.0,
    69_997_945.0 / 29_380_423.0,
];
