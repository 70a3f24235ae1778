//! A parameter, found in the scene: its values as text and in SI.

use std::ops::Range;

use assur_scene::edit::{ParsedText, TextPlace, decimal, replaced, split};
use assur_scene::{Dimension, Unit, quantity};
use assur_words::{Describe, Text, joined, name, quantity as quantity_of, text, unit as quantity_unit};
use strum::VariantArray;

use crate::vary::Range as Ends;
use crate::{SweepError, Tie, Vary};

/// A parameter that was found in the scene.
#[derive(Debug, Clone)]
pub(crate) struct Axis {
    /// Its key.
    pub(crate) key: String,
    /// Name of its column.
    pub(crate) column: String,
    /// Bytes of the file that are replaced, in one place or several.
    pub(crate) spans: Vec<Range<usize>>,
    /// First value.
    pub(crate) from: f64,
    /// Last value.
    pub(crate) to: f64,
    /// How many values a grid has.
    pub(crate) count: usize,
    /// The parameter that this one follows, by its number, and the factor; `None` for one of its own.
    pub(crate) follows: Option<(usize, f64)>,
    /// The unit of the values; empty for SI.
    name: String,
    /// That unit; `None` for a count.
    unit: Option<Unit>,
    /// What it measures; `None` for a count.
    measures: Option<Dimension>,
    /// The value of the scene, number and unit.
    written: Option<(f64, String)>,
}

/// One end of a range.
#[derive(Debug, Clone, PartialEq)]
struct End {
    number: f64,
    unit: String,
}

impl Axis {
    /// Finds the parameter in the scene, and what it measures.
    pub(crate) fn of(
        vary: &Vary,
        document: &ParsedText<'_>,
        file: &str,
        scene: &str,
    ) -> Result<Self, SweepError> {
        let key = vary.key();
        let fault = |problem: Text| SweepError::vary(&key, problem);
        let found = document.find(&vary.key).map_err(fault)?;
        let (from, to) = ends(vary).map_err(fault)?;
        let dimension = dimension(vary, &found, [&from, &to], file, scene).map_err(fault)?;
        let (from, to) = in_one_unit(from, to, dimension).map_err(fault)?;
        let suffix = dimension.map(suffix).filter(|unit| !unit.is_empty());
        let column = suffix.map_or(key.clone(), |unit| format!("{key}_{unit}"));
        let unit = dimension.map(|dimension| Unit::of(&from.unit, dimension)).transpose();
        let unit = unit.map_err(|error| fault(error.describe()))?;
        let count = vary.range.count;
        let written = found.first().and_then(|place| split(place.text.as_ref()?));
        Ok(Self {
            key,
            column,
            spans: found.into_iter().map(|place| place.span).collect(),
            from: from.number,
            to: to.number,
            count,
            follows: None,
            name: from.unit,
            unit,
            measures: dimension,
            written,
        })
    }

    /// Finds a key that follows one of the parameters; its ends are theirs, times the factor.
    pub(crate) fn tied(
        tie: &Tie,
        parameters: &[Self],
        document: &ParsedText<'_>,
        file: &str,
        scene: &str,
    ) -> Result<Self, SweepError> {
        let follows = tie.follows.to_string();
        let leader = parameters.iter().position(|axis| axis.key == follows);
        let leader = leader.ok_or_else(|| {
            SweepError::vary(tie.key.to_string(), text!("sweep-tie-not-varied", key = name(follows)))
        })?;
        let factor = tie.factor.unwrap_or(1.0);
        let end = |number: f64| {
            End { number: decimal(number * factor), unit: parameters[leader].name.clone() }.text()
        };
        let range = Ends { from: end(parameters[leader].from), to: end(parameters[leader].to), count: 1 };
        let axis = Self::of(&Vary { key: tie.key.clone(), range }, document, file, scene)?;
        let kinds = [axis.measures, parameters[leader].measures];
        if let ([Some(own), Some(other)], None) = (kinds, tie.factor)
            && own != other
        {
            let [own, other] = [own, other].map(|kind| kind.describe());
            let key = name(parameters[leader].key.clone());
            return Err(SweepError::vary(
                axis.key,
                text!("sweep-tie-other-quantity", own = own, key = key, other = other),
            ));
        }
        Ok(Self { follows: Some((leader, factor)), ..axis })
    }

    /// Whether both set a number of the scene.
    pub(crate) fn shares(&self, other: &Self) -> bool {
        self.spans.iter().any(|span| other.spans.contains(span))
    }

    /// A value in SI.
    pub(crate) fn si(&self, number: f64) -> f64 {
        self.unit.map_or(number, |unit| unit.si(number))
    }

    /// A value as it is written into the scene.
    pub(crate) fn toml(&self, number: f64) -> String {
        toml(number, &self.name, !self.name.is_empty())
    }

    /// What is said of ends without a unit that are SI, where in the unit of the scene they would be nearer to the value of the scene.
    pub(crate) fn doubt(&self) -> Option<Text> {
        let (own, written) =
            self.written.as_ref().filter(|_| self.name.is_empty() && self.follows.is_none())?;
        let (measures, end) = (self.measures?, self.from.abs().max(self.to.abs()));
        let unit = Unit::of(written, measures).ok().filter(|_| !written.is_empty())?;
        let away = |value: f64| (value / unit.si(*own)).abs().ln().abs();
        (away(unit.si(end)) < away(end)).then(|| {
            let ends = [self.from, self.to].map(|number| End { number, unit: written.clone() }.text());
            text!(
                "sweep-other-unit",
                unit = quantity_unit(measures.si().replace('*', "·")),
                own = quantity_of(*own, written.clone()),
                instead = name(format!("{}={}", self.key, ends.join("..")))
            )
        })
    }

