//! What a parameter measures, and the units of columns.

use assur_scene::Dimension;
use assur_scene::edit::split;

/// Every kind of quantity of a scene, with the unit as a column writes it.
const ALL: [(Dimension, &str); 15] = [
    (Dimension::Number, ""),
    (Dimension::Length, "m"),
    (Dimension::Angle, "rad"),
    (Dimension::Mass, "kg"),
    (Dimension::Time, "s"),
    (Dimension::Force, "N"),
    (Dimension::Moment, "Nm"),
    (Dimension::Speed, "m_per_s"),
    (Dimension::AngularSpeed, "rad_per_s"),
    (Dimension::Acceleration, "m_per_s2"),
    (Dimension::AngularAcceleration, "rad_per_s2"),
    (Dimension::Inertia, "kgm2"),
    (Dimension::Stiffness, "N_per_m"),
    (Dimension::Damping, "Ns_per_m"),
    (Dimension::Power, "W"),
];

/// The unit as the end of a column's name; empty for a plain number.
pub(crate) fn suffix(dimension: Dimension) -> &'static str {
    ALL.iter().find(|row| row.0 == dimension).map_or("", |row| row.1)
}

/// The possible values of a key, as determined by the reader of scenes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Takes {
    /// Quantities of these kinds, one or more.
    Quantity(Vec<Dimension>),
    /// Bare numbers only: a count.
    Bare,
    /// Any text: a name.
    Text,
    /// No number.
    Nothing,
}

/// The possible values of a key: quantities of each kind are tried on the reader of scenes, so there is no second list
/// of the kinds of its keys. `accepts` says whether the scene can be read with this text as the value; `texts` are
/// quantities whose numbers are tried: the value of the scene, which is within every bound, and the ends of the range.
pub(crate) fn takes(texts: &[&str], accepts: impl Fn(&str) -> bool) -> Takes {
    let takes = |dimension: Dimension| texts.iter().any(|text| accepts(&as_quantity(text, dimension)));
    let found: Vec<_> = ALL.iter().map(|row| row.0).filter(|dimension| takes(*dimension)).collect();
    if found.len() == ALL.len() {
        Takes::Text
    } else if !found.is_empty() {
        Takes::Quantity(found)
    } else if texts.iter().filter_map(|text| split(text)).any(|(number, _)| accepts(&number.to_string())) {
        Takes::Bare
    } else {
        Takes::Nothing
    }
}

/// The text itself if it is such a quantity, otherwise its number with the SI unit; as TOML.
fn as_quantity(text: &str, dimension: Dimension) -> String {
    let (number, unit) = split(text).unwrap_or((1.0, String::new()));
    let as_is = !unit.is_empty() && assur_scene::quantity(text, dimension).is_ok();
    toml(number, if as_is { &unit } else { dimension.si() }, true)
}

/// A number with a unit as TOML.
pub(crate) fn toml(number: f64, unit: &str, quoted: bool) -> String {
    match (quoted, unit.is_empty()) {
        (false, _) => number.to_string(),
        (true, true) => format!("\"{number}\""),
        (true, false) => format!("\"{number} {unit}\""),
    }
}
