//! What commands do to the state.

mod found;

use crossterm::event::KeyCode;

use super::draw::scale::Zoom;
use super::key::Key;
use super::state::{Arrows, Help, State, Traces, View, Wish};
use super::study::{Source, Study};
use super::theme::{Role, Theme};
use super::work::Job;

pub(crate) use found::{analyzer, causes, check, difference, motion, pane, plan, reaction, step, worst};

/// An eighth of the positions on or back.
pub(crate) fn jump(state: &mut State, sense: isize) {
    let eighth = (state.positions() / 8).max(1);
    state.step(sense * isize::try_from(eighth).unwrap_or(1));
}

/// The next index of so many, round.
pub(crate) fn round(now: usize, by: isize, count: usize) -> usize {
    let count = isize::try_from(count.max(1)).unwrap_or(isize::MAX);
    usize::try_from((isize::try_from(now).unwrap_or(0) + by).rem_euclid(count)).unwrap_or(0)
}

/// The next or previous quantity.
pub(crate) fn item(state: &mut State, by: isize) {
    let count = state.study.as_ref().map_or(0, |study| study.transfers.len());
    state.chosen.transfer = round(state.chosen.transfer, by, count);
}

/// The next or previous group.
pub(crate) fn group(state: &mut State, by: isize) {
    let count = state.study.as_ref().map_or(0, |study| study.linkage.structure.groups.len());
    state.chosen.group = round(state.chosen.group, by, count);
}

/// Goes to the position at which the chosen group is nearest to a singular one.
pub(crate) fn nearest(state: &mut State) {
    let least = state.study.as_ref().and_then(|study| study.least_health(state.chosen.group));
    match least {
        Some((_, at)) => state.go_to(at),
        None => state.say(Role::Plain, state.texts.no_worst_group),
    }
}

/// The next or previous column of the table.
pub(crate) fn column(state: &mut State, by: isize) {
    let count = state.study.as_ref().map_or(0, Study::column_count);
    state.chosen.column = round(state.chosen.column, by, count);
}

/// The next or previous row of the table in its present order.
pub(crate) fn row(state: &mut State, by: isize) {
    let order = super::view::table::order(state);
    let row = order.iter().position(|position| *position == state.position).unwrap_or(0);
    state.position = order.get(round(row, by, order.len())).copied().unwrap_or(0);
}

/// Sorts the table by the chosen column: up, down, by number again.
pub(crate) fn sort(state: &mut State) {
    let column = state.chosen.column;
    state.sorted = match state.sorted {
        Some((sorted, true)) if sorted == column => Some((column, false)),
        Some((sorted, false)) if sorted == column => None,
        _ => Some((column, true)),
    };
}

/// The next or previous shipped scene.
pub(crate) fn scene(state: &mut State, by: isize) {
    let count = super::menu::SCENES.len();
    state.menu.chosen = round(state.menu.chosen, by, count);
    preview(state);
}

/// Asks for the picture of the chosen shipped scene.
pub(crate) fn preview(state: &mut State) {
    let chosen = state.menu.chosen;
    if state.menu.wants(chosen) {
        state.wishes.push(Wish::Work(Job::Preview(chosen)));
    }
}

/// Opens the chosen shipped scene.
pub(crate) fn open_scene(state: &mut State) {
    if let Some((name, _)) = super::menu::SCENES.get(state.menu.chosen) {
        super::whatif::open(state, Source::Shipped(name));
    }
}

/// Back to the menu.
pub(crate) fn menu(state: &mut State) {
    state.view = View::Menu;
    state.playing = false;
    preview(state);
}

/// The next kind of arrows.
pub(crate) fn arrows(state: &mut State) {
    state.arrows = match state.arrows {
        Arrows::None => Arrows::Velocity,
        Arrows::Velocity => Arrows::Acceleration,
        Arrows::Acceleration => Arrows::Both,
        Arrows::Both => Arrows::None,
    };
}

/// The next kind of paths.
pub(crate) fn traces(state: &mut State) {
    state.traces = match state.traces {
        Traces::All => Traces::Chosen,
        Traces::Chosen => Traces::None,
        Traces::None => Traces::All,
    };
}

/// Larger or smaller, within reason.
pub(crate) fn zoom(state: &mut State, by: f64) {
    state.zoom.factor = (state.zoom.factor * by).clamp(0.25, 64.0);
}

/// Shifts the drawing by an eighth of what is seen.
pub(crate) fn pan(state: &mut State, axis: usize, sense: f64) {
    state.zoom.shift[axis] -= 0.125 * sense / state.zoom.factor;
}

/// The whole drawing again.
pub(crate) fn whole(state: &mut State) {
    state.zoom = Zoom::WHOLE;
}

/// The next theme.
pub(crate) fn theme(state: &mut State) {
    let now = Theme::ALL.iter().position(|theme| *theme == state.look.theme).unwrap_or(0);
    state.look.theme = Theme::ALL[(now + 1) % Theme::ALL.len()];
    state.say(Role::Plain, state.look.theme.name());
}

/// Opens the help.
pub(crate) fn help(state: &mut State) {
    state.help = Some(Help::default());
}

/// A key while the help is open: letters search, arrows scroll.
pub(crate) fn press_help(state: &mut State, key: Key) {
    let meant = state.command(key).map(|command| command.name);
    let page = super::view::help::page(state);
    let Some(help) = &mut state.help else { return };
    match key.code {
        KeyCode::Down => help.scroll = help.scroll.saturating_add(1),
        KeyCode::Up => help.scroll = help.scroll.saturating_sub(1),
        KeyCode::PageDown | KeyCode::Char(' ') => help.scroll += page,
        KeyCode::PageUp => help.scroll = help.scroll.saturating_sub(page),
        KeyCode::Home => help.scroll = 0,
        KeyCode::End => help.scroll = usize::MAX,
        KeyCode::Backspace => {
            help.filter.pop();
        }
        KeyCode::Esc | KeyCode::Enter => state.help = None,
        _ if help.filter.is_empty() && matches!(meant, Some("help" | "quit" | "close")) => state.help = None,
        KeyCode::Char(letter) => {
            help.filter.push(letter);
            help.scroll = 0;
        }
        _ => {}
    }
    let last = super::view::help::last_scroll(state);
    if let Some(help) = &mut state.help {
        help.scroll = help.scroll.min(last);
    }
}

/// Stops what runs beside.
fn stop(state: &mut State) {
    super::accuracy::stop(state);
    state.stop();
}

/// Reads the scene again.
pub(crate) fn reload(state: &mut State) {
    let Some(study) = &mut state.study else { return };
    match &study.source {
        // There is nothing to read, but an analysis that was stopped may go on.
        Source::Shipped(_) if study.found.is_none() => {
            study.fault = None;
            state.analyze(false);
        }
        Source::File(_) => state.wishes.push(Wish::Work(Job::Open(study.source.clone()))),
        Source::Shipped(_) => state.say(Role::Plain, state.texts.no_file),
    }
}

/// Closes the list of values, or else stops what runs beside.
pub(crate) fn close(state: &mut State) {
    if state.values_open() {
        super::whatif::toggle(state);
    } else {
        stop(state);
    }
}

/// Asks for the first picture where the program starts with the menu.
pub(crate) fn preview_menu(state: &mut State) {
    if state.study.is_none() {
        preview(state);
    }
}
