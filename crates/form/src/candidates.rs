//! Values for the keys that a table needs, which read where they stand.

use assur_mechanism::Key;
use assur_scene::edit::{bare, decimal, quoted};
use assur_scene::reference::{KeyTable, SceneKey, ValueKind};
use assur_scene::{Dimension, quantity};
use toml::de::DeValue;

use crate::change::Step;
use crate::choices::named;
use crate::fault::Fault;
use crate::rows::columns;
use crate::tables::{Tables, key_of, last, owner, table_at};

/// What the arguments of rows measure, but for plain numbers, which are as right in any unit.
const ARGUMENTS: [Dimension; 5] =
    [Dimension::Angle, Dimension::Length, Dimension::Time, Dimension::AngularSpeed, Dimension::Speed];
/// More values are not tried.
const MOST: usize = 40;
/// A table needs fewer keys.
const MOST_KEYS: usize = 24;

impl Step {
    /// Sets the keys that a table, and what stands at one of its keys, needs since the beginning; not this key itself.
    pub(crate) fn complete(&mut self, at: &Key, key: &Key) {
        let mut tried = vec![key.clone()];
        for _ in 0..MOST_KEYS {
            let place = |key: &Key| {
                let names = table_at(owner(key).steps()).into_iter().flat_map(|table| &table.keys);
                names.map(|own| own.name).position(|name| name == last(key))
            };
            let is_own = |own: &Key| owner(own) == *at || owner(own).steps().starts_with(key.steps());
            let lacking = self.faults().iter().filter_map(Fault::missing).filter(is_own).collect::<Vec<_>>();
            let lacking = lacking.into_iter().filter(|key| !tried.contains(key) && place(key).is_some());
            let Some(first) = lacking.min_by_key(|key| place(key)) else { break };
            self.fill(&first);
            tried.push(first);
        }
        let mended = if self.tries_others { tried.split_off(1) } else { Vec::new() };
        let misnamed = if self.tries_others { self.misnamed(at, key) } else { Vec::new() };
        for key in mended.into_iter().chain(misnamed) {
            let is_wrong = |fault: &Fault| fault.missing().is_none() && fault.concerns(&key);
            let wrong = self.faults();
            if wrong.iter().any(is_wrong) {
                // What is wrong with a value may show only where the whole table stands: a pair that has its friction already.
                if let Some(better) = self.better(&key, wrong.len()) {
                    *self = better;
                }
            }
        }
    }

    /// The other keys of a table that name what they can't name beside this key: a point of the link that the table had before.
    fn misnamed(&self, at: &Key, key: &Key) -> Vec<Key> {
        let names_a_part = |own: &Key| {
            let is_name = |kind: &ValueKind| matches!(kind, ValueKind::Named(_) | ValueKind::Place);
            key_of(own.steps()).is_some_and(|known| known.kinds.iter().any(is_name))
        };
        let wrong = self.faults().into_iter().filter(|fault| fault.missing().is_none());
        let keys = wrong.filter_map(|fault| fault.key);
        keys.filter(|own| own != key && owner(own) == *at && names_a_part(own)).collect()
    }

    /// Gives a key that is missing the value with the fewest faults, or one to a key that may stand in its place.
    fn fill(&mut self, key: &Key) {
        let least = self.wrong();
        let best = self.best(key, least);
        let is_good = best.as_ref().is_some_and(|(_, wrong)| *wrong <= least);
        let mut fewest = best.as_ref().map_or(usize::MAX, |(_, wrong)| *wrong);
        let mut found = best.map(|(step, _)| step);
        let known = table_at(owner(key).steps()).filter(|_| self.tries_others && !is_good);
        for rival in known.map(|table| rivals(table, last(key))).unwrap_or_default() {
            if let Some(other) = self.better(&owner(key).at(rival), fewest) {
                fewest = other.faults().len();
                found = Some(other);
            }
        }
        if let Some(step) = found {
            *self = step;
        }
    }

    /// This step with the value of a key that, with all that it makes needed, has the fewest faults, if there are fewer than so many.
    fn better(&self, key: &Key, mut fewest: usize) -> Option<Self> {
        let mut found = None;
        for value in self.candidates(key).into_iter().take(MOST) {
            let mut other = self.clone();
            other.tries_others = false;
            if other.set(key, &value).is_err() {
                continue;
            }
            other.also.push(key.clone());
            other.settle(&self.text, key, true);
            let wrong = other.faults().len();
            if wrong < fewest {
                other.tries_others = true;
                (fewest, found) = (wrong, Some(other));
            }
            if wrong == 0 {
                break;
            }
        }
        found
    }

