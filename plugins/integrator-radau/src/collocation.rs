//! One step of Radau IIA with three stages.

use assur_integrator::{
    Attempt, Control, CountedEquation, Dense, MotionError, Node, Pace, Partials, Scale, State, Step, Stepper,
};
use assur_number::elementary;
use assur_number::elimination::Lu;
use nalgebra::{Matrix3, Vector3};

/// Most iterations of Newton's method.
const ITERATIONS: usize = 8;

/// Error of an attempt whose Newton iteration did not converge: treated like a step that is much too long.
const DIVERGED: Attempt =
    Attempt { end: State { time: 0.0, coordinate: 0.0, speed: 0.0 }, error: f64::INFINITY };

/// The last step.
#[derive(Debug, Default)]
pub(crate) struct Collocation {
    h: f64,
    /// Increments of coordinate and speed at the three nodes.
    increments: [Vector3<f64>; 2],
    /// Partials at the start of the present step, with the state that they belong to.
    partials: Option<(State, Partials)>,
    /// The last good step, to start the iteration from: its end, its length and its speed increments.
    before: Option<(State, f64, Vector3<f64>)>,
    /// The last attempt passed. If not, or if there was none, the error is filtered twice where it is large.
    passed: bool,
}

/// Cubic through 0 at 0 and these values at the nodes, at `theta`; and its slope.
fn interpolate(values: &Vector3<f64>, theta: f64) -> (f64, f64) {
    let nodes = [0.0, C[0], C[1], C[2]];
    let (mut value, mut slope) = (0.0, 0.0);
    for i in 1..4 {
        let others = (0..4).filter(|j| *j != i);
        let scale: f64 = others.clone().map(|j| nodes[i] - nodes[j]).product();
        let factors: [f64; 3] = std::array::from_fn(|k| theta - nodes[(i + 1 + k) % 4]);
        let [a, b, c] = factors;
        value += values[i - 1] * a * b * c / scale;
        slope += values[i - 1] * (a * b + b * c + a * c) / scale;
    }
    (value, slope)
}

impl Collocation {
    /// Coordinates of the stages from their speeds: h A w.
    fn coordinates(&self, speed: f64, speeds: &Vector3<f64>) -> Vector3<f64> {
        A * speeds.map(|increment| self.h * (speed + increment))
    }

    /// First guess of the stage speeds: the last step's polynomial continued, else uniformly accelerated.
    fn guess(&self, from: &Node) -> Vector3<f64> {
        match self.before {
            // A step that was cut at an event ended elsewhere; its polynomial is of no use then.
            Some((end, h, increments)) if end == from.state => {
                C.map(|c| interpolate(&increments, 1.0 + c * self.h / h).0 - increments[2])
            }
            _ => C.map(|c| c * self.h * from.acceleration),
        }
    }

    /// Newton's method for the stage speeds; none if it does not converge.
    fn solve(
        &mut self,
        equation: &mut CountedEquation<'_>,
        from: &Node,
        partials: &Partials,
        scale: &Scale,
    ) -> Result<Option<()>, MotionError> {
        let h = self.h;
        let Some(newton) = newton_matrix(h, partials) else { return Ok(None) };
        let State { time, coordinate, speed } = from.state;
        let stop = (10.0 * f64::EPSILON / scale.tolerance).max(0.03_f64.min(scale.tolerance.sqrt()));
        let mut speeds = self.guess(from);
        let (mut before, mut rate) = (0.0, 1.0_f64);
        for iteration in 0..ITERATIONS {
            let coordinates = self.coordinates(speed, &speeds);
            let mut accelerations = Vector3::zeros();
            for i in 0..3 {
                accelerations[i] = equation.acceleration(&State {
                    time: time + C[i] * h,
                    coordinate: coordinate + coordinates[i],
                    speed: speed + speeds[i],
                })?;
            }
            let change = Vector3::from(newton.solve(&(A * accelerations * h - speeds).into()));
            speeds += change;
            self.increments = [self.coordinates(speed, &speeds), speeds];
            let moved = A * change * h;
            let end =
                State { time, coordinate: coordinate + self.increments[0][2], speed: speed + speeds[2] };
            let size = (0..3).map(|i| scale.norm(&end, moved[i], change[i])).fold(0.0, f64::max);
            if iteration > 0 {
                rate = (size / before).max(1e-10);
                if rate >= 1.0 {
                    return Ok(None);
                }
            }
            // The remainder of a geometric series; before its rate is known, only a vanishing correction is accepted.
            let left = if iteration > 0 { rate / (1.0 - rate) * size } else { size };
            if left <= stop || size == 0.0 {
                return Ok(Some(()));
            }
            if !size.is_finite() {
                return Ok(None);
            }
            before = size;
        }
        Ok(None)
    }

