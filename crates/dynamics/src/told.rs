//! An equation of motion that tells how far its solution is, and can be stopped.

use std::ops::ControlFlow;

use assur_integrator::{Dependence, Motion, MotionError, Partials, Piece, Reduced, State};

/// Is told of every state in which an equation of motion is evaluated; breaks where the solution is to be stopped.
pub type Tell<'t> = dyn FnMut(&State) -> ControlFlow<()> + 't;

/// Why a motion that was stopped has no solution.
#[derive(Debug, Clone, Copy, thiserror::Error)]
#[error("stopped on request")]
struct Stopped;

/// An equation of motion with somebody who is told.
pub(crate) struct Told<'a, 't> {
    pub(crate) motion: &'a mut dyn Motion,
    pub(crate) tell: &'a mut Tell<'t>,
}

impl Motion for Told<'_, '_> {
    fn dependence(&self) -> Dependence {
        self.motion.dependence()
    }

    fn enter(&mut self, state: &State) -> Result<Piece, MotionError> {
        self.motion.enter(state)
    }

    fn reduced(&mut self, state: &State) -> Result<Reduced, MotionError> {
        match (self.tell)(state) {
            ControlFlow::Continue(()) => self.motion.reduced(state),
            ControlFlow::Break(()) => Err(MotionError::mechanism(Stopped)),
        }
    }

    fn partials(&mut self, state: &State) -> Result<Option<Partials>, MotionError> {
        self.motion.partials(state)
    }
}
