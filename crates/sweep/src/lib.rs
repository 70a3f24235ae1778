//! A scene over a grid of parameters: one row of results for each point.
//!
//! [`Sweep::of`] takes the text of a scene and the parameters; [`Sweep::run`] gives a [`Table`], which is written
//! to memory as CSV ([`Table::to_csv`]) or as [`parquet`]. Each point is the text of the scene with other values in it, read by [`assur_scene::read`]: every
//! check of the reader applies, and a unit means what it means in a scene. Nothing here opens a file or prints.
//!
//! # The grid
//!
//! A parameter is `KEY=FROM..TO:N` ([`Vary`]): N values, equally spaced, FROM and TO among them (only FROM where N is 1).
//! KEY is a dotted path into the scene: `link.crank.mass`, `ground.points.C[1]`, `slide[0].angle`, `force.cutting.value`.
//! FROM and TO are quantities; if only one has a unit, it applies to both, and without a unit they are SI.
//! Of several parameters, the last one changes fastest.
//!
//! # The columns
//!
//! SI, angles in rad, the unit in the name; an empty cell where something does not apply. In this order:
//!
//! | column | means |
//! | --- | --- |
//! | `<KEY>_<unit>` | each parameter |
//! | `status` | `ok`, `no assembly`, `no solution` (a position, or the motion), `error` (as a whole), `refused` (by the reader) |
//! | `message` | the first failure in words |
//! | `failed_positions` | how many positions have no solution; then the columns below are empty: extremes over a part are none |
//! | `smallest_health`, `smallest_health_at_*` | least dimensionless determinant of all groups; the coordinate |
//! | `balancing_greatest_*`, `balancing_greatest_at_*` | greatest modulus of the balancing load; the coordinate |
//! | `balancing_mean_*`, `balancing_mean_modulus_*` | mean over the positions, with its sign; mean of the modulus |
//! | `reaction_<pair>_greatest_N` | greatest force that the pin or slide exerts on one of its links |
//! | `reaction_<slide>_moment_greatest_Nm` | greatest modulus of its moment |
//! | `<point>_x_min_m`, `_x_max_m`, `_y_min_m`, `_y_max_m` | extremes of the coordinates |
//! | `<slide>_min_m`, `_max_m`, `_travel_m` | extremes of the displacement, and their difference |
//! | `<link>_angle_min_rad`, `_angle_max_rad` | extremes of the angle, continuous over the positions |
//! | `flywheel_kgm2`, `ratio`, `torque_Nm`, `mean_speed_*`, `unevenness`, `speed_min_*`, `speed_max_*`, `excess_work_J`, `required_power_W` | periodic regime and drive |
//! | `end_time_s`, `end_coordinate_*`, `end_speed_*` | transient motion: the last state |
//! | `motor` | designation of the motor |
//!
//! Extremes are over the positions of the scene; of equal ones the first counts. Columns without a value at any point
//! are left out.

mod angles;
mod axis;
mod csv;
mod error;
mod layout;
mod measure;
pub mod parquet;
mod point;
mod points;
mod positions;
mod range;
mod rows;
mod statistics;
mod sweep;
mod tally;
mod unit;
mod variants;
mod vary;

pub use error::SweepError;
pub use measure::{MEASURES, Measure};
pub use points::Points;
pub use rows::{Rows, Status};
pub use sweep::{MOST_POINTS, Request, Sweep};
pub use tally::Tally;
pub use vary::Vary;

#[cfg(test)]
mod tests;
