//! What was found, as plain data.
//!
//! [`Analysis`] serializes to the JSON of the program. Everything is SI, angles in rad.

mod analysis;
mod course;
mod cycle;
mod dynamics;
mod named;
mod position;
mod regime;
mod structure;

pub use analysis::{Analysis, CheckRow, Failure, InputReport};
pub use course::{Energy, EventRow, Instant, Integration, Spot, Trajectory};
pub use cycle::{ByCause, Cycle, PositionPlans};
pub use dynamics::{Dynamics, MotorReport};
pub use named::Named;
pub use position::{Derivatives, PairReaction, PositionResult, Rates, Reduced, Transfer};
pub use regime::{CourseRow, MotorWork, PointReport, RegimeReport, RunnerUp};
pub use structure::{GroupReport, StructureReport};
