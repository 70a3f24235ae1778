//! The registry of force analyzers.

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

/// A method that is not there, or is there twice.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RegistryError {
    /// Two plugins have one name.
    #[error("two plugins are registered as force analyzer `{name}`: {first} and {second}; rename one")]
    Duplicate {
        /// The name.
        name: &'static str,
        /// The first crate.
        first: &'static str,
        /// The second crate.
        second: &'static str,
    },
    /// Nothing is registered.
    #[error("no force analyzer is registered; the program must link the plugins (`use assur_all as _;`)")]
    Empty,
    /// Nothing has this name.
    #[error("no force analyzer is called `{name}`; there are: {}", known.join(", "))]
    Unknown {
        /// The name asked for.
        name: String,
        /// The registered names.
        known: Vec<&'static str>,
    },
}

/// All registered methods, sorted by name.
///
/// # Errors
///
/// [`RegistryError`] where two have one name or none is registered.
pub fn analyzers() -> Result<Vec<&'static AnalyzerPlugin>, RegistryError> {
    sorted(inventory::iter::<AnalyzerPlugin>.into_iter().collect())
}

/// The method of this name.
///
/// # Errors
///
/// [`RegistryError`] where the registry is faulty or has no such method.
pub fn find(name: &str) -> Result<&'static AnalyzerPlugin, RegistryError> {
    let all = analyzers()?;
    let known = || all.iter().map(|plugin| plugin.name).collect();
    let found = all.iter().copied().find(|plugin| plugin.name == name);
    found.ok_or_else(|| RegistryError::Unknown { name: name.to_owned(), known: known() })
}

pub(crate) fn sorted(
    mut all: Vec<&'static AnalyzerPlugin>,
) -> Result<Vec<&'static AnalyzerPlugin>, RegistryError> {
    all.sort_by_key(|plugin| (plugin.name, plugin.crate_name));
    if all.is_empty() {
        return Err(RegistryError::Empty);
    }
    for two in all.windows(2) {
        if two[0].name == two[1].name {
            let (first, second) = (two[0].crate_name, two[1].crate_name);
            return Err(RegistryError::Duplicate { name: two[0].name, first, second });
        }
    }
    Ok(all)
}
