//! A list of rows of two numbers: over angle, time, speed or the stroke of a point.

use assur_mechanism::{Key, Step as KeyStep, TimeLaw};
use assur_scene::edit::{bare, decimal, quoted, split};
use assur_scene::reference::ValueKind;
use assur_scene::{Dimension, quantity};
use assur_words::{Describe, Text};
use toml::de::DeValue;

use crate::change::{Change, value};
use crate::field::Field;
use crate::sort::sort;
use crate::tables::{Tables, key_of, owner, table_at};

/// A spline is drawn with so many points between two rows.
const POINTS: usize = 16;

/// Rows [argument, value] as they stand at a key, and the curve that they make.
#[derive(Debug, Clone)]
pub struct Rows {
    /// Their key: `force[0].value.table`, `force[0].value.forward`.
    pub at: Key,
    /// What the two columns are.
    pub columns: [Column; 2],
    /// A field for each number; empty where there is a single number in place of rows.
    pub rows: Vec<[Field; 2]>,
    /// Points of the curve in SI from the first row to the last: corners, or points of a spline. A number in place of rows is a
    /// horizontal line from 0 to 1. Rows that can't be read are left out.
    pub curve: Vec<[f64; 2]>,
}

/// A column of rows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Column {
    /// The quantity; empty where the scene does not say what the input is.
    pub what: Text,
    /// The SI unit of numbers without one; empty of plain numbers.
    pub unit: &'static str,
}

/// The rows at a key; `None` where rows can't stand there.
pub fn rows(text: &str, at: &Key) -> Option<Rows> {
    let tables = Tables::of(text);
    let at = tables.numbered(at);
    key_of(at.steps()).filter(|key| key.kinds.contains(&ValueKind::Rows))?;
    let kinds = columns(&tables, &at);
    let column = |kind: Option<Dimension>| Column {
        what: kind.map(|kind| kind.describe()).unwrap_or_default(),
        unit: kind.map_or("", Dimension::si),
    };
    let row = |index: usize| {
        [0, 1].map(|place| {
            let kind = ValueKind::Quantity(kinds[place].unwrap_or(Dimension::Number));
            Field::bare(&tables, at.clone().at(index).at(place), vec![kind])
        })
    };
    let rows: Vec<_> = (0..tables.count(&at)).map(row).collect();
    let number = |field: &Field, kind: Option<Dimension>| quantity(&field.shown(), kind?).ok();
    let read = |[x, y]: &[Field; 2]| Some([number(x, kinds[0])?, number(y, kinds[1])?]);
    let mut points: Vec<[f64; 2]> = rows.iter().filter_map(read).collect();
    if let Some(constant) = tables.written(&at).filter(|_| rows.is_empty())
        && let Some(y) = kinds[1].and_then(|kind| quantity(&bare(constant), kind).ok())
    {
        points = vec![[0.0, y], [1.0, y]];
    }
    let shape = tables.word(&owner(&at).at("shape")).unwrap_or_default();
    let curve = curve(points, shape);
    Some(Rows { at, columns: kinds.map(column), rows, curve })
}

/// What the two numbers of a row measure in a table that has a key, as far as the scene says.
pub(crate) fn columns(tables: &Tables<'_>, key: &Key) -> [Option<Dimension>; 2] {
    let (at, coordinate) = (owner(key), tables.coordinate(key));
    let speed = |coordinate| match coordinate {
        Dimension::Angle => Dimension::AngularSpeed,
        _ => Dimension::Speed,
    };
    let known = table_at(at.steps());
    let argument = match known.and_then(|table| sort(tables, &at, table)) {
        Some("stroke") => Some(Dimension::Number),
        Some("angle") => coordinate,
        Some("speed") => coordinate.map(speed),
        Some("time") => Some(Dimension::Time),
        _ => known.filter(|table| table.name() == "over_time").map(|_| Dimension::Time),
    };
    let value = key_of(at.steps()).and_then(|key| key.dimension(coordinate)).or(coordinate);
    [argument, value]
}

