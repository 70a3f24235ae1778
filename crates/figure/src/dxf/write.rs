//! Groups of a DXF file: a code and a value in two lines.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::arc::Arc;
use crate::bounds::Bounds;
use crate::model::{Ink, Point, Stroke};

/// Height of a capital letter, in text sizes.
const CAPITAL: f64 = 0.72;
/// What stands before the layers: the release, and the kinds of lines with their lengths of dashes and gaps, mm of paper.
const HEAD: &str = "0 SECTION|2 HEADER|9 $ACADVER|1 AC1009";
const TYPES: &str = "0 ENDSEC|0 SECTION|2 TABLES|0 TABLE|2 LTYPE|70 4\
    |0 LTYPE|2 CONTINUOUS|70 64|3 Solid line|72 65|73 0|40 0.0\
    |0 LTYPE|2 DASHED|70 64|3 _ _ _|72 65|73 2|40 2.7|49 1.6|49 -1.1\
    |0 LTYPE|2 DOTTED|70 64|3 . . .|72 65|73 2|40 1.25|49 0.35|49 -0.9\
    |0 LTYPE|2 CHAIN|70 64|3 _ . _|72 65|73 4|40 5.15|49 3.0|49 -0.9|49 0.35|49 -0.9\
    |0 ENDTAB|0 TABLE|2 LAYER";
const ENTITIES: &str = "0 ENDTAB|0 ENDSEC|0 SECTION|2 ENTITIES";
const END: &str = "0 ENDSEC|0 EOF";

/// What an entity stands for.
#[derive(Debug, Clone, Copy)]
pub(super) enum Layer {
    /// As it is drawn elsewhere.
    Ink(Ink),
    /// Headings and scales.
    Titles,
}

impl Layer {
    /// Its name, and the number of its color.
    fn told(self) -> (String, u8) {
        const LINKS: [u8; 6] = [5, 30, 142, 42, 202, 250];
        let (name, color) = match self {
            Self::Titles => ("TITLES", 7),
            Self::Ink(Ink::Text) => ("SIGNS", 7),
            Self::Ink(Ink::Title) => ("NAMES", 7),
            Self::Ink(Ink::Dim) => ("REMARKS", 8),
            Self::Ink(Ink::Ground) => ("GROUND", 7),
            Self::Ink(Ink::Link(number)) => {
                let color = LINKS[number.saturating_sub(1) % LINKS.len()];
                return (format!("LINK_{number}"), color);
            }
            Self::Ink(Ink::Marked) => ("MARKED", 1),
            Self::Ink(Ink::Trace) => ("PATHS", 9),
            Self::Ink(Ink::Velocity) => ("VELOCITIES", 3),
            Self::Ink(Ink::Acceleration) => ("ACCELERATIONS", 6),
            Self::Ink(Ink::First) => ("FIRST", 5),
            Self::Ink(Ink::Second) => ("SECOND", 3),
            Self::Ink(Ink::Third) => ("THIRD", 6),
            Self::Ink(Ink::Cursor) => ("POSITION", 2),
        };
        (name.to_owned(), color)
    }
}

/// A drawing that grows by entities; places are on paper, mm, y downwards.
#[derive(Debug)]
pub(super) struct Drawing {
    entities: String,
    layers: BTreeMap<String, u8>,
    bounds: Bounds,
    /// Factor of the first plane: dashes are as large.
    first: Option<f64>,
    factor: f64,
    shift: Point,
}

impl Default for Drawing {
    fn default() -> Self {
        let (entities, layers) = (String::new(), BTreeMap::new());
        Self { entities, layers, bounds: Bounds::EMPTY, first: None, factor: 1.0, shift: [0.0; 2] }
    }
}

fn group(out: &mut String, code: u8, value: impl std::fmt::Display) {
    let _ = write!(out, "{code:>3}\r\n{value}\r\n");
}

/// Groups with bars between them, each a code and a value.
fn groups(out: &mut String, all: &str) {
    for (code, value) in all.split('|').filter_map(|one| one.split_once(' ')) {
        let _ = write!(out, "{code:>3}\r\n{value}\r\n");
    }
}

/// A coordinate: a millionth of a millionth of a unit is nothing.
fn number(value: f64) -> String {
    let text = format!("{value:.12}");
    let text = text.trim_end_matches('0');
    // A number with a point is no whole number for any reader.
    let text = if text.ends_with('.') { format!("{text}0") } else { text.to_owned() };
    if text == "-0.0" { "0.0".to_owned() } else { text }
}

/// A text in ASCII.
fn ascii(text: &str) -> String {
    let mut out = String::new();
    let mut units = [0; 2];
    for letter in text.chars().filter(|letter| !letter.is_control()) {
        if letter.is_ascii() {
            out.push(letter);
            continue;
        }
        for unit in letter.encode_utf16(&mut units) {
            let _ = write!(out, "\\U+{unit:04X}");
        }
    }
    // Two percent signs begin a sign of their own.
    out.replace("%%", "%%%%%%")
}

