//! Commands of the list of values.

use std::path::PathBuf;
use std::sync::Arc;

use assur_words::{name, text};

use super::write::home;
use crate::screen::state::{
    Assembled, Change, Effect, OutputFile, PromptKind, Reading, Role, STEPS, Scene, Source, State, Wanted,
};

pub(crate) fn toggle(state: &mut State) {
    (state.what_if.open, state.probe) = (!state.values_open(), None);
}

pub(super) fn step(state: &mut State) {
    state.what_if.step = (state.what_if.step + 1) % STEPS.len();
}

pub(super) fn shift(state: &mut State, sense: f64) {
    let what = &mut state.what_if;
    let Some(value) = what.values.get(what.chosen) else { return };
    if let Some(toml) = value.moved(what.now(what.chosen), sense * what.per_cent()) {
        put(state, state.what_if.chosen, toml);
    } else {
        let (key, exact) = (value.key.clone(), name(state.keys.first("exact-value")));
        state.say(Role::Bad, text!("say-no-per-cent", key = &key, exact = exact));
    }
}

pub(super) fn put(state: &mut State, index: usize, toml: String) {
    if state.what_if.put([(index, toml)]) {
        ask(state);
    }
}

/// Takes a mode of a group, by its points, and reads the changed scene; returns whether anything changes.
pub(super) fn assemble(state: &mut State, points: &[Assembled]) -> bool {
    let differs = state.what_if.assemble(points);
    if differs {
        ask(state);
    }
    differs
}

/// The same as a part of the last change.
pub(super) fn assemble_too(state: &mut State, points: &[Assembled]) {
    if state.what_if.assemble(points) {
        let more = state.what_if.done.pop().unwrap_or_default();
        if let Some(last) = state.what_if.done.last_mut() {
            last.extend(more);
        }
        ask(state);
    }
}

pub(super) fn undo(state: &mut State) {
    match state.what_if.done.pop() {
        Some(values) => {
            for (index, before) in values.into_iter().rev() {
                state.what_if.set(index, before);
            }
            ask(state);
        }
        None => state.say(Role::Plain, text!("say-no-change")),
    }
}

/// Requests the scene with the present values, unless it is shown or the one before is still being read.
pub(super) fn ask(state: &mut State) {
    let (what, Some(scene)) = (&mut state.what_if, &state.scene) else { return };
    if what.reading == Reading::Runs {
        return;
    }
    if what.wanted == what.shown {
        what.reading = Reading::Done;
        return;
    }
    what.reading = Reading::Runs;
    let (edits, session, text) = (what.wanted.clone(), Arc::clone(&scene.session), what.changed_text());
    let change = Change { opening: what.opening, edits, session, text };
    state.read(Wanted::Change(change));
}

/// Another scene was opened, or the file was reread: changes are dropped, with a message.
pub(super) fn reloaded(state: &mut State, scene: &Scene, again: bool) {
    let dropped = state.what_if.changes();
    state.compared.take_if(|compared| compared.before);
    state.what_if = state.what_if.next(scene, again);
    if again {
        let text = match dropped {
            0 => text!("say-reread"),
            _ => text!("say-reread-dropped", count = dropped),
        };
        state.say(Role::Good, text);
    }
}

pub(super) fn exact(state: &mut State) {
    if let Some(value) = state.what_if.values.get(state.what_if.chosen) {
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
    let values = state.what_if.values.iter().enumerate();
    let found =
        values.into_iter().find_map(|(index, value)| Some((index, value, typed(&value.key.to_string())?)));
    let Some((index, value, typed)) = found else { return false };
    if typed.is_empty() {
        let (key, value) = (&value.key, name(state.what_if.shown(index)));
        state.say(Role::Plain, text!("say-value-is", key = key, value = value));
    } else {
        let toml = value.typed(typed);
        put(state, index, toml);
    }
    true
}

pub(super) fn save(state: &mut State) {
    let Some(Scene { session, .. }) = &state.scene else { return };
    let source = &session.source;
    let name = PathBuf::from(source.name()).with_file_name(format!("{}-2.toml", source.stem()));
    state.open_prompt(PromptKind::Command, format!("save {}", name.display()));
}

/// `save FILE` of the `:` line: writes the scene with the changes.
pub(super) fn save_line(state: &mut State, file: &str) {
    if file.is_empty() {
        return save(state);
    }
    if state.what_if.reading != Reading::Done {
        let undo = name(state.keys.first("undo"));
        return state.say(Role::Bad, text!("say-change-not-taken", undo = undo));
    }
    let (path, content) = (home(file), state.what_if.changed_text().into_bytes());
    let file = OutputFile { path, content, scene: true, ..OutputFile::default() };
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
    if may_drop(state) {
        state.read(Wanted::Open(source));
    } else {
        let save = name(state.keys.first("save"));
        state.say(Role::Bad, text!("say-unsaved-open", save = save));
    }
}

/// Whether nothing would be lost, or the user has been warned.
fn may_drop(state: &mut State) -> bool {
    let may = state.what_if.may_drop();
    state.what_if.warned |= !may;
    may
}
