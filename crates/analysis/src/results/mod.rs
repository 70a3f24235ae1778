//! The results as plain data.
//!
//! Everything is SI, angles in rad. Results of a stage keep that stage's types; the types here are those that only
//! results need.
//!
//! What is found in the positions, and in the samples of a motion, are tables ([`Table`]): a [`Schema`], made once for a
//! scene, says what each column holds (quantity, owner, part; unit), and the numbers lie column by column. A position
//! without a solution has no row; columns that only some rows have (reactions, not determined at change points; the
//! condition of a group, infinite at singular positions) form a [`Section`] with a mark for each row.
//!
//! ```no_run
//! use assur_analysis::results::{Column, Owner, Part, Quantity, Table};
//!
//! // Velocity of point 2 along x in the position number 7; the greatest balancing load.
//! # fn f(positions: &Table) -> Option<()> {
//! let row = positions.row_of(7)?;
//! let velocity = positions.get(row, Column::of(Quantity::Velocity, Owner::Point(2)).part(Part::X))?;
//! let loads = positions.each(positions.schema().find(Column::BALANCING)?).flatten();
//! let greatest = loads.map(f64::abs).reduce(f64::max)?;
//! # Some(()) }
//! ```

mod analysis;
mod column;
mod dynamics;
mod schema;
pub(crate) mod structure;
mod survey;
mod table;

pub use crate::angles::Starts;
pub use crate::edges::Edges;
pub use crate::extremes::{Means, Peaks, Turn};
pub use crate::friction::FrictionCycle;
pub use crate::several::{ForceOrMoment, Several, SolutionReport};
pub use analysis::{
    Analysis, Checks, Cycle, Energy, Failure, InputReport, Integration, PositionPlans, Residual,
};
pub use assur_check::{Check, Finding, verdict};
pub use assur_dynamics::{
    Advice, AdvisedRegime, Effort, Figures, FlywheelByMethod, Iteration, MotorWork, Regime, RegimeState,
    SteadyMotor, Trial,
};
pub use assur_integrator::{Event, SolutionCost, State};
pub use assur_number::{Extreme, Statistic};
pub use column::{Column, Owner, Part, Quantity};
pub use dynamics::{Dynamics, EnergyMass, EnergyMassTangent, RegimeOverCycle};
pub use schema::{Schema, Section};
pub use structure::{GroupReport, ModeReport, StructureReport};
pub use survey::Survey;
pub use table::{Cells, Mask, Table};
