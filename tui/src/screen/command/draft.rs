//! Commands of the list of values.

use std::path::PathBuf;
use std::sync::Arc;

use assur_draft::Difference;
use assur_scene::edit::bare;
use assur_words::{Text, list, name, text};

use super::write::home;
use crate::screen::state::{
    Assembled, Change, Draft, Effect, OutputFile, PromptKind, Reading, Role, STEPS, Scene, Source, State,
    View, Wanted,
};

/// More differences between two texts are counted.
const MOST_TOLD: usize = 3;

pub(crate) fn toggle(state: &mut State) {
    (state.draft.open, state.probe) = (!state.values_open(), None);
}

pub(super) fn step(state: &mut State) {
    state.draft.step = (state.draft.step + 1) % STEPS.len();
}

pub(super) fn shift(state: &mut State, sense: f64) {
    let draft = &state.draft;
    let Some(value) = draft.values.get(draft.chosen) else { return };
    if let Some(toml) = value.moved(draft.now(draft.chosen), sense * draft.per_cent()) {
        put(state, state.draft.chosen, &toml);
    } else {
        let (key, exact) = (value.key.clone(), name(state.keys.first("exact-value")));
        state.say(Role::Bad, text!("say-no-per-cent", key = &key, exact = exact));
    }
}

pub(super) fn put(state: &mut State, index: usize, toml: &str) {
    if state.draft.put(index, toml) {
        ask(state);
    }
}

/// Makes another text of the scene in one step, or tells why there is none; returns whether the text differs.
pub(super) fn take(state: &mut State, text: Result<String, Text>) -> bool {
    match text {
        Ok(text) => {
            let differs = state.draft.take(&text);
            if differs {
                ask(state);
            }
            differs
        }
        Err(problem) => {
            state.say(Role::Bad, problem);
            false
        }
    }
}

/// Takes a mode of a group, by its points, and reads the changed scene; returns whether anything changes.
pub(super) fn assemble(state: &mut State, points: &[Assembled]) -> bool {
    let text = state.draft.assembled(points);
    take(state, text)
}

/// The same as a part of the last change.
pub(super) fn assemble_too(state: &mut State, points: &[Assembled]) {
    if let Ok(text) = state.draft.assembled(points)
        && state.draft.amend(&text)
    {
        ask(state);
    }
}

pub(super) fn undo(state: &mut State) {
    retrace(state, Draft::undo, ["build-undone", "say-no-change"]);
}

pub(super) fn redo(state: &mut State) {
    retrace(state, Draft::redo, ["build-redone", "say-no-step-undone"]);
}

