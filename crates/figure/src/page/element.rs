//! Elements of a page: name, attributes and text, as SVG has them.

use std::fmt::Write;

use super::{EM, width};
use crate::model::{Ink, Point, Stroke};

#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Element {
    pub(crate) name: &'static str,
    /// Attributes by name; places are in millimeters.
    pub(crate) attributes: Vec<(&'static str, String)>,
    pub(crate) text: String,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Outline {
    pub(super) ink: Ink,
    /// Width of its line, mm.
    pub(super) width: f64,
    /// How much of its ink fills it: 0 paper, 1 all; `None`: what is below is seen.
    pub(super) filled: Option<f64>,
}

/// Colors of the links, which differ for most color-blind readers (after Okabe and Ito).
const LINKS: [&str; 6] = ["#0072b2", "#d55e00", "#56799a", "#b8860b", "#7b3294", "#4d4d4d"];

pub(crate) fn color(ink: Ink) -> &'static str {
    match ink {
        Ink::Text | Ink::Title | Ink::Ground => "#000000",
        Ink::Dim => "#707070",
        Ink::Link(number) => LINKS[number.saturating_sub(1) % LINKS.len()],
        Ink::Marked => "#e60000",
        Ink::Trace => "#8c8c8c",
        Ink::Velocity | Ink::Second => "#009e73",
        Ink::Acceleration | Ink::Third => "#c2417c",
        Ink::First => "#0072b2",
        Ink::Cursor => "#e69f00",
    }
}

/// A number of millimeters with two decimals: finer than any printer.
pub(super) fn mm(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn points(all: &[Point]) -> String {
    let mut list = String::new();
    for at in all.iter().filter(|at| at[0].is_finite() && at[1].is_finite()) {
        let space = if list.is_empty() { "" } else { " " };
        let _ = write!(list, "{space}{},{}", mm(at[0]), mm(at[1]));
    }
    list
}

fn element(name: &'static str, attributes: Vec<(&'static str, String)>) -> Element {
    Element { name, attributes, text: String::new() }
}

pub(super) fn polyline(all: &[Point], stroke: Stroke, ink: Ink) -> Element {
    let (width, dashes) = match stroke {
        Stroke::Thick => (width::THICK, ""),
        Stroke::Solid => (width::LINE, ""),
        Stroke::Dashed => (width::LINE, "1.6 1.1"),
        Stroke::Dotted => (width::LINE, "0.35 0.9"),
        Stroke::Chain => (width::LINE, "3 0.9 0.35 0.9"),
        Stroke::Stars => (width::FINE, ""),
    };
    let mut line = vec![
        ("points", points(all)),
        ("fill", "none".to_owned()),
        ("stroke", color(ink).to_owned()),
        ("stroke-width", mm(width)),
    ];
    if !dashes.is_empty() {
        line.push(("stroke-dasharray", dashes.to_owned()));
    }
    element("polyline", line)
}

pub(super) fn fine(all: &[Point], ink: Ink) -> Element {
    polyline(all, Stroke::Stars, ink)
}

pub(super) fn polygon(all: &[Point], outline: Outline) -> Element {
    let mut attributes = vec![("points", points(all))];
    attributes.extend(outline.attributes());
    element("polygon", attributes)
}

pub(super) fn circle(at: Point, radius: f64, outline: Outline) -> Element {
    let mut attributes = vec![("cx", mm(at[0])), ("cy", mm(at[1])), ("r", mm(radius))];
    attributes.extend(outline.attributes());
    element("circle", attributes)
}

impl Outline {
    fn attributes(self) -> Vec<(&'static str, String)> {
        let mut attributes = vec![("stroke", color(self.ink).to_owned()), ("stroke-width", mm(self.width))];
        attributes.push(match self.filled {
            None => ("fill", "none".to_owned()),
            Some(0.0) => ("fill", "#ffffff".to_owned()),
            Some(_) => ("fill", color(self.ink).to_owned()),
        });
        if let Some(part) = self.filled.filter(|part| *part > 0.0 && *part < 1.0) {
            attributes.push(("fill-opacity", mm(part)));
        }
        attributes
    }
}

/// A text at the start, the middle or the end of its baseline.
pub(super) fn text(at: Point, words: &str, ink: Ink, anchor: &str) -> Element {
    let attributes = vec![
        ("x", mm(at[0])),
        ("y", mm(at[1])),
        ("font-size", mm(EM)),
        ("fill", color(ink).to_owned()),
        ("text-anchor", anchor.to_owned()),
    ];
    Element { name: "text", attributes, text: words.to_owned() }
}
