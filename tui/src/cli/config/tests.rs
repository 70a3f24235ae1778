//! Tests of `config`.

use super::path;
use std::path::{Path, PathBuf};

fn with(pairs: &[(&str, &str)]) -> Option<PathBuf> {
    path(|name| pairs.iter().find(|(key, _)| *key == name).map(|(_, value)| PathBuf::from(value)))
}

#[test]
fn the_folder_of_the_user_or_the_one_in_his_home() {
    let file = |name: &str| Some(Path::new(name).to_owned());
    let home = ("HOME", "/home/u");
    assert_eq!(with(&[home]), file("/home/u/.config/assur/config.toml"));
    assert_eq!(with(&[("XDG_CONFIG_HOME", "/x"), home]), file("/x/assur/config.toml"));
    assert_eq!(with(&[("XDG_CONFIG_HOME", ""), home]), with(&[home]));
    assert_eq!(with(&[("XDG_CONFIG_HOME", "relative"), home]), with(&[home]));
    assert_eq!(with(&[]), None);
}
