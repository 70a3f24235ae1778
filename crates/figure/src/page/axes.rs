//! A plot on paper, with its axes.

use assur_words::{Language, Text};

use super::element::{Outline, fine, polygon, polyline};
use super::names::text_width;
use super::{BORDER, EM, Element, LINE, Room, drawn, heading, text, width};
use crate::axis::Axis;
use crate::model::{Figure, Frame, Ink, Panel, Point, Stroke};
use crate::trace::{Paper, stars};

/// Height of the numbers and the name of the horizontal axis, mm.
pub(super) const BELOW: f64 = 2.0 * LINE;
/// Free part of the vertical axis above and below the curves.
const FREE: f64 = 0.06;
/// Least distance of the numbers of an axis, mm: horizontal, vertical.
const APART: [f64; 2] = [16.0, 8.0];
/// Least numbers of an axis.
const LEAST_NUMBERS: usize = 3;

pub(super) fn elements(
    panel: &Panel,
    shows_axis: bool,
    numbers: f64,
    room: Room,
    language: &Language,
) -> Vec<Element> {
    let Frame::Axes { x, y, cursor } = &panel.frame else { return Vec::new() };
    let below = if shows_axis { BELOW } else { 0.0 };
    let vertical = widened(y);
    let mut elements = heading(panel, room, language);
    let above = LINE * elements.len().max(1) as f64;
    let free = room.height - above - below - BORDER;
    let ticks = upright_ticks(&vertical, free);
    let (left, top) = (room.left + numbers + 0.5 * EM, room.top + above);
    let width = room.width - numbers - 0.5 * EM - 2.0 * BORDER;
    let plot = Room { left, top, width, height: free };
    let place = |at: Point| {
        [plot.left + x.part(at[0]) * plot.width, plot.top + (1.0 - vertical.part(at[1])) * plot.height]
    };
    let [low, high] = vertical.range;
    let upright = |at: f64| [place([at, low]), place([at, high])];
    for (at, number) in ticks {
        let ends = x.range.map(|end| place([end, at]));
        elements.push(grid(&ends, at == 0.0));
        let corner = [plot.left - 0.4 * EM, ends[0][1] + 0.35 * EM];
        elements.push(text(corner, &number.render(language), Ink::Text, "end"));
    }
    for (at, number) in x.ticks(count(plot.width, APART[0])) {
        let ends = upright(at);
        elements.push(grid(&ends, false));
        if shows_axis {
            let corner = [ends[0][0], plot.top + plot.height + 1.2 * EM];
            elements.push(text(corner, &number.render(language), Ink::Text, "middle"));
        }
    }
    let frame = Outline { ink: Ink::Text, width: width::FINE, filled: None };
    let [left, right] = x.range.map(upright);
    elements.push(polygon(&[left[0], left[1], right[1], right[0]], frame));
    if shows_axis {
        let corner = [plot.left + 0.5 * plot.width, plot.top + plot.height + 2.6 * EM];
        elements.push(text(corner, &x.label.render(language), Ink::Text, "middle"));
    }
    if let Some(at) = cursor.as_ref().map(|cursor| cursor.at).filter(|at| (0.0..=1.0).contains(&x.part(*at)))
    {
        elements.push(polyline(&upright(at), Stroke::Dashed, Ink::Cursor));
    }
    let paper = Paper { place, em: EM, gap: 0.0 };
    let stars = panel.items.iter().flat_map(stars);
    let marks: Vec<_> =
        panel.items.iter().cloned().chain(stars).flat_map(|item| paper.marks(&item)).collect();
    elements.extend(drawn(&marks, plot, language));
    elements
}

/// Width of the widest number of the vertical axes of a figure: one for all, so that plots below each other are aligned.
pub(super) fn numbers(figure: &Figure, height: f64, language: &Language) -> f64 {
    let height = height / figure.rows().max(1) as f64;
    let axes = figure.panels.iter().filter_map(|panel| match &panel.frame {
        Frame::Axes { y, .. } => Some(widened(y)),
        Frame::Plane { .. } => None,
    });
    let ticks = axes.flat_map(|axis| upright_ticks(&axis, height));
    ticks.map(|(_, text)| text_width(&text.render(language))).fold(0.0, f64::max)
}

/// The ticks of a vertical axis of this height, mm; two at least, from which its scale is seen.
fn upright_ticks(axis: &Axis, height: f64) -> Vec<(f64, Text)> {
    let most = count(height, APART[1]);
    let ticks = axis.ticks(most);
    if ticks.len() < 2 { axis.ticks(2 * most) } else { ticks }
}

/// How many numbers an axis has where they stand at this distance.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a page has fewer numbers than that, and a negative room has none"
)]
fn count(length: f64, apart: f64) -> usize {
    ((length / apart) as usize).max(LEAST_NUMBERS)
}

fn widened(axis: &Axis) -> Axis {
    let range = [axis.value(-FREE), axis.value(1.0 + FREE)];
    Axis { range, ..axis.clone() }
}

fn grid(ends: &[Point; 2], strong: bool) -> Element {
    let mut line = fine(ends, if strong { Ink::Text } else { Ink::Dim });
    if !strong {
        line.attributes.push(("stroke-opacity", "0.35".to_owned()));
    }
    line
}
