//! What the loop does with what waits, without a terminal.

use crossterm::event::{Event as Own, KeyCode, KeyEvent, KeyModifiers};

use super::{EventLoop, Inbox};
use crate::screen::input::Input;
use crate::screen::state::Effect;
use crate::screen::tests::{opened, press};

fn key(code: KeyCode, modifiers: KeyModifiers) -> Input {
    Input::Event(Own::Key(KeyEvent::new(code, modifiers)))
}

/// A loop on a scene; `keys` are pressed before.
fn session(keys: &str) -> EventLoop {
    let mut state = opened("shaper");
    press(&mut state, keys);
    let inbox = Inbox::new(state.keys.everywhere("quit"), || {});
    EventLoop::new(state, inbox)
}

/// Any number of one key, then Ctrl-C.
fn flooded(session: &EventLoop, code: KeyCode) {
    let flood = std::iter::repeat_with(|| key(code, KeyModifiers::NONE)).take(100_000);
    session.inbox.take(flood.chain([key(KeyCode::Char('c'), KeyModifiers::CONTROL)]));
}

#[test]
fn ctrl_c_ends_before_any_key_that_waits_is_applied() {
    // In the view, and where text is typed.
    for keys in ["1", "/", ":", "?", "? /", "p"] {
        let mut session = session(keys);
        let before = (session.state.position, session.state.entry().map(|entry| (**entry).to_owned()));
        flooded(&session, if keys == "1" { KeyCode::Right } else { KeyCode::Char('x') });
        session.apply_what_waits();
        assert!(matches!(session.state.effects[..], [Effect::Quit]), "{keys}: {:?}", session.state.effects);
        let after = (session.state.position, session.state.entry().map(|entry| (**entry).to_owned()));
        assert_eq!(after, before, "{keys}");
        assert!(session.inbox.is_empty(), "{keys}");
    }
}

#[test]
fn ctrl_c_warns_of_unsaved_changes_also_in_a_flood_and_then_ends() {
    let mut session = session("e +");
    flooded(&session, KeyCode::Char('r'));
    session.apply_what_waits();
    assert!(session.state.effects.is_empty());
    let (_, message) = session.state.message.clone().unwrap();
    assert!(message.to_string().contains("changes are not saved"), "{message}");
    flooded(&session, KeyCode::Char('x'));
    session.apply_what_waits();
    assert!(matches!(session.state.effects[..], [Effect::Quit]));
}

#[test]
fn a_wish_is_granted_before_the_keys_behind_it() {
    let mut session = session("1");
    let keys = [KeyCode::Char('w'), KeyCode::Char('3')];
    session.inbox.take(keys.into_iter().map(|code| key(code, KeyModifiers::NONE)));
    session.apply_what_waits();
    assert!(matches!(session.state.effects[..], [Effect::Write(_)]));
    assert!(!session.inbox.is_empty());
}

#[test]
fn input_that_ends_is_a_terminal_that_has_died() {
    let mut session = session("1");
    session.inbox.take(std::iter::once(Input::End));
    session.apply_what_waits();
    assert!(session.ended);
}
