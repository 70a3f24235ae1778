//! Planar linkages by Assur groups, as a library: a scene is read once, and then asked for positions, for tables of results, or for many
//! variants of itself. The plugins of the repository are linked.
//!
//! All numbers are in SI, angles in rad, counter-clockwise. The names of columns are those of the CSV of `assur analyze`, with their units.
//!
//! Positions in a loop, each a pure function of the coordinate of the input:
//!
//! ```
//! use assur::prelude::*;
//!
//! # let text = "[ground]\npoints = { O = 0, C = \"500 mm\" }\n[link.crank]\npoints = { O = 0, A = \"100 mm\" }\n[link.rod]\n\
//! #     points = { A = 0, B = \"400 mm\" }\n[link.rocker]\npoints = { C = 0, B = \"300 mm\" }\n[input]\nlink = \"crank\"\n[assembly]\nB = [0.4, 0.3]\n";
//! let scene = Scene::parse("four-bar.toml", text)?;
//! for degrees in (0..360).step_by(30) {
//!     let position = scene.at(f64::from(degrees).to_radians())?;
//!     let [x, y] = position.point("B")?;
//!     println!("{degrees}: {x} {y}");
//! }
//! # Ok::<(), assur::Error>(())
//! ```
//!
//! Reactions by the name of a pair, with the motion of the scene:
//!
//! ```
//! use assur::prelude::*;
//!
//! # let text = "[ground]\npoints = { O = 0, C = \"500 mm\" }\n[link.crank]\npoints = { O = 0, A = \"100 mm\" }\n[link.rod]\n\
//! #     points = { A = 0, B = \"400 mm\" }\nmass = 2.0\ncenter = [0.2, 0]\n[link.rocker]\npoints = { C = 0, B = \"300 mm\" }\n[input]\n\
//! #     link = \"crank\"\n[assembly]\nB = [0.4, 0.3]\n[motion]\nspeed = \"60 rpm\"\n";
//! let results = Scene::parse("four-bar.toml", text)?.analyze()?;
//! let pin = results.reaction("B")?;
//! for (x, y) in pin.x.iter().zip(pin.y) {
//!     println!("{:.1} N on {}", x.hypot(*y), pin.on);
//! }
//! # Ok::<(), assur::Error>(())
//! ```
//!
//! A sweep:
//!
//! ```
//! use assur::prelude::*;
//!
//! # let text = "[ground]\npoints = { O = 0, C = \"500 mm\" }\n[link.crank]\npoints = { O = 0, A = \"100 mm\" }\n[link.rod]\n\
//! #     points = { A = 0, B = \"400 mm\" }\n[link.rocker]\npoints = { C = 0, B = \"300 mm\" }\n[input]\nlink = \"crank\"\n[assembly]\nB = [0.4, 0.3]\n";
//! let scene = Scene::parse("four-bar.toml", text)?;
//! let rows = scene.sweep(&["link.rod.points.B=350 mm..450 mm:11"], &["transmission"])?;
//! for (length, status) in rows.column("link.rod.points.B_m")?.iter().zip(rows.statuses()) {
//!     println!("{length} m: {status}");
//! }
//! # Ok::<(), assur::Error>(())
//! ```

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod columns;
mod error;
mod position;
mod results;
mod scene;
mod swept;

pub use assur_sweep::{Numbering, PointTable};
pub use columns::Columns;
pub use error::Error;
pub use position::Position;
pub use results::{Reaction, Results};
pub use scene::Scene;
pub use swept::{SweepOptions, SweepRows};

// Linking is what registers the plugins.
use assur_all as _;

/// What a program that calculates needs.
pub mod prelude {
    pub use crate::{Columns, Error, Position, Reaction, Results, Scene, SweepOptions, SweepRows};
}

#[cfg(test)]
mod tests;
