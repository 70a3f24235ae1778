//! Writing what is shown to a file: SVG of the drawing, CSV of the rest.

use std::path::PathBuf;

use crossterm::event::KeyCode;

use super::key::Key;
use super::state::{State, View, Wish};
use super::study::Study;
use super::text::fill;
use super::theme::Role;
use super::{csv, svg};

/// A file to be written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct OutputFile {
    pub(crate) path: PathBuf,
    pub(crate) content: String,
    /// Whether an old file of this name may go.
    pub(crate) overwrite: bool,
    /// Whether it is the open scene with its changes.
    pub(crate) scene: bool,
}

/// Asks for a file of the present view.
pub(crate) fn write(state: &mut State) {
    let Some(study) = &state.study else {
        state.say(Role::Plain, state.texts.nothing_to_write);
        return;
    };
    let (ending, content) = match state.view {
        View::Mechanism | View::Structure => ("svg", svg::drawing(study, state.position)),
        View::Curves => ("csv", csv::of_columns(study, &curve_columns(state, study))),
        _ => ("csv", csv::of_columns(study, &(0..study.column_count()).collect::<Vec<_>>())),
    };
    let name = file_name(state, study, ending);
    let file = OutputFile { path: PathBuf::from(name), content, overwrite: false, scene: false };
    state.wishes.push(Wish::Write(file));
}

fn curve_columns(state: &State, study: &Study) -> Vec<usize> {
    let orders = study.transfers.get(state.chosen.transfer).map(|transfer| transfer.orders);
    std::iter::once(0).chain(orders.into_iter().flatten()).collect()
}

/// `shaper-mechanism-12.svg`: the scene, the view and, for a drawing, the position.
fn file_name(state: &State, study: &Study, ending: &str) -> String {
    let name = study.source.name();
    let stem =
        PathBuf::from(&name).file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    match state.view {
        View::Mechanism | View::Structure => format!("{stem}-mechanism-{}.{ending}", state.position),
        View::Curves => {
            let curve = study.transfers.get(state.chosen.transfer).map_or("", |transfer| &transfer.name);
            let curve: String = curve.chars().map(|c| if c.is_alphanumeric() { c } else { '-' }).collect();
            format!("{stem}-{curve}.{ending}")
        }
        _ => format!("{stem}-table.{ending}"),
    }
}

/// Writes a file, or asks where there is one already.
pub(crate) fn grant(state: &mut State, file: OutputFile) {
    let path = std::path::absolute(&file.path).unwrap_or_else(|_| file.path.clone());
    if path.exists() && !file.overwrite {
        state.question = Some(file);
        return;
    }
    match crate::cli::write(&path, &file.content) {
        Ok(()) => {
            if file.scene {
                state.what_if.keep_saved();
            }
            state.say(Role::Good, fill(state.texts.written, &[&path.display()]));
        }
        Err(fault) => state.say(Role::Bad, fault.to_string()),
    }
}

/// The answer to "overwrite?".
pub(crate) fn answer(state: &mut State, file: OutputFile, key: Key) {
    if matches!(key.code, KeyCode::Char('y' | 'Y')) {
        state.message = None;
        state.wishes.push(Wish::Write(OutputFile { overwrite: true, ..file }));
    } else {
        state.say(Role::Plain, fill(state.texts.kept, &[&file.path.display()]));
    }
}