    /// Error of order 3, filtered by (γ/h - Jacobian)^-1 so that stiff parts do not count twice (IV.8.20).
    fn error(
        &self,
        equation: &mut CountedEquation<'_>,
        (from, end): (&Node, &State),
        partials: &Partials,
        scale: &Scale,
    ) -> Result<f64, MotionError> {
        let State { time, coordinate, speed } = from.state;
        let sums = self.increments.map(|z| E.dot(&z) / self.h);
        let shift = GAMMA / self.h;
        // (shift, -1; -q, shift - w) x = b
        let solve = |b: [f64; 2]| {
            let (q, w) = (partials.by_coordinate, shift - partials.by_speed);
            let determinant = shift * w - q;
            [(b[0] * w + b[1]) / determinant, (q * b[0] + shift * b[1]) / determinant]
        };
        let [q, w] = solve([sums[0] + speed, sums[1] + from.acceleration]);
        let error = scale.norm(end, q, w);
        if error < 1.0 || self.passed {
            return Ok(error);
        }
        // On the first step and after a rejection the filter is applied twice.
        let corrected = State { time, coordinate: coordinate + q, speed: speed + w };
        let acceleration = equation.acceleration(&corrected)?;
        let [q, w] = solve([sums[0] + corrected.speed, sums[1] + acceleration]);
        Ok(scale.norm(end, q, w))
    }

    fn partials_at(
        &mut self,
        equation: &mut CountedEquation<'_>,
        from: &Node,
    ) -> Result<Partials, MotionError> {
        // Computed for each step and kept for its repetitions: two evaluations cost less than a slow iteration.
        if let Some((_, partials)) = self.partials.filter(|(state, _)| *state == from.state) {
            return Ok(partials);
        }
        let partials = equation.partials(&from.state, from.acceleration)?;
        self.partials = Some((from.state, partials));
        Ok(partials)
    }
}

/// Factors of I - h A de/dw - h² A² de/dq; none for a singular matrix.
fn newton_matrix(h: f64, partials: &Partials) -> Option<Lu<f64, 3>> {
    let matrix = A * (h * partials.by_speed) + A * A * (h * h * partials.by_coordinate);
    let newton = Matrix3::identity() - matrix;
    // Stored by columns.
    let lu = Lu::new(newton.transpose().into());
    (lu.factored.health > 0.0).then_some(lu)
}

impl Stepper for Collocation {
    const IMPLICIT: bool = true;

    const PACE: Pace = Pace::Adaptive(Control {
        proportional: 0.25,
        integral: 0.0,
        safety: 0.85,
        shrink: 0.2,
        grow: 8.0,
        order: 4.0,
    });

    fn attempt(&mut self, step: Step<'_, '_>) -> Result<Attempt, MotionError> {
        let Step { equation, from, length: h, mut scale } = step;
        self.h = h;
        // The tolerance of the error of order 3 at which the solution of order 5 has the requested accuracy (Hairer's code RADAU5).
        scale.tolerance = 0.1 * elementary::powf(scale.tolerance, 2.0 / 3.0);
        let partials = self.partials_at(equation, &from)?;
        if self.solve(equation, &from, &partials, &scale)?.is_none() {
            self.passed = false;
            return Ok(DIVERGED);
        }
        let end = State {
            time: from.state.time + h,
            coordinate: from.state.coordinate + self.increments[0][2],
            speed: from.state.speed + self.increments[1][2],
        };
        let error = self.error(equation, (&from, &end), &partials, &scale)?;
        self.passed = error <= 1.0;
        Ok(Attempt { end, error })
    }

    fn finish(&mut self, equation: &mut CountedEquation<'_>, end: &State) -> Result<f64, MotionError> {
        self.before = Some((*end, self.h, self.increments[1]));
        equation.acceleration(end)
    }

    fn dense(&mut self, _: &mut CountedEquation<'_>, from: &Node, to: &Node) -> Result<Dense, MotionError> {
        let slopes = self.increments.map(|z| [interpolate(&z, 0.0).1, interpolate(&z, 1.0).1]);
        Ok(Dense::with_slopes(&from.state, &to.state, self.h, slopes))
    }
}

/// √6.
const R: f64 = 2.449_489_742_783_178;

/// Nodes.
pub(crate) const C: Vector3<f64> = Vector3::new((4.0 - R) / 10.0, (4.0 + R) / 10.0, 1.0);

/// Stages; the last row is the solution.
pub(crate) const A: Matrix3<f64> = Matrix3::new(
    (88.0 - 7.0 * R) / 360.0,
    (296.0 - 169.0 * R) / 1800.0,
    (-2.0 + 3.0 * R) / 225.0,
    (296.0 + 169.0 * R) / 1800.0,
    (88.0 + 7.0 * R) / 360.0,
    (-2.0 - 3.0 * R) / 225.0,
    (16.0 - R) / 36.0,
    (16.0 + R) / 36.0,
    1.0 / 9.0,
);

/// Real eigenvalue of the inverse of [`A`]: 30/(6 + 81^(1/3) - 9^(1/3)).
pub(crate) const GAMMA: f64 = 3.637_834_252_744_496;

/// Weights of the stage increments in the error of order 3 (IV.8, with γ0 = 1/[`GAMMA`]).
pub(crate) const E: Vector3<f64> = Vector3::new(-(13.0 + 7.0 * R) / 3.0, (-13.0 + 7.0 * R) / 3.0, -1.0 / 3.0);
