//! Figures in character cells: Braille dots, half blocks, or ASCII strokes.

mod axes;
mod labels;
mod plane;
mod raster;

use assur_words::Language;
use strum::{EnumString, IntoStaticStr, VariantArray, VariantNames};
use unicode_width::UnicodeWidthStr;

use crate::bounds::Zoom;
use crate::model::{Figure, Frame, Ink, Item, Point, Sign, Stroke};
use crate::trace::block;
use labels::{Labels, head};
use raster::Raster;

pub use plane::point_at;
pub use raster::short;

/// The characters for the dots of a drawing, the finest first; its names are those of the configuration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumString, VariantArray, VariantNames)]
#[strum(serialize_all = "kebab-case")]
pub enum Marker {
    /// 2 x 4 dots per cell.
    Braille,
    /// 1 x 2 dots per cell.
    HalfBlock,
    /// One character per cell, chosen by the direction of the stroke.
    Ascii,
}

/// How a figure is drawn in cells.
#[derive(Debug, Clone, Copy)]
pub struct Look {
    /// The characters for dots.
    pub marker: Marker,
    /// Ratio of a cell's height to its width.
    pub ratio: f64,
    /// Zoom and pan of planes.
    pub zoom: Zoom,
    /// The language of the words.
    pub language: &'static Language,
}

/// A text at a cell; columns and rows are counted from the upper left corner.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Spot {
    /// Column of its first character.
    pub column: u16,
    /// Its row.
    pub row: u16,
    /// What is written.
    pub text: String,
    /// What it stands for.
    pub ink: Ink,
}

/// A figure in so many columns and rows: texts to be written in this order. Its title and its legend are left to whoever
/// has room for them.
pub fn draw(figure: &Figure, size: [u16; 2], look: Look) -> Vec<Spot> {
    let mut spots = Vec::new();
    for (index, panel) in figure.panels.iter().enumerate() {
        let [left, top, width, height] = area(figure, index, size);
        let drawn = match &panel.frame {
            Frame::Plane { .. } => plane::draw(panel, [width, height], look),
            Frame::Axes { .. } => axes::draw(panel, figure.shows_axis(index), [width, height], look),
        };
        spots.extend(drawn.into_iter().map(|spot| Spot {
            column: spot.column + left,
            row: spot.row + top,
            ..spot
        }));
    }
    spots
}

/// The value of the horizontal axis under a cell of a figure; `None` where there is no plot.
pub fn value_at(figure: &Figure, size: [u16; 2], [column, row]: [u16; 2]) -> Option<f64> {
    figure.panels.iter().enumerate().find_map(|(index, panel)| {
        let [left, top, width, height] = area(figure, index, size);
        let inside = (top..top + height).contains(&row) && column >= left;
        axes::value_at(panel, width, column.checked_sub(left)?).filter(|_| inside)
    })
}

/// Left, top, width and height of a panel. The rows of panels are equally high apart from the rows of their axes.
fn area(figure: &Figure, index: usize, [width, height]: [u16; 2]) -> [u16; 4] {
    let columns = short(figure.columns.max(1));
    let rows = short(figure.rows().max(1));
    let (row, column) = (short(index) / columns, short(index) % columns);
    let left = |column: u16| width / columns * column + (width % columns).min(column);
    let below = |row: u16| if figure.has_axis_below(row.into()) { axes::BELOW } else { 0 };
    let room = height.saturating_sub((0..rows).map(below).sum());
    let top = |row: u16| room / rows * row + (room % rows).min(row) + (0..row).map(below).sum::<u16>();
    [left(column), top(row), left(column + 1) - left(column), top(row + 1).min(height) - top(row).min(height)]
}

/// Draws marks, whose coordinates are widths of a cell; names and signs that may be left out come last.
fn draw_marks(marks: &[Item], size: [u16; 2], look: Look) -> (Raster, Labels) {
    let (mut raster, mut labels) = (Raster::new(size, look.marker), Labels::new(size));
    let cell = |at: [f64; 2]| [at[0], at[1] / look.ratio];
    let cells = |points: &[Point]| points.iter().map(|at| cell(*at)).collect::<Vec<_>>();
    let closed = |corners: &[Point]| cells(&[corners, &corners[..1.min(corners.len())]].concat());
    for mark in marks {
        match mark {
            Item::Line { points, stroke, ink } => raster.polyline(&cells(points), *stroke, *ink),
            Item::Area { outline, ink } => raster.polyline(&closed(outline), Stroke::Thick, *ink),
            Item::Sign { at, along, sign: Sign::Block, ink } if look.marker != Marker::Ascii => {
                raster.polyline(&closed(&block(*at, *along, look.ratio)), Stroke::Solid, *ink);
            }
            Item::Sign { at, sign: Sign::Bearing, ink, .. } => bearing(&mut raster, cell(*at), look, *ink),
            _ => {}
        }
    }
    for mark in marks {
        if let Item::Sign { at, along, sign, ink } = mark {
            put_sign(&mut labels, cell(*at), *along, *sign, *ink);
        }
    }
    for mark in marks {
        if let Item::Name { at, text, ink, needed } = mark {
            let told = text.render(look.language);
            labels.beside(&raster, cell(*at), &told, *ink, *needed);
        }
    }
    for mark in marks {
        match mark {
            Item::Sign { at, along, sign: Sign::Hatch, ink } => {
                let away = 0.75 * look.ratio;
                let at = cell([at[0] + away * along[0], at[1] + away * along[1]]);
                labels.faint(&raster, at, HATCH, *ink);
            }
            Item::Sign { at, sign: Sign::Bearing, ink, .. } => {
                let [x, y] = cell(*at);
                for column in -2..=2 {
                    labels.faint(&raster, [x + f64::from(column), y.floor() + 1.5], HATCH, *ink);
                }
            }
            _ => {}
        }
    }
    (raster, labels)
}

