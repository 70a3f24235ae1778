//! A scene with many values of its numbers: one row of results for each point.
//!
//! [`Sweep::of`] takes the text of a scene, the parameters ([`Vary`]) and what is wanted ([`SweepRequest`]); [`Sweep::run`]
//! calculates points in threads and hands on their [`Rows`] block by block, which are written as CSV
//! ([`Rows::to_csv`]), and by another crate as Parquet. Nothing here opens a file by its name or prints, and memory does not grow with the
//! number of points.
//!
//! A parameter is a dotted path into the scene with a range: `link.crank.mass`, `ground.points.C[1]`, `slide[0].angle`,
//! `force.cutting.value`. The ends of a range are quantities; if only one has a unit, it applies to both, and without a
//! unit they are SI. The points are a grid, of which the last parameter changes fastest, a sample, or those of a table ([`Points`]).
//!
//! # The columns
//!
//! They follow from the scene and the [`Measure`]s before the first point is calculated: `row`, the number of the point from 0; the
//! parameters; `status`, `message`
//! (the first failure in words), `failed_positions`; the columns of the measures; `motor`. They are in SI, angles in rad, and
//! the unit is part of the name. A cell is empty where something does not apply, and all values are where a
//! position fails: extremes over a part are none. Extremes and means are over the positions of the scene, of equal ones the first
//! counts, or, with [`SweepRequest::between`], between them too, as a report has them. Strokes, time ratios, transfer functions,
//! speeds and the shaking force, where asked for, are always those between positions.
//!
//! Rows that don't hold every [`Condition`] are calculated and not [written](Rows::written).
//!
//! # How a point is calculated
//!
//! The scene is read once, and its numbers are set in the mechanism, wherever that is the same as reading the edited text
//! (`variants`). Structure and plan are reused. The positions are solved eight at once, and add to statistics of what is
//! measured. A thread keeps its memory from one point to the next.
//!
//! # Examples
//!
//! ```
//! use assur_all as _; // the plugins that ship
//! use assur_sweep::{Points, Sweep, SweepRequest, Vary};
//!
//! let vary = Vary::parse("link.crank.points.A=70 mm..95 mm:6", Points::Grid)?;
//! let sweep = Sweep::of("four-bar.toml", assur_fixtures::scene("four-bar"), &[vary], SweepRequest::default())?;
//! assert_eq!((sweep.points(), sweep.row(5).to_csv(false)?.starts_with("5,0.095,ok")), (6, true));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod axis;
mod best;
mod between;
mod column;
mod condition;
mod error;
mod following;
mod layout;
mod measure;
mod measured;
mod origin;
mod point;
mod points;
mod positions;
mod reach;
mod rows;
mod shape;
mod sweep;
mod table;
mod tally;
mod variants;
mod vary;

pub use best::{Best, Judged};
pub use column::parameter;
pub use condition::Condition;
pub use error::SweepError;
pub use measure::{MEASURES, Measure};
pub use origin::{Origin, difference};
pub use points::Points;
pub use rows::{Columns, ReadRow, Rows, Status};
pub use sweep::{MOST_POINTS, Sweep, SweepRequest};
pub use table::{Numbering, PointTable};
pub use tally::Tally;
pub use vary::{Target, Tie, Vary};

assur_words::resources!();

#[cfg(test)]
mod tests;
