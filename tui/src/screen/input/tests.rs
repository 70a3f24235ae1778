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
fn letters_are_those_of_the_parser() {
    for letter in b' '..=b'~' {
        let codes = [super::event(&[letter]), super::parsed(&[letter])].map(|event| match event {
            Some(Event::Key(key)) => (key.code, key.kind, key.modifiers - KeyModifiers::SHIFT),
            other => panic!("{other:?}"),
        });
        assert_eq!(codes[0], codes[1], "{letter}");
    }
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

const INTERRUPT: &[u8] = b"\x03";

/// Whether the last event is Ctrl-C, with Alt after a lone escape.
fn interrupts(events: &[Event]) -> bool {
    let control = |key: &KeyEvent| key.modifiers.contains(KeyModifiers::CONTROL);
    matches!(events.last(), Some(Event::Key(key)) if key.code == KeyCode::Char('c') && control(key))
}

#[test]
fn no_beginning_of_a_sequence_takes_ctrl_c() {
    let begun: [&[u8]; 14] = [
        b"\x1b[",
        b"\x1b[1;2",
        b"\x1bO",
        b"\x1b[[",
        b"\x1b[M",
        b"\x1b[M a",
        b"\x1b]",
        b"\x1b]0;title",
        b"\x1bP1$r",
        b"\x1b_Gi=1",
        b"\x1b^x",
        b"\xe2",
        b"\xe2\x82",
        b"\xf0\x9f\x98",
    ];
    for bytes in begun {
        let mut decoder = Decoder::default();
        assert_eq!(decoder.take(bytes), [], "{bytes:?}");
        assert!(interrupts(&decoder.take(INTERRUPT)), "{bytes:?}");
        let whole = [bytes, INTERRUPT].concat();
        assert!(interrupts(&Decoder::default().take(&whole)), "{bytes:?} at once");
    }
    // Also behind a string that is longer than any.
    let long = [b"\x1b]0;", "a".repeat(5000).as_bytes(), INTERRUPT].concat();
    assert!(interrupts(&Decoder::default().take(&long)));
}

#[test]
fn ctrl_c_in_a_pasted_text_is_text_unless_nothing_follows() {
    let mut decoder = Decoder::default();
    assert_eq!(decoder.take(b"\x1b[200~rm\x03"), []);
    assert!(matches!(&decoder.take(b" x\x1b[201~")[..], [Event::Paste(text)] if text == "rm\x03 x"));
    // A text that has lost its end is left by Ctrl-C behind it,
    assert_eq!(decoder.take(b"\x1b[200~rm -r\x03"), []);
    assert!(interrupts(&decoder.pause()));
    assert_eq!(keys(decoder.take(b"q")), [KeyCode::Char('q')]);
    // or after a pause; and without it a text goes on.
    assert_eq!(decoder.take(b"\x1b[200~rm -r"), []);
    assert_eq!(decoder.pause(), []);
    assert_eq!(decoder.take(b" more"), []);
    assert_eq!(decoder.pause(), []);
    assert!(interrupts(&decoder.take(INTERRUPT)));
    assert_eq!(keys(decoder.take(b"q")), [KeyCode::Char('q')]);
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

    #[test]
    fn after_any_bytes_ctrl_c_is_ctrl_c(bytes in prop::collection::vec(any::<u8>(), 0..600)) {
        prop_assert!(interrupts(&Decoder::default().take(&[&bytes, INTERRUPT].concat())), "{bytes:?}");
    }

    #[test]
    fn any_pieces_make_the_same_keys(text in "(\\PC|\x1b\\[[A-D]|\x1bO[A-D]){0,40}", size in 1..9_usize) {
        let mut decoder = Decoder::default();
        let whole = Decoder::default().take(text.as_bytes());
        let pieces: Vec<Event> = text.as_bytes().chunks(size).flat_map(|bytes| decoder.take(bytes)).collect();
        prop_assert_eq!(pieces, whole);
    }
}
