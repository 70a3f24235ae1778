//! `value` of a load: a number, a table over angle, time, speed or stroke, or a formula.

use std::ops::Range;

use assur_formula::{Formula, FormulaError};
use assur_mechanism::{LawTable, LoadId, Over, Shape, Value};

use assur_words::{Describe, Text, joined, name, number, text, unit};

use crate::known::Known;
use crate::over_time::{Timing, others};
use crate::reference::{Bound, table};
use crate::text::{brief, in_quotes, rounded, shown, such_as};
use crate::units::{Dimension, quantity, within};
use crate::walk::{Entry, Section, quoted};
use crate::{context::Context, error::Fault};

/// The sort of a table, and what it is over; `None`: the stroke of a point.
type Argument = (&'static str, Option<Over>);
const ARGUMENTS: [(&str, Argument); 5] = [
    ("angle", ("angle", Some(Over::Coordinate))),
    ("coordinate", ("angle", Some(Over::Coordinate))),
    ("time", ("time", Some(Over::Time))),
    ("speed", ("speed", Some(Over::Speed))),
    ("stroke", ("stroke", None)),
];
const SHAPES: &[(&str, Shape)] = &[("linear", Shape::Linear), ("step", Shape::Step)];

/// The table of the reference with the keys of a law.
const LAW: &str = "value = { ... }";

/// More rows than any measurement needs.
const MOST_ROWS: usize = 100_000;

/// Reads a value of this dimension; `stroke`: whether the load has a point whose stroke a table can use.
pub(crate) fn read(
    entry: &Entry<'_>,
    dimension: Dimension,
    stroke: bool,
    context: &Context<'_>,
) -> Option<Value> {
    if !entry.value.is_table() {
        return if refused_formula(entry) { None } else { entry.quantity(dimension).map(Value::Constant) };
    }
    if entry.named(text!("scene-a-table"), Text::default()).iter().any(|key| key.name == "formula") {
        return formula(&of_sort(entry, "scene-a-formula", "formula")?, dimension, stroke, context);
    }
    let (sort, over) = argument(entry)?;
    let what = match over {
        Some(Over::Coordinate) => "scene-table-over-angle",
        Some(_) => "scene-table-over-time-or-speed",
        None => "scene-table-over-stroke",
    };
    let section = of_sort(entry, what, sort)?;
    // A single input with a law still has a coordinate and a speed.
    if over != Some(Over::Time) && context.timing == Timing::List {
        let key = section.get("over")?;
        let of = quoted(&format!("over = \"{}\"", key.value.as_str().unwrap_or(sort)));
        if context.timing.refuse_coordinate((key.faults, &key.span), of, text!("scene-over-time-instead")) {
            return None;
        }
    }
    let shape = section.get("shape").and_then(|shape| shape.choice(SHAPES)).unwrap_or(Shape::Linear);
    if let Some(over) = over {
        return plain(&section, over, shape, dimension, context);
    }
    if let Some(over) = section.get("over").filter(|_| !stroke) {
        over.fault(text!("scene-stroke-of-a-force"), text!("scene-other-arguments"));
    }
    strokes(&section, shape, dimension)
}

/// A law of one sort; `what`: the identity of its kind with an article.
fn of_sort<'a>(entry: &Entry<'a>, what: &'static str, sort: &'static str) -> Option<Section<'a>> {
    entry.section_as(text!(what), Known::Table(table(LAW), Some(sort)))
}

/// Refuses a formula that stands where a number with a unit is read: says where it belongs.
fn refused_formula(entry: &Entry<'_>) -> bool {
    let Some(text) = entry.value.as_str() else { return false };
    let is_formula = text.trim().parse::<f64>().is_err() && Formula::read(text).is_ok();
    if is_formula {
        let wanted = text!("scene-formula-as-number", text = in_quotes(text));
        entry.problem(wanted, such_as(format!("{{ formula = \"{text}\" }}")));
    }
    is_formula
}

