//! What a one-step method must provide to the driver; and the equation with a counter: every evaluation of every method is counted
//! here.

use crate::{
    Control, Dense, Dependence, EquationOfMotion, MotionError, Partials, Piece, Scale, SolutionCost, State,
    Stretch,
};

/// A state and its acceleration.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Node {
    /// State.
    pub state: State,
    /// Acceleration by the formulas of the present piece, rad/s² (m/s²).
    pub acceleration: f64,
}

impl Node {
    /// The state that uniformly accelerated motion reaches in `step` seconds.
    pub fn advanced(&self, step: f64) -> State {
        let State { time, coordinate, speed } = self.state;
        State {
            time: time + step,
            coordinate: coordinate + step * (speed + 0.5 * step * self.acceleration),
            speed: speed + step * self.acceleration,
        }
    }
}

/// What sets the length of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pace {
    /// The request: a fixed step.
    Fixed,
    /// The error estimate.
    Adaptive(Control),
    /// Nothing: a step is exact at any length.
    Unlimited,
}

/// A step to be tried.
pub struct Step<'a, 'm> {
    /// The equation, in the piece of the step.
    pub equation: &'a mut CountedEquation<'m>,
    /// Its start.
    pub from: Node,
    /// Its length, s.
    pub length: f64,
    /// Scale of the errors.
    pub scale: Scale,
}

/// A tried step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attempt {
    /// State at the end of the step.
    pub end: State,
    /// Estimated error divided by the tolerance (accepted up to 1); infinite if the step could not be computed.
    pub error: f64,
}

/// A one-step method. The driver does the rest: pieces, events, ends, samples, size of steps.
///
/// The order of calls for a step: [`attempt`](Self::attempt); if its error passes, [`finish`](Self::finish);
/// then, only where a sample or an event needs the inside of the step, [`dense`](Self::dense).
pub trait Stepper: Default {
    /// What sets the length of a step.
    const PACE: Pace;

    /// A step is a parabola in time, and its dense output is exact at each instant.
    const PARABOLIC: bool = false;

    /// The method is implicit: stiffness does not force short steps.
    const IMPLICIT: bool = false;

    /// Bound of step times eigenvalue beyond which the method is unstable where the equation is damped: checked at a
    /// fixed step.
    const STABLE: f64 = f64::INFINITY;

    /// Tries a step.
    ///
    /// # Errors
    ///
    /// [`MotionError`] if the equation fails at a stage; the driver tries a shorter step.
    fn attempt(&mut self, step: Step<'_, '_>) -> Result<Attempt, MotionError>;

    /// Acceleration at the end of the last attempt.
    fn finish(&mut self, equation: &mut CountedEquation<'_>, end: &State) -> Result<f64, MotionError> {
        equation.acceleration(end)
    }

    /// The inside of the last step, from `from` to `to`: by default the parabola, or the polynomials through both ends.
    fn dense(
        &mut self,
        equation: &mut CountedEquation<'_>,
        from: &Node,
        to: &Node,
    ) -> Result<Dense, MotionError> {
        let _ = equation;
        let step = to.state.time - from.state.time;
        Ok(if Self::PARABOLIC { Dense::parabola(from, step) } else { Dense::hermite(from, to) })
    }
}

/// The equation of motion as a step sees it.
pub struct CountedEquation<'a> {
    motion: &'a mut dyn EquationOfMotion,
    /// What the solution has cost so far.
    pub cost: SolutionCost,
}

impl<'a> CountedEquation<'a> {
    /// Counts from zero.
    pub fn new(motion: &'a mut dyn EquationOfMotion) -> Self {
        Self { motion, cost: SolutionCost::default() }
    }

    /// What J and Q depend on.
    pub fn dependence(&self) -> Dependence {
        self.motion.dependence()
    }

    /// Enters the piece just after `state`, see [`EquationOfMotion::enter`].
    pub fn enter(&mut self, state: &State) -> Result<Piece, MotionError> {
        self.cost.pieces += 1;
        self.motion.enter(state)
    }

    /// Whether the formulas of the present piece hold throughout a stretch, see [`EquationOfMotion::holds`].
    pub(crate) fn holds(&self, stretch: &Stretch) -> Option<bool> {
        self.motion.holds(stretch)
    }

    /// Acceleration at a state, by the formulas of the present piece.
    #[inline]
    pub fn acceleration(&mut self, state: &State) -> Result<f64, MotionError> {
        self.cost.evaluations += 1;
        self.motion.acceleration(state)
    }

    /// J and Q at a coordinate, for the energy form; counts as one evaluation.
    ///
    /// # Errors
    ///
    /// [`MotionError`] of the equation, or if J is not positive or either is not finite.
    #[inline]
    pub fn work(&mut self, state: &State) -> Result<(f64, f64), MotionError> {
        self.cost.evaluations += 1;
        let reduced = self.motion.reduced(state)?;
        reduced.acceleration(state.speed)?;
        Ok((reduced.inertia, reduced.moment))
    }

    /// The [`EquationOfMotion::bends`] at a state; counts as one evaluation.
    pub(crate) fn bends(&mut self, state: &State) -> Result<Vec<f64>, MotionError> {
        self.cost.evaluations += 1;
        self.motion.bends(state)
    }

    /// Partial derivatives of the acceleration: from the equation, else by forward differences from
    /// `acceleration`, its value at `state`.
    pub fn partials(&mut self, state: &State, acceleration: f64) -> Result<Partials, MotionError> {
        self.cost.jacobians += 1;
        if let Some(partials) = self.motion.partials(state)? {
            return Ok(partials);
        }
        let State { coordinate: q, speed: w, .. } = *state;
        let (dq, dw) = (increment(q), increment(w));
        let by_coordinate = (self.acceleration(&State { coordinate: q + dq, ..*state })? - acceleration) / dq;
        let by_speed = (self.acceleration(&State { speed: w + dw, ..*state })? - acceleration) / dw;
        Ok(Partials { by_coordinate, by_speed })
    }

    /// Largest modulus of the eigenvalues of the equation at a state, 1/s.
    pub fn eigenvalue(&mut self, state: &State) -> Result<f64, MotionError> {
        let acceleration = self.acceleration(state)?;
        let Partials { by_coordinate, by_speed } = self.partials(state, acceleration)?;
        let discriminant = by_speed * by_speed + 4.0 * by_coordinate;
        Ok(if discriminant < 0.0 {
            (-by_coordinate).sqrt()
        } else {
            0.5 * (by_speed.abs() + discriminant.sqrt())
        })
    }
}

/// Increment of a forward difference: half of the digits of the value, which balances truncation and rounding error.
/// Adding and subtracting makes it exact in binary.
fn increment(value: f64) -> f64 {
    /// Below this size a value counts as this size.
    const SMALL: f64 = 1e-4;
    let wanted = f64::EPSILON.sqrt() * value.abs().max(SMALL);
    (value + wanted) - value
}

#[cfg(test)]
mod tests;
