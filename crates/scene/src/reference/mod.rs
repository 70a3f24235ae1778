//! The reference of the scene: every key that the reader accepts, described once, in `keys.txt`. From here come the quantity,
//! the limits and the default of a number that is read, the keys that an error lists, `assur keys`, `docs/scene.md`, and the
//! manual page.

mod bound;
mod find;
mod key;
mod kind;
mod table;
#[cfg(test)]
mod tests;

pub use bound::Bound;
pub use find::{key_of, near, search, words_of};
pub use key::{KeyDefault, SceneKey};
pub use kind::{ValueKind, either};
pub use table::{KeyTable, TABLES, table};
