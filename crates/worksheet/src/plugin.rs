//! The registry entry by which a kind of group provides its own equations.

use assur_group::{Body, BuildError, GroupFrame, inventory};

use crate::Sheet;

/// Writes a part of the working of one placed group.
///
/// `bodies` are solved; they only determine which assembly holds (the signs of roots).
pub type Write = fn(&mut Sheet, &GroupFrame, &[Body<f64>]) -> Result<(), BuildError>;

/// Entry of a kind's working in the registry: `inventory::submit! { WorkingPlugin { ... } }`.
#[derive(Debug, Clone, Copy)]
pub struct WorkingPlugin {
    /// Name of the group plugin: `rrr`.
    pub group: &'static str,
    /// The crate that registers it.
    pub crate_name: &'static str,
    /// Writes positions, PF1 and PF2; it must set the pose of every link of the group.
    pub motion: Write,
    /// Writes the reactions in all pairs of the group; it must pass those of the outer pairs to the outer bodies.
    pub reactions: Write,
}

inventory::collect!(WorkingPlugin);

/// A fault of the registry: a mistake of the build, not of a scene.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("two workings are registered for group `{group}`: by {first} and {second}; remove one")]
pub struct WorkingRegistryError {
    /// The group.
    pub group: String,
    /// The first crate.
    pub first: &'static str,
    /// The second crate.
    pub second: &'static str,
}

/// The working of a kind of group; `None` if the kind provides none.
///
/// # Errors
///
/// [`WorkingRegistryError`] if two workings are registered for the kind.
pub fn plugin_for(group: &str) -> Result<Option<&'static WorkingPlugin>, WorkingRegistryError> {
    let all = inventory::iter::<WorkingPlugin>.into_iter();
    let mut found: Vec<_> = all.filter(|plugin| plugin.group == group).collect();
    found.sort_by_key(|plugin| plugin.crate_name);
    match found[..] {
        [] => Ok(None),
        [one] => Ok(Some(one)),
        [one, two, ..] => Err(WorkingRegistryError {
            group: group.to_owned(),
            first: one.crate_name,
            second: two.crate_name,
        }),
    }
}
