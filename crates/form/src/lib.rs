//! Forms for the tables of a scene, made from the reference of its keys: what a table may have, what it has, and the steps that change
//! it.
//!
//! There is no state: a [`Form`] is made from a text, and each step returns another text, with what the reader of scenes says of it
//! ([`Change`]). A form for a table is [`table`], for the masses of all links [`masses`], for rows over angle, time or stroke [`rows`];
//! [`sections`] lists the tables that stand and those that may be added.
//!
//! # Examples
//!
//! ```
//! use assur_form::{put, table};
//! use assur_mechanism::Key;
//!
//! let scene = "[ground]\npoints = { O = 0 }\n[link.arm]\npoints = { O = 0 }\n[input]\nlink = 'arm'\n[motion]\nspeed = '60 rpm'\n";
//! let form = table(scene, &Key::of("motion"), &[]);
//! let speed = form.fields.iter().find(|field| field.label == "speed").unwrap();
//! assert_eq!((speed.shown().as_str(), speed.unit), ("60 rpm", "rad/s"));
//! let wrong = put(scene, speed, "60 mm");
//! assert!(wrong.here.unwrap().message.to_string().starts_with("`speed` wants a speed of rotation"));
//! ```

mod added;
mod candidates;
mod change;
mod choices;
mod fault;
mod field;
mod form;
mod masses;
mod rows;
mod sections;
mod sort;
mod tables;
#[cfg(test)]
mod tests;
mod typed;

pub use added::{added, made};
pub use change::{Change, put};
pub use choices::{Choice, Offers};
pub use fault::{Fault, faults};
pub use field::{Field, Opening, field};
pub use form::{Form, table};
pub use masses::{Grid, GridRow, masses, rod};
pub use rows::{Column, Rows, deleted, inserted, rows};
pub use sections::{Instance, Section, sections};
pub use typed::typed;

assur_words::resources!();
