//! Writing what is shown to files: the picture, and the numbers behind it.

use std::path::PathBuf;
use std::sync::Arc;

use assur_analysis::results::Check;
use assur_figure::{Figure, Frame, Item, dxf, svg};
use assur_report::csv::{self, CsvCell};
use assur_words::{Describe, Text, name, text};
use crossterm::event::KeyCode;

use crate::files;
use crate::screen::state::{Effect, Job, Key, OutputFile, Question, Role, Scene, State, View, ViewPart};
use crate::screen::view;
use crate::still::{PAGE, picture};

const TEXT: u16 = 100;

/// Writes the picture of the view with its numbers, or the numbers alone, to a name that says what they are.
pub(super) fn write(state: &mut State) {
    let Some(scene) = &state.scene else {
        return state.say(Role::Plain, text!("say-nothing-to-write"));
    };
    let stem = scene.session.source.stem();
    let of = subject(state, scene).join("-");
    let of: String = of.chars().map(|c| if c.is_alphanumeric() { c } else { '-' }).collect();
    let path = match view::figure(state, state.view) {
        Some(_) => format!("{stem}-{of}-{}.svg", state.position),
        None if state.view == View::Working => format!("{stem}-{of}-{}.txt", state.position),
        None => format!("{stem}-{of}.csv"),
    };
    write_to(state, path.into());
}

/// What is shown, by its names: the view with its part, and of whom or what.
fn subject(state: &State, scene: &Scene) -> Vec<String> {
    let (view, part) = (state.view, state.part(state.view));
    let mut names = vec![view.command().to_owned()];
    names.extend(
        view.parts().iter().skip(1).find(|other| **other == part).map(<&str>::from).map(str::to_owned),
    );
    match view {
        View::Curves if !state.picked.is_empty() => return state.picked.clone(),
        View::Curves => {
            let transfer = scene.transfers.get(state.chosen.transfer);
            return transfer.map(|transfer| transfer.name.to_string()).into_iter().collect();
        }
        View::Forces => {
            let reactions = state.found().map_or(&[][..], |found| &found.reactions);
            names.extend(reactions.get(state.chosen.reaction).map(|reaction| reaction.name.to_string()));
        }
        View::Plans if part == ViewPart::Forces => names.push((state.chosen.polygon + 1).to_string()),
        _ => {}
    }
    names
}

pub(super) fn write_to(state: &mut State, path: PathBuf) {
    let Some(scene) = &state.scene else {
        return state.say(Role::Plain, text!("say-nothing-to-write"));
    };
    let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    let figure = view::figure(state, state.view);
    let numbers = numbers(state, scene, figure.as_ref());
    let content = match (&figure, ending.as_str()) {
        (_, "txt") if state.view == View::Working => {
            let lines = view::report::lines(state, View::Working, TEXT);
            Ok(((lines.join("\n") + "\n").into_bytes(), None))
        }
        (_, "csv") => numbers.map(|numbers| (numbers, None)),
        (None, _) => Err(text!("say-no-picture")),
        (Some(figure), "dxf") => {
            let drawn = dxf::write(std::slice::from_ref(figure), state.language());
            drawn.and_then(|drawn| numbers.map(|numbers| (drawn.into_bytes(), Some(numbers))))
        }
        (Some(figure), _) => {
            let (svg, size) = svg::sheet(std::slice::from_ref(figure), 1, PAGE, state.language());
            let picture = picture(svg, &path, size);
            picture.and_then(|picture| numbers.map(|numbers| (picture, Some(numbers))))
        }
    };
    match content {
        Ok((content, numbers)) => {
            let file = OutputFile { path, content, numbers, ..OutputFile::default() };
            state.effects.push(Effect::Write(file));
        }
        Err(error) => state.say(Role::Bad, error),
    }
}

/// Writes the explanatory note of the scene that is shown to a name of its own.
pub(super) fn note(state: &mut State) {
    let Some(scene) = &state.scene else {
        return state.say(Role::Plain, text!("say-no-scene-for-note"));
    };
    let path = PathBuf::from(format!("{}-note.html", scene.session.source.stem()));
    let (session, options) = (Arc::clone(&scene.session), state.options.clone());
    state.effects.push(Effect::Work(Job::Note { session, options, path }));
    state.say(Role::Plain, text!("say-note-written"));
}

/// The numbers of the view: the quantities over the positions, or of another figure its points.
fn numbers(state: &State, scene: &Scene, figure: Option<&Figure>) -> Result<Vec<u8>, Text> {
    let (beyond, part) = (|index: &usize| index + scene.series.len(), state.part(state.view));
    match (state.view, scene.transfers.get(state.chosen.transfer), state.found()) {
        (View::Mechanism, ..) => table(scene, 0..scene.series.len()),
        (View::Curves, ..) if !state.picked.is_empty() => {
            let picked = (0..scene.column_count()).filter(|index| {
                scene.column(*index).is_some_and(|series| state.picked.contains(&series.short))
            });
            table(scene, std::iter::once(0).chain(picked.filter(|index| *index > 0)))
        }
        (View::Curves, Some(transfer), _) => table(scene, std::iter::once(0).chain(transfer.orders)),
        (View::Forces, _, Some(found)) if [ViewPart::Overview, ViewPart::Curves].contains(&part) => {
            match found.reactions.get(state.chosen.reaction) {
                Some(reaction) => {
                    let columns = reaction.series.iter().chain(&reaction.moment).map(beyond);
                    table(scene, std::iter::once(0).chain(columns))
                }
                None => table(scene, 0..scene.column_count()),
            }
        }
        (View::Checks, _, Some(found)) => {
            let header = ["check", "residual", "limit", "where", "position", "ok"];
            let checks = &found.analysis.checks;
            let words_of = |check: &Check| [&check.name, &check.finding.place].map(ToString::to_string);
            let words: Vec<_> = checks.iter().map(words_of).collect();
            let rows = checks.iter().zip(&words).map(|(check, words)| row(check, words));
            bytes(csv::write(&header, rows, false))
        }
        (View::Working, ..) => Err(text!("say-working-is-text")),
        (View::Accuracy, ..) => match state.measured.as_ref().map(|measured| &measured.chart) {
            Some(Ok(data)) => bytes(assur_study::chart::csv(data)),
            Some(Err(error)) => Err(error.clone()),
            None => Err(text!("say-nothing-measured")),
        },
        (View::Forces | View::Plans | View::Motion | View::Drive | View::Structure, ..)
            if figure.is_some() =>
        {
            points(figure.map_or(&[][..], |figure| &figure.panels))
        }
        _ => table(scene, 0..scene.column_count()),
    }
}

