//! The one-line input for `:` and `/`.

use crossterm::event::KeyCode;

use super::key::Key;
use super::line;
use super::state::State;

/// What the line is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Command,
    Search,
}

/// The line while it is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Prompt {
    pub(crate) kind: Kind,
    pub(crate) text: String,
    /// Number of the completion that Tab gave, and what was typed before.
    completing: Option<(usize, String)>,
}

impl Prompt {
    /// The sign before the line.
    pub(crate) fn sign(&self) -> char {
        match self.kind {
            Kind::Command => ':',
            Kind::Search => '/',
        }
    }
}

/// Opens the line.
pub(crate) fn open(state: &mut State, kind: Kind) {
    state.prompt = Some(Prompt { kind, text: String::new(), completing: None });
}

/// Opens the `:` line with something written already.
pub(crate) fn open_with(state: &mut State, text: String) {
    state.prompt = Some(Prompt { kind: Kind::Command, text, completing: None });
}

/// A key while the line is open.
pub(crate) fn press(state: &mut State, key: Key) {
    let Some(mut prompt) = state.prompt.take() else { return };
    match key.code {
        KeyCode::Esc => return,
        KeyCode::Enter => {
            state.message = None;
            match prompt.kind {
                Kind::Command => line::run(state, prompt.text.trim()),
                Kind::Search => line::search(state, prompt.text.trim()),
            }
            return;
        }
        KeyCode::Backspace => {
            prompt.completing = None;
            // As in other programs: deleting from an empty line closes it.
            if prompt.text.pop().is_none() {
                return;
            }
        }
        KeyCode::Char('u') if key.control => prompt.text.clear(),
        KeyCode::Char(letter) if !key.control => {
            prompt.completing = None;
            prompt.text.push(letter);
        }
        KeyCode::Tab => complete(state, &mut prompt, 1),
        KeyCode::BackTab => complete(state, &mut prompt, -1),
        _ => {}
    }
    state.prompt = Some(prompt);
}

/// Puts the next completion of what was typed.
fn complete(state: &State, prompt: &mut Prompt, by: isize) {
    if prompt.kind == Kind::Search {
        return;
    }
    let (shown, typed) = prompt.completing.clone().unwrap_or_else(|| (usize::MAX, prompt.text.clone()));
    let offers = line::completions(state, &typed);
    let Ok(count) = isize::try_from(offers.len()) else { return };
    if count == 0 {
        return;
    }
    let last = isize::try_from(shown).ok();
    let next = last.map_or(if by > 0 { 0 } else { count - 1 }, |shown| (shown + by).rem_euclid(count));
    let next = usize::try_from(next).unwrap_or(0);
    prompt.text.clone_from(&offers[next]);
    prompt.completing = Some((next, typed));
}
