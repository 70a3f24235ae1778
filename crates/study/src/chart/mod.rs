//! Speed versus accuracy: every registered method of every stage that a scene has, over its settings, on the same work.
//!
//! [`chart`] measures; [`ChartData`] is the result, as data for JSON, [`csv()`] and a page ([`ChartData::tell`]).
//!
//! * **Errors** are the largest deviation from a reference, relative to the largest value of the same quantity over the
//!   work. The reference is better than what it judges: extended precision, a closed form, or a tight run of another
//!   method. A method is never its own reference. What lies below the reference's own error estimate is reported as
//!   "at most that".
//! * **Times** are medians of repeated runs in one process, the methods taking turns so that drift hits all alike. The
//!   clock is handed in; nothing else here depends on it but how often a run is repeated.

mod data;
mod forces;
pub(crate) mod friction;
pub(crate) mod kinematics;
mod motion;
mod page;
mod race;
mod run;
mod steady;
pub(crate) mod work;

pub use data::{ChartData, Measurement, Reference, Setting, SettingValue, Stage, csv};
pub(crate) use forces::state;
pub use page::{figure, time};
pub use race::{ChartOptions, Progress};
pub use run::{ChartError, chart};

#[cfg(test)]
mod tests;
