//! Errors in decomposing a mechanism.

use assur_group::{BuildError, RegistryError};

/// The mobility count that an error shows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Counted {
    /// W by Chebyshev's formula.
    pub mobility: i64,
    /// The calculation of W: `3*5 - 2*7`.
    pub formula: String,
}

/// Why a mechanism can't be decomposed into groups.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StructureError {
    /// Some links can move while the input is fixed.
    #[error(
        "mobility {} ({}), but one input moves the mechanism: {} can still move while the input is fixed{also}; \
         join {} to another link by one more pair, or leave out what hangs there",
        counted.mobility, counted.formula, listed("link", "links", links), if links.len() == 1 { "it" } else { "them" }
    )]
    Loose {
        /// The count.
        counted: Counted,
        /// The links that are loose.
        links: Vec<String>,
        /// Addition for surplus pairs elsewhere; may be empty.
        also: String,
    },
    /// Some pairs constrain what is already fixed.
    #[error(
        "mobility {} ({}), must be 1: {} one constraint too many on {}; take one pair or one link away there \
         (a passive link that only repeats a motion must be left out of the scene)",
        counted.mobility, counted.formula, surplus(pairs), listed("link", "links", links)
    )]
    Surplus {
        /// The count.
        counted: Counted,
        /// Pairs of which one is surplus.
        pairs: Vec<String>,
        /// Links that they lock.
        links: Vec<String>,
    },
    /// No plugin solves a group.
    #[error(
        "{} form a group of class {}, order {order} ({pattern}); no plugin is registered for it \
         (see `assur plugins`; another input link may give other groups)",
        listed("link", "links", links), crate::roman(*class)
    )]
    NoPlugin {
        /// Its links.
        links: Vec<String>,
        /// Its class.
        class: u8,
        /// Its order.
        order: u8,
        /// Its pairs by letter and name.
        pattern: String,
    },
    /// The lengths don't form a group of the kind.
    #[error("{group}: {source}")]
    Build {
        /// The group.
        group: String,
        /// What is wrong.
        source: BuildError,
    },
    /// The registry of groups is faulty.
    #[error(transparent)]
    Registry(#[from] RegistryError),
}

impl StructureError {
    /// The first link concerned, if the error is about links.
    pub fn link(&self) -> Option<&str> {
        match self {
            Self::Loose { links, .. } | Self::Surplus { links, .. } | Self::NoPlugin { links, .. } => {
                links.first().map(String::as_str)
            }
            Self::Build { .. } | Self::Registry(_) => None,
        }
    }
}

/// Most names that a message lists.
const MOST_NAMES: usize = 24;

fn listed(one: &str, many: &str, names: &[String]) -> String {
    let noun = if names.len() == 1 { one } else { many };
    format!("{noun} {}", some(names, |name| format!("`{name}`")))
}

/// The first of some names, and how many there are.
pub(crate) fn some(names: &[String], shown: impl Fn(&str) -> String) -> String {
    let first: Vec<_> = names.iter().take(MOST_NAMES).map(|name| shown(name)).collect();
    let more = if names.len() > MOST_NAMES {
        format!(" ... ({MOST_NAMES} of {} shown)", names.len())
    } else {
        String::new()
    };
    first.join(", ") + &more
}

fn surplus(pairs: &[String]) -> String {
    format!("{} give{}", listed("pair", "pairs", pairs), if pairs.len() == 1 { "s" } else { "" })
}