/// Reads the size of a load under a key of its section, times the load's `scale`; `id`: of the load.
pub(crate) fn sized(
    section: &Section<'_>,
    key: &str,
    dimension: Dimension,
    stroke: bool,
    context: &Context<'_>,
    id: LoadId,
) -> Option<Value> {
    let law = section.need(key).and_then(|entry| read(&entry, dimension, stroke, context))?;
    let Some(scale) = section.get("scale") else { return Some(law) };
    let value = law.clone().scaled(section.number("scale")?);
    tell_scale(&scale, law, dimension, id);
    if let Some(size) = value.sizes().find(|size| within(*size, "", dimension).is_err()) {
        let message = text!("scene-scale-out-of-range", size = brief(size));
        scale.fault(message, text!("scene-right-unit-and-factor"));
        return None;
    }
    Some(value)
}

/// Tells how the scale of a law is set, and how far the sizes of the law stay within their limits.
fn tell_scale(scale: &Entry<'_>, law: Value, dimension: Dimension, id: LoadId) {
    let most = dimension.most() / law.sizes().map(f64::abs).fold(0.0, f64::max);
    scale.is_within(0.0, -most..=most);
    scale.faults.tell(|told| {
        told.whole(&scale.span, move |scene, number| {
            let found = scene.loads[id].kind.law_mut();
            found.map(|found| *found = law.clone().scaled(number)).is_some()
        });
    });
}

/// The argument of the table; if `over` is missing, the keys are checked against those of all tables.
fn argument(entry: &Entry<'_>) -> Option<Argument> {
    let mut over =
        entry.named(text!("scene-a-table"), Text::default()).into_iter().filter(|key| key.name == "over");
    if let Some(over) = over.next() {
        return over.choice(&ARGUMENTS);
    }
    let section = entry.section(table(LAW))?;
    section.missing("over", text!("scene-all-arguments"));
    None
}

fn formula(
    section: &Section<'_>,
    dimension: Dimension,
    stroke: bool,
    context: &Context<'_>,
) -> Option<Value> {
    let (entry, formula, factor) = formula_with_unit(section, dimension)?;
    let mut others = others(formula.used());
    if context.timing == Timing::Law {
        others.retain(|letter| letter == 'x');
    }
    let what = text!("scene-formula-of", variables = name(others.clone()));
    let at = (entry.faults, &entry.span);
    if !others.is_empty() && context.timing.refuse_coordinate(at, what, text!("scene-over-time-instead")) {
        return None;
    }
    // In a scene the speed is counted along the direction of the input, in a mechanism along the coordinate.
    let formula = if context.sign() < 0.0 { formula.mirrored() } else { formula };
    let used = formula.used();
    if used.speed || used.time {
        context.need_motion(&entry, text!("scene-formula-of-motion"));
    }
    let axis = section.get("axis");
    match (&axis, used.place) {
        (Some(axis), false) => {
            axis.fault(text!("scene-axis-without-x"), text!("scene-leave-it-out"));
        }
        (None, true) if stroke => section.missing("axis", text!("scene-x-along-axis")),
        (_, true) if !stroke => {
            entry.fault(text!("scene-x-of-a-force"), text!("scene-use-other-variables"));
        }
        _ => {}
    }
    let axis = if axis.is_some() { Some(section.number("axis")?) } else { None };
    Some(Value::Formula { formula, factor, axis })
}

/// The key `formula`, what it says, and the SI value of a result of 1 by the key `unit`.
pub(crate) fn formula_with_unit<'a>(
    section: &Section<'a>,
    dimension: Dimension,
) -> Option<(Entry<'a>, Formula, f64)> {
    let entry = section.get("formula")?;
    let text = entry.text(text!("scene-a-formula"))?;
    let factor = match section.get("unit") {
        None => 1.0,
        Some(entry) => {
            let name = entry.text(text!("scene-a-unit"))?;
            quantity(&format!("1 {name}"), dimension)
                .map_err(|error| {
                    entry.problem(error.describe(), such_as(format!("\"{}\"", dimension.si())));
                })
                .ok()?
        }
    };
    let misread = |error: FormulaError| {
        entry.note(Fault::new(within_text(&entry, text, &error.span), error.describe()));
    };
    let formula = Formula::read(text).map_err(misread).ok()?;
    if let Some(function) = formula.takes_degrees() {
        entry
            .faults
            .mistake(entry.span.clone(), text!("scene-degrees-in-formula", function = shown(function)));
    }
    Some((entry, formula, factor))
}

