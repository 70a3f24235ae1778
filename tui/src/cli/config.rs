//! `assur config`, and the file of the user.

#[cfg(test)]
mod tests;

use std::path::{Path, PathBuf};

use super::fault::{Fault, Status};
use super::output;
use super::style::Style;
use crate::files;
use crate::screen::{Config, default_text};

/// Path of the file below the folder of configurations.
const FILE: &str = "assur/config.toml";

pub(crate) fn print(style: Style) -> Result<Status, Fault> {
    output::print(&style.text(&default_text(style.language)))?;
    Ok(Status::Done)
}

/// The path of the configuration of the user, which need not exist.
pub(crate) fn file() -> Option<PathBuf> {
    path(|name| std::env::var_os(name).map(PathBuf::from))
}

/// The configuration of the user; or the default, with the reason. A missing file is no error.
pub(crate) fn load() -> (Config, Option<Fault>) {
    match file().filter(|path| path.exists()).map(|path| read(&path)) {
        None => (Config::default(), None),
        Some(Ok(config)) => (config, None),
        Some(Err(fault)) => (Config::default(), Some(fault)),
    }
}

fn read(path: &Path) -> Result<Config, Fault> {
    let text = files::read(path)?;
    Config::read(&path.display().to_string(), &text).map_err(Fault::scene)
}

/// `$XDG_CONFIG_HOME`, else `~/.config`; a path that is not absolute counts as unset, as the specification demands.
fn path(variable: impl Fn(&str) -> Option<PathBuf>) -> Option<PathBuf> {
    let own = variable("XDG_CONFIG_HOME").filter(|folder| folder.is_absolute());
    let home = || variable("HOME").filter(|home| home.is_absolute()).map(|home| home.join(".config"));
    own.or_else(home).map(|folder| folder.join(FILE))
}
