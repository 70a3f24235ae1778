//! The working of a calculation by hand: equations in symbols, with numbers substituted, and their results.
//!
//! * [`Expr`]: the right side of an equation. One tree is printed in symbols, printed with numbers, and evaluated, so
//!   the three always agree. A writer gets it as a row of [`Term`]s.
//! * [`Sheet`]: collects [`Line`]s in [`Section`]s, and the symbols of points, links and loads.
//! * [`WorkingPlugin`]: the registry entry by which a kind of group provides its own equations. A kind without an
//!   entry uses the general linear system.
//!
//! Intermediate values are carried with all digits. Each line shows its numbers with as many digits as are needed to
//! recompute its printed result from them.
//!
//! This crate is independent of concrete groups, of scenes and of the terminal. Units are SI; angles are
//! counter-clockwise.

pub mod dyad;
mod expr;
mod figure;
mod line;
mod load;
mod place;
mod render;
mod sheet;
mod symbol;
mod term;

pub use expr::Expr;
pub use line::{Entry, Line, RESULT_DIGITS, Section};
pub use load::{Reaction, WorkedLoad};
pub use place::{Guide, Point, Pose, Rod};
pub use render::{WIDTH, text};
pub use sheet::{Names, Sheet, Units, WorkingPlugin, Write, plugin_for};
pub use symbol::Symbol;
pub use term::Term;

pub use assur_group::inventory;
pub use assur_plugin::RegistryError;

assur_words::resources!();

#[cfg(test)]
mod tests;
