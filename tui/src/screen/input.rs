//! The input from the terminal, divided into key presses and reports by bytes and time.
//!
//! The reader of crossterm keeps a sequence that is cut off, or one that it does not know, and swallows all later keys
//! (its issues 1060 and 1104). Here a sequence ends where the standard says (ECMA-48), or when no more bytes come.

#[cfg(test)]
mod tests;

use std::io::{self, Read};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use crossterm::event::Event;

use super::pixels::{Answer, answer};

/// A sequence that is not complete after this time is cut off; a lone escape is the key.
const PATIENCE: Duration = Duration::from_millis(100);
/// No key or report is longer; a longer sequence is dropped.
const LONGEST: usize = 256;
/// What stands around a pasted text.
const PASTE: [&[u8]; 2] = [b"\x1b[200~", b"\x1b[201~"];
/// A pasted text that has not ended after a pause of this time has no end: a slow connection may stop for long.
const PASTE_PATIENCE: Duration = Duration::from_secs(3);
/// Bytes of a pasted text that are kept; the rest of a longer one is dropped.
const LONGEST_PASTE: usize = 1 << 16;
const ESCAPE: u8 = 0x1b;

/// What comes from the terminal.
#[derive(Debug)]
pub(crate) enum Input {
    /// A key, a pasted text, the mouse, the focus.
    Event(Event),
    /// An answer to the question for pictures.
    Answer(Answer),
    /// Nothing more.
    End,
}

/// Reads the terminal; each input is passed to `tell`, which returns false to end.
pub(crate) fn listen(mut tell: impl FnMut(Input) -> bool + Send + 'static) -> io::Result<()> {
    let (sender, bytes) = channel();
    // Reading blocks, so an idle program takes no processor time.
    thread::Builder::new().name("assur-input".into()).spawn(move || {
        let mut buffer = [0; 1024];
        while let Ok(count @ 1..) = io::stdin().lock().read(&mut buffer) {
            if sender.send(buffer[..count].to_vec()).is_err() {
                return;
            }
        }
    })?;
    thread::Builder::new().name("assur-keys".into()).spawn(move || {
        let mut decoder = Decoder::default();
        loop {
            let pause = decoder.patience();
            let events = match bytes.recv_timeout(pause) {
                Ok(bytes) => decoder.take(&bytes),
                Err(RecvTimeoutError::Timeout) => decoder.expire(),
                Err(RecvTimeoutError::Disconnected) => {
                    tell(Input::End);
                    return;
                }
            };
            let answers = std::mem::take(&mut decoder.answers).into_iter().map(Input::Answer);
            if !events.into_iter().map(Input::Event).chain(answers).all(&mut tell) {
                return;
            }
        }
    })?;
    Ok(())
}

/// Bytes that do not form a complete sequence yet.
#[derive(Debug, Default)]
pub(crate) struct Decoder {
    rest: Vec<u8>,
    /// The beginning of a pasted text whose end has not come yet.
    pasted: Option<Vec<u8>>,
    /// Answers of the terminal to the question for pictures.
    pub(crate) answers: Vec<Answer>,
}

/// What the bytes begin with.
enum Head {
    /// A sequence of this many bytes.
    Whole(usize),
    /// This many bytes that can't become a sequence.
    Broken(usize),
    /// The beginning of a sequence.
    Open,
}

impl Decoder {
    /// The events of all complete sequences.
    pub(crate) fn take(&mut self, bytes: &[u8]) -> Vec<Event> {
        self.rest.extend_from_slice(bytes);
        let mut events = Vec::new();
        while !self.rest.is_empty() {
            if self.pasted.is_some() {
                match self.paste() {
                    Some(event) => events.push(event),
                    None => break,
                }
                continue;
            }
            let head = head(&self.rest);
            if let Head::Whole(count) | Head::Broken(count) = head {
                self.answers.extend(answer(&self.rest[..count]));
            }
            match head {
                Head::Whole(count) if self.rest[..count] == *PASTE[0] => {
                    self.rest.drain(..count);
                    self.pasted = Some(Vec::new());
                }
                Head::Whole(count) => events.extend(event(&self.rest.drain(..count).collect::<Vec<_>>())),
                Head::Broken(count) => drop(self.rest.drain(..count)),
                Head::Open if self.rest.len() > LONGEST => self.rest.clear(),
                Head::Open => break,
            }
        }
        events
    }

