//! Beginning a mechanism, and adding to it: a new scene, unsaved changes that are opened, groups, the input.

use std::path::Path;

use assur_draft::Part;
use assur_mechanism::Key;
use assur_scene::edit::ParsedText;
use assur_sketch::{Addition, Drive, Sketch, Start, additions, drives};
use assur_words::text;
use crossterm::event::KeyCode;

use super::{choices, draft, fields, form, join, reading};
use crate::screen::state::{
    Build, Choice, Draft, FormSource, Join, Key as CommandKey, Picker, PickerKind, Question, Recovered, Role,
    Source, State, Task, View,
};

/// What a new mechanism may begin with.
const STARTS: [(&str, Start); 2] = [("build-start-crank", Start::CRANK), ("build-start-slide", Start::SLIDE)];
/// Shows the mechanism while it is built, or the view before.
pub(super) fn toggle(state: &mut State) {
    if state.view == View::Build {
        state.build.task = Task::Choose;
        state.view = View::Mechanism;
    } else {
        (state.view, state.probe, state.draft.open) = (View::Build, None, false);
        (state.picker, state.fault) = (None, None);
    }
    draft::ask(state);
}

/// Begins a scene from nothing.
pub(crate) fn new(state: &mut State) {
    if !draft::may_open(state) {
        return;
    }
    state.draft = Draft::from(state.draft.opening + 1, Source::New, "");
    (state.scene, state.compared, state.fault) = (None, None, None);
    state.build = Build::default();
    (state.view, state.playing, state.position) = (View::Build, false, 0);
    let row = |(id, _): (&'static str, Start)| Choice { name: id.to_owned(), text: state.told(text!(id)) };
    let rows = STARTS.map(row).to_vec();
    reading::refresh(state);
    state.picker = Some(Picker::new(PickerKind::Starts, text!("build-start"), rows));
}

/// Offers the next unsaved changes of a program that has died.
pub(crate) fn offer_recovered(state: &mut State) {
    if !state.recovered.is_empty() {
        state.question = Some(Question::Recover(state.recovered.remove(0)));
    }
}

/// The answer to the question whether unsaved changes are opened: `y` opens them as a step beyond the file, `n` throws them away, any
/// other key leaves them.
pub(super) fn recover(state: &mut State, found: Recovered, key: CommandKey) {
    match key.code {
        KeyCode::Char('y' | 'Y') => {
            let opened = found.source.text().unwrap_or_default();
            state.draft = Draft::from(state.draft.opening + 1, found.source, &opened);
            (state.scene, state.compared, state.picker) = (None, None, None);
            (state.build, state.view) = (Build::default(), View::Build);
            draft::take(state, Ok(found.text.to_string()));
            forget(&found.path);
        }
        KeyCode::Char('n' | 'N') => {
            forget(&found.path);
            offer_recovered(state);
        }
        _ => {
            state.say(Role::Plain, text!("recover-later"));
            offer_recovered(state);
        }
    }
}

/// Removes a file of unsaved changes: they are open now, or not wanted.
pub(super) fn forget(path: &Path) {
    // It may be gone already.
    let _ = std::fs::remove_file(path);
}

/// Opens the list of groups that can be added.
pub(super) fn add(state: &mut State) {
    if state.draft.text().trim().is_empty() {
        return new(state);
    }
    let row = |addition: &Addition| {
        let [title, about] = [&addition.title, &addition.about].map(|text| state.told(text.clone()));
        Choice { name: addition.name.to_owned(), text: format!("{title:<5} {about}") }
    };
    let rows = additions().unwrap_or_default().iter().map(row).collect();
    state.picker = Some(Picker::new(PickerKind::Additions, text!("build-add"), rows));
}

/// The form of a new scene: the names and numbers of its input.
pub(super) fn begun(state: &mut State) {
    let Some(Sketch { mechanism, .. }) = state.build.sketch() else { return };
    let points = mechanism.points.iter().map(|point| Part::Point(point.name.to_string()));
    let links = mechanism.links.iter().skip(1).map(|link| Part::Link(link.name.to_string()));
    let keys = ParsedText::of(state.draft.text()).values().into_iter().map(|value| value.key).collect();
    let from = Key::of("input").at("from");
    let mut unique = fields::whole(keys);
    // The origin of the frame of a link is no number to fill in.
    unique.retain(|key| key.to_string() != "link.crank.points.O");
    if !unique.contains(&from) {
        unique.insert(unique.len().saturating_sub(1), from);
    }
    let parts = links.chain(points).collect();
    form::open(state, FormSource::Made(parts, unique));
}

/// Takes what was chosen in a list that belongs to building.
pub(super) fn take(state: &mut State, kind: PickerKind, taken: &str) {
    match kind {
        PickerKind::Starts => {
            let Some((_, start)) = STARTS.iter().find(|(id, _)| *id == taken) else { return };
            if draft::take(state, Ok(assur_sketch::start(*start))) {
                begun(state);
            }
        }
        PickerKind::Additions => {
            let found = additions().unwrap_or_default().into_iter().find(|one| one.name == taken);
            let Some(addition) = found else { return };
            state.build.task = Task::Join(Box::new(Join::of(addition)));
            join::go_on(state);
        }
        PickerKind::Drives => {
            let Some(sketch) = state.build.sketch() else { return };
            let drives = drives(&sketch.mechanism);
            let Some(drive) = taken.parse::<usize>().ok().and_then(|index| drives.get(index)) else { return };
            let present = drive.coordinate(sketch).unwrap_or_default();
            let text = assur_sketch::drive(state.draft.text(), sketch, drive, present);
            if draft::take(state, text) {
                form::open(state, FormSource::Table(Key::of("input")));
            }
        }
        PickerKind::Tables => choices::of_table(state, taken),
        PickerKind::Choices => choices::choose(state, taken),
        _ => {}
    }
}

/// Opens the list of what could be the input.
pub(super) fn input(state: &mut State) {
    let Some(sketch) = state.build.sketch() else { return };
    let row = |(index, drive): (usize, &Drive)| Choice {
        name: index.to_string(),
        text: state.told(drive.words(&sketch.mechanism)),
    };
    let rows: Vec<Choice> = drives(&sketch.mechanism).iter().enumerate().map(row).collect();
    state.picker = Some(Picker::new(PickerKind::Drives, text!("build-drives"), rows));
}
