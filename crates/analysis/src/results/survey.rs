//! What is known about all positions, of which only some are kept.

use assur_diagram::Sizes;
use assur_mechanism::{LinkId, PairId};
use assur_number::Statistic;

use super::{Column, Owner, Part, Quantity, Schema, Section, Table};

/// What is known about all positions of a scene.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Survey {
    /// Positions that have a solution.
    pub rows: usize,
    /// Failures: positions without a solution, or without forces.
    pub failures: usize,
    /// Of the balancing load, and of the condition number of each group.
    pub(crate) statistics: Vec<(Column, Statistic)>,
    /// The first number that is not finite: its place among the rows and its column.
    pub not_finite: Option<(usize, usize)>,
    /// By section, whether any row has its numbers.
    present: Vec<bool>,
    /// Sizes of the reactions, by pair and link.
    pub(crate) sizes: Vec<(PairId, LinkId, Sizes)>,
}

impl Survey {
    /// Of no positions yet.
    pub(crate) fn new(schema: &Schema) -> Self {
        let sizes = schema.owners(Quantity::Force).into_iter().filter_map(|owner| match owner {
            Owner::PairOn(pair, link) => Some((pair, link, Sizes::default())),
            _ => None,
        });
        let is_watched =
            |column: &&Column| **column == Column::BALANCING || column.quantity == Quantity::Condition;
        let watched = schema.columns().iter().filter(is_watched);
        let statistics = watched.map(|column| (*column, Statistic::default())).collect();
        Self { statistics, present: vec![false; schema.sections], sizes: sizes.collect(), ..Self::default() }
    }

    /// Of positions that are all kept.
    pub fn over(positions: &Table) -> Self {
        let mut survey = Self::new(positions.schema());
        survey.add(positions, positions.not_finite());
        survey
    }

    /// Adds the next rows, with their first number that is not finite.
    pub(crate) fn add(&mut self, rows: &Table, not_finite: Option<(usize, usize)>) {
        self.not_finite = self.not_finite.or(not_finite.map(|(row, column)| (self.rows + row, column)));
        self.rows += rows.len();
        for (section, any) in self.present.iter_mut().enumerate() {
            *any |= rows.present(Section(section)).contains(&true);
        }
        let schema = rows.schema();
        for (column, statistic) in &mut self.statistics {
            let values = schema.find(*column).into_iter().flat_map(|column| rows.each(column));
            for (number, value) in rows.numbers().iter().zip(values) {
                if let Some(value) = value {
                    statistic.push(*number, value);
                }
            }
        }
        let Some(coordinate) = schema.find(Column::COORDINATE) else { return };
        for (pair, link, sizes) in &mut self.sizes {
            let force = Column::of(Quantity::Force, Owner::PairOn(*pair, *link));
            let [Some(x), Some(y)] = [Part::X, Part::Y].map(|part| schema.find(force.part(part))) else {
                continue;
            };
            let (coordinates, x_values, y_values) = (rows.values(coordinate), rows.values(x), rows.values(y));
            let present = rows.present(schema.section_of(x));
            for row in (0..rows.len()).filter(|row| present[*row]) {
                sizes.add(rows.numbers()[row], coordinates[row], [x_values[row], y_values[row]]);
            }
        }
    }

    /// The statistic of a column; `None` where none is gathered.
    pub fn of(&self, column: Column) -> Option<&Statistic> {
        self.statistics.iter().find(|(known, _)| *known == column).map(|(_, statistic)| statistic)
    }

    /// Adds the columns that are joined to the kept positions.
    pub(crate) fn join(&mut self, positions: &Table, columns: &Table) {
        self.present.resize(positions.schema().sections, false);
        let sections = 1..columns.schema().sections;
        self.present.extend(sections.map(|section| columns.present(Section(section)).contains(&true)));
    }

    /// Whether any position has numbers in a section.
    pub fn has(&self, section: Section) -> bool {
        self.present.get(section.0).copied().unwrap_or(false)
    }
}
