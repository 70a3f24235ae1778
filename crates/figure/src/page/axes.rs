//! A plot on paper, with its axes.

use assur_words::Text;

use super::element::{polygon, polyline};
use super::{Anchor, BORDER, Element, Form, Print, Room, drawn, heading};
use crate::axis::Axis;
use crate::model::{Figure, Frame, Ink, Panel, Point, Stroke};
use crate::trace::{Paper, stars};

/// Height of the numbers and the name of the horizontal axis, in lines of text.
pub(super) const BELOW: f64 = 2.0;
/// Free part of the vertical axis above and below the curves.
const FREE: f64 = 0.06;
/// Least distance of the numbers of an axis, mm: horizontal, vertical.
const APART: [f64; 2] = [16.0, 8.0];
/// Space between the heading and the factor of the vertical axis, in text sizes.
const BESIDE: f64 = 1.5;
/// Least numbers of an axis.
const LEAST_NUMBERS: usize = 3;

pub(super) fn elements(
    panel: &Panel,
    shows_axis: bool,
    numbers: f64,
    room: Room,
    print: &Print<'_>,
) -> Vec<Element> {
    let Frame::Axes { x, y, cursor } = &panel.frame else { return Vec::new() };
    let below = if shows_axis { BELOW * print.style.row() } else { 0.0 };
    let vertical = widened(y);
    let (em, fine_width) = (print.style.em, print.style.fine);
    let told = if print.style.axes_to_scale { factor_room(y, print) } else { 0.0 };
    let mut elements = heading(panel, Room { width: room.width - told, ..room }, print);
    let above = print.style.row() * elements.len().max(1) as f64;
    let free = room.height - above - below - BORDER;
    let (left, top) = (room.left + numbers + 0.5 * em, room.top + above);
    let width = room.width - numbers - 0.5 * em - 2.0 * BORDER;
    let mut below_told = None;
    let (width, vertical) = if print.style.axes_to_scale {
        let factors = [x.units_in_mm(width), vertical.units_in_mm(free)];
        let fitted = to_scale(x, vertical, [width, free], factors);
        // At the end of the plot, unless the heading needs its place.
        let heading = elements.iter().filter_map(Element::bounds).map(|own| own[2]).fold(left, f64::max);
        let end = (left + fitted.0).max(heading + told).min(room.left + room.width - BORDER);
        let corner = [end, room.top + above - 0.5 * em];
        let upright = factor_told(&fitted.1, factors[1], print);
        elements.extend(upright.map(|told| print.text(corner, &told, Ink::Text, Anchor::End)));
        below_told = factor_told(x, factors[0], print);
        fitted
    } else {
        (width, vertical)
    };
    let ticks = upright_ticks(&vertical, free);
    let plot = Room { left, top, width, height: free, scale: 0.0 };
    let place = |at: Point| {
        [plot.left + x.part(at[0]) * plot.width, plot.top + (1.0 - vertical.part(at[1])) * plot.height]
    };
    let [low, high] = vertical.range;
    let upright = |at: f64| [place([at, low]), place([at, high])];
    for (at, number) in ticks {
        let ends = x.range.map(|end| place([end, at]));
        elements.push(grid(&ends, at == 0.0, fine_width));
        let corner = [plot.left - 0.4 * em, ends[0][1] + 0.35 * em];
        elements.push(print.text(corner, &number.typeset(print.language), Ink::Text, Anchor::End));
    }
    for (at, number) in x.ticks(count(plot.width, APART[0])) {
        let ends = upright(at);
        elements.push(grid(&ends, false, fine_width));
        if shows_axis {
            let corner = [ends[0][0], plot.top + plot.height + 1.2 * em];
            elements.push(print.text(corner, &number.typeset(print.language), Ink::Text, Anchor::Middle));
        }
    }
    let [left, right] = x.range.map(upright);
    elements.push(polygon(&[left[0], left[1], right[1], right[0]], fine_width, None, Ink::Text));
    if shows_axis {
        let corner = [plot.left + 0.5 * plot.width, plot.top + plot.height + 2.6 * em];
        let label = x.label.typeset(print.language);
        let label = below_told.map_or(label.clone(), |told| format!("{label}   {told}"));
        elements.push(print.text(corner, &label, Ink::Text, Anchor::Middle));
    }
    if let Some(at) = cursor.as_ref().map(|cursor| cursor.at).filter(|at| (0.0..=1.0).contains(&x.part(*at)))
    {
        elements.push(polyline(&upright(at), Stroke::Dashed, Ink::Cursor, &print.style));
    }
    let paper = Paper { place, em, gap: 0.0 };
    let stars = panel.items.iter().flat_map(stars);
    let marks: Vec<_> =
        panel.items.iter().cloned().chain(stars).flat_map(|item| paper.marks(&item)).collect();
    elements.extend(drawn(&marks, plot, print));
    elements
}

/// Width of the widest number of the vertical axes of a figure: one for all, so that plots below each other are aligned.
pub(super) fn numbers(figure: &Figure, height: f64, print: &Print<'_>) -> f64 {
    let height = height / figure.rows().max(1) as f64;
    let axes = figure.panels.iter().filter_map(|panel| match &panel.frame {
        Frame::Axes { y, .. } => Some(widened(y)),
        Frame::Plane { .. } => None,
    });
    let ticks = axes.flat_map(|axis| upright_ticks(&axis, height));
    ticks.map(|(_, text)| print.width(&text.typeset(print.language))).fold(0.0, f64::max)
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

/// A plot whose scales are round: narrower, and with a longer range of the vertical axis, than fits.
fn to_scale(x: &Axis, vertical: Axis, [width, height]: [f64; 2], factors: [Option<f64>; 2]) -> (f64, Axis) {
    let width = factors[0].map_or(width, |factor| (x.range[1] - x.range[0]) / factor);
    let Some(factor) = factors[1] else { return (width, vertical) };
    let [low, high] = vertical.range;
    let more = 0.5 * (factor * height - (high - low));
    (width, Axis { range: [low - more, high + more], ..vertical })
}

/// The factor of an axis in words.
fn factor_told(axis: &Axis, factor: Option<f64>, print: &Print<'_>) -> Option<String> {
    Some(axis.scale.as_ref()?.factor(factor?)?.typeset(print.language))
}

/// The room of a factor of an axis, mm, with the space before it: of a long one; none where it has none.
pub(super) fn factor_room(axis: &Axis, print: &Print<'_>) -> f64 {
    const LONG: f64 = 2.5e-2;
    let told = axis.scale.as_ref().and_then(|scale| scale.factor(LONG / scale.size));
    told.map_or(0.0, |told| print.width(&told.typeset(print.language)) + BESIDE * print.style.em)
}

fn widened(axis: &Axis) -> Axis {
    let range = [axis.value(-FREE), axis.value(1.0 + FREE)];
    Axis { range, ..axis.clone() }
}

fn grid(ends: &[Point; 2], strong: bool, width: f64) -> Element {
    let mut line = Element::line(*ends, width, if strong { Ink::Text } else { Ink::Dim });
    if let Form::Line { opacity, .. } = &mut line.form {
        *opacity = (!strong).then_some(0.35);
    }
    line
}
