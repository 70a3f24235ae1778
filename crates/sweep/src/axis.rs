//! A parameter, found in the scene: its values as text and in SI.

use std::ops::Range;

use assur_mechanism::{Mechanism, Step};
use assur_number::elementary;
use assur_scene::edit::{ParsedText, TextPlace, decimal, split};
use assur_scene::{Dimension, Reading, SceneNumber, Unit, quantity};
use assur_words::{Describe, Text, joined, name, quantity as quantity_of, text, unit as quantity_unit};
use strum::VariantArray;

use crate::vary::{Range as Ends, between};
use crate::{SweepError, Tie, Vary};

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
    /// The values, where they are listed; `from` and `to` are then the least and the greatest.
    listed: Vec<f64>,
    /// The parameter that this one follows; `None` for one of its own.
    pub(crate) follows: Option<Following>,
    /// The unit of the values; empty for SI.
    name: String,
    /// That unit; `None` for a count.
    unit: Option<Unit>,
    /// What it measures; `None` for a count.
    measures: Option<Dimension>,
    /// The value of the scene, number and unit.
    written: Option<(f64, String)>,
}

/// How a parameter follows another one.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Following {
    /// The number of that parameter.
    pub(crate) leader: usize,
    /// By which its value is multiplied.
    pub(crate) factor: f64,
    /// What is added, in the unit of that parameter.
    pub(crate) added: f64,
    /// The tie behind the key, as it is written.
    pub(crate) text: String,
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
        let values = ends(vary).map_err(fault)?;
        let numbers: Vec<_> = found.iter().filter_map(|place| scene.number(&place.span)).collect();
        let dimension = measured(vary, &found, &numbers, &values).map_err(fault)?;
        let values = in_one_unit(values, dimension).map_err(fault)?;
        let suffix = dimension.map(suffix).filter(|unit| !unit.is_empty());
        let column = suffix.map_or(key.clone(), |unit| format!("{key}_{unit}"));
        let name = values[0].unit.clone();
        let unit = dimension.map(|dimension| Unit::of(&name, dimension)).transpose();
        let unit = unit.map_err(|error| fault(error.describe()))?;
        let count = vary.range.count;
        let numbers_written: Vec<f64> = values.iter().map(|value| value.number).collect();
        let (from, to, listed) = if vary.range.listed.is_empty() {
            (numbers_written[0], numbers_written[numbers_written.len() - 1], Vec::new())
        } else {
            let least = numbers_written.iter().copied().fold(f64::INFINITY, f64::min);
            (least, numbers_written.iter().copied().fold(f64::NEG_INFINITY, f64::max), numbers_written)
        };
        let written = found.first().and_then(|place| split(place.text.as_ref()?));
        Ok(Self {
            key,
            column,
            replaces_words: found
                .iter()
                .any(|place| place.text.as_deref().is_some_and(|text| split(text).is_none())),
            spans: found.into_iter().map(|place| place.span).collect(),
            numbers: numbers.into_iter().cloned().collect(),
            from,
            to,
            count,
            listed,
            follows: None,
            name,
            unit,
            measures: dimension,
            written,
        })
    }

    /// Finds a key that follows one of the parameters; its ends follow from theirs.
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
        let added = parameters[leader].added(tie)?;
        let end = |number: f64| {
            End { number: decimal(number * factor + added), unit: parameters[leader].name.clone() }.text()
        };
        let ends = [parameters[leader].from, parameters[leader].to].map(end);
        let [from, to] = ends;
        let range = Ends { from, to, count: 1, listed: Vec::new() };
        let axis = Self::of(&Vary { key: tie.key.clone(), range }, document, scene)?;
        let kinds = [axis.measures, parameters[leader].measures];
        if let ([Some(own), Some(other)], None) = (kinds, tie.factor)
            && own != other
        {
            let [own, other] = [own, other].map(|kind| kind.describe());
            let key = name(parameters[leader].key.clone());
            return Err(SweepError::vary(axis.key, text!("sweep-tie-other-quantity", own, key, other)));
        }
        let constant = tie.added.as_ref().map(|added| format!("+{added}")).unwrap_or_default();
        let text = format!("{}*{factor}{constant}", parameters[leader].key);
        Ok(Self { follows: Some(Following { leader, factor, added, text }), ..axis })
    }

    /// What a tie adds to a multiple of this parameter, in the unit of its values.
    fn added(&self, tie: &Tie) -> Result<f64, SweepError> {
        let Some(added) = &tie.added else { return Ok(0.0) };
        let si = match self.measures {
            Some(dimension) => quantity(added, dimension).map_err(|error| error.describe()),
            None => added.parse().map_err(|_| text!("sweep-no-number", text = name(added.clone()))),
        };
        let si: f64 = si.map_err(|problem| SweepError::vary(tie.key.to_string(), problem))?;
        Ok(si / self.si(1.0))
    }

    /// A value of a grid by its number.
    pub(crate) fn value(&self, index: usize) -> f64 {
        let listed = self.listed.get(index).copied();
        listed.unwrap_or_else(|| between(self.from, self.to, index, self.count))
    }

    /// The range as it is given: `1 kg..5 kg:9`, `1 kg,2 kg`; of a sample without the count.
    pub(crate) fn range(&self, has_count: bool) -> String {
        if let Some(following) = &self.follows {
            return following.text.clone();
        }
        if !self.listed.is_empty() {
            return self.listed.iter().map(|value| self.shown(*value)).collect::<Vec<_>>().join(",");
        }
        let count = if has_count { format!(":{}", self.count) } else { String::new() };
        format!("{}..{}{count}", self.shown(self.from), self.shown(self.to))
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
            let listed =
                self.listed.iter().map(|number| End { number: *number, unit: written.clone() }.text());
            let ends = [self.from, self.to].map(|number| End { number, unit: written.clone() }.text());
            let values =
                if self.listed.is_empty() { ends.join("..") } else { listed.collect::<Vec<_>>().join(",") };
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
        End { number, unit: self.name.clone() }.text()
    }
}

/// The ends or the listed values; where some have a unit, and all the same, it applies to the others too.
fn ends(vary: &Vary) -> Result<Vec<End>, Text> {
    let end = |end: &str| match split(end) {
        Some((number, unit)) => Ok(End { number, unit }),
        None => Err(text!("sweep-no-number", text = name(end.to_owned()))),
    };
    let mut all = vary.range.written().into_iter().map(end).collect::<Result<Vec<_>, _>>()?;
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
            let wrong = ends.iter().find_map(|end| quantity(&end.text(), *kind).err());
            Err(wrong.map_or_else(|| text!("sweep-different-ends"), |error| error.describe()))
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
