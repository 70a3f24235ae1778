//! The registry entry by which a kind of group provides its own equations.

use assur_group::{Body, BuildError, GroupFrame};
use assur_plugin::RegistryError;

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

assur_plugin::registry!(WorkingPlugin, assur_plugin::Text::message("group-working-sort", Vec::new()), group);

/// The working of a kind of group; `None` if the kind provides none.
///
/// # Errors
///
/// [`RegistryError::Duplicate`] if two workings are registered for one kind.
pub fn plugin_for(group: &str) -> Result<Option<&'static WorkingPlugin>, RegistryError> {
    match assur_plugin::find(group) {
        Ok(plugin) => Ok(Some(plugin)),
        Err(RegistryError::Empty(_) | RegistryError::Unknown { .. }) => Ok(None),
        Err(fault) => Err(fault),
    }
}
