//! The one-line input for `:` and `/`.

use crossterm::event::KeyCode;

use super::line;
use crate::screen::state::{Key, Prompt, PromptKind, State, round};

/// Handles a key while the line is open.
pub(super) fn press(state: &mut State, key: Key) {
    let Some(mut prompt) = state.prompt.take() else { return };
    match key.code {
        // Also where another key closes.
        KeyCode::Esc => return,
        KeyCode::Enter => {
            state.message = None;
            match prompt.kind {
                PromptKind::Command => line::run(state, prompt.text.trim()),
                PromptKind::Search => line::search(state, prompt.text.trim()),
            }
            return;
        }
        KeyCode::Backspace => {
            prompt.completing = None;
            // As in other programs, deleting from an empty line closes it.
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

/// Inserts the next or previous completion of the typed text.
fn complete(state: &State, prompt: &mut Prompt, by: isize) {
    if prompt.kind == PromptKind::Search {
        return;
    }
    let (shown, typed) = prompt
        .completing
        .take()
        .map_or_else(|| (None, prompt.text.clone()), |(shown, typed)| (Some(shown), typed));
    let offers = line::completions(state, &typed);
    let next = match shown {
        Some(shown) => round(shown, by, offers.len()),
        None if by > 0 => 0,
        None => offers.len().saturating_sub(1),
    };
    if let Some(offer) = offers.into_iter().nth(next) {
        prompt.text = offer;
        prompt.completing = Some((next, typed));
    }
}
