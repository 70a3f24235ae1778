//! `assur new`, `assur completions` and `assur man`: what needs no scene.

use std::path::Path;

use super::fault::{Fault, Status};
use super::{output, program};
use crate::files;
use assur_fixtures::SCENES;

pub(crate) fn completions(shell: clap_complete::Shell) -> Result<Status, Fault> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut program::command(), program::own().name, &mut script);
    output::print(&String::from_utf8_lossy(&script))?;
    Ok(Status::Done)
}

pub(crate) fn man() -> Result<Status, Fault> {
    let mut page = Vec::new();
    let mut command = program::command();
    command.build();
    clap_mangen::Man::new(command.clone()).render(&mut page).map_err(Fault::other)?;
    for sub in command.get_subcommands().filter(|sub| sub.get_name() != "help") {
        let man = clap_mangen::Man::new(sub.clone());
        let title = format!("{} {}", program::own().name, sub.get_name()).to_uppercase();
        page.extend(format!(".SH {}\n", title.replace('-', "\\-")).bytes());
        man.render_description_section(&mut page).map_err(Fault::other)?;
        man.render_options_section(&mut page).map_err(Fault::other)?;
    }
    page.extend(super::keys::manual().bytes());
    output::print(&String::from_utf8_lossy(&page))?;
    Ok(Status::Done)
}

pub(crate) fn new(path: &Path, kind: Option<&str>) -> Result<Status, Fault> {
    let scene =
        SCENES.iter().find(|(known, _)| Some(*known) == kind).map_or(assur_scene::STARTER, |(_, text)| text);
    files::remove_on_signals();
    files::create(path, scene)?;
    Ok(Status::Done)
}