const HATCH: &str = "╱";

fn bearing(raster: &mut Raster, [x, y]: [f64; 2], look: Look, ink: Ink) {
    if look.marker != Marker::Ascii {
        for side in [-1.5, 1.5] {
            raster.polyline(&[[x, y], [x + side, y.floor() + 1.0]], Stroke::Solid, ink);
        }
    }
}

fn put_sign(labels: &mut Labels, at: [f64; 2], along: [f64; 2], sign: Sign, ink: Ink) {
    let text = match sign {
        Sign::Pin | Sign::Bearing | Sign::Ring => "o",
        Sign::Head if along.iter().any(|part| part.abs() > 0.0) => head(along),
        Sign::Node => return labels.fill(at, "•", ink),
        Sign::Dot | Sign::Head => return labels.fill(at, "o", ink),
        Sign::Cross => "x",
        Sign::Plus => "+",
        Sign::Star => "*",
        Sign::Block | Sign::Hatch => return,
    };
    labels.put(at, text, ink);
}

/// The beginning of a text; an ellipsis shows that the rest is missing. A value is left out with its unit rather than cut.
pub fn cut(text: &str, width: usize) -> String {
    if text.width() <= width {
        return text.to_owned();
    }
    let beginnings = text.char_indices().map(|(end, _)| &text[..end]);
    let Some(kept) = beginnings.take_while(|kept| kept.width() < width).last() else { return String::new() };
    let is_cut = !text[kept.len()..].starts_with(' ');
    let mut words: Vec<&str> = kept.split(' ').collect();
    let begun = words.pop_if(|_| is_cut).filter(|word| !is_value(word));
    if !words.last().is_some_and(|word| is_value(word)) {
        words.extend(begun);
    }
    while words.pop_if(|word| is_value(word) || !word.contains(char::is_alphanumeric)).is_some() {}
    format!("{}…", words.join(" ").trim_end_matches(|letter: char| !letter.is_alphabetic() && letter != ')'))
}

/// Whether a word is a number, with or without a sign.
fn is_value(word: &str) -> bool {
    word.trim_start_matches(['+', '-', '−', '>', '~', '('])
        .starts_with(|letter: char| letter.is_ascii_digit())
}

/// Most rows of a heading, and the fewest that it leaves to the drawing below it.
const HEADING: u16 = 3;
const DRAWING: u16 = 3;

/// The heading of a panel in rows of at most this many columns, broken where two spaces part what it names, or else between words;
/// of `rows` rows it leaves enough to the drawing.
fn heading(title: &str, value: &str, width: u16, rows: u16) -> Vec<String> {
    let most = usize::from(rows.saturating_sub(DRAWING).clamp(1, HEADING));
    let width = usize::from(width);
    let mut lines: Vec<String> = Vec::new();
    for part in title.split("  ") {
        let whole = part.width() <= width;
        for (index, piece) in part.split(if whole { "  " } else { " " }).enumerate() {
            let gap = if index == 0 { "  " } else { " " };
            match lines.last_mut().filter(|line| line.width() + gap.len() + piece.width() <= width) {
                Some(line) => {
                    line.push_str(gap);
                    line.push_str(piece);
                }
                None => lines.push(piece.to_owned()),
            }
        }
    }
    // The value stands behind all names and is never cut.
    let room = width.saturating_sub(value.width() + 2 * usize::from(!value.is_empty()));
    if lines.len() < most && lines.last().is_some_and(|line| line.width() > room) {
        lines.push(String::new());
    }
    let rest = lines.split_off(lines.len().min(most)).join("  ");
    if let Some(last) = lines.last_mut() {
        let names = shortened(format!("{last}  {rest}").trim(), room);
        format!("{names}  {value}").trim().clone_into(last);
    }
    lines.iter().map(|line| cut(line, width)).collect()
}

/// A heading in so many columns: its longest names are shortened, the first one last, so that each is still seen, with its unit.
fn shortened(heading: &str, width: usize) -> String {
    /// Fewest columns of a shortened name; no unit has more.
    const FEWEST: usize = 8;
    let (first, others) = heading.split_at(heading.find("  ").unwrap_or(heading.len()));
    let all = first.split_inclusive([',', ':']).chain(others.split_inclusive("  "));
    let mut all: Vec<String> = all.map(str::to_owned).collect();
    loop {
        let excess = all.iter().map(|name| name.width()).sum::<usize>().saturating_sub(width);
        let is_long = |name: &String| excess > 0 && name.trim_end().width() > FEWEST;
        let longest = (0..all.len()).rev().filter(|at| is_long(&all[*at]));
        let longest = longest.max_by_key(|at| (*at > 0, all[*at].width()));
        let Some(longest) = longest else { return cut(&all.concat(), width) };
        let name = &mut all[longest];
        let end = name.trim_end_matches([' ', ',', ':']).len();
        let end = name.split_off(end);
        let kept: String =
            name.chars().take(name.width().saturating_sub(excess + 1).max(FEWEST - 3)).collect();
        *name = format!("{}…{end}", kept.trim_end_matches(|letter: char| !letter.is_alphabetic()));
    }
}

fn headed(lines: Vec<String>, column: u16) -> impl Iterator<Item = Spot> {
    (0..).zip(lines).map(move |(row, text)| Spot { column, row, text, ink: Ink::Title })
}
