//! What is asked, what is answered, and the pictures.

use assur_figure::{Axis, Figure, Frame, Panel};
use assur_words::{Language, Text, name};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use ratatui::layout::Rect;

use super::{Answer, CHUNK, answer, bytes};
use crate::screen::input::Decoder;
use crate::screen::state::Pictures;
use crate::screen::tests::{opened, press, text};

#[test]
fn answers_are_told_from_keys_in_any_pieces() {
    let all = "\x1b_Gi=31;OK\x1b\\\x1b]1337;ReportCellSize=20.0;10.0\x07\x1b[?62;4cq";
    for size in [1, 2, 7, 100] {
        let mut decoder = Decoder::default();
        let events: Vec<_> = all.as_bytes().chunks(size).flat_map(|bytes| decoder.take(bytes)).collect();
        assert_eq!(events.len(), 1, "the key alone: {events:?}");
        let wanted = [Answer::Takes(Pictures::Kitty), Answer::Takes(Pictures::Iterm), Answer::End];
        assert_eq!(decoder.answers, wanted, "{size}");
    }
    for other in ["\x1b[c", "\x1b_Gi=31;EINVAL:no\x1b\\", "\x1b[?2026;2$y", "q"] {
        assert_eq!(answer(other.as_bytes()), None, "{other:?}");
    }
}

#[test]
fn a_picture_is_a_png_at_its_place() {
    let axis = Axis::around(Text::default(), [0.0, 1.0], 0.0);
    let frame = Frame::Axes { x: axis.clone(), y: axis, cursor: None };
    let figure = Figure::of(Panel { title: name("t"), frame, items: Vec::new() });
    let pictures = [(figure, Rect::new(4, 2, 60, 20))];
    let kitty = bytes(&pictures, Pictures::Kitty, [10.0, 20.0], Language::english());
    assert!(kitty.contains("\x1b[3;5H\x1b_Ga=T,f=100,q=2,C=1,c=60,r=20,m="), "{}", &kitty[..80]);
    let chunks: Vec<&str> =
        kitty.split("m=").skip(1).filter_map(|rest| rest.split(['\x1b', ';']).nth(1)).collect();
    assert!(chunks.iter().all(|chunk| chunk.len() <= CHUNK));
    assert_eq!(kitty.matches("m=0;").count(), 1, "one end");
    let iterm = bytes(&pictures, Pictures::Iterm, [10.0, 20.0], Language::english());
    let whole = iterm.split([':', '\x07']).nth(1).unwrap();
    assert_eq!(chunks.concat(), whole);
    assert!(STANDARD.decode(whole).unwrap().starts_with(b"\x89PNG\r\n\x1a\n"));
}

#[test]
fn characters_give_way_to_pictures_where_the_terminal_takes_them() {
    let mut state = opened("shaper");
    let is_dotted = |frame: &str| frame.chars().any(|letter| ('\u{2801}'..'\u{2900}').contains(&letter));
    press(&mut state, "I");
    assert!(is_dotted(&text(&state, 80, 24)), "nobody has answered yet");
    state.pictures = Pictures::Kitty;
    let frame = text(&state, 80, 24);
    assert!(!is_dotted(&frame) && frame.contains("PF0 100.000 mm"), "{frame}");
    assert_eq!(state.shown.borrow().len(), 1);
    press(&mut state, "?");
    let _ = text(&state, 80, 24);
    assert!(state.shown.borrow().is_empty(), "a picture would cover the help");
    press(&mut state, "Esc I");
    assert!(is_dotted(&text(&state, 80, 24)));
}