/// A check as a row; the last cell is empty where the check is not conclusive.
fn row<'a>(check: &Check, [name, place]: &'a [String; 2]) -> [CsvCell<'a>; 6] {
    let ok =
        check.finding.holds.map_or(CsvCell::Empty, |ok| CsvCell::Text(if ok { "true" } else { "false" }));
    let at = check.at.map_or(CsvCell::Empty, |at| CsvCell::Number(at as f64));
    let [residual, limit] = [check.finding.error, check.finding.bound].map(finite);
    [CsvCell::Text(name), residual, limit, CsvCell::Text(place), at, ok]
}

/// A number; an empty cell where it is not determined.
fn finite(value: f64) -> CsvCell<'static> {
    if value.is_finite() { CsvCell::Number(value) } else { CsvCell::Empty }
}

fn bytes(written: Result<String, impl Describe>) -> Result<Vec<u8>, Text> {
    written.map(String::into_bytes).map_err(|error| error.describe())
}

/// The points of every line and arrow of panels, a row each.
fn points(panels: &[assur_figure::Panel]) -> Result<Vec<u8>, Text> {
    let mut rows = Vec::new();
    for (index, panel) in panels.iter().enumerate() {
        let axes = match &panel.frame {
            Frame::Plane { scales, .. } => scales.first().map_or(String::new(), |scale| scale.unit.clone()),
            Frame::Axes { x, y, .. } => format!("{}; {}", x.label, y.label),
        };
        let title = if panel.title.is_empty() { index.to_string() } else { panel.title.to_string() };
        let lines = panel.items.iter().filter(|item| matches!(item, Item::Line { .. } | Item::Arrow { .. }));
        for (line, item) in lines.enumerate() {
            for at in item.points().iter().filter(|at| at[0].is_finite() && at[1].is_finite()) {
                rows.push((title.clone(), axes.clone(), line, *at));
            }
        }
    }
    let rows = rows.iter().map(|(title, axes, line, [x, y])| {
        [CsvCell::Text(title), CsvCell::Text(axes), finite(*line as f64), finite(*x), finite(*y)]
    });
    bytes(csv::write(&["panel", "axes", "line", "x", "y"], rows, false))
}

/// The position and these columns as CSV, each column with its unit in the name; a missing number is an empty field.
fn table(scene: &Scene, columns: impl Iterator<Item = usize>) -> Result<Vec<u8>, Text> {
    let columns: Vec<_> = columns.filter_map(|column| scene.column(column)).collect();
    let names = columns.iter().map(|series| format!("{}_{}", series.short, series.unit.name));
    let header: Vec<String> = std::iter::once("position".to_owned()).chain(names).collect();
    let row = |position: usize| {
        let values = columns.iter().map(move |series| finite(series.at(position)));
        std::iter::once(CsvCell::Number(position as f64)).chain(values)
    };
    bytes(csv::write(&header, (0..scene.positions()).map(row), false))
}

/// Writes a file and the numbers beside it, or asks if one exists already.
pub(crate) fn grant(state: &mut State, file: OutputFile) {
    let path = std::path::absolute(&file.path).unwrap_or_else(|_| file.path.clone());
    let beside = path.with_extension("csv");
    if (path.exists() || (file.numbers.is_some() && beside.exists())) && !file.overwrite {
        state.question = Some(Question::Overwrite(file));
        return;
    }
    let numbers = file.numbers.as_ref().map_or(Ok(()), |numbers| files::write(&beside, numbers));
    match numbers.and_then(|()| files::write(&path, &file.content)) {
        Ok(()) => {
            if file.scene {
                state.draft.save(&file.path);
            }
            let told = if file.numbers.is_some() { "say-written-both" } else { "say-written" };
            state.say(Role::Good, text!(told, file = name(path.display().to_string())));
        }
        Err(error) => state.say(Role::Bad, error.describe()),
    }
}

/// The answer to "overwrite?".
pub(super) fn answer(state: &mut State, file: OutputFile, key: Key) {
    if matches!(key.code, KeyCode::Char('y' | 'Y')) {
        state.message = None;
        state.effects.push(Effect::Write(OutputFile { overwrite: true, ..file }));
    } else {
        state.say(Role::Plain, text!("say-left", file = name(file.path.display().to_string())));
    }
}

/// `~/` is the home of the user, as in a shell.
pub(super) fn home(name: &str) -> PathBuf {
    let home = || std::env::var_os("HOME").map(PathBuf::from);
    name.strip_prefix("~/").and_then(|rest| Some(home()?.join(rest))).unwrap_or_else(|| PathBuf::from(name))
}
