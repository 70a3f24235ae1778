//! The text of a scene while it is built.
//!
//! All functions go from a text to a text; comments, order and spelling of what is not changed stay as they are.

mod edit;

pub use edit::{append, remove, set};
