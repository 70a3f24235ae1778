//! The registry of force analyzers.

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
    /// Where the formulas are from.
    pub source: &'static str,
    /// The method.
    pub instance: &'static dyn ForceAnalyzer,
    /// Whether it finds reactions; otherwise the balancing load alone.
    pub gives_reactions: bool,
}

inventory::collect!(AnalyzerPlugin);

impl Registered for AnalyzerPlugin {
    const WHAT: &'static str = "force analyzer";

    fn name(&self) -> &'static str {
        self.name
    }

    fn crate_name(&self) -> &'static str {
        self.crate_name
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

/// The method of this name.
///
/// # Errors
///
/// [`RegistryError`] where the registry is faulty or has no such method.
pub fn find(name: &str) -> Result<&'static AnalyzerPlugin, RegistryError> {
    assur_plugin::find(name)
}
