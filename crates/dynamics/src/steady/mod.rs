//! The steady regime: the periodic speed over a cycle, and the ratio and flywheel for a requested mean speed and
//! unevenness.
//!
//! [`RegimeSolver`] evaluates the machine over one cycle: J, J' and Q at the nodes of panels between all jumps of the loads.
//! Everything after that (shooting, ratio, flywheel) reuses them, unless a load depends on the speed.
//! [`RegimeSolver::solve`] finds a [`Regime`].
//!
//! Along the cycle the variable is the path coordinate x = sense * (q - q0), which grows with the motion, and the speed
//! v = sense * w is positive. The equation J e + J' w²/2 = Q reads d(J v²/2)/dx = M there, M the moment along the motion: the
//! kinetic energy T(x) is the integral of the moment (E eq. 1). On each panel it is found by collocation.

mod diagram;
mod path;
mod regime;
mod run;
mod segment;
mod shooting;
mod solution;
mod solver;
mod switch;
mod tuning;

pub use regime::{CycleRequest, DriveRequest, Effort, Figures, FlywheelByMethod, Regime, TorqueRequest};
pub use solution::{Iteration, RegimeState};
pub use solver::RegimeSolver;
pub use tuning::Trial;
