//! Every quantity over the positions, in the unit that is shown.

use assur_analysis::results::{Column, Owner, Schema};
use assur_book::{Course, Unit, catalogue};
use assur_words::{Text, exact, joined, list, name, unit};

use assur_figure::number::number;

/// One quantity over the positions.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// What it is, by its identity in the results.
    pub column: Column,
    /// `point D x`, without the order.
    pub of: Text,
    /// Column header: `D.x'`.
    pub head: Text,
    /// The header in English, by which it is named in files; no two quantities have the same.
    pub short: String,
    /// What it is, in words by which it is looked for: `velocity`, `PF1`.
    pub kind: Text,
    /// Unit of the values.
    pub unit: Unit,
    /// The values with their coordinates, SI.
    pub course: Course,
    /// Values below this, SI, count as zero, however small the rest of the series is.
    pub floor: f64,
}

impl Series {
    /// A column of results with its values; values below `floor`, SI, count as zero.
    pub fn of(schema: &Schema, column: Column, course: Course, floor: f64) -> Self {
        let (of, head) = (catalogue::subject(schema, column), catalogue::short(schema, column));
        let (kind, short) = (catalogue::further(column), head.to_string());
        let unit = catalogue::unit(schema, column);
        let floor = if catalogue::is_ratio(column) { 0.0 } else { floor.max(course.rounding()) };
        Self { column, of, head, short, kind, unit, course, floor }
    }

    /// Value at a position; NaN where there is none.
    pub fn at(&self, position: usize) -> f64 {
        self.course.get(position).map_or(f64::NAN, |value| self.unit.factor * value)
    }

    /// Value at a position, SI; 0 if it is rounding compared with the greatest value. `None` where there is none.
    pub fn clean(&self, position: usize) -> Option<f64> {
        self.course.get(position).map(|value| if value.abs() <= self.floor { 0.0 } else { value })
    }

    /// Value and unit at a position.
    pub fn show(&self, position: usize) -> Text {
        let (number, symbol) = (self.number_told(position), self.unit.name);
        if symbol.is_empty() { number } else { joined(" ", [number, unit(symbol)]) }
    }

    /// Value at a position without its unit; 0 if it is rounding compared with the greatest value.
    pub fn bare(&self, position: usize) -> String {
        let value = self.at(position);
        if value.abs() <= self.least() { "0".to_owned() } else { number(value) }
    }

    /// The same for a reader, whose language may have digits of its own.
    pub fn number_told(&self, position: usize) -> Text {
        let value = self.at(position);
        if value.abs() <= self.least() { name("0") } else { exact(value, number(value)) }
    }

    /// The greatest size that counts as zero, in the unit that is shown.
    pub fn least(&self) -> f64 {
        self.unit.factor * self.floor
    }

    /// The greatest modulus of a value, in the unit that is shown.
    pub fn size(&self) -> f64 {
        self.unit.factor * self.course.size()
    }

    /// What it is, and of what: `point D x PF1`.
    pub fn told(&self) -> Text {
        joined(" ", [&self.of, &self.kind].into_iter().filter(|text| !text.is_empty()).cloned())
    }

    /// Its name for a list: `point D x PF1, m/rad`.
    pub fn title(&self) -> Text {
        list([self.told(), unit(self.unit.name)].into_iter().filter(|text| !text.is_empty()))
    }
}

/// A quantity with its two derivatives: indices of three series.
#[derive(Debug, Clone, PartialEq)]
pub struct Transfer {
    /// `point D x`.
    pub name: Text,
    /// The link, point or slide to which it belongs.
    pub owner: Owner,
    /// PF0, PF1, PF2.
    pub orders: [usize; 3],
}
