//! What happens over the cycle: where the assembly modes of the groups begin and end, where friction holds the machine or leaves no
//! solution, and where guides change sides.

use assur_analysis::GroupModes;
use assur_analysis::results::Analysis;
use assur_book::{Document, Table, Unit};
use assur_diagram::SignChange;
use assur_kinematics::CourseEnd;
use assur_words::{Text, number, ordinal, text};

use super::structure::mode_end;

/// Something that lasts over a part of the cycle, or occurs at one place of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Event {
    /// What it is: `mode 2 of group 1`, `self-locking`.
    pub what: Text,
    /// Where it begins and ends, rad or m; equal for what occurs at one place.
    pub ends: [f64; 2],
    /// How it begins and ends; may be empty.
    pub how: Text,
    /// The number of its band, from 1: the same that occurs several times is one band.
    pub band: usize,
}

impl Event {
    fn new(what: Text, ends: [f64; 2], how: Text) -> Self {
        Self { what, ends, how, band: 0 }
    }

    /// Whether it occurs at one place.
    pub fn is_place(&self) -> bool {
        self.ends[0].to_bits() == self.ends[1].to_bits()
    }
}

/// All events of the cycle: those of the groups in solving order, of friction, of the guides.
pub fn events(analysis: &Analysis, modes: &[GroupModes]) -> Vec<Event> {
    let mut events: Vec<Event> = modes.iter().flat_map(of_group).collect();
    if let Some(friction) = &analysis.friction {
        let intervals =
            [("fact-self-braking", &friction.self_braking), ("fact-dead-angle", &friction.dead_angles)];
        let told = intervals.into_iter().flat_map(|(id, found)| found.iter().map(move |ends| (id, *ends)));
        events.extend(told.map(|(id, ends)| Event::new(text!(id), ends, Text::default())));
    }
    for (slide, changes) in &analysis.cycle.sign_changes {
        let what = || text!("event-side", guide = slide);
        let event = |found: &SignChange| Event::new(what(), [found.coordinate; 2], how_changed(found));
        events.extend(changes.iter().map(event));
    }
    let mut bands = Vec::new();
    for event in &mut events {
        let band = bands.iter().position(|what| *what == event.what).unwrap_or(bands.len());
        if band == bands.len() {
            bands.push(event.what.clone());
        }
        event.band = band + 1;
    }
    events
}

/// Where the modes of a group begin, end and meet.
fn of_group(modes: &GroupModes) -> Vec<Event> {
    let group = || number(modes.group);
    let mut events = Vec::new();
    for mode in &modes.courses.modes {
        let (of, circuit) = (ordinal(mode.way), ordinal(mode.circuit));
        let how = match [mode.begins, mode.ends] {
            [CourseEnd::Cycle, CourseEnd::Cycle] => text!("event-mode-whole"),
            both => {
                let [begins, ends] = both.map(mode_end);
                text!("event-mode-ends", begins, ends)
            }
        };
        let is_present = modes.way == Some(mode.way);
        let id = if is_present { "event-mode-present" } else { "event-mode" };
        let what = Text::message(id, vec![("mode", of), ("group", group()), ("circuit", circuit)]);
        events.push(Event::new(what, [mode.from, mode.to], how));
    }
    for meeting in &modes.courses.meetings {
        let [one, other] = meeting.ways.map(ordinal);
        let what = text!("event-meeting", one, other, group = group());
        events.push(Event::new(what, [meeting.at; 2], Text::default()));
    }
    events
}

/// How the force of a guide changes its side.
pub(super) fn how_changed(change: &SignChange) -> Text {
    text!(if change.jump { "report-jumps" } else { "report-passes-zero" })
}

/// The events as a table.
pub fn list_of_events(events: &[Event], unit: Unit, page: &mut Document) {
    let table = Table::each(Text::default(), events)
        .column(text!("head-number"), |event| event.band)
        .column(text!("head-occurrence"), |event| event.what.clone())
        .measured(text!("head-from"), unit, |event| event.ends[0])
        .measured(text!("head-to"), unit, |event| Some(event.ends[1]).filter(|_| !event.is_place()))
        .column(text!("head-how"), |event| event.how.clone());
    page.table(table.table());
}