    /// A value for messages with its key, SI where it is written without a unit: `link.crank.mass = 2 kg`.
    pub(crate) fn told(&self, number: f64) -> Text {
        let si = self.measures.filter(|_| self.name.is_empty()).map(Dimension::si).unwrap_or_default();
        let value =
            if si.is_empty() { name(self.shown(number)) } else { quantity_of(number, si.replace('*', "·")) };
        joined(" = ", [name(self.key.clone()), value])
    }

    /// A value as its range has it: `120 mm`.
    pub(crate) fn shown(&self, number: f64) -> String {
        End { number, unit: self.name.clone() }.text()
    }
}

/// Both ends; if only one has a unit, it applies to both.
fn ends(vary: &Vary) -> Result<(End, End), Text> {
    let end = |end: &str| match split(end) {
        Some((number, unit)) => Ok(End { number, unit }),
        None => Err(text!("sweep-no-number", text = name(end.to_owned()))),
    };
    let (mut from, mut to) = (end(&vary.range.from)?, end(&vary.range.to)?);
    if from.unit.is_empty() {
        from.unit.clone_from(&to.unit);
    } else if to.unit.is_empty() {
        to.unit.clone_from(&from.unit);
    }
    Ok((from, to))
}

impl End {
    fn text(&self) -> String {
        let space = if self.unit.is_empty() { "" } else { " " };
        format!("{}{space}{}", self.number, self.unit)
    }
}

/// What the parameter measures; `None` for a count.
fn dimension(
    vary: &Vary,
    found: &[TextPlace],
    ends: [&End; 2],
    file: &str,
    scene: &str,
) -> Result<Option<Dimension>, Text> {
    let written = |place: &TextPlace| scene.get(place.span.clone()).map(|text| text.replace('_', ""));
    let own = found.first().and_then(|place| place.text.clone().or_else(|| written(place)));
    let own = own.filter(|text| split(text).is_some());
    let texts = ends.map(End::text);
    let texts: Vec<&str> = own.iter().chain(&texts).map(String::as_str).collect();
    let with = |value: &str| replaced(scene, found.iter().map(|place| (&place.span, value)));
    match takes(&texts, |value| assur_scene::read(file, &with(value)).is_ok()) {
        Takes::Quantity(kinds) => chosen(&kinds, ends).map(Some),
        Takes::Bare if ends.iter().all(|end| end.unit.is_empty()) => Ok(None),
        Takes::Bare => Err(text!("sweep-count", key = name(vary.key()))),
        Takes::Text => Err(text!("sweep-text", key = name(vary.key()))),
        Takes::Nothing => {
            Err(match assur_scene::read(file, &with(&toml(ends[0].number, &ends[0].unit, true))) {
                Err(errors) if !errors.errors.is_empty() => errors.errors[0].message.clone(),
                _ => text!("sweep-takes-no-number", key = name(vary.key())),
            })
        }
    }
}

/// The kind of quantity of the ends, among those that the scene accepts there.
fn chosen(kinds: &[Dimension], ends: [&End; 2]) -> Result<Dimension, Text> {
    let fits = |kind: Dimension, end: &End| end.unit.is_empty() || quantity(&end.text(), kind).is_ok();
    let fitting: Vec<_> = kinds.iter().filter(|kind| ends.iter().all(|end| fits(**kind, end))).collect();
    match (fitting.as_slice(), kinds) {
        ([kind], _) => Ok(**kind),
        ([], [kind, ..]) => {
            let wrong = ends.iter().find_map(|end| quantity(&end.text(), *kind).err());
            Err(wrong.map_or_else(|| text!("sweep-different-ends"), |error| error.describe()))
        }
        _ => Err(text!("sweep-several-quantities")),
    }
}

/// The ends in the unit of both, so that decimal steps stay decimal; in SI if they have different units.
fn in_one_unit(from: End, to: End, dimension: Option<Dimension>) -> Result<(End, End), Text> {
    let si = |end: &End| match dimension.filter(|_| !end.unit.is_empty()) {
        Some(dimension) => quantity(&end.text(), dimension).map_err(|error| error.describe()),
        None => Ok(end.number),
    };
    let numbers = (si(&from)?, si(&to)?);
    match dimension {
        Some(dimension) if from.unit != to.unit => {
            let end = |number| End { number, unit: dimension.si().to_owned() };
            Ok((end(numbers.0), end(numbers.1)))
        }
        _ => Ok((from, to)),
    }
}

/// The unit as the end of a column's name, `kgm2`, `m_per_s`; empty for a plain number.
pub(crate) fn suffix(dimension: Dimension) -> String {
    dimension.si().replace('/', "_per_").replace(['*', '^'], "")
}

/// Every kind of quantity with the end of the names of its columns, the longest first.
pub fn suffixes() -> Vec<(Dimension, String)> {
    let mut all: Vec<_> = Dimension::VARIANTS.iter().map(|kind| (*kind, suffix(*kind))).collect();
    all.retain(|(_, suffix)| !suffix.is_empty());
    all.sort_by_key(|(_, suffix)| std::cmp::Reverse(suffix.len()));
    all
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
    let found: Vec<_> = Dimension::VARIANTS.iter().copied().filter(|dimension| takes(*dimension)).collect();
    if found.len() == Dimension::VARIANTS.len() {
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
