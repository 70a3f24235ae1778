//! An equation of motion that reports the progress of its solution, and can be stopped.

use std::ops::ControlFlow;

use assur_integrator::{Dependence, Motion, MotionError, Partials, Piece, Reduced, State};

/// Called with every state in which an equation of motion is evaluated; breaks to stop the solution.
pub type Watcher<'w> = dyn FnMut(&State) -> ControlFlow<()> + 'w;

/// Why a motion that was stopped has no solution.
#[derive(Debug, Clone, Copy, thiserror::Error)]
#[error("stopped on request")]
struct Stopped;

/// An equation of motion and who watches it, if anybody.
pub(crate) struct Watched<'a, 'w> {
    pub(crate) motion: &'a mut dyn Motion,
    pub(crate) watcher: Option<&'a mut Watcher<'w>>,
}

impl Motion for Watched<'_, '_> {
    fn dependence(&self) -> Dependence {
        self.motion.dependence()
    }

    fn enter(&mut self, state: &State) -> Result<Piece, MotionError> {
        self.motion.enter(state)
    }

    fn reduced(&mut self, state: &State) -> Result<Reduced, MotionError> {
        let flow = self.watcher.as_mut().map_or(ControlFlow::Continue(()), |watcher| watcher(state));
        if flow.is_break() {
            return Err(MotionError::mechanism(Stopped));
        }
        self.motion.reduced(state)
    }

    fn partials(&mut self, state: &State) -> Result<Option<Partials>, MotionError> {
        self.motion.partials(state)
    }
}
