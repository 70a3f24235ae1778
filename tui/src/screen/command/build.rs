//! Commands of building: things of the picture are chosen, moved, joined, renamed and deleted; each makes another text of the scene.

use std::path::Path;
use std::sync::Arc;

use assur_draft::{Part, delete, dependents, key_at, readable, rename_in_link};
use assur_kinematics::decompose;
use assur_mechanism::{GROUND, Key, Mechanism, Step};
use assur_scene::edit::ParsedText;
use assur_sketch::{Addition, Drive, Names, Sketch, Start, additions, closings, drives, sketch};
use assur_structure::StructureError;
use assur_words::{Describe, name, number, quantity, text};
use crossterm::event::KeyCode;
use ratatui::layout::Rect;

use super::{draft, form, join};
use crate::number::digits;
use crate::screen::state::{
    Build, Choice, Draft, Entry, Faulty, FormSource, Join, Key as CommandKey, MOVES, Picker, PickerKind,
    PromptKind, Question, Read, Recovered, Role, Scene, Source, State, Task, View, place, round,
};
use crate::screen::view;

/// Lines by which the file is scrolled.
const PAGE: isize = 5;
/// The size of the mechanism by the distance at which a point is near.
const NEAR: f64 = 10.0;
/// How often what is loose or surplus is left out before nothing is drawn.
const ATTEMPTS: usize = 20;
/// What a new mechanism may begin with.
const STARTS: [(&str, Start); 2] = [("build-start-crank", Start::CRANK), ("build-start-slide", Start::SLIDE)];
/// By which a key turns a guide, rad: 1 degree.
const TURN: f64 = std::f64::consts::PI / 180.0;

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
    refresh(state);
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
fn forget(path: &Path) {
    // It may be gone already.
    let _ = std::fs::remove_file(path);
}

/// Looks at the text, if it is another one than before.
pub(super) fn refresh(state: &mut State) {
    let is_new = state.build.read.as_ref().is_none_or(|read| read.text != *state.draft.text());
    if state.view != View::Build || !is_new {
        return;
    }
    let name = state.draft.source.short_name();
    state.build.read = Some(read(&name, state.draft.text()));
    state.build.line = None;
    let things = state.build.things();
    state.build.chosen.take_if(|chosen| !things.contains(chosen));
    form::renew(state);
}

fn read(name: &str, text: &Arc<str>) -> Read {
    let found = readable(name, text);
    let mechanism = |text: &str| assur_scene::read(name, text).unwrap_or_default();
    let faulty = |fault: &assur_scene::SceneError| Faulty {
        text: fault.message.clone(),
        key: key_at(text, fault.span.start).filter(|_| !fault.span.is_empty()),
    };
    let mut faults: Vec<Faulty> = found.faults.iter().map(faulty).collect();
    let sketch = sketch(&mechanism(&found.text));
    let moving = moving(name, found.text, &mut faults).map(Arc::from);
    let readable = moving.map(|moving: Arc<str>| if *moving == **text { Arc::clone(text) } else { moving });
    Read { text: Arc::clone(text), readable, sketch, faults, closings: None }
}

/// The part of a text that makes a mechanism: without the links that are loose; `None` if nothing does.
fn moving(name: &str, mut text: String, faults: &mut Vec<Faulty>) -> Option<String> {
    for attempt in 0..ATTEMPTS {
        let mechanism = assur_scene::read(name, &text).ok()?;
        let Err(error) = decompose(&mechanism) else { return Some(text) };
        if attempt == 0 {
            let key = assur_kinematics::CompileError::from(error.clone()).key();
            faults.push(Faulty { text: error.describe(), key });
        }
        let StructureError::Loose { links, .. } = error else { return None };
        let parts: Vec<Part> = links.into_iter().map(Part::Link).collect();
        text = delete(&text, &parts).ok().filter(|_| !parts.is_empty())?;
    }
    None
}

