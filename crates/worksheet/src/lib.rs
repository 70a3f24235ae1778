//! The working of a calculation by hand: equations in symbols, with numbers put in, and their results.
//!
//! * [`Expr`]: an equation's right side; one tree is written in symbols, written with numbers, and evaluated, so that the
//!   three can't differ.
//! * [`Sheet`]: collects [`Line`]s in [`Section`]s, and knows the symbols of points, links and loads so far.
//! * [`WorkingPlugin`]: the registry entry by which a kind of group brings its own equations. A kind without an entry is
//!   worked by the general linear system; nothing needs a change for it.
//!
//! Intermediate values are carried with all digits; each line shows as many digits of its numbers as its own printed
//! result needs, so that it recomputes from what is printed.
//!
//! Knows no concrete group, no scene and no terminal. SI units; angles counter-clockwise.

pub mod dyad;
mod expr;
mod figure;
mod line;
mod load;
mod place;
mod plugin;
mod render;
mod sheet;
mod show;

pub use expr::Expr;
pub use line::{Entry, Line, RESULT_DIGITS, Section};
pub use load::{Load, Reaction};
pub use place::{Guide, Point, Pose, Rod};
pub use plugin::{WorkingPlugin, WorkingRegistryError, Write, plugin_for};
pub use render::{WIDTH, text};
pub use sheet::{Names, Sheet, Units, symbol_of};

pub use assur_group::inventory;

#[cfg(test)]
mod tests;
