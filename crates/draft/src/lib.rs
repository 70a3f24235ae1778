//! The text of a scene while it is built.
//!
//! All functions go from a text to a text; comments, order and spelling of what is not changed stay as they are.
//!
//! ```
//! use assur_mechanism::Key;
//!
//! let key = Key::parse("link.crank.mass")?;
//! let text = assur_draft::set("[link.crank]\nmass = 1 # of steel\n", &key, "2")?;
//! assert_eq!(text, "[link.crank]\nmass = 2 # of steel\n");
//! # Ok::<(), assur_words::Text>(())
//! ```

mod braces;
mod difference;
mod edit;
mod find;
mod hang;
mod insertion;
mod known;
mod layout;
mod names;
mod part;
mod place;
mod readable;
mod removal;
mod rename;
mod written;

pub use difference::{Difference, differences};
pub use edit::{append, remove, set};
pub use hang::{delete, dependents};
pub use part::{Part, stands};
pub use readable::{Readable, key_at, readable};
pub use rename::{rename, rename_in_link, renamed_key};

assur_words::resources!();

#[cfg(test)]
mod tests;
