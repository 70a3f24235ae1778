//! Forms of the shipped scenes.

mod examples;
mod lists;
mod steps;
mod values;

use assur_fixtures::scene;
use assur_mechanism::{Key, Mechanism};

use crate::{Change, Field, field, put};

fn key(text: &str) -> Key {
    Key::parse(text).unwrap()
}

/// The field of a key.
fn of(text: &str, at: &str) -> Field {
    field(text, &key(at), &[]).unwrap_or_else(|| panic!("{at}"))
}

/// What is made of a text where something is typed into the field of a key.
fn typing(text: &str, at: &str, typed: &str) -> Change {
    put(text, &of(text, at), typed)
}

fn read(text: &str) -> Mechanism {
    assur_scene::read("a.toml", text).unwrap_or_else(|errors| panic!("{errors}\n{text}"))
}

/// The text of a step that reads.
fn reads(change: Change) -> String {
    assert!(change.here.is_none(), "{:?}\n{}", change.here, change.text);
    assert!(change.elsewhere.is_empty(), "{:?}\n{}", change.elsewhere, change.text);
    read(&change.text);
    change.text
}

/// The shaper, which moves with 60 rpm, with a cutting force over the stroke.
fn shaper() -> &'static str {
    scene("shaper")
}