fn with_dependents(text: &str, parts: &[Part]) -> Vec<Part> {
    let mut all = parts.to_vec();
    for part in parts {
        for more in dependents(text, part) {
            if !all.contains(&more) {
                all.push(more);
            }
        }
    }
    all
}

/// Chooses the next (1) or previous (-1) thing in the order of the file.
pub(super) fn next(state: &mut State, by: isize) {
    let things = state.build.things();
    let now = state.build.chosen.as_ref().and_then(|chosen| things.iter().position(|one| one == chosen));
    let next = match now {
        Some(now) => round(now, by, things.len()),
        None if by > 0 => 0,
        None => things.len().saturating_sub(1),
    };
    state.build.chosen = things.get(next).cloned();
    follow(state);
}

/// The group of the chosen link is that of the view of the structure as well.
pub(super) fn follow(state: &mut State) {
    if state.view != View::Build {
        return;
    }
    let (Some(Part::Link(link)), Some(scene)) = (&state.build.chosen, &state.scene) else { return };
    let found = scene.linkage.mechanism.link(link);
    let groups = &scene.linkage.structure.groups;
    let group = found.and_then(|link| groups.iter().position(|group| group.frame.links.contains(&link)));
    state.chosen.group = group.unwrap_or(state.chosen.group);
}

/// Goes in a direction of the picture: moves the chosen thing, or chooses the nearest one there.
pub(super) fn go(state: &mut State, direction: [f64; 2]) {
    if matches!(state.build.task, Task::Move) {
        return shift(state, direction);
    }
    let Some(sketch) = state.build.sketch() else { return };
    let things = state.build.things().into_iter();
    let places: Vec<_> = things.filter_map(|part| Some((place(sketch, &part)?, part))).collect();
    let from = state.build.chosen.as_ref().and_then(|part| place(sketch, part));
    let next = join::nearest_in(&places, from, direction).cloned();
    state.build.chosen = next.or(state.build.chosen.take());
    follow(state);
}

/// Moves the chosen thing by a step.
pub(super) fn shift(state: &mut State, direction: [f64; 2]) {
    let step = MOVES[state.build.step % MOVES.len()];
    let Some((sketch, chosen)) = state.build.sketch().zip(state.build.chosen.as_ref()) else {
        return state.say(Role::Plain, text!("build-nothing-chosen"));
    };
    let by = direction.map(|part| part * step);
    let text = match chosen {
        Part::Point(point) => match sketch.place(point) {
            Some([x, y]) => {
                assur_sketch::move_point(state.draft.text(), sketch, point, [x + by[0], y + by[1]])
            }
            None => Err(text!("build-no-place", name = name(point.clone()))),
        },
        Part::Slide(slide) => assur_sketch::move_guide(state.draft.text(), sketch, slide, by),
        _ => Err(text!("build-move-a-point")),
    };
    draft::take(state, text);
}

/// Moves the chosen point to the place under the mouse; returns whether the frame may differ.
pub(super) fn drag(state: &mut State, area: Rect, cell: [u16; 2], begins: bool) -> bool {
    let Some(at) = view::build::place_at(state, area, cell) else { return false };
    let Some(sketch) = state.build.sketch() else { return false };
    if matches!(state.build.task, Task::Join(_)) {
        return join::click(state, at);
    }
    if begins {
        let things = state.build.things().into_iter();
        let places: Vec<_> = things.filter_map(|part| Some((place(sketch, &part)?, part))).collect();
        // A point is meant rather than the link on which it is.
        let behind = |part: &Part| if matches!(part, Part::Point(_)) { 0.0 } else { sketch.size() / NEAR };
        let distance =
            |(place, part): &([f64; 2], Part)| (place[0] - at[0]).hypot(place[1] - at[1]) + behind(part);
        let near = places.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
        (state.build.chosen, state.build.dragged) = (near.map(|(_, part)| part.clone()), false);
        follow(state);
        return true;
    }
    let Some(Part::Point(point)) = &state.build.chosen else {
        state.say(Role::Plain, text!("build-drag-a-point"));
        return true;
    };
    // To whole millimeters.
    let to = at.map(|x| (1e3 * x).round() / 1e3);
    let text = assur_sketch::move_point(state.draft.text(), sketch, point, to);
    match text {
        Ok(text) => {
            let changed =
                if state.build.dragged { state.draft.amend(&text) } else { state.draft.take(&text) };
            state.build.dragged = true;
            if changed {
                draft::ask(state);
            }
        }
        Err(problem) => state.say(Role::Bad, problem),
    }
    true
}

