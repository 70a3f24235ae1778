//! Tests of `key`.

use crate::screen::command::COMMANDS;
use crate::screen::state::{Command, Key};

#[test]
fn every_key_has_a_name_that_reads_back() {
    for key in COMMANDS.iter().flat_map(Command::default_keys) {
        assert_eq!(Key::parse(&key.name()), Some(key), "{}", key.name());
    }
    assert_eq!(Key::parse("F12").map(Key::name).as_deref(), Some("F12"));
    assert_eq!(Key::parse("F13"), None);
    assert_eq!(Key::parse("nonsense"), None);
    assert_eq!(Key::parse(""), None);
}
