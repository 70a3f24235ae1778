//! What the commands of the list do, and what comes back from reading a changed scene.

use std::path::PathBuf;

use super::{Change, Reading, STEPS};
use crate::screen::accuracy::{self, Accuracy};
use crate::screen::act::round;
use crate::screen::prompt;
use crate::screen::state::{State, View, Wish};
use crate::screen::study::{Source, Study};
use crate::screen::text::fill;
use crate::screen::theme::Role;
use crate::screen::work::Job;
use crate::screen::writing::OutputFile;

impl State {
    /// Whether the list of values is shown.
    pub(crate) fn values_open(&self) -> bool {
        self.what_if.open && self.study.is_some() && self.view != View::Menu
    }

    /// Shows a changed scene where the one before was: view, position and choices stay.
    fn exchange(&mut self, study: Study) {
        if let Some(old) = self.study.as_ref().filter(|old| old.found.is_some()) {
            self.what_if.compared = old.other.as_ref().map(|other| other.analyzer.clone());
        }
        self.position = self.position.min(study.positions().saturating_sub(1));
        self.study = Some(study);
        accuracy::stop(self);
        self.accuracy = Accuracy::default();
        self.generation += 1;
        self.analyze(false);
        if let Some(other) = self.what_if.compared.clone() {
            let now = self.analyzer.replace(other);
            self.analyze(true);
            self.analyzer = now;
        }
    }
}

/// Shows the list of values, or closes it.
pub(crate) fn toggle(state: &mut State) {
    state.what_if.open = !state.values_open();
}

/// The next or previous value.
pub(crate) fn choose(state: &mut State, by: isize) {
    state.what_if.chosen = round(state.what_if.chosen, by, state.what_if.values.len());
}

/// The next size of a step.
pub(crate) fn step(state: &mut State) {
    state.what_if.step = (state.what_if.step + 1) % STEPS.len();
}

/// The chosen value, a step up.
pub(crate) fn raise(state: &mut State) {
    shift(state, 1.0);
}

/// The chosen value, a step down.
pub(crate) fn lower(state: &mut State) {
    shift(state, -1.0);
}

fn shift(state: &mut State, sense: f64) {
    let what = &mut state.what_if;
    let Some(value) = what.values.get(what.chosen) else { return };
    if let Some(toml) = value.moved(what.now(what.chosen), sense * what.per_cent()) {
        put(state, state.what_if.chosen, toml);
    } else {
        let text = fill(state.texts.no_per_cent, &[&value.key, &state.keys.first("exact-value")]);
        state.say(Role::Bad, text);
    }
}

fn put(state: &mut State, index: usize, toml: String) {
    if state.what_if.put(index, toml) {
        ask(state);
    }
}

/// Takes back the last change.
pub(crate) fn undo(state: &mut State) {
    match state.what_if.done.pop() {
        Some((index, before)) => {
            state.what_if.set(index, before);
            ask(state);
        }
        None => state.say(Role::Plain, state.texts.nothing_to_undo),
    }
}

/// Asks for the scene as it is wanted, unless it is shown or the one before is still being read.
fn ask(state: &mut State) {
    let (what, Some(study)) = (&mut state.what_if, &state.study) else { return };
    if what.reading == Reading::Runs {
        return;
    }
    if what.wanted == what.shown {
        what.reading = Reading::Done;
        return;
    }
    what.reading = Reading::Runs;
    let change = Change {
        scene: what.scene,
        edits: what.wanted.clone(),
        source: study.source.clone(),
        text: what.changed_text(),
    };
    state.wishes.push(Wish::Work(Job::Change(change)));
}

/// Takes a changed scene, or why it is none; tells whether the frame may differ.
pub(crate) fn take(state: &mut State, change: &Change, study: Result<Box<Study>, String>) -> bool {
    let what = &mut state.what_if;
    if change.scene != what.scene {
        return false;
    }
    what.reading = Reading::Done;
    let late = change.edits != what.wanted;
    match study {
        Ok(study) => {
            what.shown.clone_from(&change.edits);
            state.exchange(*study);
        }
        Err(text) if !late => {
            what.reading = Reading::Refused;
            state.fault = Some((state.texts.change_title, text));
        }
        Err(_) => {}
    }
    if late {
        ask(state);
    }
    true
}