/// Ends the task in hand without taking it; returns whether there was one.
pub(super) fn close_task(state: &mut State) -> bool {
    state.build.line = None;
    match &mut state.build.task {
        Task::Form(_) => form::close(state),
        Task::Join(join) if !join.entry.is_empty() => join.entry = Entry::default(),
        Task::Choose if state.chosen.mode.is_some() => state.chosen.mode = None,
        Task::Choose if state.build.chosen.is_some() => state.build.chosen = None,
        Task::Choose => return false,
        _ => state.build.task = Task::Choose,
    }
    true
}

pub(super) fn grab(state: &mut State) {
    state.build.task = match (&state.build.task, &state.build.chosen) {
        (Task::Move, _) => Task::Choose,
        (_, Some(Part::Point(_) | Part::Slide(_))) => Task::Move,
        _ => return state.say(Role::Plain, text!("build-move-a-point")),
    };
}

pub(super) fn step(state: &mut State) {
    state.build.step = (state.build.step + 1) % MOVES.len();
    let step = quantity(digits(1e3 * MOVES[state.build.step], 1), "mm");
    state.say(Role::Plain, text!("build-step", step));
}

pub(super) fn turn(state: &mut State, sense: f64) {
    let (Some(sketch), Some(Part::Slide(slide))) = (state.build.sketch(), &state.build.chosen) else {
        return state.say(Role::Plain, text!("build-turn-a-guide"));
    };
    let text = assur_sketch::turn_guide(state.draft.text(), sketch, slide, sense * TURN);
    draft::take(state, text);
}

/// Enter: takes the mode that is shown, ends a move, or opens the form of the chosen thing.
pub(super) fn enter(state: &mut State) {
    if let Some(group) = Some(state.chosen.group).filter(|group| state.mode_of(*group).is_some()) {
        state.chosen.group = group;
        return super::modes::take(state);
    }
    if matches!(state.build.task, Task::Move) {
        state.build.task = Task::Choose;
        return;
    }
    match state.build.chosen.clone() {
        Some(part) => form::of_part(state, &part),
        None if state.build.read.as_ref().is_some_and(|read| !read.faults.is_empty()) => fault(state),
        None => add(state),
    }
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

/// Keys of which those of both coordinates of a place are one.
fn whole(keys: Vec<Key>) -> Vec<Key> {
    let mut unique: Vec<Key> = Vec::new();
    for key in keys.into_iter().map(|key| key.of_list()) {
        if !unique.contains(&key) {
            unique.push(key);
        }
    }
    unique
}

/// The form of a new scene: the names and numbers of its input.
fn begun(state: &mut State) {
    let Some(Sketch { mechanism, .. }) = state.build.sketch() else { return };
    let points = mechanism.points.iter().map(|point| Part::Point(point.name.to_string()));
    let links = mechanism.links.iter().skip(1).map(|link| Part::Link(link.name.to_string()));
    let keys = ParsedText::of(state.draft.text()).values().into_iter().map(|value| value.key).collect();
    let from = Key::of("input").at("from");
    let mut unique = whole(keys);
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
        PickerKind::Tables => form::of_table(state, taken),
        PickerKind::Choices => form::choose(state, taken),
        _ => {}
    }
}