    /// This step with the best value of a key, and how many faults it has then; the first value with so few as `least`.
    fn best(&self, key: &Key, least: usize) -> Option<(Self, usize)> {
        let mut best: Option<(Self, usize)> = None;
        for value in self.candidates(key).into_iter().take(MOST) {
            let mut other = self.clone();
            if other.set(key, &value).is_err() {
                continue;
            }
            other.also.push(key.clone());
            let wrong = other.wrong();
            if best.as_ref().is_none_or(|(_, fewest)| wrong < *fewest) {
                best = Some((other, wrong));
            }
            if wrong <= least {
                break;
            }
        }
        best
    }

    /// How many faults are new, but for keys that are missing.
    fn wrong(&self) -> usize {
        self.faults().iter().filter(|fault| fault.missing().is_none()).count()
    }

    /// Values for a key, the best first.
    pub(crate) fn candidates(&self, key: &Key) -> Vec<String> {
        let Some(known) = key_of(key.steps()) else { return Vec::new() };
        let tables = Tables::of(&self.text);
        let same =
            |(own, _): &&(Key, String)| key_of(own.steps()).is_some_and(|own| own.kinds == known.kinds);
        let carried = self.carried.iter().filter(same).map(|(_, value)| value.clone());
        let rows = known.kinds.contains(&ValueKind::Rows).then(|| self.of_rows(&tables, key));
        // Words come before names: a slide is on the ground. Whatever names nothing may be as in the reference.
        let names_something = known
            .kinds
            .iter()
            .any(|kind| matches!(kind, ValueKind::Named(_) | ValueKind::Place | ValueKind::Two(_)));
        let first: Vec<_> = match last(key) {
            "formula" => self.constant(&tables, key).into_iter().collect(),
            _ if names_something => known.words().map(quoted).collect(),
            _ => Vec::new(),
        };
        let example = (!names_something).then(|| known.example.to_owned());
        let values = known.kinds.iter().flat_map(|kind| Self::of_kind(&tables, key, (known, kind)));
        carried.chain(rows.into_iter().flatten()).chain(first).chain(example).chain(values).collect()
    }

    /// Values of one kind; none of a kind whose values name nothing and have no unit.
    fn of_kind(tables: &Tables<'_>, key: &Key, (known, kind): (&SceneKey, &ValueKind)) -> Vec<String> {
        match kind {
            ValueKind::Quantity(dimension) => vec![of_dimension(known.example, *dimension)],
            ValueKind::ByInput(turning, sliding) => {
                let slides = tables.coordinate(key) == Some(Dimension::Length);
                vec![of_dimension(known.example, if slides { *sliding } else { *turning })]
            }
            ValueKind::Named(_) => named(tables, key, kind).iter().map(|name| quoted(name)).collect(),
            ValueKind::Place => {
                let points = named(tables, key, kind).into_iter().rev().map(|point| quoted(&point));
                points.chain(["[0, 0]".to_owned()]).collect()
            }
            ValueKind::Two(item) if matches!(**item, ValueKind::Named(_)) => {
                let names = named(tables, key, kind);
                let is_place = tables.points_beside(key).is_some();
                let pairs = |(at, one): (usize, &String)| {
                    // Both ends of a spring are not on one link, as the points are by which a place is given.
                    let links = tables.holders(one);
                    let is_apart = |other: &&String| {
                        is_place || tables.holders(other).iter().all(|link| !links.contains(link))
                    };
                    let others = names[at + 1..].iter().filter(is_apart);
                    others.map(|other| format!("[{}, {}]", quoted(one), quoted(other))).collect::<Vec<_>>()
                };
                names.iter().enumerate().flat_map(pairs).collect()
            }
            // Two equal lengths close a triangle if they are great enough.
            ValueKind::Two(_) if last(key) == "lengths" => {
                let lengths = ["100 mm", "1 m", "10 m"].map(quoted);
                lengths.map(|length| format!("[{length}, {length}]")).into()
            }
            // The example of the reference stands for all that names nothing.
            _ => Vec::new(),
        }
    }

