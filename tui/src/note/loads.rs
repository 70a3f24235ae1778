//! The loads as they are given: where they act and the laws of their values.

use assur_mechanism::{Direction, Mechanism, Over, Place, Table, Value};

use crate::number::trimmed;
use crate::words::Words;

/// Of a longer table the first rows are shown.
const MOST_ROWS: usize = 12;

/// Digits of given numbers.
const DIGITS: usize = 6;

/// A given number.
pub(super) fn number(words: &Words, value: f64) -> String {
    words.number(&trimmed(value, DIGITS))
}

/// A row for each load: its name, where and how it acts, its value.
pub(super) fn rows(words: &Words, mechanism: &Mechanism) -> Vec<Vec<String>> {
    let link = |link: usize| ("link", words.name(&mechanism.links[link].name));
    let mut rows = Vec::new();
    let mut add = |name: &str, what: String, value: String| rows.push(vec![words.name(name), what, value]);
    if let Some([x, y]) = mechanism.gravity {
        let size = format!("g = {} {}", number(words, x.hypot(y)), words.unit("m/s2"));
        add("G", words.get("gravity"), size);
    }
    for force in &mechanism.forces {
        let what = format!("{}, {}", at(words, mechanism, force.at), direction(words, force.direction));
        add(&force.name, what, law(words, mechanism, &force.value, "N"));
    }
    for moment in &mechanism.moments {
        let (id, unit) = if moment.brake.is_some() { ("brake-on", "N") } else { ("moment-on", "N m") };
        let mut what = words.with(id, &[link(moment.link)]);
        if let Some(brake) = &moment.brake {
            let values =
                [("radius", number(words, 1e3 * brake.radius)), ("friction", number(words, brake.friction))];
            what = format!("{what}, {}", words.with("brake-data", &values));
        }
        add(&moment.name, what, law(words, mechanism, &moment.value, unit));
    }
    for spring in &mechanism.springs {
        let [one, other] = spring.ends.map(|end| words.name(&mechanism.links[end.link].name));
        let values = [
            ("stiffness", number(words, spring.stiffness)),
            ("length", number(words, 1e3 * spring.length)),
            ("damping", number(words, spring.damping)),
        ];
        let what = words.with("spring-between", &[("one", one), ("other", other)]);
        add(&spring.name, what, words.with("spring-data", &values));
    }
    for contact in &mechanism.contacts {
        let values = [link(contact.center.link), ("radius", number(words, 1e3 * contact.radius))];
        add(&contact.name, words.with("contact-of", &values), law(words, mechanism, &contact.force, "N"));
    }
    rows
}

fn at(words: &Words, mechanism: &Mechanism, place: Place) -> String {
    let [x, y] = place.at.map(|value| number(words, 1e3 * value));
    words.with("force-at", &[("x", x), ("y", y), ("link", words.name(&mechanism.links[place.link].name))])
}

fn direction(words: &Words, direction: Direction) -> String {
    let degrees = |angle: f64| [("angle", number(words, angle.to_degrees()))];
    match direction {
        Direction::Ground(angle) => words.with("along-ground", &degrees(angle)),
        Direction::Link(angle) => words.with("along-link", &degrees(angle)),
        Direction::AgainstMotion => words.get("against-motion"),
    }
}

/// A value or the law by which it varies, in words.
fn law(words: &Words, mechanism: &Mechanism, value: &Value, unit: &str) -> String {
    let unit = words.unit(unit);
    match value {
        Value::Constant(value) => format!("{} {unit}", number(words, *value)),
        Value::Table { over, table, .. } => {
            let (id, factor) = match over {
                Over::Coordinate if mechanism.input.is_angle() => {
                    ("over-angle", 180.0 / std::f64::consts::PI)
                }
                Over::Coordinate => ("over-displacement", 1e3),
                Over::Time => ("over-time", 1.0),
                Over::Speed => ("over-speed", 1.0),
            };
            words.with(id, &[("rows", list(words, table, factor)), ("unit", unit)])
        }
        Value::Stroke { axis, forward, back } => {
            let values = [
                ("axis", number(words, axis.to_degrees())),
                ("forward", list(words, forward, 1.0)),
                ("back", list(words, back, 1.0)),
                ("unit", unit),
            ];
            words.with("over-stroke", &values)
        }
        Value::Formula { formula, .. } => {
            words.with("by-formula", &[("formula", formula.text().to_owned()), ("unit", unit)])
        }
    }
}

/// The rows of a table: argument, value; a constant is its value alone.
fn list(words: &Words, table: &Table, factor: f64) -> String {
    if let [[_, value]] = table.rows[..] {
        return number(words, value);
    }
    let row = |[x, y]: &[f64; 2]| format!("({}; {})", number(words, factor * x), number(words, *y));
    let shown: Vec<String> = table.rows.iter().take(MOST_ROWS).map(row).collect();
    let more = if table.rows.len() > MOST_ROWS { ", …" } else { "" };
    shown.join(", ") + more
}