/// Adds the group whose pairs are joined now.
pub(super) fn finish(state: &mut State, join: &Join) {
    let Some(sketch) = state.build.sketch() else { return };
    let added =
        assur_sketch::add(state.draft.text(), sketch, &join.addition, &join.targets, &Names::default());
    match added {
        Ok(added) => {
            if draft::take(state, Ok(added.text)) {
                state.build.chosen = added.links.last().cloned().map(Part::Link);
                let links = added.links.into_iter().map(Part::Link);
                let parts = links.chain(added.points.into_iter().map(Part::Point)).collect();
                form::open(state, FormSource::Made(parts, whole(added.fields)));
            }
        }
        Err(problem) => state.say(Role::Bad, problem),
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

/// Asks whether the chosen thing may go, with what hangs on it.
pub(super) fn ask_delete(state: &mut State) {
    let Some(chosen) = state.build.chosen.clone() else {
        return state.say(Role::Plain, text!("build-nothing-chosen"));
    };
    let parts = with_dependents(state.draft.text(), &[chosen]);
    state.build.task = Task::Delete(parts);
}

/// The answer to the question whether parts may go.
pub(super) fn answer_delete(state: &mut State, yes: bool) {
    let Task::Delete(parts) = std::mem::take(&mut state.build.task) else { return };
    if yes {
        let text = delete(state.draft.text(), &parts);
        draft::take(state, text);
    } else {
        state.say(Role::Plain, text!("build-nothing-deleted"));
    }
}

/// Opens the form of the chosen thing at its name.
pub(super) fn rename(state: &mut State) {
    match state.build.chosen.clone() {
        Some(part) => form::open(state, FormSource::Made(vec![part], Vec::new())),
        None => state.say(Role::Plain, text!("build-nothing-chosen")),
    }
}

/// Adds a point to the chosen link, in its middle; to the ground where no link is chosen.
pub(super) fn add_point(state: &mut State) {
    let Some(mechanism) = state.build.sketch().map(|sketch| &sketch.mechanism) else { return };
    let chosen = if let Some(Part::Link(link)) = &state.build.chosen { mechanism.link(link) } else { None };
    let table = match chosen {
        Some(link) => Key::of("link").at(&mechanism.links[link].name),
        None => Key::of("ground"),
    };
    let link = chosen.unwrap_or(GROUND);
    let places: Vec<_> = mechanism.points.iter().filter_map(|point| point.on(link)).collect();
    let count = places.len().max(1) as f64;
    let [x, y] = [0, 1].map(|axis| (1e3 * places.iter().map(|at| at[axis]).sum::<f64>() / count).round());
    let is_free = |own: &String| mechanism.points.iter().all(|point| point.name.as_str() != own);
    let letters = ('A'..='Z').map(String::from).chain((1..).map(|number| format!("P{number}")));
    let Some(own) = letters.into_iter().find(is_free) else { return };
    let key = table.at("points").at(&*own);
    let text = assur_draft::set(state.draft.text(), &key, &format!("[\"{x} mm\", \"{y} mm\"]"));
    if draft::take(state, text) {
        form::open(state, FormSource::Made(vec![Part::Point(own)], vec![key]));
    }
}

/// Opens the line on which a pin of the chosen link is joined elsewhere: `join LINK POINT NEW`.
pub(super) fn rejoin(state: &mut State) {
    let Some(Part::Link(link)) = &state.build.chosen else {
        return state.say(Role::Plain, text!("build-choose-a-link"));
    };
    let line = format!("join {link} ");
    state.open_prompt(PromptKind::Command, line);
}

/// `join LINK POINT NEW` of the `:` line: the point of this link has another name there, so that it is another pin.
pub(super) fn rejoin_line(state: &mut State, words: &str) {
    let mut words = words.split_whitespace();
    let text = match (words.next(), words.next(), words.next()) {
        (Some(link), Some(point), Some(new)) => rename_in_link(state.draft.text(), link, point, new),
        _ => Err(text!("build-join-line")),
    };
    draft::take(state, text);
}

/// Goes to the field of the next fault.
pub(super) fn fault(state: &mut State) {
    let faults = state.build.read.as_ref().map_or(&[][..], |read| &read.faults);
    let Some(fault) = faults.get(state.build.fault % faults.len().max(1)).cloned() else {
        return state.say(Role::Good, text!("build-no-faults"));
    };
    let [at, count] = [state.build.fault % faults.len() + 1, faults.len()].map(number);
    state.build.fault += 1;
    if let Some(key) = &fault.key {
        form::at(state, key);
    }
    state.say(Role::Bad, text!("build-fault", at, count, fault = fault.text));
}

/// Before a frame: of a dyad that can't be assembled the lengths with which it could, unless one is being typed. Of a larger group they
/// are looked for when they are asked for, since that may take seconds.
pub(super) fn look_for_closings(state: &mut State) {
    let is_typing = state.build.form().is_some_and(|form| form.entry.is_some());
    let of_dyad = |scene: &Scene| {
        let broken = scene.broken.values().next().map(|broken| broken.group);
        let group = broken.and_then(|group| scene.linkage.structure.groups.get(group));
        group.is_some_and(|group| group.frame.links.len() <= 2)
    };
    if state.view == View::Build && !is_typing && state.scene.as_ref().is_some_and(of_dyad) {
        find_closings(state);
    }
}

/// Looks for numbers with which the mechanism could be assembled, where it can't.
fn find_closings(state: &mut State) {
    let (Some(scene), Some(read)) = (&state.scene, &mut state.build.read) else { return };
    let is_shown = state.draft.shown == read.text && scene.session.text == *read.text;
    let Some(broken) = scene.broken.values().next().filter(|_| is_shown && read.closings.is_none()) else {
        return;
    };
    let mechanism = &scene.linkage.mechanism;
    let group = scene.linkage.structure.groups.get(broken.group);
    let links = group.map_or(&[][..], |group| &group.frame.links);
    let keys = ParsedText::of(&read.text).values().into_iter().map(|value| value.key);
    let keys: Vec<Key> = keys.filter(|key| is_of(key, mechanism, links)).collect();
    read.closings = Some(closings(&read.text, &keys));
}

/// Whether a key is that of a place on one of these links.
fn is_of(key: &Key, mechanism: &Mechanism, links: &[usize]) -> bool {
    let mut steps = key.steps().iter();
    steps.next() == Some(&Step::from("link"))
        && steps
            .next()
            .is_some_and(|step| links.iter().any(|link| *step == Step::from(&mechanism.links[*link].name)))
        && steps.next() == Some(&Step::from("points"))
}

/// Takes the nearest change of one number with which the mechanism can be assembled.
pub(super) fn close(state: &mut State) {
    let found = |state: &State| state.build.read.as_ref().and_then(|read| read.closings.clone());
    if found(state).is_none() {
        find_closings(state);
        if found(state).is_some_and(|found| !found.is_empty()) {
            return;
        }
    }
    let closing = found(state).and_then(|found| found.into_iter().next());
    match closing {
        Some(closing) => {
            let text = assur_draft::set(state.draft.text(), &closing.key, &closing.toml);
            draft::take(state, text);
        }
        None => state.say(Role::Plain, text!("build-nothing-to-close")),
    }
}

pub(super) fn masses(state: &mut State) {
    form::open(state, FormSource::Masses);
}

pub(super) fn tables(state: &mut State) {
    form::tables(state);
}

/// Scrolls the file.
pub(super) fn scroll(state: &mut State, sense: isize) {
    let last = state.draft.text().lines().count();
    let line = state.build.line.unwrap_or_default();
    state.build.line = Some(line.saturating_add_signed(sense * PAGE).min(last));
}
