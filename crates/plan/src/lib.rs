//! What a scene needs, and by which method.
//!
//! [`Plan::of`] reads the content of a mechanism and what it asks for, and says which stages are run and why, which are
//! left out and why, which groups must be solved and to which order. The calculation obeys the plan; `explain` prints it.
//! Nothing is calculated here.

mod carry;
mod explain;
mod kinematics;
mod missing;
mod model;
mod needs;
mod order;
mod plan;
mod stages;
mod words;

pub use explain::explain;
pub use missing::not_modelled;
pub use model::{Remark, modelled};
pub use plan::{Methods, Plan, Stage, Wanted};

#[cfg(test)]
mod tests;
