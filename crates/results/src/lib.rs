//! What was found, as plain data, and the three forms in which it is handed over: text, JSON, CSV.
//!
//! [`Analysis`] serializes to the JSON of the program; [`json`], [`text`] and [`csv`] write it to a string or a writer and
//! touch no file. Everything is SI, angles in rad; only the text report converts (degrees, millimeters).

mod analysis;
mod course;
pub mod csv;
mod cycle;
mod dynamics;
mod fold;
pub mod json;
mod named;
mod position;
mod regime;
mod structure;
pub mod text;

pub use analysis::{Analysis, CheckRow, Failure, InputReport};
pub use course::{Energy, EventRow, Instant, Integration, Spot, Trajectory};
pub use cycle::{ByCause, Cycle, PositionPlans};
pub use dynamics::{Dynamics, MotorReport};
pub use fold::to_ascii;
pub use named::Named;
pub use position::{Derivatives, PairReaction, PositionResult, Rates, Reduced, Transfer};
pub use regime::{
    CourseRow, FlywheelRow, MotorWork, PointReport, RegimeReport, RunnerUp, TrialRow, TurnRow, WheelRow,
};
pub use structure::{GroupReport, StructureReport};

#[cfg(test)]
mod tests;
