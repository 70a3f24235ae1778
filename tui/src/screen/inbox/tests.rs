//! The order of what waits, and what of it is dropped.

use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError, channel};

use crossterm::event::{Event as Own, KeyCode, KeyEvent, KeyModifiers};

use super::{Event, Inbox, MOST};
use crate::screen::input::Input;
use crate::screen::state::Key;

fn key(letter: char) -> Input {
    Input::Event(Own::Key(KeyEvent::new(KeyCode::Char(letter), KeyModifiers::NONE)))
}

fn interrupt() -> Input {
    Input::Event(Own::Key(KeyEvent::new(KeyCode::Char('c'), KeyModifiers::CONTROL)))
}

/// The letters of the keys that wait, `^` before one with Ctrl, and a sign for each other event.
fn drained(inbox: &Inbox) -> String {
    let mut all = String::new();
    while let Some(event) = inbox.try_next() {
        match event {
            Event::Input(Input::Event(Own::Key(key))) => {
                if key.modifiers.contains(KeyModifiers::CONTROL) {
                    all.push('^');
                }
                all.extend(key.code.as_char());
            }
            Event::Input(Input::End) => all.push('.'),
            Event::Resized => all.push('#'),
            other => panic!("{other:?}"),
        }
    }
    all
}

#[test]
fn an_interrupt_comes_before_a_million_keys_and_discards_them() {
    let inbox = Inbox::new(vec![Key::parse("C-c").unwrap()], || {});
    inbox.send(Event::Resized);
    inbox.take((0..1_000_000).map(|_| key('a')));
    inbox.send(Event::Resized);
    inbox.take([interrupt(), key('b')].into_iter());
    assert_eq!(drained(&inbox), "^c##b");
    // It is a key like any other where another one ends the program.
    let inbox = Inbox::new(vec![Key::parse("C-x").unwrap()], || {});
    inbox.take([key('a'), interrupt(), key('b')].into_iter());
    assert_eq!(drained(&inbox), "a^cb");
}

#[test]
fn the_newest_inputs_stay_in_their_order_and_nothing_else_is_lost() {
    let inbox = Inbox::new(Vec::new(), || {});
    inbox.send(Event::Resized);
    inbox.take(std::iter::repeat_with(|| key('a')).take(7).chain((0..MOST - 2).map(|_| key('b'))));
    inbox.take([key('c'), key('q')].into_iter());
    assert_eq!(inbox.dropped(), 7);
    assert_eq!(inbox.dropped(), 0);
    let all = drained(&inbox);
    assert!(all.starts_with("#b") && all.ends_with("bcq"), "{all}");
    assert_eq!(all.len(), 1 + MOST);
    // Also the end of input is never dropped.
    inbox.take(std::iter::once(Input::End).chain((0..2 * MOST).map(|_| key('a'))));
    assert!(drained(&inbox).starts_with('.'));
    assert!(inbox.is_empty());
}

#[test]
fn two_interrupts_are_two() {
    let inbox = Inbox::new(vec![Key::parse("C-c").unwrap()], || {});
    inbox.take([key('a'), interrupt()].into_iter());
    // The first one is taken and answered by a warning.
    assert!(inbox.try_next().is_some());
    inbox.answered();
    inbox.take([key('b'), interrupt()].into_iter());
    assert_eq!(drained(&inbox), "^c");
    inbox.answered();
}

/// An inbox that nobody empties, and the signs of its end.
fn unread(free: bool) -> (Arc<Inbox>, Receiver<()>) {
    let (end, ended) = channel();
    let inbox = Inbox::new(vec![Key::parse("C-c").unwrap()], move || end.send(()).unwrap());
    inbox.set_free(free);
    (inbox, ended)
}

#[test]
fn an_interrupt_that_the_loop_does_not_take_ends_the_program() {
    let (inbox, ended) = unread(true);
    inbox.take(std::iter::once(interrupt()));
    assert_eq!(ended.recv(), Ok(()));
    // Where a warning is due that can't be shown, the second one ends.
    let (inbox, ended) = unread(false);
    inbox.take(std::iter::once(interrupt()));
    assert_eq!(ended.try_recv(), Err(TryRecvError::Empty));
    inbox.take(std::iter::once(interrupt()));
    assert_eq!(ended.recv(), Ok(()));
}
