//! A parameter, found in the scene: its values as text and in SI.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use assur_mechanism::{Mechanism, Step};
use assur_number::elementary;
use assur_scene::edit::{ParsedText, TextPlace, quoted, split};
use assur_scene::{Dimension, Reading, SceneNumber, Unit, UnitError, quantity};
use assur_words::{Describe, Text, joined, name, quantity as quantity_of, text, unit as quantity_unit};

use crate::column::suffix;
use crate::following::Following;
use crate::vary::{Written, between};
use crate::{SweepError, Vary};

/// Most listed values that a message repeats; of more it has the least and the greatest.
const MOST_SHOWN: usize = 12;

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
    pub(crate) values: Values,
    /// The unit of the values; empty for SI.
    pub(crate) name: String,
    /// That unit; `None` for a count and for texts.
    unit: Option<Unit>,
    /// What it measures; `None` for a count and for texts.
    pub(crate) measures: Option<Dimension>,
    /// The value of the scene, number and unit.
    written: Option<(f64, String)>,
}

/// The values of a parameter.
#[derive(Debug, Clone)]
pub(crate) enum Values {
    /// So many, equally spaced.
    Spaced(usize),
    /// These; the first and the last value of the parameter are then the least and the greatest.
    Listed(Vec<f64>),
    /// Texts, each once, of which the values of the parameter are indices; and the values in their order.
    Words(Arc<[String]>, Vec<usize>),
    /// Those of another parameter.
    Follow(Following),
}

/// A value of a range.
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
        let numbers: Vec<_> = found.iter().filter_map(|place| scene.number(&place.span)).collect();
        if takes_words(vary, &found, &numbers) {
            return Ok(Self::of_words(key, &vary.values, found));
        }
        let values = ends(&vary.values).map_err(fault)?;
        let dimension = measured(vary, &found, &numbers, &values).map_err(fault)?;
        let values = in_one_unit(values, dimension).map_err(fault)?;
        let suffix = dimension.map(suffix).filter(|unit| !unit.is_empty());
        let column = suffix.map_or(key.clone(), |unit| format!("{key}_{unit}"));
        let name = values[0].unit.clone();
        let unit = dimension.map(|dimension| Unit::of(&name, dimension)).transpose();
        let unit = unit.map_err(|error| fault(error.describe()))?;
        let all: Vec<f64> = values.iter().map(|value| value.number).collect();
        let extremes = [
            all.iter().copied().fold(f64::INFINITY, f64::min),
            all.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        ];
        let ([from, to], values) = match &vary.values {
            Written::Range { count, .. } => ([all[0], all[all.len() - 1]], Values::Spaced(*count)),
            Written::Listed(_) | Written::Column(..) => (extremes, Values::Listed(all)),
        };
        let is_word = |place: &TextPlace| place.text.as_deref().is_some_and(|text| split(text).is_none());
        Ok(Self {
            key,
            column,
            replaces_words: found.iter().any(is_word),
            written: found.first().and_then(|place| split(place.text.as_ref()?)),
            spans: found.into_iter().map(|place| place.span).collect(),
            numbers: numbers.into_iter().cloned().collect(),
            from,
            to,
            values,
            name,
            unit,
            measures: dimension,
        })
    }

    /// A parameter whose values are texts.
    fn of_words(key: String, written: &Written, found: Vec<TextPlace>) -> Self {
        let mut words: Vec<String> = Vec::new();
        let mut numbered = BTreeMap::new();
        let number = |word| {
            *numbered.entry(word).or_insert_with(|| {
                words.push(str::to_owned(word));
                words.len() - 1
            })
        };
        let order: Vec<usize> = written.texts().into_iter().map(number).collect();
        Self {
            column: key.clone(),
            key,
            replaces_words: true,
            written: None,
            spans: found.into_iter().map(|place| place.span).collect(),
            numbers: Vec::new(),
            from: 0.0,
            to: words.len().saturating_sub(1) as f64,
            values: Values::Words(words.into(), order),
            name: String::new(),
            unit: None,
            measures: None,
        }
    }

    /// The parameter as one that follows another.
    pub(crate) fn following(self, following: Following) -> Self {
        Self { values: Values::Follow(following), ..self }
    }

    /// The parameter that this one follows, and how; `None` for one of its own.
    pub(crate) fn follows(&self) -> Option<&Following> {
        if let Values::Follow(following) = &self.values { Some(following) } else { None }
    }

    /// The texts that are its values; `None` of numbers.
    pub(crate) fn words(&self) -> Option<&Arc<[String]>> {
        if let Values::Words(words, _) = &self.values { Some(words) } else { None }
    }

    /// The text of a value.
    fn word(&self, number: f64) -> Option<&str> {
        self.words().and_then(|words| word(words, number))
    }

    /// How many values a grid has.
    pub(crate) fn count(&self) -> usize {
        match &self.values {
            Values::Spaced(count) => *count,
            Values::Listed(values) => values.len(),
            Values::Words(_, order) => order.len(),
            Values::Follow(_) => 1,
        }
    }

    /// Values between which the others lie; of texts all of them.
    pub(crate) fn compared(&self) -> Vec<f64> {
        let all = |words: &Arc<[String]>| (0..words.len()).map(|index| index as f64).collect();
        self.words().map_or_else(|| vec![self.from, self.to], all)
    }

    /// A value of a grid by its number.
    pub(crate) fn value(&self, index: usize) -> f64 {
        match &self.values {
            Values::Listed(values) => values.get(index).copied().unwrap_or(self.to),
            Values::Words(_, order) => order.get(index).map_or(self.to, |index| *index as f64),
            Values::Spaced(_) | Values::Follow(_) => between(self.from, self.to, index, self.count()),
        }
    }

    /// The range as it is given: `1 kg..5 kg:9`, `1 kg,2 kg`; of a sample without the count.
    pub(crate) fn range(&self, has_count: bool) -> String {
        match &self.values {
            Values::Follow(following) => following.text.clone(),
            Values::Listed(_) | Values::Words(..) => {
                let each = (0..self.count()).map(|index| self.shown(self.value(index)));
                each.collect::<Vec<_>>().join(",")
            }
            Values::Spaced(count) => {
                let count = if has_count { format!(":{count}") } else { String::new() };
                format!("{}..{}{count}", self.shown(self.from), self.shown(self.to))
            }
        }
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
        let is_free = |number: &SceneNumber| number.is_free() && ends.iter().all(|end| number.admits(*end));
        self.words().is_none() && self.numbers.iter().all(is_free)
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
        match self.word(number) {
            Some(word) => quoted(word),
            None if self.name.is_empty() => number.to_string(),
            None => format!("\"{number} {}\"", self.name),
        }
    }

    /// What is said of ends without a unit that are SI, where in the unit of the scene they would be nearer to the value of the scene.
    pub(crate) fn warning(&self) -> Option<Text> {
        let (own, written) =
            self.written.as_ref().filter(|_| self.name.is_empty() && self.follows().is_none())?;
        let (measures, end) = (self.measures?, self.from.abs().max(self.to.abs()));
        let unit = Unit::of(written, measures).ok().filter(|_| !written.is_empty())?;
        let away = |value: f64| elementary::ln((value / unit.si(*own)).abs()).abs();
        (away(unit.si(end)) < away(end)).then(|| {
            let shown = |number: &f64| End { number: *number, unit: written.clone() }.text();
            let values = match &self.values {
                Values::Listed(values) if values.len() <= MOST_SHOWN => {
                    values.iter().map(shown).collect::<Vec<_>>().join(",")
                }
                _ => [self.from, self.to].map(|end| shown(&end)).join(".."),
            };
            text!(
                "sweep-other-unit",
                unit = quantity_unit(measures.si().replace('*', "·")),
                own = quantity_of(*own, written.clone()),
                instead = name(format!("{}={values}", self.key))
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
        let text = || End { number, unit: self.name.clone() }.text();
        self.word(number).map_or_else(text, str::to_owned)
    }
}

/// The text with a number that is its index.
pub(crate) fn word(words: &[String], number: f64) -> Option<&str> {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "an index; what is none has no text"
    )]
    words.get(number as usize).map(String::as_str)
}