    /// How long to wait for the rest of what has begun.
    fn patience(&self) -> Duration {
        match (&self.pasted, self.rest.is_empty()) {
            (Some(_), _) => PASTE_PATIENCE,
            (None, false) => PATIENCE,
            (None, true) => Duration::MAX,
        }
    }

    /// Moves bytes to the pasted text; returns it when its end has come.
    fn paste(&mut self) -> Option<Event> {
        let end = self.rest.windows(PASTE[1].len()).position(|bytes| bytes == PASTE[1]);
        // The last bytes may be the beginning of the end.
        let whole = end.unwrap_or_else(|| self.rest.len().saturating_sub(PASTE[1].len() - 1));
        let text = self.pasted.get_or_insert_default();
        text.extend(self.rest.drain(..whole));
        text.truncate(LONGEST_PASTE);
        end?;
        self.rest.drain(..PASTE[1].len());
        let text = self.pasted.take()?;
        Some(Event::Paste(String::from_utf8_lossy(&text).into_owned()))
    }

    /// No more bytes have come: a lone escape is the key, any other beginning is dropped, and a pasted text without an
    /// end is no text.
    pub(crate) fn expire(&mut self) -> Vec<Event> {
        self.pasted = None;
        let rest = std::mem::take(&mut self.rest);
        if rest == [ESCAPE] { event(&rest).into_iter().collect() } else { Vec::new() }
    }
}

fn head(bytes: &[u8]) -> Head {
    match bytes {
        [ESCAPE] | [ESCAPE, b'O'] | [ESCAPE, b'[', b'['] => Head::Open,
        // Escape, and then a sequence of its own.
        [ESCAPE, ESCAPE, ..] => Head::Whole(1),
        // The Linux console has function keys such as `ESC [ [ A`.
        [ESCAPE, b'[', b'[', _, ..] => Head::Whole(4),
        [ESCAPE, b'[', b'M', rest @ ..] => {
            if rest.len() < 3 {
                Head::Open
            } else {
                Head::Whole(6)
            }
        }
        [ESCAPE, b'[', rest @ ..] => match rest.iter().position(|byte| !matches!(byte, 0x20..=0x3f)) {
            Some(end) if matches!(rest[end], 0x40..=0x7e) => Head::Whole(end + 3),
            Some(end) => Head::Broken(end + 2),
            None => Head::Open,
        },
        [ESCAPE, b'O', _, ..] => Head::Whole(3),
        // A string of the terminal, which ends with a bell or with `ESC \`.
        [ESCAPE, b']' | b'P' | b'_' | b'^', rest @ ..] => {
            let bell = rest.iter().position(|byte| *byte == 7).map(|end| end + 3);
            let end = rest.windows(2).position(|two| two == [ESCAPE, b'\\']).map(|end| end + 4);
            bell.into_iter().chain(end).min().map_or(Head::Open, Head::Broken)
        }
        [ESCAPE, rest @ ..] => character(rest, 1),
        _ => character(bytes, 0),
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
    match bytes.get(..length).map(std::str::from_utf8) {
        Some(Ok(_)) => Head::Whole(before + length),
        Some(Err(_)) => Head::Broken(before + 1),
        None => Head::Open,
    }
}

/// The meaning of a complete sequence; nothing if it is unknown.
fn event(sequence: &[u8]) -> Option<Event> {
    let parsed = terminput::Event::parse_from(sequence).ok().flatten()?;
    terminput_crossterm::to_crossterm(parsed).ok()
}
