//! The registry of integrators.

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

/// Why the registry can't be used.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RegistryError {
    /// Two plugins claim one name.
    #[error("two integrators are named `{name}`: from `{first}` and from `{second}`; rename one")]
    Duplicate {
        /// The name.
        name: &'static str,
        /// One crate.
        first: &'static str,
        /// The other crate.
        second: &'static str,
    },
    /// No plugin is linked.
    #[error("no integrator is linked into this program; depend on the crate that lists the plugins")]
    Empty,
    /// No plugin of that name.
    #[error("no integrator is named `{name}`; there are: {known}")]
    Unknown {
        /// The name asked for.
        name: String,
        /// All names.
        known: String,
    },
}

/// All linked integrators, sorted by name.
///
/// # Errors
///
/// [`RegistryError::Duplicate`], [`RegistryError::Empty`].
pub fn integrators() -> Result<Vec<&'static IntegratorPlugin>, RegistryError> {
    sorted(inventory::iter::<IntegratorPlugin>.into_iter().collect())
}

/// The integrator of that name.
///
/// # Errors
///
/// As [`integrators`], and [`RegistryError::Unknown`].
pub fn find(name: &str) -> Result<&'static IntegratorPlugin, RegistryError> {
    let all = integrators()?;
    all.iter().find(|plugin| plugin.name == name).copied().ok_or_else(|| RegistryError::Unknown {
        name: name.to_owned(),
        known: all.iter().map(|plugin| plugin.name).collect::<Vec<_>>().join(", "),
    })
}

/// Sorts by name; the order of linking must not matter.
fn sorted(mut all: Vec<&IntegratorPlugin>) -> Result<Vec<&IntegratorPlugin>, RegistryError> {
    all.sort_by_key(|plugin| (plugin.name, plugin.crate_name));
    match all.windows(2).find(|pair| pair[0].name == pair[1].name) {
        Some(pair) => Err(RegistryError::Duplicate {
            name: pair[0].name,
            first: pair[0].crate_name,
            second: pair[1].crate_name,
        }),
        None if all.is_empty() => Err(RegistryError::Empty),
        None => Ok(all),
    }
}

#[cfg(test)]
mod tests;
