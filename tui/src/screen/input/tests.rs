//! Whole, cut and unknown sequences, in any pieces.

use crossterm::event::{Event, KeyCode, KeyEvent, KeyModifiers};
use proptest::prelude::*;

use super::Decoder;

fn keys(events: Vec<Event>) -> Vec<KeyCode> {
    let code = |event| match event {
        Event::Key(KeyEvent { code, .. }) => Some(code),
        _ => None,
    };
    events.into_iter().filter_map(code).collect()
}

#[test]
fn keys_are_read_whole_and_in_pieces() {
    use KeyCode::{BackTab, Char, Down, End, Enter, F, Home, Left, PageUp, Tab};
    let all: [(&[u8], KeyCode); 13] = [
        (b"q", Char('q')),
        ("\u{44f}".as_bytes(), Char('\u{44f}')),
        (b"\r", Enter),
        (b"\t", Tab),
        (b"\x1b[D", Left),
        (b"\x1bOB", Down),
        (b"\x1b[H", Home),
        (b"\x1b[4~", End),
        (b"\x1b[5~", PageUp),
        (b"\x1b[Z", BackTab),
        (b"\x1bOP", F(1)),
        (b"\x1b[15~", F(5)),
        (b"\x1b[[A", F(1)),
    ];
    for (bytes, key) in all {
        assert_eq!(keys(Decoder::default().take(bytes)), [key], "{bytes:?}");
        let mut decoder = Decoder::default();
        let events: Vec<Event> = bytes.iter().flat_map(|byte| decoder.take(&[*byte])).collect();
        assert_eq!(keys(events), [key], "{bytes:?} byte by byte");
    }
    let control = Decoder::default().take(b"\x03");
    assert_eq!(control, [Event::Key(KeyEvent::new(KeyCode::Char('c'), KeyModifiers::CONTROL))]);
}

#[test]
fn a_lone_escape_is_the_key_after_a_pause() {
    let mut decoder = Decoder::default();
    assert_eq!(decoder.take(b"\x1b"), []);
    assert_eq!(keys(decoder.expire()), [KeyCode::Esc]);
    assert_eq!(keys(decoder.take(b"\x1b\x1b[C")), [KeyCode::Esc, KeyCode::Right]);
}

#[test]
fn a_sequence_that_is_cut_off_swallows_no_key() {
    for cut in ["\x1b[<0;1", "\x1b[", "\x1bO", "\x1b]0;title", "\x1b[?2026;2", "\x1b[M a", "\u{44f}"] {
        let cut = &cut.as_bytes()[..cut.len() - usize::from(!cut.is_ascii())];
        let mut decoder = Decoder::default();
        assert_eq!(decoder.take(cut), [], "{cut:?}");
        assert_eq!(decoder.expire(), [], "{cut:?}");
        assert_eq!(keys(decoder.take(b"q")), [KeyCode::Char('q')], "{cut:?}");
    }
    // Unknown reports, and the end of a paste that never began, are dropped at once.
    for unknown in
        ["\x1b[201~", "\x1b[?2026;2$y", "\x1b]11;rgb:0/0/0\x07", "\x1b[<0;1\x03", "\u{ff}\x1b[999~"]
    {
        let mut decoder = Decoder::default();
        decoder.take(unknown.as_bytes());
        assert_eq!(keys(decoder.take(b"q")).last(), Some(&KeyCode::Char('q')), "{unknown:?}");
    }
}

#[test]
fn a_pasted_text_is_no_keys() {
    let pasted = |bytes: &[u8], size: usize| {
        let mut decoder = Decoder::default();
        bytes.chunks(size).flat_map(|bytes| decoder.take(bytes)).collect::<Vec<_>>()
    };
    let text = "q\x1b[A\nr\u{44f}";
    let bytes = format!("a\x1b[200~{text}\x1b[201~b");
    for size in [1, 2, 3, 5, 100] {
        let events = pasted(bytes.as_bytes(), size);
        assert!(
            matches!(&events[..], [Event::Key(_), Event::Paste(found), Event::Key(_)] if found == text),
            "{size}: {events:?}"
        );
    }
    // A text without an end is dropped after a pause, and one that is too long is cut.
    let mut decoder = Decoder::default();
    assert_eq!(decoder.take(b"\x1b[200~quit"), []);
    assert_eq!(decoder.expire(), []);
    assert_eq!(keys(decoder.take(b"q")), [KeyCode::Char('q')]);
    let long = pasted(format!("\x1b[200~{}\x1b[201~", "a".repeat(100_000)).as_bytes(), 1024);
    assert!(matches!(&long[..], [Event::Paste(text)] if text.len() == 1 << 16));
}

#[test]
fn clicks_and_focus_are_reported() {
    let events = Decoder::default().take(b"\x1b[<0;12;7M\x1b[I\x1b[O");
    assert!(
        matches!(events[..], [Event::Mouse(mouse), Event::FocusGained, Event::FocusLost]
        if (mouse.column, mouse.row) == (11, 6)),
        "{events:?}"
    );
}

proptest! {
    #[test]
    fn after_any_bytes_and_a_pause_a_key_is_a_key(bytes in prop::collection::vec(any::<u8>(), 0..600)) {
        let mut decoder = Decoder::default();
        decoder.take(&bytes);
        decoder.expire();
        prop_assert_eq!(keys(decoder.take(b"q")), [KeyCode::Char('q')]);
    }
}
