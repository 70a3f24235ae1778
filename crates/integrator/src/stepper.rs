//! What a one-step method must provide to the driver.

use crate::{Control, CountedEquation, Dense, MotionError, Scale, State};

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
#[derive(Debug)]
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
    /// A step is a parabola in time, and its dense output is exact at each instant.
    const PARABOLIC: bool = false;

    /// The method is implicit: stiffness does not force short steps.
    const IMPLICIT: bool = false;

    /// Bound of step times eigenvalue beyond which the method is unstable where the equation is damped: checked at a
    /// fixed step.
    const STABLE: f64 = f64::INFINITY;

    /// What sets the length of a step.
    fn pace(&self) -> Pace;

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

    /// The inside of the last step, from `from` to `to`.
    ///
    /// # Errors
    ///
    /// [`MotionError`] if an extra stage fails.
    fn dense(
        &mut self,
        equation: &mut CountedEquation<'_>,
        from: &Node,
        to: &Node,
    ) -> Result<Dense, MotionError>;
}
