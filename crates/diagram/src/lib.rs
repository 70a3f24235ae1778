//! The diagrams that accompany a calculation, as plain data to draw or to print; nothing is drawn here.
//!
//! * [`force_polygons`]: loads and reactions of every group and of the input link, head to tail.
//! * [`velocity_plan`], [`acceleration_plan`]: pole, images of the points, the parts of each vector.
//! * [`construction_plans`]: the construction of a force analyzer (longitudinal reactions, Zhukovsky's lever).
//! * [`split`]: reactions by cause; [`Hodograph`], [`sign_changes`]: reactions over the cycle.
//! * [`friction_circle`], [`friction_cone`]: a reaction beside the friction of its pair.
//! * [`enveloping`]: the straight line that an arc envelopes.
//! * [`sheet`]: all plans of one position.
//!
//! SI units. Knows no terminal, no file and no concrete method.

mod construction;
mod cycle;
mod enveloping;
mod error;
mod friction;
mod motion_plan;
mod plan;
mod polygon;
mod sheet;
mod sign;

pub use assur_force::VectorKind;
pub use construction::{StepInPicture, construction_picture, construction_plans};
pub use cycle::{Hodograph, ReactionExtreme, Sizes};
pub use enveloping::{Enveloping, EnvelopingPoint, enveloping};
pub use error::DiagramError;
pub use friction::{friction_circle, friction_cone};
pub use motion_plan::{acceleration_plan, velocity_plan};
pub use plan::{PlanPoint, PlanVector, VectorPlan};
pub use polygon::force_polygons;
pub use sheet::{JointForce, PlanSheet, Share, Split, constructions, sheet, split};
pub use sign::{SignChange, Solver, sign_changes};

assur_words::resources!();

#[cfg(test)]
mod tests;
