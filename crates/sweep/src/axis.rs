//! A parameter, found in the scene: its values as text and in SI.

use std::ops::Range;

use assur_mechanism::{Mechanism, Step};
use assur_number::elementary;
use assur_scene::edit::{ParsedText, TextPlace, decimal, split};
use assur_scene::{Dimension, Reading, SceneNumber, Unit, quantity};
use assur_words::{Describe, Text, joined, name, quantity as quantity_of, text, unit as quantity_unit};
use strum::VariantArray;

use crate::{SweepError, Tie, Vary, vary::Range as Ends};

/// A parameter that was found in the scene.
#[derive(Debug, Clone)]
pub(crate) struct Axis {
    pub(crate) key: String,
    pub(crate) column: String,
    /// Bytes of the file that are replaced, in one place or several.
    pub(crate) spans: Vec<Range<usize>>,
    /// The numbers that stand there.
    numbers: Vec<SceneNumber>,
    /// Whether a number takes the place of a word or a name.
    pub(crate) replaces_words: bool,
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
    pub(crate) fn of(vary: &Vary, document: &ParsedText<'_>, scene: &Reading) -> Result<Self, SweepError> {
        let key = vary.key.to_string();
        let fault = |problem: Text| SweepError::vary(&key, problem);
        let found = document.find(&vary.key).map_err(fault)?;
        let (from, to) = ends(vary).map_err(fault)?;
        let numbers: Vec<_> = found.iter().filter_map(|place| scene.number(&place.span)).collect();
        let dimension = measured(vary, &found, &numbers, [&from, &to]).map_err(fault)?;
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
            replaces_words: found
                .iter()
                .any(|place| place.text.as_deref().is_some_and(|text| split(text).is_none())),
            spans: found.into_iter().map(|place| place.span).collect(),
            numbers: numbers.into_iter().cloned().collect(),
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
        scene: &Reading,
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
        let axis = Self::of(&Vary { key: tie.key.clone(), range }, document, scene)?;
        let kinds = [axis.measures, parameters[leader].measures];
        if let ([Some(own), Some(other)], None) = (kinds, tie.factor)
            && own != other
        {
            let [own, other] = [own, other].map(|kind| kind.describe());
            let key = name(parameters[leader].key.clone());
            return Err(SweepError::vary(axis.key, text!("sweep-tie-other-quantity", own, key, other)));
        }
        Ok(Self { follows: Some((leader, factor)), ..axis })
    }

    /// Whether both set a number of the scene.
    pub(crate) fn shares(&self, other: &Self) -> bool {
        self.spans.iter().any(|span| other.spans.contains(span))
    }

    /// Whether this is the scale of a load, and the other one a number of what it scales.
    pub(crate) fn scales(&self, other: &Self) -> bool {
        let scaled = self.numbers.iter().filter_map(|number| match number.key.steps() {
            [load @ .., Step::Name(last)] if last == "scale" => Some(load),
            _ => None,
        });
        let is_law = |step: &Step| matches!(step, Step::Name(name) if name == "value" || name == "force");
        scaled.into_iter().any(|load| {
            let mut steps = other.numbers.iter().map(|number| number.key.steps());
            steps.any(|steps| steps.strip_prefix(load).and_then(<[_]>::first).is_some_and(is_law))
        })
    }

    /// Whether the mechanism with any value of the range is made by setting numbers.
    pub(crate) fn is_free(&self) -> bool {
        let ends = [self.from, self.to].map(|end| self.si(end));
        self.numbers.iter().all(|number| number.is_free() && ends.iter().all(|end| number.admits(*end)))
    }

    /// Sets a value, SI, in a mechanism of the scene.
    pub(crate) fn set(&self, mechanism: &mut Mechanism, value: f64) {
        for number in &self.numbers {
            number.set(mechanism, value);
        }
    }

    /// A value in SI.
    pub(crate) fn si(&self, number: f64) -> f64 {
        self.unit.map_or(number, |unit| unit.si(number))
    }

    /// A value as it is written into the scene.
    pub(crate) fn toml(&self, number: f64) -> String {
        if self.name.is_empty() { number.to_string() } else { format!("\"{number} {}\"", self.name) }
    }

    /// What is said of ends without a unit that are SI, where in the unit of the scene they would be nearer to the value of the scene.
    pub(crate) fn warning(&self) -> Option<Text> {
        let (own, written) =
            self.written.as_ref().filter(|_| self.name.is_empty() && self.follows.is_none())?;
        let (measures, end) = (self.measures?, self.from.abs().max(self.to.abs()));
        let unit = Unit::of(written, measures).ok().filter(|_| !written.is_empty())?;
        let away = |value: f64| elementary::ln((value / unit.si(*own)).abs()).abs();
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

/// What a parameter measures at every place that was found, as its ends tell where there is a choice; `None` for a count.
fn measured(
    vary: &Vary,
    found: &[TextPlace],
    numbers: &[&SceneNumber],
    ends: [&End; 2],
) -> Result<Option<Dimension>, Text> {
    let Some((first, others)) = numbers.split_first().filter(|_| numbers.len() == found.len()) else {
        let is_text = found.iter().any(|place| place.text.is_some());
        return Err(text!(if is_text { "sweep-text" } else { "sweep-takes-no-number" }, key = &vary.key));
    };
    let shared = |kind: &Dimension| others.iter().all(|other| other.kinds.contains(kind));
    let kinds: Vec<Dimension> = first.kinds.iter().copied().filter(shared).collect();
    let is_bare = |end: &End| end.unit.is_empty();
    let fits =
        |kind: &&Dimension| ends.iter().all(|end| is_bare(end) || quantity(&end.text(), **kind).is_ok());
    match (kinds.iter().filter(fits).collect::<Vec<_>>().as_slice(), kinds.as_slice()) {
        ([kind], _) => Ok(Some(**kind)),
        ([], []) if !numbers.iter().all(|number| number.is_count()) => {
            Err(text!("sweep-takes-no-number", key = &vary.key))
        }
        ([], []) if ends.into_iter().all(is_bare) => Ok(None),
        ([], []) => Err(text!("sweep-count", key = &vary.key)),
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
