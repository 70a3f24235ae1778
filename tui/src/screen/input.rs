//! The input from the terminal, divided into key presses and reports by bytes and time.
//!
//! The reader of crossterm keeps a sequence that is cut off, or one that it does not know, and swallows all later keys
//! (its issues 1060 and 1104). Here a sequence ends where the standard says (ECMA-48), or when no more bytes come.

#[cfg(test)]
mod tests;

use std::io::{self, Read};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::thread;
use std::time::Duration;

use crossterm::event::{Event, KeyCode, KeyEvent};

use super::pixels::{Answer, answer};

/// A sequence that is not complete after this time is cut off; a lone escape is the key.
const PATIENCE: Duration = Duration::from_millis(100);
/// No key or report is longer; a longer sequence is dropped.
const LONGEST: usize = 256;
const PASTE: [&[u8]; 2] = [b"\x1b[200~", b"\x1b[201~"];
/// A pasted text that has not ended after a pause of this time has no end: a slow connection may stop for long.
const PASTE_PATIENCE: Duration = Duration::from_secs(3);
/// Bytes of a pasted text that are kept; the rest of a longer one is dropped.
const LONGEST_PASTE: usize = 1 << 16;
const ESCAPE: u8 = 0x1b;
const INTERRUPT: u8 = 3;
/// Bytes that are read at once: as many as a terminal keeps.
const PIECE: usize = 4096;
/// Pieces that wait to be divided into keys: what waits is short, and the rest of a long input waits in the terminal.
const PIECES: usize = 1;

#[derive(Debug)]
pub(crate) enum Input {
    /// A key, a pasted text, the mouse, the focus.
    Event(Event),
    Answer(Answer),
    End,
}

/// Reads the terminal; the inputs that come at once are passed to `tell` together.
pub(crate) fn listen(tell: impl Fn(&mut dyn Iterator<Item = Input>) + Send + 'static) -> io::Result<()> {
    let (sender, bytes) = sync_channel(PIECES);
    // Reading blocks, so an idle program takes no processor time.
    thread::Builder::new().name("assur-input".into()).spawn(move || {
        let mut buffer = [0; PIECE];
        loop {
            match io::stdin().lock().read(&mut buffer) {
                Ok(count @ 1..) if sender.send(buffer[..count].to_vec()).is_ok() => {}
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                // The terminal has died.
                _ => return,
            }
        }
    })?;
    thread::Builder::new().name("assur-keys".into()).spawn(move || {
        let mut decoder = Decoder::default();
        loop {
            let pause = decoder.patience();
            let events = match bytes.recv_timeout(pause) {
                Ok(bytes) => decoder.take(&bytes),
                Err(RecvTimeoutError::Timeout) => decoder.pause(),
                Err(RecvTimeoutError::Disconnected) => return tell(&mut std::iter::once(Input::End)),
            };
            let answers = std::mem::take(&mut decoder.answers).into_iter().map(Input::Answer);
            tell(&mut events.into_iter().map(Input::Event).chain(answers));
        }
    })?;
    Ok(())
}

#[derive(Debug, Default)]
pub(crate) struct Decoder {
    rest: Vec<u8>,
    /// The beginning of a pasted text whose end has not come yet.
    pasted: Option<Vec<u8>>,
    /// Whether the pasted text has not gone on for [`PATIENCE`].
    stalled: bool,
    /// Answers of the terminal to the question for pictures.
    pub(crate) answers: Vec<Answer>,
}

enum Head {
    Whole(usize),
    /// This many bytes that can't become a sequence.
    Broken(usize),
    Open,
}

impl Decoder {
    pub(crate) fn take(&mut self, bytes: &[u8]) -> Vec<Event> {
        // Ctrl-C is a part of a pasted text, but alone and after a pause it is the key: this text has lost its end.
        if std::mem::take(&mut self.stalled) && bytes == [INTERRUPT] {
            (self.pasted, self.rest) = (None, Vec::new());
        }
        let mut all = std::mem::take(&mut self.rest);
        all.extend_from_slice(bytes);
        let mut rest = &all[..];
        let mut events = Vec::new();
        while !rest.is_empty() {
            let count = if self.pasted.is_some() {
                let (count, event) = self.paste(rest);
                events.extend(event);
                if self.pasted.is_some() {
                    rest = &rest[count..];
                    break;
                }
                count
            } else {
                match head(rest) {
                    Head::Whole(count) => {
                        self.begin(&rest[..count], &mut events);
                        count
                    }
                    Head::Broken(count) => {
                        self.answers.extend(answer(&rest[..count]));
                        count
                    }
                    Head::Open if rest.len() > LONGEST => rest.len(),
                    Head::Open => break,
                }
            };
            rest = &rest[count..];
        }
        self.rest = rest.to_vec();
        events
    }

    /// Takes a whole sequence: a key, a report, or the beginning of a pasted text.
    fn begin(&mut self, sequence: &[u8], events: &mut Vec<Event>) {
        if sequence == PASTE[0] {
            self.pasted = Some(Vec::new());
        } else {
            self.answers.extend(answer(sequence));
            events.extend(event(sequence));
        }
    }

    fn patience(&self) -> Duration {
        match (&self.pasted, self.rest.is_empty()) {
            (Some(_), _) if self.stalled => PASTE_PATIENCE,
            (None, true) => Duration::MAX,
            _ => PATIENCE,
        }
    }

