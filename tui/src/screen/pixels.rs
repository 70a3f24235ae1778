//! Drawings as pixels in terminals that show pictures: kitty's protocol and that of iTerm2, which both take a PNG. A terminal is
//! asked, and only when the user wants pixels.
//!
//! Sixels are left out: the crates that write them (`ratatui-image` 11, `icy_sixel` 0.7) bring forty others, seven of them in a
//! second version, to reduce colors of which these figures have a dozen.

#[cfg(test)]
mod tests;

use std::fmt::Write;

use assur_figure::{Figure, svg};
use assur_png as png;
use assur_words::Language;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use ratatui::layout::Rect;

use super::state::Pictures;

/// What the terminal is asked: whether it takes a picture of kitty's protocol; the size of a cell, as iTerm2 tells it; and what
/// every terminal answers, so that the end of the answers is known.
pub(crate) const QUESTION: &str =
    "\x1b_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\x1b\\\x1b]1337;ReportCellSize\x07\x1b[c";

/// Most bytes of a picture in one sequence of kitty's protocol.
const CHUNK: usize = 4096;
/// Height of the letters of a picture in heights of a cell.
const LETTERS: f64 = 0.6;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Answer {
    /// The terminal takes pictures in this way.
    Takes(Pictures),
    End,
}

/// The answer that a sequence from the terminal is, if it is one.
pub(crate) fn answer(sequence: &[u8]) -> Option<Answer> {
    let text = std::str::from_utf8(sequence).ok()?;
    if text.starts_with("\x1b_G") {
        return text.contains(";OK").then_some(Answer::Takes(Pictures::Kitty));
    }
    if text.starts_with("\x1b]1337;ReportCellSize=") {
        return Some(Answer::Takes(Pictures::Iterm));
    }
    (text.starts_with("\x1b[?") && text.ends_with('c')).then_some(Answer::End)
}

/// The bytes that show pictures in place of those before, each with its place on the terminal; `cell`: width and height of a
/// cell in pixels.
pub(crate) fn bytes(shown: &[(Figure, Rect)], way: Pictures, cell: [f64; 2], language: &Language) -> String {
    // The cursor stays where it is.
    let mut text = "\x1b7".to_owned();
    if way == Pictures::Kitty {
        text.push_str("\x1b_Ga=d,d=A,q=2\x1b\\");
    }
    for (figure, area) in shown {
        let mm = svg::EM / (LETTERS * cell[1]);
        let size = [f64::from(area.width) * cell[0] * mm, f64::from(area.height) * cell[1] * mm];
        let Ok(picture) = png::write(&svg::write(figure, size, language), size) else { continue };
        let picture = STANDARD.encode(picture);
        let (columns, rows) = (area.width, area.height);
        let _ = write!(text, "\x1b[{};{}H", area.y + 1, area.x + 1);
        if way == Pictures::Kitty {
            let mut chunks = picture.as_bytes().chunks(CHUNK).peekable();
            let mut head = format!("a=T,f=100,q=2,C=1,c={columns},r={rows},");
            while let Some(chunk) = chunks.next() {
                let (more, chunk) = (u8::from(chunks.peek().is_some()), String::from_utf8_lossy(chunk));
                let _ = write!(text, "\x1b_G{head}m={more};{chunk}\x1b\\");
                head.clear();
            }
        } else {
            let shape = format!("inline=1;width={columns};height={rows};preserveAspectRatio=0");
            let _ = write!(text, "\x1b]1337;File={shape}:{picture}\x07");
        }
    }
    text + "\x1b8"
}
