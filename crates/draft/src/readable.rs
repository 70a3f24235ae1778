//! What can be read of a text with faults.

use assur_mechanism::{Key, Step};
use assur_scene::{SceneError, read};

use crate::known::Of;
use crate::layout::{Layout, line_end, line_start, slip};
use crate::names::{Names, point_of};
use crate::part::Part;
use crate::written::quoted;
use crate::{append, remove};

/// A text that the reader accepts, made of one that may have faults.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Readable {
    /// The text without what is wrong; empty if nothing can be read.
    pub text: String,
    /// The faults of the whole text, in its order.
    pub faults: Vec<SceneError>,
    /// Whether the text has an input that the whole one lacks: on the first link that is joined to the ground.
    pub is_input_provisional: bool,
}

/// How often something is taken out before the text is given up.
const ATTEMPTS: usize = 1000;

/// So many faults at most are taken out one by one, since one may be the cause of others.
const FEW: usize = 16;

/// Takes out of a text what is wrong, as little as possible: a value, then its key, then its table. `name`: of the file, for the
/// errors.
pub fn readable(name: &str, text: &str) -> Readable {
    let mut found = Readable { text: text.to_owned(), faults: Vec::new(), is_input_provisional: false };
    for attempt in 0..ATTEMPTS {
        let Err(errors) = read(name, &found.text) else { return found };
        let without = if let Some(fault) = slip(&found.text) {
            without_lines(&found.text, &fault)
        } else {
            let count = if errors.errors.len() > FEW { errors.errors.len() } else { 1 };
            let places: Vec<usize> = errors
                .errors
                .iter()
                .filter(|fault| !fault.span.is_empty())
                .map(|fault| fault.span.start)
                .collect();
            without_places(&found.text, &places[..count.min(places.len())]).or_else(|| {
                let lacks_input = !std::mem::replace(&mut found.is_input_provisional, true);
                with_input(&found.text).filter(|_| lacks_input)
            })
        };
        if attempt == 0 {
            found.faults = errors.errors;
        }
        match without {
            Some(text) => found.text = text,
            None => break,
        }
    }
    Readable { text: String::new(), is_input_provisional: false, ..found }
}

/// The key whose name or value, or header, is at a byte of a text, which may have faults; elements of lists by their name where
/// they have one.
pub fn key_at(text: &str, byte: usize) -> Option<Key> {
    let layout = Layout::of_any(text)?;
    let path = layout.path_at(byte).filter(|path| !path.is_empty())?;
    Some(layout.named(&path))
}

/// The text without the line in which the syntax goes wrong, the one before it, which may not be closed, or their table: that
/// after which the most can be read, and of these the least.
fn without_lines(text: &str, fault: &SceneError) -> Option<String> {
    let is_header = |line: &str| line.trim_start().starts_with('[');
    let end_of = |start: usize| {
        let mut end = line_end(text, start);
        while end < text.len() && is_header(&text[start..]) && !is_header(&text[end..]) {
            end = line_end(text, end);
        }
        end
    };
    let own = line_start(text, fault.span.start.min(text.len()));
    let before = &text[..own];
    let header = before.rfind("\n[").map_or(0, |at| at + 1);
    let starts = [own, line_start(text, before.trim_end().len()), header];
    let without = starts.map(|start| format!("{}{}", &text[..start], &text[end_of(start)..]));
    let unread = |text: &String| slip(text).map_or(0, |fault| text.len() - fault.span.start.min(text.len()));
    without
        .into_iter()
        .filter(|rest| rest.len() < text.len())
        .min_by_key(|rest| (unread(rest), text.len() - rest.len()))
}

/// The text without what stands at some places; `None` if nothing does.
fn without_places(text: &str, places: &[usize]) -> Option<String> {
    let layout = Layout::of(text).ok()?;
    let mut paths: Vec<Vec<Step>> =
        places.iter().filter_map(|place| layout.path_at(*place)).filter(|path| !path.is_empty()).collect();
    // Elements of a list have their numbers until those before them go.
    paths.sort_unstable();
    paths.dedup();
    let without = paths.iter().rev().fold(text.to_owned(), |text, path| remove(&text, &Key::from(&path[..])));
    (without != text).then_some(without)
}

/// The text with an input on the first link that is pinned to the ground or slides on it; `None` if it has an input, or no such link.
fn with_input(text: &str) -> Option<String> {
    let names = Names::of(Layout::of(text).ok()?);
    if !names.paths(&Part::Load("input", 0)).is_empty() {
        return None;
    }
    let input = names.definitions(Of::Link).find_map(|link| {
        let link = &link.word;
        let is_pin = |point: &str| {
            let has = |wanted: &str| names.holders(point).any(|(holder, _)| holder == wanted);
            has("ground") && has(link)
        };
        let pin = names.points.iter().map(|path| point_of(path)).find(|point| is_pin(point));
        let slide = || names.slides.iter().find(|slide| slide.link == *link && slide.on == "ground");
        let pin = pin.map(|pin| format!("pin = {}\nof = {}\non = \"ground\"", quoted(pin), quoted(link)));
        pin.or_else(|| Some(format!("slide = {}\nto = 0\npositions = 1", quoted(&slide()?.name))))
    });
    append(text, &format!("[input]\n{}\n", input?)).ok()
}
