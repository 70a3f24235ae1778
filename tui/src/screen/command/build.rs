//! Commands of building: things of the picture are chosen, moved, joined, renamed and deleted; each makes another text of the scene.

use assur_draft::{Part, delete, dependents, rename_in_link};
use assur_mechanism::{GROUND, Key};
use assur_words::{name, quantity, text};
use ratatui::layout::Rect;

use super::{begin, choices, draft, form, found, join};
use crate::number::digits;
use crate::screen::state::{Entry, FormSource, MOVES, PromptKind, Role, State, Task, place, round};
use crate::screen::view;

/// Lines by which the file is scrolled.
const PAGE: isize = 5;
/// The size of the mechanism by the distance at which a point is near.
const NEAR: f64 = 10.0;
/// By which a key turns a guide, rad: 1 degree.
const TURN: f64 = std::f64::consts::PI / 180.0;

pub(super) fn with_dependents(text: &str, parts: &[Part]) -> Vec<Part> {
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
    state.follow();
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
    state.follow();
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
        state.follow();
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
        None if state.build.read.as_ref().is_some_and(|read| !read.faults.is_empty()) => found::fault(state),
        None => begin::add(state),
    }
}

/// Asks whether the chosen thing may go, with what hangs on it.
pub(super) fn ask_delete(state: &mut State) {
    let Some(chosen) = state.build.chosen.clone() else {
        return state.say(Role::Plain, text!("build-nothing-chosen"));
    };
    let parts = with_dependents(state.draft.text(), &group(state, &chosen).unwrap_or_else(|| vec![chosen]));
    state.build.task = Task::Delete(parts);
}

/// The links that go with a link: its group, and the groups that are joined to those that go. `None` for a link of no group, or while
/// the text is no mechanism.
fn group(state: &State, chosen: &Part) -> Option<Vec<Part>> {
    let Part::Link(link) = chosen else { return None };
    let scene = state.scene.as_ref().filter(|scene| *scene.session.text == **state.draft.text())?;
    let (mechanism, groups) = (&scene.linkage.mechanism, &scene.linkage.structure.groups);
    let link = mechanism.link(link)?;
    let mut gone: Vec<usize> = Vec::new();
    for group in groups {
        let frame = &group.frame;
        if frame.links.contains(&link) || frame.carriers().any(|carrier| gone.contains(&carrier)) {
            gone.extend(&frame.links);
        }
    }
    let parts = gone.into_iter().map(|link| Part::Link(mechanism.links[link].name.to_string()));
    Some(parts.collect()).filter(|parts: &Vec<Part>| !parts.is_empty())
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

pub(super) fn masses(state: &mut State) {
    form::open(state, FormSource::Masses);
}

pub(super) fn tables(state: &mut State) {
    choices::tables(state);
}

/// Scrolls the file.
pub(super) fn scroll(state: &mut State, sense: isize) {
    let last = state.draft.text().lines().count();
    let line = state.build.line.unwrap_or_default();
    state.build.line = Some(line.saturating_add_signed(sense * PAGE).min(last));
}