/// The place in the file of a part of a text, where the text stands there as it is; else of the whole text.
pub(crate) fn within_text(entry: &Entry<'_>, text: &str, part: &Range<usize>) -> Range<usize> {
    let quotes = entry.span.len().saturating_sub(text.len());
    let start = entry.span.start + quotes / 2;
    if matches!(quotes, 2 | 6) { start + part.start..start + part.end } else { entry.span.clone() }
}

fn plain(
    section: &Section<'_>,
    over: Over,
    shape: Shape,
    dimension: Dimension,
    context: &Context<'_>,
) -> Option<Value> {
    let argument = match over {
        Over::Coordinate => context.coordinate(),
        Over::Time => Some(Dimension::Time),
        Over::Speed => context.speed(),
    };
    if over != Over::Coordinate {
        context.need_motion(&section.get("over")?, text!("scene-table-over-time-or-speed"));
    }
    let flag = section.get("repeat");
    let given = flag.as_ref().and_then(Entry::flag);
    if let Some(entry) = flag.filter(|_| given == Some(true) && context.has_no_cycle()) {
        entry.fault(text!("scene-repeat-without-cycle"), text!("scene-give-a-cycle"));
    }
    let repeat = over == Over::Coordinate && given.unwrap_or(!context.has_no_cycle());
    let entry = section.need("table")?;
    let mut table = LawTable { rows: rows(&entry, argument, dimension)?, shape };
    if over == Over::Speed && !context.timing.is_time() && context.sign() < 0.0 {
        table = table.mirrored();
    }
    if repeat {
        check_span(&entry, &table, context);
        if given.is_none() {
            doubt_end(&entry, &table, (dimension, context));
        }
    }
    Some(Value::Table { over, table, repeat })
}

/// Notes a table of lines that ends inside the cycle with another value than it begins with: the last one holds from there, and the
/// value jumps where the cycle begins anew. Two last rows with one argument are a jump that is meant.
fn doubt_end(entry: &Entry<'_>, table: &LawTable, (dimension, context): (Dimension, &Context<'_>)) {
    let (Some(cycle), [first, .., last], [.., before, _]) =
        (context.input.and_then(assur_mechanism::Input::period), &table.rows[..], &table.rows[..])
    else {
        return;
    };
    let is_jump = (last[1] - first[1]).abs() > 0.0 && last[0] > before[0];
    let ends = last[0] - first[0] < cycle * (1.0 - 1e-9);
    let value = entry.list(Text::default()).pop().and_then(|row| row.pair(&Text::default()));
    if let (true, true, Shape::Linear, Some([at, _])) = (ends, is_jump, table.shape, value) {
        let (symbol, scale) = match context.coordinate() {
            Some(Dimension::Angle) => ("deg", 180.0 / std::f64::consts::PI),
            _ => ("m", 1.0),
        };
        let shown = |value: f64, symbol| joined(" ", [rounded(value), unit(symbol)]);
        let text = text!(
            "scene-table-ends",
            last = shown(last[0] * scale, symbol),
            end = shown((first[0] + cycle) * scale, symbol),
            held = shown(last[1], dimension.si()),
            first = shown(first[1], dimension.si())
        );
        entry.faults.mistake(at.span, text);
    }
}

