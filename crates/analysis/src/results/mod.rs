//! The results as plain data.
//!
//! [`Analysis`] serializes to the JSON of the program. Everything is SI, angles in rad. Results of a stage keep that
//! stage's types; the types here are those that only results need.

mod analysis;
mod cycle;
mod dynamics;
mod motion;
mod named;
mod position;
mod structure;

pub use analysis::{Analysis, Failure, InputReport};
pub use assur_check::Check;
pub use assur_dynamics::{Effort, FlywheelByMethod, Iteration, Trial};
pub use assur_integrator::{Event, Reduced, State, Statistics};
pub use assur_kinematics::{PointMotion, ScalarMotion};
pub use cycle::{ByCause, Cycle, PositionPlans};
pub use dynamics::{Dynamics, MotorReport, MotorWork, PointReport, RegimePoint, RegimeReport, RunnerUp};
pub use motion::{Energy, Integration, MotionSample, PointPosition};
pub use named::Named;
pub use position::{PairReaction, PositionResult, Rates};
pub use structure::{GroupReport, StructureReport};
