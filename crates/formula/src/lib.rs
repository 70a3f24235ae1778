//! Formulas such as `5000 + 600*sin(2*q)`: read once, then evaluated at many states without allocation.
//!
//! A formula is smooth except where the argument of `sign`, `step` or `abs` changes its sign, the difference of those of `min` or
//! `max`, or the first of `atan2`. Each of these is a [`Switch`]. [`Formula::side_ahead`] tells on which side of a switch a
//! state lies, on the switch itself by what is just ahead and with regard to rounding; [`Formula::value_on`] evaluates the
//! formula on given sides, continued smoothly beyond the switches, and [`Formula::smooth_until`] finds the next change along
//! a path by interval arithmetic, so that no change is missed between two samples. Crates for expressions evaluate, but do not show where a formula jumps; so only the parsing
//! of operators and their precedence is borrowed (`winnow`).

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod formula;
mod interval;
mod locate;
mod number;
mod parse;
mod precise;
mod program;
mod rounded;
mod slope;

pub use formula::Formula;
pub use parse::{FUNCTIONS, FormulaError};
pub use program::{Branches, Sign, Switch, Used, Variable, Variables};

assur_words::resources!();

#[cfg(test)]
mod tests;
