//! The loads on the links, and the reactions in the pairs.
//!
//! * [`Loads`]: the loads of a mechanism as flat compiled formulas: wrenches on the links, reduction to the input link
//!   (theory of the project, section 3), energies, smooth pieces for integration.
//! * [`ForceAnalyzer`]: finds the reactions in all pairs and the balancing load; [`AnalyzerPlugin`] is its entry in the
//!   registry.
//! * [`Kinetostatics`], [`LaneKinetostatics`]: loads and reactions of one position after the other, or of eight at once.
//! * [`joints`]: what each pin and slide of the scene exerts, summed from the reactions in the pairs.
//!
//! Knows no concrete analyzer, no scene file and no method of integration. SI units; forces in the ground's frame; moments
//! counter-clockwise.
//!
//! The moment that holds a horizontal crank of 2 kg against its weight:
//!
//! ```
//! use assur_all as _; // the methods that ship
//! use assur_force::{Kinetostatics, LoadState, Loads, choose};
//! use assur_group::Order;
//!
//! let text = "gravity = 9.81\n[ground]\npoints = { O = 0 }\n\
//!     [link.crank]\npoints = { O = 0, A = 0.2 }\nmass = 2\ncenter = 0.1\n[input]\nlink = 'crank'\n[motion]\nspeed = 0";
//! let linkage = assur_kinematics::Linkage::compile(assur_scene::read("crank.toml", text)?)?;
//! let (loads, mut position) = (Loads::compile(&linkage)?, linkage.position());
//! linkage.solve(0.0, Order::Second, &mut position)?;
//! let mut forces = Kinetostatics::new(&linkage, &loads, choose(None, false, false)?.instance, &[]);
//! forces.solve(&LoadState::prescribed(&linkage.mechanism, 0.0), &position)?;
//! assert!((forces.reactions.balancing - 2.0 * 9.81 * 0.1).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod analyzer;
mod balance;
mod breaks;
mod choice;
mod compile;
mod construction;
mod curve;
mod error;
mod formula;
mod friction;
mod grid;
mod group_by_group;
mod joints;
mod kinetostatics;
mod law;
mod loads;
mod place;
mod reduce;
mod sharing;
mod sliding;
mod state;
mod stroke;
mod visit;
mod wrenches;

assur_words::resources!();

pub use analyzer::{AnalyzerPlugin, ForceAnalyzer, FrictionAnalysis, analyzers, applicable, choose, find};
pub use assur_integrator::{Dependence, Piece, Reduced};
pub use assur_plugin::RegistryError;
pub use balance::{IdleBalance, Reactions, UnitBalance, drive_direction};
pub use breaks::tolerance;
pub use choice::Phase;
pub use construction::{Acting, Construction, ConstructionStep, Drawing, VectorKind};
pub use error::{ForceError, LoadError, LoadFault};
pub use friction::{
    Accelerations, Bearing, Block, Doubt, Followed, FreeMotion, FrictionForces, FrictionIteration,
    FrictionSolution, Frictions, Unknown, UnknownKind,
};
pub use group_by_group::{Unsolved, drive, drive_of_pair, drives, group_by_group, rate};
pub use joints::{Joint, JointReaction, joints};
pub use kinetostatics::{Kinetostatics, LaneKinetostatics, solve_by};
pub use loads::{Cause, Loads};
pub use reduce::power;
pub use state::{LoadNumber, LoadState, Side, beside};

pub use inventory;

#[cfg(test)]
mod tests;
