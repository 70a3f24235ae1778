//! Inputs over time: laws of motion, and the instants at which a motion is calculated.

use std::ops::Range as Bytes;

use assur_formula::Used;
use assur_mechanism::TimeLaw;
use assur_words::{Text, name, quantity, text};

use crate::error::Faults;
use crate::input::MOST;
use crate::known::Known;
use crate::reference::{Bound, table};
use crate::text::{brief, exclude, rounded, such_as};
use crate::units::Dimension;
use crate::value::{formula_with_unit, rows};
use crate::walk::{Entry, Section, quoted};

/// A law is tried at so many instants whether it has values.
const TRIED: usize = 1000;

/// The shapes of a table over time.
type Shape = fn(&[[f64; 2]], f64) -> TimeLaw;
const SHAPES: &[(&str, Shape)] = &[("linear", TimeLaw::linear), ("smooth", TimeLaw::smooth)];

/// What the coordinate of a scene's mechanism is, by the form of its input.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Timing {
    /// That of the single input.
    Coordinate,
    /// The time: the single input has a law over time.
    Law,
    /// The time: there is a list of inputs.
    List,
}

/// The instants at which a motion over time is calculated, from 0 on.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Instants {
    /// The last one, s.
    pub(crate) until: f64,
    /// How many.
    pub(crate) count: usize,
}

impl Timing {
    pub(crate) fn of(root: &Section<'_>) -> Self {
        match root.get("input") {
            Some(entry) if entry.is_list() => Self::List,
            Some(entry) if entry.value.as_table().is_some_and(|table| table.contains_key("over_time")) => {
                Self::Law
            }
            _ => Self::Coordinate,
        }
    }

    /// Whether the coordinate is the time.
    pub(crate) fn is_time(self) -> bool {
        self != Self::Coordinate
    }

    /// Notes what moves an input otherwise than its law over time, if it has one. Says whether it does.
    pub(crate) fn refuse_mover(self, faults: &Faults, span: &Bytes<usize>, what: &str) -> bool {
        self.refuse((faults, span), quoted(what), "scene-law-prescribes", text!("scene-leave-it-out"))
    }

    /// Notes what is over the coordinate or the speed of the input, if the coordinate of the mechanism is the time. Says whether it is.
    pub(crate) fn refuse_coordinate(self, at: (&Faults, &Bytes<usize>), what: Text, label: Text) -> bool {
        self.refuse(at, what, "scene-not-over-coordinate", label)
    }

    /// `of_law`: the identity of what is said of a single input.
    fn refuse(
        self,
        (faults, span): (&Faults, &Bytes<usize>),
        what: Text,
        of_law: &'static str,
        label: Text,
    ) -> bool {
        let message = match self {
            Self::Coordinate => return false,
            Self::Law => of_law,
            Self::List => "scene-needs-one-input",
        };
        faults.add(span.clone(), text!(message, what), label);
        true
    }
}

/// Reads `[motion]` where the coordinate is the time; a list of inputs without it has one instant. `None` if it is faulty.
pub(crate) fn instants(root: &Section<'_>, timing: Timing) -> Option<Instants> {
    let Some(motion) = root.get("motion") else {
        if timing == Timing::Law
            && let Some(input) = root.get("input")
        {
            let message = text!("scene-needs-motion", what = quoted("over_time"));
            root.faults.add(input.key, message, text!("scene-add-motion-until"));
            return None;
        }
        return Some(Instants { until: 0.0, count: 1 });
    };
    let section = motion.section(table("[motion]"))?;
    for entry in section.entries().iter().filter(|entry| !["until", "samples"].contains(&entry.name.as_str()))
    {
        if table("[motion]").key(&entry.name).is_some() {
            timing.refuse_mover(section.faults, &entry.key, &entry.name);
        }
    }
    let until = section.get("until");
    if until.is_none() {
        let message = text!("scene-needs-key", what = &section.what, key = name("until"));
        section.faults.add(section.span.clone(), message, text!("scene-why-until"));
    }
    let samples = section.get("samples").map_or(Some(100), |entry| entry.count(1, MOST - 1));
    let until = until?.bounded(Dimension::Time, Bound::Positive)?;
    Some(Instants { until, count: samples? + 1 })
}