    /// Moves bytes to the pasted text; returns their number, and the text when its end has come.
    fn paste(&mut self, bytes: &[u8]) -> (usize, Option<Event>) {
        let end = bytes.windows(PASTE[1].len()).position(|bytes| bytes == PASTE[1]);
        // The last bytes may be the beginning of the end.
        let whole = end.unwrap_or_else(|| bytes.len().saturating_sub(PASTE[1].len() - 1));
        let text = self.pasted.get_or_insert_default();
        text.extend(&bytes[..whole.min(LONGEST_PASTE.saturating_sub(text.len()))]);
        if end.is_none() {
            return (whole, None);
        }
        let text = self.pasted.take().unwrap_or_default();
        (whole + PASTE[1].len(), Some(Event::Paste(String::from_utf8_lossy(&text).into_owned())))
    }

    /// No more bytes have come for a time. A pasted text may go on, as a slow connection stops now and then; one that ends
    /// with Ctrl-C has lost its end, and this was the key.
    pub(crate) fn pause(&mut self) -> Vec<Event> {
        if self.pasted.is_none() || std::mem::replace(&mut self.stalled, true) {
            return self.expire();
        }
        if self.rest.last() != Some(&INTERRUPT) {
            return Vec::new();
        }
        self.expire();
        self.take(&[INTERRUPT])
    }

    /// No more bytes have come: a lone escape is the key, any other beginning is dropped, and a pasted text without an
    /// end is no text.
    pub(crate) fn expire(&mut self) -> Vec<Event> {
        (self.pasted, self.stalled) = (None, false);
        let rest = std::mem::take(&mut self.rest);
        if rest == [ESCAPE] { event(&rest).into_iter().collect() } else { Vec::new() }
    }
}

/// What bytes begin with. A control character is in no sequence, so none takes the Ctrl-C behind its beginning.
fn head(bytes: &[u8]) -> Head {
    match bytes {
        [ESCAPE] | [ESCAPE, b'O'] | [ESCAPE, b'[', b'['] => Head::Open,
        // Escape, and then a sequence of its own.
        [ESCAPE, ESCAPE, ..] => Head::Whole(1),
        // The Linux console has function keys such as `ESC [ [ A`.
        [ESCAPE, b'[', b'[', rest @ ..] => fixed(rest, 3, 1),
        [ESCAPE, b'[', b'M', rest @ ..] => fixed(rest, 3, 3),
        [ESCAPE, b'[', rest @ ..] => match rest.iter().position(|byte| !matches!(byte, 0x20..=0x3f)) {
            Some(end) if matches!(rest[end], 0x40..=0x7e) => Head::Whole(end + 3),
            Some(end) => Head::Broken(end + 2),
            None => Head::Open,
        },
        [ESCAPE, b'O', rest @ ..] => fixed(rest, 2, 1),
        [ESCAPE, b']' | b'P' | b'_' | b'^', rest @ ..] => string(rest),
        [ESCAPE, rest @ ..] => character(rest, 1),
        _ => character(bytes, 0),
    }
}

/// A sequence that goes on with this many characters after its beginning.
fn fixed(rest: &[u8], before: usize, count: usize) -> Head {
    match rest.iter().take(count).position(|byte| *byte < b' ') {
        Some(control) => Head::Broken(before + control),
        None if rest.len() < count => Head::Open,
        None => Head::Whole(before + count),
    }
}

/// A string of the terminal, which ends with a bell or with `ESC \`; any other control character but those of a line
/// cuts it off.
fn string(rest: &[u8]) -> Head {
    let control = |byte: &u8| matches!(byte, 0..=7 | 0x0e..=0x1f);
    let Some(end) = rest.iter().position(control) else { return Head::Open };
    match rest[end..] {
        [7, ..] => Head::Broken(end + 3),
        [ESCAPE, b'\\', ..] => Head::Broken(end + 4),
        [ESCAPE] => Head::Open,
        _ => Head::Broken(end + 2),
    }
}

/// One character of UTF-8 after this many bytes.
fn character(bytes: &[u8], before: usize) -> Head {
    let length = match bytes[0] {
        0..=0x7f => 1,
        0xc2..=0xdf => 2,
        0xe0..=0xef => 3,
        0xf0..=0xf4 => 4,
        _ => return Head::Broken(before + 1),
    };
    let present = &bytes[..length.min(bytes.len())];
    match std::str::from_utf8(present) {
        Ok(_) => Head::Whole(before + length),
        // More bytes may make a character of them.
        Err(error) if error.error_len().is_none() => Head::Open,
        Err(_) => Head::Broken(before + 1),
    }
}

/// The meaning of a complete sequence; nothing if it is unknown.
fn event(sequence: &[u8]) -> Option<Event> {
    // Most of a long input: the parser would take much longer for them.
    if let [letter @ b' '..=b'~'] = sequence {
        return Some(Event::Key(KeyEvent::from(KeyCode::Char(char::from(*letter)))));
    }
    parsed(sequence)
}

fn parsed(sequence: &[u8]) -> Option<Event> {
    let parsed = terminput::Event::parse_from(sequence).ok().flatten()?;
    terminput_crossterm::to_crossterm(parsed).ok()
}
