//! Formulas such as `5000 + 600*sin(2*q)`: read once, then evaluated at many states without allocation.
//!
//! A formula is smooth except where the argument of `sign`, `step`, `abs`, `min` or `max` changes its sign (of `min` and
//! `max`: the difference of both arguments). Each of these is a [`Switch`]. [`Formula::branches`] tells on which side of every
//! switch a state lies, [`Formula::value_on`] evaluates the formula on given sides, continued smoothly beyond the switches,
//! and [`Formula::smooth_until`] finds the next change along one variable by interval arithmetic, so that no change is
//! missed between two samples. Crates for expressions evaluate, but do not show where a formula jumps; so only the parsing
//! of operators and their precedence is borrowed (`winnow`).

mod evaluate;
mod formula;
mod interval;
mod locate;
mod number;
mod parse;
mod program;

pub use formula::{Formula, Switch, Used, Variable, Variables};
pub use parse::{FUNCTIONS, FormulaError};

#[cfg(test)]
mod tests;