    /// The number that stood in place of the table of a formula, as a formula in SI.
    fn constant(&self, tables: &Tables<'_>, key: &Key) -> Option<String> {
        let size = quantity(&bare(self.size(key)?), columns(tables, key)[1]?).ok()?;
        Some(quoted(&size.to_string()))
    }

    /// The number that stood in place of the table that has a key.
    fn size(&self, key: &Key) -> Option<&str> {
        let of = owner(key);
        let is_number = |value: &&String| !value.starts_with(['{', '[']);
        self.carried
            .iter()
            .rev()
            .filter(|(own, _)| *own == of)
            .map(|(_, value)| value)
            .find(is_number)
            .map(String::as_str)
    }

    /// Rows for a key: those of another key of its table over its own argument, or else the number that stood in their place.
    fn of_rows(&self, tables: &Tables<'_>, key: &Key) -> Vec<String> {
        let (argument, table) = (columns(tables, key)[0], owner(key));
        let of_table = |(own, _): &&(Key, String)| owner(own) == table;
        let old = self.carried.iter().filter(of_table).find_map(|(_, value)| places(value));
        let size = self.size(key).unwrap_or("0");
        let old = old.unwrap_or_else(|| [0.0, 1.0].map(|place| (place, size.to_owned())).into());
        ends(argument).iter().map(|(end, unit)| spread(&old, *end, unit)).collect()
    }
}

/// Where rows may end that begin at 0, with a unit.
fn ends(argument: Option<Dimension>) -> &'static [(f64, &'static str)] {
    match argument {
        Some(Dimension::Angle) => &[(360.0, "deg"), (90.0, "deg")],
        Some(Dimension::Length) => &[(100.0, "mm"), (10.0, "mm")],
        Some(Dimension::Time) => &[(1.0, "s"), (1000.0, "s")],
        Some(Dimension::AngularSpeed) => &[(100.0, "rpm")],
        Some(Dimension::Speed) => &[(1.0, "m/s")],
        _ => &[(1.0, "")],
    }
}

/// Rows by the place of their arguments between the first, 0, and the last, 1, with their values as they are written; `None` of what are
/// no rows.
fn places(rows: &str) -> Option<Vec<(f64, String)>> {
    let list = DeValue::parse(rows).ok()?;
    let row = |row: &toml::Spanned<DeValue<'_>>| {
        let row = row.get_ref().as_array()?;
        Some([row.first()?, row.get(1)?].map(|cell| rows.get(cell.span()).unwrap_or_default().to_owned()))
    };
    let rows: Vec<[String; 2]> = list.get_ref().as_array()?.iter().map(row).collect::<Option<_>>()?;
    let read = |dimension: &Dimension| {
        rows.iter().map(|[at, _]| quantity(&bare(at), *dimension).ok()).collect::<Option<Vec<_>>>()
    };
    let at = ARGUMENTS.iter().find_map(read)?;
    let (first, last) = (*at.first()?, *at.last()?);
    let place = |at: f64| if last > first { (at - first) / (last - first) } else { 0.0 };
    Some(at.into_iter().map(place).zip(rows.into_iter().map(|[_, value]| value)).collect())
}

/// Rows from 0 to an end.
fn spread(places: &[(f64, String)], end: f64, unit: &str) -> String {
    let row = |(place, value): &(f64, String)| {
        let at = decimal(place * end);
        let at = if unit.is_empty() || at == 0.0 { at.to_string() } else { quoted(&format!("{at} {unit}")) };
        format!("[{at}, {value}]")
    };
    format!("[{}]", places.iter().map(row).collect::<Vec<_>>().join(", "))
}

/// The first of the keys of each row that excludes a key.
fn rivals(table: &KeyTable, key: &str) -> Vec<&'static str> {
    let has = |row: &&Vec<&str>| row.contains(&key);
    let choices = table.either.iter().filter(|rows| rows.iter().any(|row| has(&row)));
    choices.flatten().filter(|row| !has(row)).filter_map(|row| row.first().copied()).collect()
}

/// The example where it measures the dimension, or else that of the dimension.
fn of_dimension(example: &str, dimension: Dimension) -> String {
    if quantity(&bare(example), dimension).is_ok() {
        return example.to_owned();
    }
    let own = dimension.example();
    if dimension == Dimension::Number { own.to_owned() } else { quoted(own) }
}
