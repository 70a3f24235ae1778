//! Commands: their table, and their effects on the state.

mod accuracy;
mod act;
mod jobs;
mod line;
mod plans;
mod prompt;
mod reports;
mod table;
mod whatif;
mod write;

use crossterm::event::{KeyCode, KeyEvent, MouseButton, MouseEvent, MouseEventKind};

pub(crate) use jobs::ask;
pub(crate) use line::search;
pub(crate) use reports::take;
pub(crate) use table::COMMANDS;
#[cfg(test)]
pub(crate) use whatif::toggle;
pub(crate) use write::{PAGE, grant, picture};

use super::state::{Group, Key, Purpose, State, View};
use super::view;

/// Requests the data for the first frame: the analysis of the scene, or the first picture of the menu.
pub(crate) fn start(state: &mut State) {
    if state.scene.is_some() {
        jobs::ask(state, Purpose::Main);
    } else {
        act::preview(state);
    }
}

/// Passes a key to what is open: a question, the `:` line, the help, or else the view.
pub(crate) fn press(state: &mut State, event: KeyEvent) {
    let key = Key::from(event);
    let meant = state.command(key);
    if let Some(command) = meant.filter(|command| key.control && command.group == Group::Program) {
        return (command.run)(state);
    }
    if let Some(file) = state.question.take() {
        return write::answer(state, file, key);
    }
    if state.prompt.is_some() {
        return prompt::press(state, key);
    }
    state.message = None;
    if state.help.is_some() {
        return press_in_help(state, key);
    }
    state.fault = None;
    if let Some(command) = meant {
        (command.run)(state);
    }
}

/// A key while the help is open: letters search, arrows scroll.
fn press_in_help(state: &mut State, key: Key) {
    let meant = state.command(key).map(|command| command.name);
    let page = view::help::page(state);
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
    let last = view::help::last_scroll(state);
    if let Some(help) = &mut state.help {
        help.scroll = help.scroll.min(last);
    }
}

/// A click chooses a position on a chart; returns whether the frame may differ.
pub(crate) fn click(state: &mut State, mouse: MouseEvent) -> bool {
    let pressed = matches!(
        mouse.kind,
        MouseEventKind::Down(MouseButton::Left) | MouseEventKind::Drag(MouseButton::Left)
    );
    if !pressed || state.view != View::Curves {
        return false;
    }
    match view::curves::position_at(state, view::room(state), [mouse.column, mouse.row]) {
        Some(position) => std::mem::replace(&mut state.position, position) != position,
        None => false,
    }
}
