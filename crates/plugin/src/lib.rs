//! What every registry of plugins has in common: entries sorted by name, unique names, search by name.
//!
//! `inventory` returns the entries in the order of linking, which is arbitrary; results must not depend on it.

pub use assur_words::Text;
use assur_words::{Describe, list, name, text};
pub use inventory;
use inventory::Collect;

assur_words::resources!();

/// A registry entry that plugins submit.
pub trait Registered: Collect {
    /// The sort of entry, for messages: force analyzer.
    const WHAT: Text;

    /// Its stable identifier, which users write, and the crate that registers it.
    fn registration(&self) -> (&'static str, &'static str);
}

/// Makes a registry of a type: its entries are collected, and go by the named field; they have a field `crate_name`, too. The
/// text says what an entry is.
#[macro_export]
macro_rules! registry {
    ($entry:ty, $what:expr, $name:ident) => {
        $crate::inventory::collect!($entry);

        impl $crate::Registered for $entry {
            const WHAT: $crate::Text = $what;

            fn registration(&self) -> (&'static str, &'static str) {
                (self.$name, self.crate_name)
            }
        }
    };
}

/// A plugin that is missing, or registered twice.
#[derive(Clone, PartialEq, Eq)]
pub enum RegistryError {
    /// Two plugins have the same name: a mistake of the build.
    Duplicate {
        /// The sort of entry.
        what: Text,
        /// The name.
        name: &'static str,
        /// The first crate.
        first: &'static str,
        /// The second crate.
        second: &'static str,
    },
    /// Two plugins fit one thing equally well: a mistake of the build.
    Ambiguous {
        /// The sort of entry.
        what: Text,
        /// Name and crate of the first one.
        first: (&'static str, &'static str),
        /// Name and crate of the second one.
        second: (&'static str, &'static str),
    },
    /// Nothing is registered: a mistake of the build.
    Empty(Text),
    /// Nothing has this name.
    Unknown {
        /// The sort of entry.
        what: Text,
        /// The unknown name.
        name: String,
        /// The registered names.
        known: Vec<&'static str>,
    },
}

assur_words::errors!(RegistryError);

impl Describe for RegistryError {
    fn describe(&self) -> Text {
        match self {
            Self::Duplicate { what, name: of, first, second } => {
                text!("plugin-twice", what, name = name(*of), first = name(*first), second = name(*second))
            }
            Self::Ambiguous { what, first, second } => text!(
                "plugin-ambiguous",
                what,
                first = name(first.0),
                first_crate = name(first.1),
                second = name(second.0),
                second_crate = name(second.1)
            ),
            Self::Empty(what) => text!("plugin-empty", what),
            Self::Unknown { what, name: asked, known } => text!(
                "plugin-unknown",
                what,
                name = name(asked.clone()),
                known = list(known.iter().map(|known| name(*known)))
            ),
        }
    }
}

/// All registered entries of a kind, sorted by name.
pub fn all<P: Registered>() -> Result<Vec<&'static P>, RegistryError>
where
    inventory::iter<P>: IntoIterator<Item = &'static P>,
{
    sorted(inventory::iter::<P>.into_iter().collect())
}

/// The entry of this name.
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
