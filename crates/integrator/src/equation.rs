//! The equation with a counter: every evaluation of every method is counted here.

use crate::{EquationOfMotion, MotionError, Partials, Piece, SolutionCost, State};

/// The equation of motion as a step sees it.
pub struct CountedEquation<'a> {
    motion: &'a mut dyn EquationOfMotion,
    evaluations: usize,
    jacobians: usize,
    pieces: usize,
}

impl std::fmt::Debug for CountedEquation<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("CountedEquation").field("evaluations", &self.evaluations).finish_non_exhaustive()
    }
}

impl<'a> CountedEquation<'a> {
    /// Counts from zero.
    pub fn new(motion: &'a mut dyn EquationOfMotion) -> Self {
        Self { motion, evaluations: 0, jacobians: 0, pieces: 0 }
    }

    /// A statistic with the counts of this equation.
    pub(crate) fn counted(&self, statistics: SolutionCost) -> SolutionCost {
        let Self { evaluations, jacobians, pieces, .. } = *self;
        SolutionCost { evaluations, jacobians, pieces, ..statistics }
    }

    /// The moment depends on time.
    pub fn depends_on_time(&self) -> bool {
        self.motion.dependence().moment_on_time
    }

    /// The moment depends on the acceleration: dry friction through inertia loads.
    pub fn depends_on_acceleration(&self) -> bool {
        self.motion.dependence().moment_on_acceleration
    }

    /// Enters the piece just after `state`, see [`EquationOfMotion::enter`].
    pub fn enter(&mut self, state: &State) -> Result<Piece, MotionError> {
        self.pieces += 1;
        self.motion.enter(state)
    }

    /// Acceleration at a state, by the formulas of the present piece.
    #[inline]
    pub fn acceleration(&mut self, state: &State) -> Result<f64, MotionError> {
        self.evaluations += 1;
        self.motion.acceleration(state)
    }

    /// J and Q at a coordinate, for the energy form; counts as one evaluation.
    ///
    /// # Errors
    ///
    /// [`MotionError`] of the equation, or if J is not positive or either is not finite.
    #[inline]
    pub fn work(&mut self, state: &State) -> Result<(f64, f64), MotionError> {
        self.evaluations += 1;
        let reduced = self.motion.reduced(state)?;
        reduced.acceleration(state.speed)?;
        Ok((reduced.inertia, reduced.moment))
    }

    /// The [`EquationOfMotion::bends`] at a state; counts as one evaluation.
    ///
    /// # Errors
    ///
    /// [`MotionError`] of the equation.
    pub(crate) fn bends(&mut self, state: &State) -> Result<Vec<f64>, MotionError> {
        self.evaluations += 1;
        self.motion.bends(state)
    }

    /// Partial derivatives of the acceleration: from the equation, else by forward differences from
    /// `acceleration`, its value at `state`.
    pub fn partials(&mut self, state: &State, acceleration: f64) -> Result<Partials, MotionError> {
        self.jacobians += 1;
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