/// Another scene was opened, or the file was read again: changes are dropped, and that is said.
pub(crate) fn reloaded(state: &mut State, study: &Study, again: bool) {
    let dropped = state.what_if.changes();
    state.what_if = state.what_if.next(study, again);
    if again {
        let text = match dropped {
            0 => state.texts.reloaded.to_owned(),
            _ => fill(state.texts.reloaded_dropped, &[&dropped]),
        };
        state.say(Role::Good, text);
    }
}

/// Opens the `:` line for the exact value.
pub(crate) fn exact(state: &mut State) {
    if let Some(value) = state.what_if.values.get(state.what_if.chosen) {
        let line = format!("value {} ", value.key);
        prompt::open_with(state, line);
    }
}

/// `value KEY VALUE` of the `:` line: the value, or without one what it is.
pub(crate) fn set(state: &mut State, rest: &str) -> bool {
    let of = |value: &assur_scene::edit::SceneValue| {
        let typed = rest.strip_prefix(value.key.as_str())?;
        (typed.is_empty() || typed.starts_with(char::is_whitespace)).then(|| typed.trim().to_owned())
    };
    let found = state.what_if.values.iter().enumerate().find_map(|(index, v)| Some((index, of(v)?)));
    let Some((index, typed)) = found else { return false };
    let value = &state.what_if.values[index];
    if typed.is_empty() {
        let text = fill(state.texts.value_is, &[&value.key, &state.what_if.shown(index)]);
        state.say(Role::Plain, text);
    } else {
        let toml = value.typed(&typed);
        put(state, index, toml);
    }
    true
}

/// The next value whose key has the text.
pub(crate) fn search(state: &mut State, text: &str) {
    let (wanted, what) = (text.to_lowercase(), &mut state.what_if);
    let count = what.values.len();
    let fits = |index: &usize| what.values[*index].key.to_lowercase().contains(&wanted);
    match (1..=count).map(|step| (what.chosen + step) % count).find(fits) {
        Some(index) => what.chosen = index,
        None => state.say(Role::Bad, fill(state.texts.not_found, &[&text])),
    }
}

/// Opens the `:` line with a name for the changed scene.
pub(crate) fn save(state: &mut State) {
    let Some(study) = &state.study else { return };
    let path = PathBuf::from(study.source.name());
    let stem = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    let name = path.with_file_name(format!("{stem}-2.toml"));
    prompt::open_with(state, format!("save {}", name.display()));
}

/// `save FILE` of the `:` line: writes the scene with the changes.
pub(crate) fn save_line(state: &mut State, name: &str) {
    if name.is_empty() {
        save(state);
        return;
    }
    if state.what_if.reading != Reading::Done {
        state.say(Role::Bad, fill(state.texts.not_saved, &[&state.keys.first("undo")]));
        return;
    }
    let file =
        OutputFile { path: home(name), content: state.what_if.changed_text(), overwrite: false, scene: true };
    state.wishes.push(Wish::Write(file));
}

/// `~/` is the home of the user, as in a shell.
pub(crate) fn home(name: &str) -> PathBuf {
    let home = || std::env::var_os("HOME").map(PathBuf::from);
    name.strip_prefix("~/").and_then(|rest| Some(home()?.join(rest))).unwrap_or_else(|| PathBuf::from(name))
}

/// Leaves, but first says that changes are not saved.
pub(crate) fn quit(state: &mut State) {
    if may_drop(state) {
        state.wishes.push(Wish::Quit);
    } else {
        let text = fill(state.texts.unsaved, &[&state.keys.first("save"), &state.keys.first("quit")]);
        state.say(Role::Bad, text);
    }
}

/// Opens a scene, but first says that changes of the open one are not saved.
pub(crate) fn open(state: &mut State, source: Source) {
    if may_drop(state) {
        state.wishes.push(Wish::Work(Job::Open(source)));
    } else {
        state.say(Role::Bad, fill(state.texts.unsaved_here, &[&state.keys.first("save")]));
    }
}

/// Whether there is nothing to lose, or the user was told.
fn may_drop(state: &mut State) -> bool {
    !state.what_if.unsaved() || std::mem::replace(&mut state.what_if.warned, true)
}