fn curve(points: Vec<[f64; 2]>, shape: &str) -> Vec<[f64; 2]> {
    let ascends = points.windows(2).all(|ends| ends[0][0] < ends[1][0]);
    match (shape, points.last()) {
        ("step", Some(&last)) => {
            let held = points.windows(2).flat_map(|ends| [ends[0], [ends[1][0], ends[0][1]]]);
            held.chain([last]).collect()
        }
        ("smooth", Some(&last)) if points.len() > 1 && ascends => {
            let law = TimeLaw::smooth(&points, last[0]);
            let between = |ends: &[[f64; 2]]| {
                let [from, to] = [ends[0][0], ends[1][0]];
                (0..POINTS).map(move |at| from + (to - from) * at as f64 / POINTS as f64).collect::<Vec<_>>()
            };
            let times = points.windows(2).flat_map(between);
            times.map(|time| [time, law.at(time)[0]]).chain([last]).collect()
        }
        _ => points,
    }
}

/// A new row before the one of this number (from 0), or behind the last: halfway between its neighbors, with the value of the row
/// before it. A number in place of rows becomes two rows with it.
pub fn inserted(text: &str, at: &Key, index: usize) -> Change {
    let tables = Tables::of(text);
    let at = tables.numbered(at);
    let kinds = columns(&tables, &at);
    let mut rows = written(&tables, &at);
    if rows.is_empty() {
        let size = tables.written(&at).unwrap_or("0").to_owned();
        rows = ["0", "1"].map(|argument| [argument.to_owned(), size.clone()]).into();
    } else {
        let index = index.min(rows.len());
        let argument = |index: usize| rows.get(index).map(|row| row[0].as_str());
        let before = index.checked_sub(1).and_then(argument);
        let new = match (before, argument(index)) {
            (Some(one), Some(other)) => mixed(one, other, 0.5, kinds[0]),
            // A stroke ends at 0 and 1.
            (Some(end), None) | (None, Some(end)) if kinds[0] == Some(Dimension::Number) => end.to_owned(),
            (Some(end), None) => {
                let earlier = index.checked_sub(2).and_then(argument).unwrap_or("0");
                mixed(earlier, end, 2.0, kinds[0])
            }
            (None, end) => mixed(argument(1).unwrap_or("1"), end.unwrap_or("0"), 2.0, kinds[0]),
        };
        let like = rows[index.saturating_sub(1)][1].clone();
        rows.insert(index, [new, like]);
    }
    value(text, &at, &listed(&rows))
}

/// The rows without one (from 0); without the last one the key is removed.
pub fn deleted(text: &str, at: &Key, index: usize) -> Change {
    let tables = Tables::of(text);
    let at = tables.numbered(at);
    let mut rows = written(&tables, &at);
    if index < rows.len() {
        rows.remove(index);
    }
    value(text, &at, &if rows.is_empty() { String::new() } else { listed(&rows) })
}

/// The rows as they are written.
fn written(tables: &Tables<'_>, at: &Key) -> Vec<[String; 2]> {
    let cell = |index: usize, place: usize| {
        let key = at.clone().at(index).at(KeyStep::Index(place));
        tables.written(&key).unwrap_or("0").to_owned()
    };
    (0..tables.count(at)).map(|index| [0, 1].map(|place| cell(index, place))).collect()
}

fn listed(rows: &[[String; 2]]) -> String {
    format!("[{}]", rows.iter().map(|[x, y]| format!("[{x}, {y}]")).collect::<Vec<_>>().join(", "))
}

/// A number so far from one to another, 1 at the other, in the unit of both.
fn mixed(one: &str, other: &str, part: f64, kind: Option<Dimension>) -> String {
    let read = |number: &str| split(&bare(number)).unwrap_or_default();
    let mix = |one: f64, other: f64| decimal(one + part * (other - one));
    let ((x, unit), (y, second)) = (read(one), read(other));
    let is_same = unit == second || x == 0.0 && unit.is_empty() || y == 0.0 && second.is_empty();
    let unit = if unit.is_empty() { second } else { unit };
    if is_same && !unit.is_empty() {
        return quoted(&format!("{} {unit}", mix(x, y)));
    }
    let si = |number: &str| kind.and_then(|kind| quantity(&bare(number), kind).ok()).unwrap_or_default();
    toml_number(mix(si(one), si(other)))
}

/// A number as TOML.
pub(crate) fn toml_number(number: f64) -> String {
    let plain = number.to_string();
    if DeValue::parse(&plain).is_ok() { plain } else { format!("{number:e}") }
}
