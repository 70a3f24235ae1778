//! The registry of integrators.

use assur_plugin::{Registered, RegistryError};

use crate::Integrator;

/// Registers an integrator: `inventory::submit! { IntegratorPlugin { ... } }`.
#[derive(Debug, Clone, Copy)]
pub struct IntegratorPlugin {
    /// Stable name, as users write it.
    pub name: &'static str,
    /// The crate it comes from: `env!("CARGO_PKG_NAME")`.
    pub crate_name: &'static str,
    /// One line for lists.
    pub summary: &'static str,
    /// Where the method is described.
    pub source: &'static str,
    /// Order of accuracy; 0 for a method without error of discretization in time.
    pub order: u8,
    /// The method.
    pub instance: fn() -> &'static dyn Integrator,
}

inventory::collect!(IntegratorPlugin);

impl Registered for IntegratorPlugin {
    const WHAT: &'static str = "integrator";

    fn name(&self) -> &'static str {
        self.name
    }

    fn crate_name(&self) -> &'static str {
        self.crate_name
    }
}

/// All linked integrators, sorted by name.
///
/// # Errors
///
/// [`RegistryError`] where two have one name or none is linked.
pub fn integrators() -> Result<Vec<&'static IntegratorPlugin>, RegistryError> {
    assur_plugin::all()
}

/// The integrator of that name.
///
/// # Errors
///
/// [`RegistryError`] where the registry is faulty or has no such integrator.
pub fn find(name: &str) -> Result<&'static IntegratorPlugin, RegistryError> {
    assur_plugin::find(name)
}