/// Whether the values are texts: the key takes no number, or has a text, and none is given.
fn takes_words(vary: &Vary, found: &[TextPlace], numbers: &[&SceneNumber]) -> bool {
    vary.values.is_list()
        && found.iter().all(|place| place.text.is_some())
        && (numbers.is_empty() || vary.values.texts().into_iter().all(|text| split(text).is_none()))
}

/// The ends or the listed values; where some have a unit, and all the same, it applies to the others too. A cell of a table has
/// a unit of its own or none.
fn ends(written: &Written) -> Result<Vec<End>, Text> {
    let end = |(index, end): (usize, &str)| match split(end) {
        Some((number, unit)) => Ok(End { number, unit }),
        None => Err(written.located(index, text!("sweep-no-number", text = name(end.to_owned())))),
    };
    let mut all = written.texts().into_iter().enumerate().map(end).collect::<Result<Vec<_>, _>>()?;
    if matches!(written, Written::Column(..)) {
        return Ok(all);
    }
    let mut units: Vec<String> =
        all.iter().map(|end| end.unit.clone()).filter(|unit| !unit.is_empty()).collect();
    units.dedup();
    if let [unit] = &units[..] {
        all.iter_mut().filter(|end| end.unit.is_empty()).for_each(|end| end.unit.clone_from(unit));
    }
    Ok(all)
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
    ends: &[End],
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
        ([], []) if ends.iter().all(is_bare) => Ok(None),
        ([], []) => Err(text!("sweep-count", key = &vary.key)),
        ([], [kind, ..]) => {
            let fault = |(index, end): (usize, &End)| Some((index, quantity(&end.text(), *kind).err()?));
            let wrong = ends.iter().enumerate().filter(|(_, end)| !is_bare(end)).find_map(fault);
            let told = |(index, error): (usize, UnitError)| vary.values.located(index, error.describe());
            Err(wrong.map_or_else(|| text!("sweep-different-ends"), told))
        }
        _ => Err(text!("sweep-several-quantities")),
    }
}

/// The values in the unit of all, so that decimal steps stay decimal; in SI if they have different units.
fn in_one_unit(mut values: Vec<End>, dimension: Option<Dimension>) -> Result<Vec<End>, Text> {
    let Some(dimension) = dimension.filter(|_| values.iter().any(|value| value.unit != values[0].unit))
    else {
        return Ok(values);
    };
    for value in values.iter_mut().filter(|value| !value.unit.is_empty()) {
        value.number = quantity(&value.text(), dimension).map_err(|error| error.describe())?;
    }
    for value in &mut values {
        dimension.si().clone_into(&mut value.unit);
    }
    Ok(values)
}
