//! The events of the cycle as bands over the coordinate: assembly modes, self-locking, dead angles, changes of the side of a guide.

use assur_figure::{
    Axis, AxisKind, Cursor, Figure, Frame, Ink, Item, Key, Panel, Sample, Sign, Stroke, extent,
};
use assur_report::topic::Event;
use assur_words::{Text, name, text};

use crate::plots::numbered;
use crate::{Look, Results, coordinate_unit};

/// Room above the first band and below the last one, in distances of two bands.
const MARGIN: f64 = 0.6;

/// A band for each kind of event, in the order of the list, each with its number; the chosen event is highlighted.
pub(crate) fn figure(results: &Results, look: &Look<'_>) -> Figure {
    let events = results.found.as_ref().map_or(&[][..], |found| &found.events);
    let Some(last) = events.iter().map(|event| event.band).max() else { return Figure::default() };
    let (_, factor) = coordinate_unit(&results.linkage);
    let mut items = Vec::new();
    let mut legend = Vec::new();
    for (index, event) in events.iter().enumerate() {
        let (ink, row) = (ink(event, index == look.event), -(event.band as f64));
        let [from, to] = event.ends.map(|end| [factor * end, row]);
        let sample = if event.is_place() {
            items.push(Item::sign(from, Sign::Ring, ink));
            Sample::Sign(Sign::Ring, ink)
        } else {
            items.push(Item::line([from, to], Stroke::Thick, ink));
            Sample::Line(Stroke::Thick, ink)
        };
        if legend.len() < event.band {
            items.push(Item::name(from, name(event.band.to_string()), Ink::Title));
            legend.push(Key { sample, text: numbered(event.band - 1, event.what.clone()) });
        }
    }
    let base = results.base_of_cycle(look);
    let range = [-(last as f64) - MARGIN, MARGIN - 1.0];
    let y = Axis { label: Text::default(), range, kind: AxisKind::Unmarked, scale: None };
    // Modes are told of a whole turn, of which the positions may be a part.
    let ends = events.iter().flat_map(|event| event.ends.map(|end| factor * end)).chain(base.axis.range);
    let x = Axis { range: extent(ends).unwrap_or(base.axis.range), ..base.axis };
    let cursor = Some(Cursor::from(base.cursor));
    let title = text!("events-title");
    let panel = Panel { title: Text::default(), frame: Frame::Axes { x, y, cursor }, items };
    Figure { title, legend, ..Figure::of(panel) }
}

fn ink(event: &Event, chosen: bool) -> Ink {
    if chosen { Ink::Marked } else { Ink::Link(event.band) }
}
