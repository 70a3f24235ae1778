//! J constant and M(t) (D's case 2): w = w0 + (1/J) ∫ M dt, and the displacement by a second integral, without stages
//! that depend on each other. Exact where M is a polynomial of degree 4 or less, as between the rows of a table over
//! time.

use assur_integrator::{
    Attempt, COEFFICIENTS, Control, CountedEquation, Dense, MotionError, Node, Pace, State, Step, Stepper,
};

/// Nodes of a step from 0 to 1: those of Lobatto, which include both ends.
const NODES: [f64; 5] = [0.0, 0.172_673_164_646_011_42, 0.5, 0.827_326_835_353_988_6, 1.0];

/// Places between them at which the polynomial is compared with the equation: near its largest deviations.
const TRIALS: [f64; 3] = [0.07, 0.33, 0.67];

/// Step sizes grow without limit: with a table over time there is no error to estimate.
const CONTROL: Control =
    Control { proportional: 0.2, integral: 0.0, safety: 0.9, shrink: 0.2, grow: 1e3, order: 5.0 };

/// The last step: speed and displacement inside it, as powers of the relative time in the step.
#[derive(Debug, Default)]
pub(crate) struct Impulse {
    speed: [f64; COEFFICIENTS],
    way: [f64; COEFFICIENTS],
    acceleration: f64,
}

impl Stepper for Impulse {
    const PACE: Pace = Pace::Adaptive(CONTROL);

    fn attempt(&mut self, step: Step<'_, '_>) -> Result<Attempt, MotionError> {
        let Step { equation, from, length: h, scale } = step;
        let State { time, coordinate, speed } = from.state;
        let mut at = |part: f64| equation.acceleration(&State { time: time + part * h, ..from.state });
        let mut values = [from.acceleration; NODES.len()];
        for (value, node) in values.iter_mut().zip(NODES).skip(1) {
            *value = at(node)?;
        }
        let power = interpolated(values);
        let mut deviation = 0.0_f64;
        for part in TRIALS {
            deviation = deviation.max((at(part)? - polynomial(&power, part)).abs());
        }
        self.acceleration = values[NODES.len() - 1];
        self.speed = integrated(&power, h, speed);
        self.way = integrated(&self.speed, h, coordinate);
        let end = State {
            time: time + h,
            coordinate: polynomial(&self.way, 1.0),
            speed: polynomial(&self.speed, 1.0),
        };
        let error = scale.norm(&end, 0.5 * h * h * deviation, h * deviation);
        Ok(Attempt { end, error })
    }

    fn finish(&mut self, _: &mut CountedEquation<'_>, _: &State) -> Result<f64, MotionError> {
        Ok(self.acceleration)
    }

    fn dense(&mut self, _: &mut CountedEquation<'_>, from: &Node, to: &Node) -> Result<Dense, MotionError> {
        Ok(Dense {
            time: from.state.time,
            step: to.state.time - from.state.time,
            coordinate: nested(self.way),
            speed: nested(self.speed),
        })
    }
}

/// Powers of the polynomial through the values at the nodes, by divided differences (Newton).
fn interpolated(mut values: [f64; NODES.len()]) -> [f64; COEFFICIENTS] {
    let last = NODES.len() - 1;
    for level in 1..=last {
        for i in (level..=last).rev() {
            values[i] = (values[i] - values[i - 1]) / (NODES[i] - NODES[i - level]);
        }
    }
    let mut power = [0.0; COEFFICIENTS];
    for i in (0..=last).rev() {
        // power := power * (x - node) + value
        for k in (0..=last).rev() {
            let below = if k > 0 { power[k - 1] } else { 0.0 };
            power[k] = below - NODES[i] * power[k];
        }
        power[0] += values[i];
    }
    power
}

fn polynomial(power: &[f64; COEFFICIENTS], x: f64) -> f64 {
    power.iter().rev().fold(0.0, |sum, coefficient| sum * x + coefficient)
}

/// Integral over a step of `h`, with a first value; the degree must leave room for one more power.
fn integrated(power: &[f64; COEFFICIENTS], h: f64, first: f64) -> [f64; COEFFICIENTS] {
    std::array::from_fn(|k| if k == 0 { first } else { h * power[k - 1] / k as f64 })
}

/// The nested form of [`Dense`]: factors x and 1 - x are divided out in turn.
fn nested(mut power: [f64; COEFFICIENTS]) -> [f64; COEFFICIENTS] {
    std::array::from_fn(|k| {
        if k % 2 == 0 {
            // P = P(0) + x Q
            let value = power[0];
            power.copy_within(1.., 0);
            power[COEFFICIENTS - 1] = 0.0;
            value
        } else {
            // P = P(1) + (1 - x) Q: the coefficients of Q are the sums of all higher ones, with the other sign.
            let value = polynomial(&power, 1.0);
            let mut sum = 0.0;
            for coefficient in power.iter_mut().rev() {
                let own = *coefficient;
                *coefficient = -sum;
                sum += own;
            }
            value
        }
    })
}

#[cfg(test)]
mod tests;
