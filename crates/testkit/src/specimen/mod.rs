//! Test support: random mechanisms that can be assembled by construction, and a writer of scenes.
//!
//! A pose of every link in the first position is drawn first; the pairs are then placed to fit these poses. Any
//! arrangement is equally easy to construct: groups of all registered kinds in any order on any earlier bodies,
//! guides on either link, offset and tilted, multiple joints, links of many points, pinned and sliding inputs.

mod draft;
mod formula;
mod loads;
mod recipe;
mod write;

use assur_mechanism::{Brake, Contact, Force, LoadKind, Moment, Value};

pub use crate::Rng;
pub use formula::{Terms, formula};
pub use recipe::{Recipe, Specimen, kinds};
pub use write::scene_text;

/// The law of the size of a load, to be changed; a spring has none.
pub fn law_mut(load: &mut LoadKind) -> Option<&mut Value> {
    match load {
        LoadKind::Force(Force { value, .. })
        | LoadKind::Moment(Moment { value, .. })
        | LoadKind::Brake(Brake { force: value, .. })
        | LoadKind::Contact(Contact { force: value, .. }) => Some(value),
        LoadKind::Spring(_) => None,
    }
}

#[cfg(test)]
mod tests;
