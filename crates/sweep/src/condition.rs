//! Conditions that the written rows of a sweep hold.

use std::fmt;

use assur_scene::quantity;
use assur_words::{Describe, Text, name, text};

use crate::column::measured;
use crate::layout::Layout;
use crate::rows::{Columns, Rows, shown};
use crate::{MEASURES, Measure, SweepError};

/// A condition on a column, which rows hold or not.
///
/// # Examples
///
/// ```
/// use assur_sweep::Condition;
///
/// let condition = Condition::parse("transmission>40 deg")?;
/// assert_eq!(condition.to_string(), "transmission > 40 deg");
/// assert!(Condition::parse("transmission = 40 deg").is_err());
/// # Ok::<(), assur_sweep::SweepError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Condition {
    column: String,
    relation: Relation,
    value: String,
}

/// How a number has to compare with that of the condition.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Relation {
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
}

impl Relation {
    fn sign(self) -> &'static str {
        match self {
            Self::Less => "<",
            Self::LessOrEqual => "<=",
            Self::Greater => ">",
            Self::GreaterOrEqual => ">=",
        }
    }

    fn holds(self, number: f64, limit: f64) -> bool {
        match self {
            Self::Less => number < limit,
            Self::LessOrEqual => number <= limit,
            Self::Greater => number > limit,
            Self::GreaterOrEqual => number >= limit,
        }
    }
}

impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} {}", self.column, self.relation.sign(), self.value)
    }
}

impl Condition {
    /// Reads `COLUMN > VALUE`, with one of the signs `<`, `<=`, `>`, `>=`. The column is one of the sweep, or a measure that gives
    /// one value; the value is in SI or has a unit.
    pub fn parse(text: &str) -> Result<Self, SweepError> {
        let fault = || SweepError::vary(text, text!("sweep-write-where"));
        // A name may contain anything, a number none of the signs.
        let at = text.rfind(['<', '>']).ok_or_else(fault)?;
        let (column, rest) = text.split_at(at);
        let (relation, value) = match (&rest[..1], &rest[1..]) {
            ("<", value) => match value.strip_prefix('=') {
                Some(value) => (Relation::LessOrEqual, value),
                None => (Relation::Less, value),
            },
            (_, value) => match value.strip_prefix('=') {
                Some(value) => (Relation::GreaterOrEqual, value),
                None => (Relation::Greater, value),
            },
        };
        let [column, value] = [column, value].map(|part| part.trim().to_owned());
        if column.is_empty() || value.is_empty() {
            return Err(fault());
        }
        Ok(Self { column, relation, value })
    }

    fn fault(&self, problem: Text) -> SweepError {
        SweepError::vary(self.to_string(), problem)
    }

    /// The index of the column: of its name, or of the only one of a measure that is not the place of another.
    fn find(&self, columns: &Columns, layout: &Layout) -> Result<usize, SweepError> {
        let of_measure: Vec<usize> =
            layout.values_of(&self.column).map(|value| columns.of_value(value)).collect();
        match (columns.find(&self.column), &of_measure[..]) {
            (Ok(column), _) => Ok(column),
            (_, [column]) => Ok(*column),
            (Err(problem), []) => Err(problem),
            (_, several) => {
                let names: Vec<_> = several.iter().map(|column| columns.names[*column].as_str()).collect();
                Err(self.fault(text!("sweep-where-several", columns = shown(&names))))
            }
        }
    }

    /// The value in SI, of a column that has this name.
    fn number(&self, column: &str) -> Result<f64, SweepError> {
        let bare = self.value.parse::<f64>().ok().filter(|number| number.is_finite());
        let read = || match measured(column) {
            Some(kind) => quantity(&self.value, kind).map_err(|error| error.describe()),
            None => Err(text!("sweep-where-bare", column = name(column.to_owned()))),
        };
        bare.map_or_else(read, Ok).map_err(|problem| self.fault(problem))
    }

    /// Finds the column of the condition among those of a sweep.
    pub(crate) fn among(self, columns: &Columns, layout: &Layout) -> Result<Test, SweepError> {
        let column = self.find(columns, layout)?;
        let limit = self.number(&columns.names[column])?;
        Ok(Test { condition: self, column, limit })
    }
}

/// The measures, and those that conditions name, which are then named.
pub(crate) fn with_named(mut measures: Vec<Measure>, conditions: &[Condition]) -> Vec<Measure> {
    for own in MEASURES.iter().filter(|own| conditions.iter().any(|one| one.column == own.name)) {
        let named = own.in_full();
        match measures.iter_mut().find(|measure| measure.name == own.name && !measure.is_plain) {
            Some(measure) => *measure = named,
            None => measures.push(named),
        }
    }
    // Those that are not in the list are of columns of the positions, and last.
    let place = |measure: &Measure| {
        let own = MEASURES.iter().position(|own| own.name == measure.name && !measure.is_plain);
        own.unwrap_or(MEASURES.len())
    };
    measures.sort_by_key(place);
    measures
}

/// A condition on a column that was found.
#[derive(Debug, Clone)]
pub(crate) struct Test {
    /// As it is written.
    pub(crate) condition: Condition,
    column: usize,
    /// SI.
    limit: f64,
}

impl Test {
    /// Whether a row holds it; one without a number does not.
    pub(crate) fn holds(&self, rows: &Rows, row: usize) -> bool {
        rows.number(row, self.column).is_some_and(|number| self.condition.relation.holds(number, self.limit))
    }
}
