//! The columns of the results as series with names: rates, reduction, reactions, loads, residuals.

use std::collections::HashMap;

use assur_analysis::results::{Column, Edges, Owner, Part, Quantity, Table};
use assur_book::{Course, ROUNDING, catalogue};
use assur_mechanism::{LinkId, Named, PairId};
use assur_words::Text;

use crate::Series;

/// The force that a pair exerts on one link, as indices of series.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reaction {
    /// The pin or slide, and the link on which it acts; `None` for the balancing load.
    pub of: Option<(Named<PairId>, Named<LinkId>)>,
    /// `A on crank`, `balancing load`.
    pub name: Text,
    /// Fx, Fy, modulus; for the balancing load its one series.
    pub series: Vec<usize>,
    /// Moment of a slide.
    pub moment: Option<usize>,
}

/// Series that are being collected from the positions of an analysis.
pub(crate) struct Gather<'a> {
    pub(crate) table: &'a Table,
    /// What lies between and after them.
    pub(crate) edges: &'a Edges,
    pub(crate) series: Vec<Series>,
}

impl Gather<'_> {
    /// Adds a column as a series if any position has it, and returns its index.
    pub(crate) fn add(&mut self, column: Column) -> Option<usize> {
        let course = Course::of(self.table, Some(self.edges), Column::COORDINATE, column);
        if course.is_empty() {
            return None;
        }
        self.series.push(Series::of(self.table.schema(), column, course, 0.0));
        Some(self.series.len() - 1)
    }

    /// Adds a whole quantity, or both projections of a vector and its modulus.
    fn add_all(&mut self, whole: Column) -> Vec<usize> {
        let is_vector = self.table.schema().find(whole.part(Part::X)).is_some();
        let parts: &[Part] = if is_vector { &[Part::X, Part::Y, Part::Modulus] } else { &[Part::Whole] };
        parts.iter().filter_map(|part| self.add(whole.part(*part))).collect()
    }

    pub(crate) fn motion(&mut self) -> Vec<usize> {
        let all = [
            Quantity::Velocity,
            Quantity::Acceleration,
            Quantity::ReducedInertia,
            Quantity::ReducedInertiaDerivative,
            Quantity::ReducedMoment,
        ];
        all.into_iter().filter_map(|quantity| self.add(Column::of(quantity, Owner::Input))).collect()
    }

    pub(crate) fn rates(&mut self) {
        let schema = self.table.schema();
        for quantity in [Quantity::Velocity, Quantity::Acceleration] {
            let owners = schema.owners(quantity).into_iter().filter(|owner| *owner != Owner::Input);
            owners.for_each(|owner| drop(self.add_all(Column::of(quantity, owner))));
        }
    }

    /// Force and moment of every pair, then the balancing load.
    pub(crate) fn reactions(&mut self) -> Vec<Reaction> {
        let schema = self.table.schema();
        let mut found = Vec::new();
        for (id, on) in catalogue::reactions(schema) {
            let pair = schema.named(Owner::Pair(id)).map(|name| Named { id, name: name.clone() });
            let of = pair.map(|pair| (pair, Named { id: on, name: schema.links[on].clone() }));
            let force = Column::of(Quantity::Force, Owner::PairOn(id, on));
            let (name, series) = (catalogue::owner(schema, force), self.add_all(force));
            let moment = self.add(Column::of(Quantity::Moment, Owner::Pair(id)));
            if series.len() == 3 {
                found.push(Reaction { of, name, series, moment });
            }
        }
        if let Some(index) = self.add(Column::BALANCING) {
            let name = catalogue::kind(Column::BALANCING);
            found.push(Reaction { of: None, name, series: vec![index], moment: None });
        }
        found
    }

    /// What else a position has: loads, inertia loads, friction, what shakes the ground, how well each group is conditioned.
    pub(crate) fn others(&mut self) {
        let schema = self.table.schema();
        for &column in schema.columns() {
            let whole = column.part(Part::Whole);
            // Transfer functions are those of the scene; of the two forces of a pair one is shown; shares have a view of their own.
            let is_elsewhere =
                matches!(column.quantity, Quantity::Transfer(_) | Quantity::Force) || column.cause.is_some();
            let is_new = self.series.iter().all(|series| series.column.part(Part::Whole) != whole);
            if is_new && !is_elsewhere && catalogue::path(schema, column).is_some() {
                self.add_all(whole);
            }
        }
    }

    /// Raises the limits below which values count as zero to what is rounding beside the greatest value in their unit.
    pub(crate) fn mark_rounding(&mut self) {
        let mut greatest: HashMap<&str, f64> = HashMap::new();
        for series in &self.series {
            let most = greatest.entry(&series.unit).or_default();
            *most = most.max(series.course.size());
        }
        let floors: Vec<f64> =
            self.series.iter().map(|series| ROUNDING * greatest[series.unit.as_str()]).collect();
        let of_units = self.series.iter_mut().zip(floors);
        for (series, floor) in of_units.filter(|(series, _)| !catalogue::is_ratio(series.column)) {
            series.floor = series.floor.max(floor);
        }
    }
}
