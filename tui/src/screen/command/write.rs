//! Writing what is shown to a file: SVG of the drawing, CSV of the rest.

use std::path::{Path, PathBuf};

use crossterm::event::KeyCode;

use crate::files;
use crate::screen::draw::svg;
use crate::screen::state::{Key, OutputFile, Role, Scene, State, View, Wish};

/// Asks for the name of a file for the present view.
pub(super) fn write(state: &mut State) {
    let Some(scene) = &state.scene else {
        return state.say(Role::Plain, "this view has nothing to write");
    };
    let transfer = scene.transfers.get(state.chosen.transfer);
    let name = scene.source.name();
    let stem = Path::new(&name).file_stem().unwrap_or_default().to_string_lossy();
    let (path, content) = match (state.view, transfer) {
        (View::Mechanism | View::Structure, _) => {
            (format!("{stem}-mechanism-{}.svg", state.position), Ok(svg::drawing(scene, state.position)))
        }
        (View::Curves, Some(transfer)) => {
            let letters = transfer.name.chars();
            let curve: String = letters.map(|c| if c.is_alphanumeric() { c } else { '-' }).collect();
            let columns = std::iter::once(0).chain(transfer.orders);
            (format!("{stem}-{curve}.csv"), table(scene, columns))
        }
        _ => (format!("{stem}-table.csv"), table(scene, 0..scene.column_count())),
    };
    match content {
        Ok(content) => {
            let file = OutputFile { path: path.into(), content, overwrite: false, scene: false };
            state.wishes.push(Wish::Write(file));
        }
        Err(error) => state.say(Role::Bad, error.to_string()),
    }
}

/// The position and these columns as CSV, each column with its unit in the name; a missing number is an empty field.
fn table(scene: &Scene, columns: impl Iterator<Item = usize>) -> Result<String, Box<dyn std::error::Error>> {
    let columns: Vec<_> = columns.filter_map(|column| scene.column(column)).collect();
    let mut writer = csv::Writer::from_writer(Vec::new());
    let names = columns.iter().map(|series| format!("{}_{}", series.short, series.unit));
    writer.write_record(std::iter::once("position".to_owned()).chain(names))?;
    for position in 0..scene.positions() {
        let values = columns.iter().map(|series| series.at(position));
        let values = values.map(|value| if value.is_finite() { value.to_string() } else { String::new() });
        writer.write_record(std::iter::once(position.to_string()).chain(values))?;
    }
    Ok(String::from_utf8(writer.into_inner()?)?)
}

/// Writes a file, or asks if it exists already.
pub(crate) fn grant(state: &mut State, file: OutputFile) {
    let path = std::path::absolute(&file.path).unwrap_or_else(|_| file.path.clone());
    if path.exists() && !file.overwrite {
        state.question = Some(file);
        return;
    }
    match files::write(&path, &file.content) {
        Ok(()) => {
            if file.scene {
                state.what_if.keep_saved();
            }
            state.say(Role::Good, format!("written: {}", path.display()));
        }
        Err(error) => state.say(Role::Bad, error.to_string()),
    }
}

/// The answer to "overwrite?".
pub(super) fn answer(state: &mut State, file: OutputFile, key: Key) {
    if matches!(key.code, KeyCode::Char('y' | 'Y')) {
        state.message = None;
        state.wishes.push(Wish::Write(OutputFile { overwrite: true, ..file }));
    } else {
        state.say(Role::Plain, format!("{} was left as it is", file.path.display()));
    }
}

/// `~/` is the home of the user, as in a shell.
pub(super) fn home(name: &str) -> PathBuf {
    let home = || std::env::var_os("HOME").map(PathBuf::from);
    name.strip_prefix("~/").and_then(|rest| Some(home()?.join(rest))).unwrap_or_else(|| PathBuf::from(name))
}
