//! The registry of force analyzers, and the choice among them by what they declare.

use assur_kinematics::Linkage;
use assur_plugin::{Registered, RegistryError};

use crate::ForceAnalyzer;

/// Entry of a method in the registry: `inventory::submit! { AnalyzerPlugin { ... } }`.
#[derive(Debug, Clone, Copy)]
pub struct AnalyzerPlugin {
    /// Stable identifier, lower case: `newton-euler`.
    pub name: &'static str,
    /// The crate that registers it.
    pub crate_name: &'static str,
    /// One line.
    pub summary: &'static str,
    /// Source of the formulas.
    pub source: &'static str,
    /// The method.
    pub instance: &'static dyn ForceAnalyzer,
    /// Whether it finds reactions; otherwise the balancing load alone.
    pub gives_reactions: bool,
    /// Whether the method solves group by group, so that a group which is not placed or carries no load can be left out
    /// ([`Reactions::solved`](crate::Reactions::solved)). Other methods need all groups placed.
    pub by_groups: bool,
    /// Order of preference: of the methods that give reactions, the one of the lowest rank is used where the user names
    /// none. Methods of equal rank go by name.
    pub rank: u8,
}

inventory::collect!(AnalyzerPlugin);

impl Registered for AnalyzerPlugin {
    const WHAT: &'static str = "force analyzer";

    fn registration(&self) -> (&'static str, &'static str) {
        (self.name, self.crate_name)
    }
}

/// All registered methods, sorted by name.
///
/// # Errors
///
/// [`RegistryError`] where two have one name or none is registered.
pub fn analyzers() -> Result<Vec<&'static AnalyzerPlugin>, RegistryError> {
    assur_plugin::all()
}

/// The registered methods that can treat a mechanism, sorted by name; none where the registry is faulty.
pub fn applicable(linkage: &Linkage) -> Vec<&'static AnalyzerPlugin> {
    let all = analyzers().unwrap_or_default().into_iter();
    all.filter(|plugin| plugin.instance.supports(linkage).is_ok()).collect()
}

/// The method of this name.
///
/// # Errors
///
/// [`RegistryError`] where the registry is faulty or has no such method.
pub fn find(name: &str) -> Result<&'static AnalyzerPlugin, RegistryError> {
    assur_plugin::find(name)
}

/// The method of this name; without a name the preferred one of those that give reactions.
///
/// # Errors
///
/// [`RegistryError`] where the registry is faulty or has no such method.
pub fn choose(name: Option<&str>) -> Result<&'static AnalyzerPlugin, RegistryError> {
    if let Some(name) = name {
        return find(name);
    }
    let all = analyzers()?.into_iter().filter(|plugin| plugin.gives_reactions);
    all.min_by_key(|plugin| plugin.rank).ok_or(RegistryError::Empty { what: AnalyzerPlugin::WHAT })
}
