//! The geometry of building a mechanism: where its links lie, where a group is put, which length would close, how points are moved.
//!
//! All functions go from the text of a scene, with the [`Sketch`] of its mechanism, to a text.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod addition;
mod closing;
mod drive;
mod frame;
mod group;
mod guess;
mod layout;
mod moved;
mod naming;
mod number;
mod pose;
mod reach;
mod settled;
mod shape;
mod sketch;
mod start;
mod tables;

assur_words::resources!();

pub use addition::{Added, Addition, Fit, Names, Target, additions};
pub use closing::{Closing, closings};
pub use drive::{Drive, drive, drives};
pub use group::add;
pub use moved::{move_guide, move_point, turn_guide};
pub use pose::Pose;
pub use settled::settled;
pub use sketch::{Sketch, sketch};
pub use start::{Start, start};

#[cfg(test)]
mod tests;
