//! How lengths and angles are written in a scene.

use std::f64::consts::PI;

use assur_mechanism::{Key, Mechanism};
use assur_scene::edit::{ParsedText, TextPlace, bare, decimal, split};
use assur_scene::{Dimension, Unit};

/// Parts of a meter to which lengths are rounded that take the place of others: 0.001 mm.
pub(crate) const FINEST: f64 = 1e-6;

/// The step of round lengths, m: 1 mm, of a mechanism smaller than 50 mm 0.1 mm, smaller than 5 mm 0.01 mm, and so on.
pub(crate) fn step_of(size: f64) -> f64 {
    let mut step = 1e-3;
    while size < 50.0 * step && step > FINEST {
        step /= 10.0;
    }
    step
}

/// A number rounded to a multiple of a step.
pub(crate) fn rounded(value: f64, step: f64) -> f64 {
    // The step is the reciprocal of a number without rounding more often than the step itself.
    let per = (1.0 / step).round();
    let value = if per >= 1.0 { (value * per).round() / per } else { (value / step).round() * step };
    // No zero has a sign.
    value + 0.0
}

/// A length (m) in millimeters as TOML: `"80 mm"`.
pub(crate) fn millimeters(length: f64) -> String {
    format!("\"{} mm\"", decimal(length * 1e3) + 0.0)
}

/// An angle (rad) in degrees as TOML, to 0.01 degrees: `"90 deg"`.
pub(crate) fn degrees(angle: f64) -> String {
    format!("\"{} deg\"", decimal(rounded(angle * 180.0 / PI, 0.01)))
}

/// A number of a scene with its unit: "100 mm" is (100, "mm").
type Written = (f64, String);

/// The numbers that are written at a key: one, two coordinates, or none where the key is left out or has something else.
pub(crate) fn written(text: &str, key: &Key) -> Vec<Written> {
    let parsed = ParsedText::of(text);
    let number = |key: &Key| {
        let place = parsed.find(key).ok()?.into_iter().next()?;
        let TextPlace { span, text: quoted } = place;
        split(&bare(quoted.as_deref().or(text.get(span))?).replace('_', ""))
    };
    if let Some(single) = number(key) {
        return vec![single];
    }
    let both: Option<Vec<_>> = [0, 1].map(|axis| number(&key.clone().at(axis))).into_iter().collect();
    both.unwrap_or_default()
}

/// Whether a number, a text or a list stands at a key.
pub(crate) fn stands(text: &str, key: &Key) -> bool {
    let parsed = ParsedText::of(text);
    parsed.find(key).is_ok() || parsed.find(&key.clone().at(0)).is_ok()
}

/// A value (SI) as TOML in the unit of the numbers that it replaces, rounded to six digits and to 0.001 mm (an angle to 0.0001 degrees).
/// Zeros don't tell a unit: it is then mm or degrees.
pub(crate) fn like(old: &[Written], value: f64, dimension: Dimension) -> String {
    let is_angle = dimension == Dimension::Angle;
    let usual = if is_angle { "deg" } else { "mm" };
    let told = old.iter().find(|(number, unit)| *number != 0.0 || !unit.is_empty());
    let unit = told.map_or(usual, |(_, unit)| unit.as_str());
    let scale = Unit::of(unit, dimension).map_or(1.0, |unit| unit.si(1.0));
    let number = if is_angle {
        rounded(value * 180.0 / PI, 1e-4) * (PI / 180.0) / scale
    } else {
        rounded(value, FINEST) / scale
    };
    let digits = if is_angle { 8 } else { 6 };
    let number = significant(number, digits);
    if unit.is_empty() { number.to_string() } else { format!("\"{number} {unit}\"") }
}

/// A number with so many significant digits.
fn significant(number: f64, digits: usize) -> f64 {
    let short = format!("{number:.*e}", digits - 1);
    short.parse().unwrap_or(number) + 0.0
}

/// A place in the frame of a link (m) as TOML in the units of what it replaces: a number where it lies on the x axis and `single` allows
/// it, else both coordinates.
pub(crate) fn place_like(old: &[Written], [x, y]: [f64; 2], single: bool) -> String {
    let (x, y) = (rounded(x, FINEST), rounded(y, FINEST));
    if single && y == 0.0 {
        return if x == 0.0 { "0".to_owned() } else { like(old, x, Dimension::Length) };
    }
    // Each coordinate has its own unit where it has one.
    let of = |axis: usize, value: f64| {
        let own = old.get(axis).filter(|(number, unit)| *number != 0.0 || !unit.is_empty());
        like(own.map_or(old, std::slice::from_ref), value, Dimension::Length)
    };
    format!("[{}, {}]", of(0, x), of(1, y))
}

/// A name as a key of TOML, in quotes where it needs them.
pub(crate) fn key_of(name: &str) -> String {
    let is_bare = |letter: char| letter.is_ascii_alphanumeric() || matches!(letter, '_' | '-');
    if !name.is_empty() && name.chars().all(is_bare) {
        name.to_owned()
    } else {
        assur_scene::edit::quoted(name)
    }
}

/// The key of a point of a link, the ground included.
pub(crate) fn point_key(mechanism: &Mechanism, link: usize, point: &str) -> Key {
    let owner = if link == assur_mechanism::GROUND {
        Key::of("ground")
    } else {
        Key::of("link").at(&mechanism.links[link].name)
    };
    owner.at("points").at(point)
}