/// Rows of a repeating table beyond the cycle would never be reached.
fn check_span(entry: &Entry<'_>, table: &LawTable, context: &Context<'_>) {
    let (Some(first), Some(last)) = (table.rows.first(), table.rows.last()) else {
        return;
    };
    let Some(cycle) = context.input.and_then(assur_mechanism::Input::period) else {
        return;
    };
    let span = last[0] - first[0];
    // The limit allows for the rounding of angles.
    if span > cycle * (1.0 + 1e-9) {
        let (symbol, scale) = match context.coordinate() {
            Some(Dimension::Angle) => ("deg", 180.0 / std::f64::consts::PI),
            _ => ("m", 1.0),
        };
        let rounded = |value: f64| joined(" ", [brief((value * scale * 1e6).round() / 1e6), unit(symbol)]);
        let message = text!("scene-long-table", span = rounded(span), cycle = rounded(cycle));
        let in_degrees = context.coordinate() == Some(Dimension::Angle)
            && table.rows.iter().all(|row| row[0].fract() == 0.0 && row[0].abs() <= 1440.0);
        entry
            .fault(message, text!(if in_degrees { "scene-degrees-in-table" } else { "scene-shorten-table" }));
    }
}

fn strokes(section: &Section<'_>, shape: Shape, dimension: Dimension) -> Option<Value> {
    section.need("axis");
    let axis = section.number("axis");
    let side = |key: &str| match section.get(key) {
        None => Some(LawTable::constant(0.0)),
        Some(entry) => one_way(&entry, shape, dimension),
    };
    if section.get("forward").is_none() && section.get("back").is_none() {
        section.missing("forward", text!("scene-forward-or-back"));
    }
    let (forward, back) = (side("forward"), side("back"));
    Some(Value::Stroke { axis: axis?, forward: forward?, back: back? })
}

/// One direction of a stroke: a number, or rows over 0 to 1.
fn one_way(entry: &Entry<'_>, shape: Shape, dimension: Dimension) -> Option<LawTable> {
    if !entry.value.is_array() {
        return entry.quantity(dimension).map(LawTable::constant);
    }
    let rows = rows(entry, Dimension::Number, dimension)?;
    let ends = [rows.first(), rows.last()];
    if let Some([at, _]) = ends.into_iter().flatten().find(|row| !(0.0..=1.0).contains(&row[0])) {
        entry.problem(text!("scene-row-outside-stroke", at = brief(*at)), Text::default());
        return None;
    }
    Some(LawTable { rows, shape })
}

/// Reads rows [argument, value] with arguments that do not decrease.
pub(crate) fn rows(
    entry: &Entry<'_>,
    argument: impl Into<Option<Dimension>>,
    dimension: Dimension,
) -> Option<Vec<[f64; 2]>> {
    let argument = argument.into();
    if !entry.value.is_array() {
        entry.wrong(text!("scene-list-of-rows"), such_as("[[0, 10], [1, 20]]"));
        return None;
    }
    let items = entry.list(text!("scene-list-of-rows"));
    if items.is_empty() {
        entry.problem(text!("scene-no-rows"), such_as("[[0, 10], [1, 20]]"));
        return None;
    }
    if items.len() > MOST_ROWS {
        let problem = text!("scene-many-rows", count = items.len(), most = number(MOST_ROWS));
        entry.problem(problem, text!("scene-leave-rows-out"));
        return None;
    }
    let mut rows: Vec<[f64; 2]> = Vec::with_capacity(items.len());
    let mut whole = true;
    for item in &items {
        let Some(row) = row(item, argument, dimension) else {
            whole = false;
            continue;
        };
        if argument.is_some() && rows.last().is_some_and(|last| row[0] < last[0]) {
            item.fault(text!("scene-rows-decrease"), text!("scene-smaller-than-before"));
            whole = false;
        }
        rows.push(row);
    }
    whole.then_some(rows)
}

fn row(item: &Entry<'_>, argument: Option<Dimension>, dimension: Dimension) -> Option<[f64; 2]> {
    let [x, y] = item.pair(&text!("scene-rows-of-two"))?;
    let (x, y) = (x.bounded(argument, Bound::Any), y.bounded(dimension, Bound::Any));
    Some([x?, y?])
}
