//! Test support: random mechanisms that can be assembled by construction, and a writer of scenes.
//!
//! A pose of every link in the first position is drawn first; the pairs are then placed to fit these poses. Any
//! arrangement is equally easy to construct: groups of all registered kinds in any order on any earlier bodies,
//! guides on either link, offset and tilted, multiple joints, links of many points, pinned and sliding inputs.

mod draft;
mod formula;
mod loads;
mod recipe;
mod several;
mod write;

pub use crate::Rng;
pub use formula::{Terms, formula};
pub use recipe::{Recipe, Specimen, kinds};
pub use write::scene_text;

#[cfg(test)]
mod tests;
