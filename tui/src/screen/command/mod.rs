//! Commands: their table, their effects on the state, and the keys and lines that run them.

mod act;
mod begin;
mod build;
mod choices;
mod draft;
mod fields;
mod form;
mod form_keys;
mod found;
mod jobs;
mod join;
mod jump;
mod line;
mod modes;
mod motors;
mod picker;
mod probe;
mod reading;
mod sheet;
mod table;
mod tour;
mod write;
pub(crate) use begin::{new as from_nothing, offer_recovered};
pub(crate) use jobs::take;
pub(crate) use table::COMMANDS;
pub(crate) use tour::begin as tour;

use assur_words::{name, number, text};
use crossterm::event::{KeyCode, KeyEvent, MouseButton, MouseEvent, MouseEventKind};

#[cfg(test)]
pub(crate) use draft::toggle;
pub(crate) use write::grant;

use super::state::{
    Command, Group, Key, LONGEST, PickerKind, PromptKind, Purpose, Question, Role, State, Stop, Task, View,
    round,
};
use super::view;

/// Requests the data for the first frame: the analysis of the scene, or the list of shipped scenes.
pub(crate) fn start(state: &mut State) {
    if state.scene.is_some() {
        jobs::ask(state, Purpose::Main);
    } else {
        picker::scenes(state);
    }
}

/// Takes a key; a view that is left by it is remembered.
pub(crate) fn press(state: &mut State, event: KeyEvent) {
    let (before, count) = (Stop::of(state), state.trail.len());
    pass(state, event);
    let left = before.filter(|before| before.view != state.view && state.trail.len() == count);
    if let Some(stop) = left {
        state.leave(stop);
    }
}

/// Passes a key to what is open: a question, the `:` line, the help, a list, or else the view.
fn pass(state: &mut State, event: KeyEvent) {
    let key = Key::from(event);
    let meant = state.command(key);
    let everywhere =
        |command: &&Command| command.name == "close" || (key.control && command.group == Group::Program);
    if let Some(command) = meant.filter(everywhere) {
        return (command.run)(state);
    }
    if let Some(question) = state.question.take() {
        return match question {
            Question::Overwrite(file) => write::answer(state, file, key),
            Question::Recover(found) => begin::recover(state, found, key),
        };
    }
    if state.prompt.is_some() {
        return press_in_line(state, key);
    }
    state.message = None;
    if state.builds() && state.fault.is_none() {
        let is_help = key.code == KeyCode::Char('?');
        match (&state.build.task, meant) {
            (Task::Delete(_), _) => {
                return build::answer_delete(state, matches!(key.code, KeyCode::Char('y' | 'Y')));
            }
            (Task::Form(_), _) if !is_help => return form_keys::press(state, key),
            (Task::Join(_), _) if !is_help => return join::press(state, key),
            _ => {}
        }
    }
    // Before a search begins, the commands of the program keep their keys.
    let filter = state.help.as_ref().map(|help| &help.filter);
    let filter = filter.or(state.picker.as_ref().map(|picker| &picker.filter));
    let typing = filter.is_some_and(|filter| filter.typing);
    let meant = meant.filter(|command| !typing && (filter.is_none() || OF_LISTS.contains(&command.name)));
    match meant {
        Some(command) if command.name == "quit" && lies_over_the_view(state) => {
            // Without a scene there is nothing behind the list of scenes.
            let last = state.help.is_none() && state.scene.is_none();
            (if last { command.run } else { act::close })(state);
        }
        Some(command) if command.name == "help" && state.help.is_some() => state.help = None,
        Some(command) => {
            state.fault = None;
            (command.run)(state);
        }
        None => pass_in_view(state, key),
    }
}

/// A key without a command goes to what lies over the view, else to the view.
fn pass_in_view(state: &mut State, key: Key) {
    match key.code {
        KeyCode::Esc => act::close(state),
        _ if state.help.is_some() => press_in_help(state, key),
        KeyCode::Tab if state.picker.as_ref().is_some_and(|picker| picker.kind == PickerKind::Scenes) => {
            // A file of the user is named on the line.
            let typed = state.entry().map(|entry| format!("open {}", &**entry));
            state.open_prompt(PromptKind::Command, typed.unwrap_or_default());
        }
        _ if state.picker.is_some() => picker::press(state, key),
        _ if state.view == View::Build && state.fault.is_none() => {
            let help = name(state.keys.first("help"));
            state.say(Role::Plain, text!("say-no-key-here", key = name(key.name()), help));
        }
        _ => state.fault = None,
    }
}

/// What follows from all keys that were taken, before a frame is drawn: the picture of what is chosen, and the notice that a
/// text is at its end.
pub(crate) fn prepare(state: &mut State) {
    picker::preview(state);
    reading::look_for_closings(state);
    tour::go_on(state);
    if state.entry().is_some_and(|entry| entry.cut) {
        state.say(Role::Bad, text!("say-too-long", most = number(LONGEST)));
    }
}