/// Reads `over_time` of an input, whose coordinate has this dimension.
pub(crate) fn law(entry: &Entry<'_>, dimension: Dimension, instants: Option<Instants>) -> Option<TimeLaw> {
    let keys = entry.named(text!("scene-law-over-time"), such_as(EXAMPLE));
    let has = |key: &str| keys.iter().any(|entry| entry.name == key);
    let sort = match (has("table"), has("formula")) {
        (false, true) => "formula",
        (true, false) => "table",
        (both, _) => {
            if both {
                entry.fault(exclude(["table", "formula"].map(name)), text!("scene-leave-one-out"));
            } else if entry.value.is_table() {
                entry.section(table(LAW))?.missing("table", text!("scene-why-a-law"));
            }
            return None;
        }
    };
    let section = entry.section_as(text!("scene-law-over-time"), Known::Table(table(LAW), Some(sort)))?;
    let law =
        if sort == "table" { tabulated(&section, dimension, instants) } else { formula(&section, dimension) };
    check_values(entry, &law?, dimension, instants?)
}

/// The table of the reference with the keys of a law.
const LAW: &str = "over_time = { ... }";
const EXAMPLE: &str = "{ table = [[0, 0], [\"2 s\", 1]] }";

fn tabulated(section: &Section<'_>, dimension: Dimension, instants: Option<Instants>) -> Option<TimeLaw> {
    let shape = section.get("shape").map_or(Some(SHAPES[0].1), |entry| entry.choice(SHAPES));
    let entry = section.get("table")?;
    let rows = rows(&entry, Dimension::Time, dimension)?;
    let (Some(first), Some(last)) = (rows.first(), rows.last()) else { return None };
    if first[0].abs() > 0.0 {
        let got = quantity(brief(first[0]), "s");
        entry.problem(text!("scene-not-from-zero", got), such_as("[[0, 0], [1, 2]]"));
        return None;
    }
    if rows.len() < 2 {
        entry.problem(text!("scene-single-row"), such_as("[[0, 0], [1, 2]]"));
        return None;
    }
    let items = entry.list(Text::default());
    if let Some(row) = rows.windows(2).position(|ends| ends[0][0] >= ends[1][0]) {
        items[row + 1].fault(text!("scene-times-repeat"), text!("scene-law-without-jumps"));
        return None;
    }
    let until = instants.map_or(last[0], |instants| instants.until);
    let law = shape?(&rows, until);
    if let Some(end) = law.end().filter(|end| until > end * (1.0 + 1e-9)) {
        let [until, last] = [until, end].map(|time| quantity(brief(time), "s"));
        entry.fault(text!("scene-until-beyond", until, last), text!("scene-longer-or-closed"));
        return None;
    }
    Some(law)
}

fn formula(section: &Section<'_>, dimension: Dimension) -> Option<TimeLaw> {
    let (entry, formula, factor) = formula_with_unit(section, dimension)?;
    let others = others(formula.used());
    if !others.is_empty() {
        let message = text!("scene-law-of-others", variables = name(others));
        entry.fault(message, text!("scene-law-of-t"));
        return None;
    }
    Some(TimeLaw::Formula { formula, factor })
}

/// The variables of a formula besides the time: "q, w".
pub(crate) fn others(used: Used) -> String {
    let all = [(used.coordinate, "q"), (used.speed, "w"), (used.place, "x")];
    all.iter().filter(|one| one.0).map(|one| one.1).collect::<Vec<_>>().join(", ")
}

/// Refuses a law that has no value, or one beyond the limits of its dimension, at one of the instants.
fn check_values(
    entry: &Entry<'_>,
    law: &TimeLaw,
    dimension: Dimension,
    instants: Instants,
) -> Option<TimeLaw> {
    let tried = instants.count.clamp(2, TRIED);
    #[expect(clippy::cast_precision_loss, reason = "at most a thousand")]
    let mut times = (0..tried).map(|index| instants.until * (index as f64 / (tried - 1) as f64));
    let fails = |time: &f64| {
        let [value, speed, acceleration] = law.at(*time);
        // A number that is none is not within.
        !(value.abs() <= dimension.most() && speed.is_finite() && acceleration.is_finite())
    };
    let Some(time) = times.find(fails) else { return Some(law.clone()) };
    let at = quantity(rounded(time), "s");
    entry.fault(text!("scene-law-without-value", at), text!("scene-law-within-limits"));
    None
}
