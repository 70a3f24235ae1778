//! What every registry of plugins has in common: entries sorted by name, unique names, search by name.
//!
//! `inventory` returns the entries in the order of linking, which is arbitrary; results must not depend on it.

pub use inventory;
use inventory::Collect;

/// A registry entry that plugins submit.
pub trait Registered: Collect {
    /// The sort of entry, for messages: `force analyzer`.
    const WHAT: &'static str;

    /// Its stable identifier, which users write, and the crate that registers it.
    fn registration(&self) -> (&'static str, &'static str);
}

/// Makes a registry of a type: its entries are collected, and go by the named field; they have a field `crate_name`, too.
#[macro_export]
macro_rules! registry {
    ($entry:ty, $what:literal, $name:ident) => {
        $crate::inventory::collect!($entry);

        impl $crate::Registered for $entry {
            const WHAT: &'static str = $what;

            fn registration(&self) -> (&'static str, &'static str) {
                (self.$name, self.crate_name)
            }
        }
    };
}

/// A plugin that is missing, or registered twice.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RegistryError {
    /// Two plugins have the same name: a mistake of the build.
    #[error("two plugins are registered as {what} `{name}`: {first} and {second}; rename one")]
    Duplicate {
        /// The sort of entry.
        what: &'static str,
        /// The name.
        name: &'static str,
        /// The first crate.
        first: &'static str,
        /// The second crate.
        second: &'static str,
    },
    /// Two plugins fit one thing equally well: a mistake of the build.
    #[error(
        "two plugins registered as {what} fit the same thing: `{}` of {} and `{}` of {}; leave one out, or declare one more \
         precisely",
        first.0, first.1, second.0, second.1
    )]
    Ambiguous {
        /// The sort of entry.
        what: &'static str,
        /// Name and crate of the first one.
        first: (&'static str, &'static str),
        /// Name and crate of the second one.
        second: (&'static str, &'static str),
    },
    /// Nothing is registered: a mistake of the build.
    #[error("no {0} is registered; the program must link the plugins (`use assur_all as _;`)")]
    Empty(&'static str),
    /// Nothing has this name.
    #[error("no {what} is called `{name}`; there are: {}", known.join(", "))]
    Unknown {
        /// The sort of entry.
        what: &'static str,
        /// The unknown name.
        name: String,
        /// The registered names.
        known: Vec<&'static str>,
    },
}

/// All registered entries of a kind, sorted by name.
///
/// # Errors
///
/// [`RegistryError`] if two entries have one name, or if none is registered.
pub fn all<P: Registered>() -> Result<Vec<&'static P>, RegistryError>
where
    inventory::iter<P>: IntoIterator<Item = &'static P>,
{
    sorted(inventory::iter::<P>.into_iter().collect())
}

/// The entry of this name.
///
/// # Errors
///
/// [`RegistryError`] where the registry is faulty or has no such entry.
pub fn find<P: Registered>(name: &str) -> Result<&'static P, RegistryError>
where
    inventory::iter<P>: IntoIterator<Item = &'static P>,
{
    let all = all::<P>()?;
    let found = all.iter().copied().find(|plugin| plugin.registration().0 == name);
    let known = || all.iter().map(|plugin| plugin.registration().0).collect();
    found.ok_or_else(|| RegistryError::Unknown { what: P::WHAT, name: name.to_owned(), known: known() })
}

fn sorted<P: Registered>(mut all: Vec<&'static P>) -> Result<Vec<&'static P>, RegistryError> {
    all.sort_by_key(|plugin| plugin.registration());
    if all.is_empty() {
        return Err(RegistryError::Empty(P::WHAT));
    }
    let mut twins = all.windows(2).map(|two| (two[0].registration(), two[1].registration()));
    match twins.find(|(first, second)| first.0 == second.0) {
        Some(((name, first), (_, second))) => {
            Err(RegistryError::Duplicate { what: P::WHAT, name, first, second })
        }
        None => Ok(all),
    }
}

#[cfg(test)]
mod tests;
