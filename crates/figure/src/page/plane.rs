//! A plane on paper, to a round scale.

use assur_words::{Language, joined};

use super::element::polyline;
use super::{Anchor, BORDER, Element, Print, Room, drawn, heading, plain as plain_text};
use crate::bounds::Bounds;
use crate::model::{Frame, Ink, Panel, Point, Stroke};
use crate::number::round_up;
use crate::scale::{SCALES, Scale};
use crate::trace::Paper;

/// Free space around what is drawn, for names, bearings and sliders, in text sizes.
pub(crate) const MARGIN: f64 = 2.2;
/// Space behind the words of a scale, in text sizes: those of the next panel don't seem to go on with them.
const BEHIND: f64 = 2.5;
/// Rounding of a scale.
const SAME: f64 = 1e-9;
/// Greatest length of a scale bar, mm, and height of its ends, in text sizes.
const BAR: f64 = 20.0;
const END: f64 = 0.4;

/// The elements of a panel.
pub(super) fn elements(panel: &Panel, room: Room, print: &Print<'_>) -> Vec<Element> {
    let Frame::Plane { bounds, scales } = &panel.frame else { return Vec::new() };
    let mut elements = heading(panel, room, print);
    let (plot, scale) = fit(bounds, scales, room, elements.len(), print);
    let em = print.style.em;
    let center = bounds.center().map(|x| if x.is_finite() { x } else { 0.0 });
    let middle = [plot.left + 0.5 * plot.width, plot.top + 0.5 * plot.height];
    let place =
        |at: Point| [middle[0] + (at[0] - center[0]) / scale, middle[1] - (at[1] - center[1]) / scale];
    let paper = Paper { place, em, gap: 0.1 * em };
    let marks: Vec<_> = panel.items.iter().flat_map(|item| paper.marks(item)).collect();
    elements.extend(drawn(&marks, plot, print));
    // What lies in one place has no scale.
    if bounds.size().iter().any(|side| *side != 0.0) {
        for (row, own) in scales.iter().enumerate() {
            let corner = [room.left, plot.top + plot.height + (row as f64 + 0.7) * print.style.row()];
            elements.extend(bar(own, scale, corner, print));
        }
    }
    elements
}

/// A panel's room, shrunk to its drawing.
pub(super) fn shrunk(panel: &Panel, room: Room, print: &Print<'_>) -> Room {
    let Frame::Plane { bounds, scales } = &panel.frame else { return room };
    let em = print.style.em;
    // A heading keeps clear of that of the next panel.
    let title = print.width(&plain_text(&panel.title, print.language)) + em;
    let lines = |room| heading(panel, room, print).len();
    let (_, scale) = fit(bounds, scales, room, lines(room), print);
    let [width, height] = bounds.size().map(|side| side / scale + 2.0 * MARGIN * em + BORDER);
    let of_scale = |own| {
        let (length, words) = told(own, scale, print.language);
        length / scale + print.width(&words) + BEHIND * em
    };
    let width = scales.iter().map(of_scale).fold(width.max(title).min(room.width), f64::max);
    let around = print.style.row() * (lines(Room { width, ..room }) + scales.len()) as f64;
    Room { width, height: (height + around).min(room.height), ..room }
}

/// The symbol and the unit of a plane that has a round scale.
pub(super) fn kind(panel: &Panel) -> Option<(&'static str, &str)> {
    let Frame::Plane { scales, .. } = &panel.frame else { return None };
    scales.first().map(|own| (own.symbol, own.unit.as_str())).filter(|(symbol, _)| !symbol.is_empty())
}

/// The greater side of what a panel draws, in its units.
pub(super) fn largest(panel: &Panel) -> f64 {
    let Frame::Plane { bounds, .. } = &panel.frame else { return 0.0 };
    bounds.size().into_iter().fold(0.0, f64::max)
}

/// The room that a panel needs at a scale; its heading is divided within the width of a room.
pub(super) fn at_scale(panel: &Panel, room: Room, scale: f64, print: &Print<'_>) -> Room {
    let Frame::Plane { bounds, scales } = &panel.frame else { return room };
    let em = print.style.em;
    let [drawn, high] = bounds.size().map(|side| side / scale + 2.0 * MARGIN * em + BORDER);
    let of_scale = |own| {
        let (length, words) = told(own, scale, print.language);
        length / scale + print.width(&words) + BEHIND * em
    };
    let title = (print.width(&plain_text(&panel.title, print.language)) + em).min(room.width);
    let width = scales.iter().map(of_scale).fold(drawn.max(title), f64::max);
    let lines = heading(panel, Room { width, ..room }, print).len() + scales.len();
    Room { width, height: high + print.style.row() * lines as f64, scale, ..room }
}

/// The scale of a panel in its room.
pub(super) fn scale_in(panel: &Panel, room: Room, print: &Print<'_>) -> Option<f64> {
    let Frame::Plane { bounds, scales } = &panel.frame else { return None };
    Some(fit(bounds, scales, room, heading(panel, room, print).len(), print).1)
}

/// The place of the drawing below so many lines of a heading, and its scale: units of the plane in a millimeter.
fn fit(bounds: &Bounds, scales: &[Scale], room: Room, lines: usize, print: &Print<'_>) -> (Room, f64) {
    let em = print.style.em;
    let above = print.style.row() * lines as f64;
    let height = room.height - above - print.style.row() * scales.len() as f64;
    let plot = Room { top: room.top + above, height, ..room };
    let [width, height] = bounds.size();
    let free = |length: f64| (length - 2.0 * MARGIN * em - BORDER).max(1.0);
    let least = (width / free(plot.width)).max(height / free(plot.height));
    (plot, scaled(least.max((1.0 - SAME) * room.scale), scales))
}

/// The scale of a plane of which a millimeter is at least so many units.
pub(crate) fn scaled(least: f64, scales: &[Scale]) -> f64 {
    let least = if least.is_finite() && least > 0.0 { least } else { 1.0 };
    let is_round = scales.first().is_some_and(|scale| !scale.symbol.is_empty());
    if is_round { round_up(least, &SCALES) } else { least }
}

/// A scale as a bar of a round number of units.
fn bar(own: &Scale, scale: f64, [left, base]: Point, print: &Print<'_>) -> [Element; 2] {
    let (length, words) = told(own, scale, print.language);
    let (right, top) = (left + length / scale, base - END * print.style.em);
    let bar = polyline(
        &[[left, top], [left, base], [right, base], [right, top]],
        Stroke::Solid,
        Ink::Dim,
        &print.style,
    );
    [bar, print.text([right + 0.5 * print.style.em, base], &words, Ink::Dim, Anchor::Start)]
}

/// The length of the bar of a scale, and what it is with the factor: what a millimeter stands for.
pub(crate) fn told(own: &Scale, scale: f64, language: &Language) -> (f64, String) {
    let (bar, length) = own.bar(BAR * scale);
    (bar, joined("   ", std::iter::once(length).chain(own.factor(scale))).typeset(language))
}