/// Goes back or forth in the steps; while a mechanism is built, what differs then is told.
fn retrace(state: &mut State, step: fn(&mut Draft) -> bool, [told, none]: [&'static str; 2]) {
    let before = Arc::clone(state.draft.text());
    if !step(&mut state.draft) {
        return state.say(Role::Plain, text!(none));
    }
    if state.view == View::Build {
        let what = difference(&before, state.draft.text());
        state.say(Role::Plain, text!(told, what));
    }
    ask(state);
}

/// The first keys at which two texts differ: numbers and words with both values, `+` before what is new and `-` before what is gone.
fn difference(before: &str, after: &str) -> Text {
    let all = assur_draft::differences(before, after);
    let told = |one: &Difference| {
        let key = name(one.key.to_string());
        match [&one.before, &one.after].map(|value| value.as_ref().map(|value| name(bare(value)))) {
            [Some(from), Some(to)] => text!("build-changed", key, from, to),
            [None, _] => text!("build-new-key", key),
            [_, None] => text!("build-gone-key", key),
        }
    };
    let more = all.len().saturating_sub(MOST_TOLD);
    let more = Some(text!("build-more-keys", count = more)).filter(|_| more > 0);
    list(all.iter().take(MOST_TOLD).map(told).chain(more))
}

/// Requests the scene of the present text, unless it is shown or the one before is still being read.
pub(super) fn ask(state: &mut State) {
    super::reading::refresh(state);
    let State { draft, build, scene, .. } = state;
    if draft.reading == Reading::Runs {
        return;
    }
    if *draft.text() == draft.shown && (scene.is_some() || state.view != View::Build) {
        draft.reading = Reading::Done;
        return;
    }
    let text = Arc::clone(draft.text());
    let readable = match &build.read {
        Some(read) if state.view == View::Build => match &read.readable {
            Some(readable) => Arc::clone(readable),
            None => return,
        },
        _ => Arc::clone(&text),
    };
    let session = scene.as_ref().map(|scene| Arc::clone(&scene.session));
    let source = draft.source.clone();
    draft.reading = Reading::Runs;
    let change = Change { opening: draft.opening, text, readable, session, source };
    state.read(Wanted::Change(change));
}

/// Another scene was opened, or the file was reread: changes are dropped, with a message.
pub(super) fn reloaded(state: &mut State, scene: &Scene, again: bool) {
    let dropped = state.draft.changes();
    state.compared.take_if(|compared| compared.before);
    state.draft = state.draft.next(scene, again);
    if again {
        let text = match dropped {
            0 => text!("say-reread"),
            _ => {
                text!("say-reread-dropped", count = dropped, undo = name(state.keys.first("undo")))
            }
        };
        state.say(Role::Good, text);
    }
}

pub(super) fn exact(state: &mut State) {
    if let Some(value) = state.draft.values.get(state.draft.chosen) {
        let line = format!("value {} ", value.key);
        state.open_prompt(PromptKind::Command, line);
    }
}

/// `value KEY VALUE` of the `:` line: changes the value, or without VALUE shows it; false if there is no such key.
pub(super) fn set(state: &mut State, rest: &str) -> bool {
    let typed = |key: &str| {
        let typed = rest.strip_prefix(key)?;
        (typed.is_empty() || typed.starts_with(char::is_whitespace)).then(|| typed.trim())
    };
    let values = state.draft.values.iter().enumerate();
    let found =
        values.into_iter().find_map(|(index, value)| Some((index, value, typed(&value.key.to_string())?)));
    let Some((index, value, typed)) = found else { return false };
    if typed.is_empty() {
        let (key, value) = (&value.key, name(state.draft.shown_value(index)));
        state.say(Role::Plain, text!("say-value-is", key = key, value = value));
    } else {
        let toml = value.typed(typed);
        put(state, index, &toml);
    }
    true
}

pub(super) fn save(state: &mut State) {
    let source = &state.draft.source;
    let name = match (state.view, source) {
        // A scene that is built is saved where it comes from; one that is new has no name yet.
        (View::Build, Source::File(path)) => path.display().to_string(),
        (_, Source::New) => String::new(),
        _ => {
            let file = format!("{}-2.toml", source.stem());
            PathBuf::from(source.name()).with_file_name(file).display().to_string()
        }
    };
    let is_nameless = name.is_empty();
    state.open_prompt(PromptKind::Command, format!("save {name}"));
    if is_nameless {
        state.say(Role::Plain, text!("say-name-the-file"));
    }
}

/// `save FILE` of the `:` line: writes the scene with the changes.
pub(super) fn save_line(state: &mut State, file: &str) {
    if file.is_empty() {
        return save(state);
    }
    if state.draft.reading != Reading::Done && state.view != View::Build {
        let undo = name(state.keys.first("undo"));
        return state.say(Role::Bad, text!("say-change-not-taken", undo = undo));
    }
    let (mut path, content) = (home(file), state.draft.text().as_bytes().to_vec());
    if path.extension().is_none() && !path.is_dir() {
        path.set_extension("toml");
    }
    // Its own file is replaced without a question, if nobody else has changed it.
    let overwrite =
        matches!(&state.draft.source, Source::File(own) if *own == path) && state.draft.is_known(&path);
    let file = OutputFile { path, content, overwrite, scene: true, ..OutputFile::default() };
    state.effects.push(Effect::Write(file));
}

pub(super) fn quit(state: &mut State) {
    if may_drop(state) {
        state.effects.push(Effect::Quit);
    } else {
        let [save, quit] = ["save", "quit"].map(|command| name(state.keys.first(command)));
        state.say(Role::Bad, text!("say-unsaved-quit", save = save, quit = quit));
    }
}

pub(super) fn open(state: &mut State, source: Source) {
    if may_open(state) {
        state.read(Wanted::Open(source));
    }
}

/// Whether another scene may be opened; if not, that is told.
pub(super) fn may_open(state: &mut State) -> bool {
    let may = may_drop(state);
    if !may {
        let save = name(state.keys.first("save"));
        state.say(Role::Bad, text!("say-unsaved-open", save = save));
    }
    may
}

/// Whether nothing would be lost, or the user has been warned.
fn may_drop(state: &mut State) -> bool {
    let may = state.draft.may_drop();
    state.draft.warned |= !may;
    may
}