/// Whether something is open that `q` closes before it leaves the program.
fn lies_over_the_view(state: &State) -> bool {
    state.help.is_some() || state.picker.is_some() || state.values_open() || state.probe.is_some()
}

/// Commands whose keys have a meaning while the help or a list is open and nothing is typed yet.
const OF_LISTS: [&str; 3] = ["quit", "help", "command"];

/// Takes a pasted text into the line that is being written; it is never read as keys.
pub(crate) fn paste(state: &mut State, text: &str) {
    let line: String =
        text.trim().chars().map(|letter| if letter.is_control() { ' ' } else { letter }).collect();
    if let Some(prompt) = &mut state.prompt {
        prompt.completing = None;
        prompt.text.push_str(&line);
    } else if let Some(help) = &mut state.help {
        (help.filter.typing, help.scroll) = (true, 0);
        help.filter.text.push_str(&line);
    } else if let Some(picker) = &mut state.picker {
        (picker.filter.typing, picker.chosen) = (true, 0);
        picker.filter.text.push_str(&line);
    } else if state.build.form().is_some() && state.builds() {
        form::typed(state, |entry| {
            entry.push_str(&line);
            true
        });
    } else if let (Task::Join(join), View::Build) = (&mut state.build.task, state.view) {
        join.entry.push_str(&line);
    } else if state.question.is_none() {
        // It is shown, and runs only after Enter.
        state.open_prompt(PromptKind::Command, line);
    }
}

fn press_in_help(state: &mut State, key: Key) {
    let page = view::help::page(state);
    let Some(help) = &mut state.help else { return };
    let before = help.scroll;
    match key.code {
        KeyCode::Down => help.scroll = help.scroll.saturating_add(1),
        KeyCode::Up => help.scroll = help.scroll.saturating_sub(1),
        KeyCode::PageDown => help.scroll += page,
        KeyCode::Char(' ') if !help.filter.typing => help.scroll += page,
        KeyCode::PageUp => help.scroll = help.scroll.saturating_sub(page),
        KeyCode::Home => help.scroll = 0,
        KeyCode::End => help.scroll = usize::MAX,
        KeyCode::Enter => state.help = None,
        _ => {
            if help.filter.press(key) {
                help.scroll = 0;
            }
        }
    }
    // Laying out the text takes longer than a letter of a search may.
    if state.help.as_ref().is_some_and(|help| help.scroll > before) {
        let last = view::help::last_scroll(state);
        state.help.as_mut().into_iter().for_each(|help| help.scroll = help.scroll.min(last));
    }
}

/// A click chooses a position on a chart, or the place of the point that is moved; returns whether the frame may differ.
pub(crate) fn click(state: &mut State, mouse: MouseEvent) -> bool {
    let pressed = matches!(
        mouse.kind,
        MouseEventKind::Down(MouseButton::Left) | MouseEventKind::Drag(MouseButton::Left)
    );
    let cell = [mouse.column, mouse.row];
    let Some((view, area)) =
        view::areas(state).into_iter().find(|(_, area)| area.contains((mouse.column, mouse.row).into()))
    else {
        return false;
    };
    match view {
        View::Curves if pressed => match view::curves::position_at(state, area, cell) {
            Some(position) => std::mem::replace(&mut state.position, position) != position,
            None => false,
        },
        View::Mechanism if pressed && state.probe.is_some() => probe::click(state, area, cell),
        View::Build if pressed && state.builds() => {
            build::drag(state, area, cell, matches!(mouse.kind, MouseEventKind::Down(_)))
        }
        _ => false,
    }
}

fn press_in_line(state: &mut State, key: Key) {
    state.message = None;
    let Some(prompt) = &mut state.prompt else { return };
    match key.code {
        // Also where another key closes.
        KeyCode::Esc => state.prompt = None,
        // As in other programs, deleting from an empty line closes it.
        KeyCode::Backspace if prompt.text.is_empty() => state.prompt = None,
        KeyCode::Enter => {
            let (kind, text) = (prompt.kind, prompt.text.trim().to_owned());
            state.prompt = None;
            match kind {
                PromptKind::Command => line::run(state, &text),
                PromptKind::Search => line::search(state, &text),
            }
        }
        KeyCode::Tab => complete(state, 1),
        KeyCode::BackTab => complete(state, -1),
        _ if prompt.text.press(key) => prompt.completing = None,
        _ => {}
    }
}

fn complete(state: &mut State, by: isize) {
    let Some(prompt) = state.prompt.as_ref().filter(|prompt| prompt.kind == PromptKind::Command) else {
        return;
    };
    let typed = prompt.completing.as_ref().map_or(&*prompt.text, |(_, typed)| typed).to_owned();
    let offers = line::completions(state, &typed);
    let next = match &prompt.completing {
        Some((shown, _)) => round(*shown, by, offers.len()),
        None if by > 0 => 0,
        None => offers.len().saturating_sub(1),
    };
    if let (Some(offer), Some(prompt)) = (offers.get(next), &mut state.prompt) {
        prompt.text = offer.as_str().into();
        prompt.completing = Some((next, typed));
    }
}