impl Drawing {
    /// Begins a plane: units in a millimeter of paper, and where its origin is.
    pub(super) fn place(&mut self, factor: f64, shift: Point) {
        self.first.get_or_insert(factor);
        (self.factor, self.shift) = (factor, shift);
    }

    fn at(&self, [x, y]: Point) -> Point {
        [x * self.factor + self.shift[0], -y * self.factor + self.shift[1]]
    }

    fn group(&mut self, code: u8, value: impl std::fmt::Display) {
        group(&mut self.entities, code, value);
    }

    fn begin(&mut self, kind: &str, layer: Layer) {
        let (name, color) = layer.told();
        self.group(0, kind);
        self.group(8, &name);
        self.layers.insert(name, color);
    }

    fn point(&mut self, code: u8, at: Point) {
        let place = self.at(at);
        self.bounds.add(place);
        for (axis, value) in (0..).zip([place[0], place[1], 0.0]) {
            self.group(code + 10 * axis, number(value));
        }
    }

    fn stroke(&mut self, stroke: Option<Stroke>) {
        let kind = match stroke {
            Some(Stroke::Dashed) => "DASHED",
            Some(Stroke::Dotted) => "DOTTED",
            Some(Stroke::Chain) => "CHAIN",
            _ => return,
        };
        self.group(6, kind);
    }

    /// A line from point to point; a single one is a point.
    pub(super) fn line(&mut self, points: &[Point], layer: Layer, stroke: Option<Stroke>) {
        match points {
            [] => {}
            [alone] => {
                self.begin("POINT", layer);
                self.point(10, *alone);
            }
            [from, to] => {
                self.begin("LINE", layer);
                self.stroke(stroke);
                self.point(10, *from);
                self.point(11, *to);
            }
            many => match Arc::through(many) {
                Some(arc) => self.arc(arc, layer, stroke),
                None => self.polyline(many, layer, stroke, false),
            },
        }
    }

    pub(super) fn outline(&mut self, corners: &[Point], layer: Layer) {
        match corners {
            [_, _, _, ..] => self.polyline(corners, layer, None, true),
            few => self.line(few, layer, None),
        }
    }

    fn polyline(&mut self, points: &[Point], layer: Layer, stroke: Option<Stroke>, is_closed: bool) {
        self.begin("POLYLINE", layer);
        self.stroke(stroke);
        self.group(66, 1);
        for code in [10, 20, 30] {
            self.group(code, "0.0");
        }
        self.group(70, u8::from(is_closed));
        for at in points {
            self.begin("VERTEX", layer);
            self.point(10, *at);
        }
        self.begin("SEQEND", layer);
    }

    pub(super) fn circle(&mut self, at: Point, radius: f64, layer: Layer) {
        self.arc(Arc { center: at, radius, from: 0.0, along: std::f64::consts::TAU }, layer, None);
    }

    /// An arc goes counter-clockwise; on paper, where y grows downwards, that is the other way.
    fn arc(&mut self, arc: Arc, layer: Layer, stroke: Option<Stroke>) {
        self.begin(if arc.is_circle() { "CIRCLE" } else { "ARC" }, layer);
        self.stroke(stroke);
        self.point(10, arc.center);
        self.group(40, number(arc.radius * self.factor));
        if !arc.is_circle() {
            let (from, to) = (-arc.from, -arc.from - arc.along);
            let ends = if arc.along < 0.0 { [from, to] } else { [to, from] };
            for (code, end) in [50, 51].into_iter().zip(ends) {
                self.group(code, number(end.to_degrees().rem_euclid(360.0)));
            }
        }
    }

    /// A text at the beginning of its line, as high as this on paper.
    pub(super) fn text(&mut self, at: Point, height: f64, text: &str, layer: Layer) {
        self.begin("TEXT", layer);
        self.point(10, at);
        self.group(40, number(CAPITAL * height * self.factor));
        self.group(1, ascii(text));
    }

    /// As [`text`](Self::text), with letters of this width as part of that of the font.
    pub(super) fn narrow_text(&mut self, at: Point, height: f64, narrow: f64, text: &str, layer: Layer) {
        self.text(at, height, text, layer);
        if narrow < 1.0 {
            self.group(41, number(narrow));
        }
    }

    /// The file.
    pub(super) fn finish(self) -> String {
        let mut out = String::new();
        groups(&mut out, HEAD);
        groups(&mut out, &format!("9 $LTSCALE|40 {}", number(self.first.unwrap_or(1.0))));
        for (name, [x, y]) in [("$EXTMIN", self.bounds.low), ("$EXTMAX", self.bounds.high)] {
            groups(&mut out, &format!("9 {name}|10 {}|20 {}|30 0.0", number(x), number(y)));
        }
        groups(&mut out, &format!("{TYPES}|70 {}", self.layers.len()));
        for (name, color) in &self.layers {
            groups(&mut out, &format!("0 LAYER|2 {name}|70 64|62 {color}|6 CONTINUOUS"));
        }
        groups(&mut out, ENTITIES);
        out.push_str(&self.entities);
        groups(&mut out, END);
        out
    }
}
