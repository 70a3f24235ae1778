//! What is known about all positions, of which only some are kept.

use assur_diagram::Sizes;
use assur_mechanism::{LinkId, PairId};

use super::{Column, Owner, Part, Quantity, Schema, Section, Table};

/// What is known about all positions of a scene.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Survey {
    /// Positions that have a solution.
    pub rows: usize,
    /// Failures: positions without a solution, or without forces.
    pub failures: usize,
    /// The balancing load of greatest modulus, N m or N, the first of those that are equal up to rounding (a cycle often
    /// has two), with the number of its position.
    pub greatest_balancing: Option<(usize, f64)>,
    /// By guide, its moment of greatest modulus, N m, likewise.
    pub greatest_moments: Vec<(PairId, (usize, f64))>,
    /// By group, its greatest condition number, likewise.
    pub worst_conditions: Vec<(usize, (usize, f64))>,
    /// The first number that is not finite: its place among the rows and its column.
    pub not_finite: Option<(usize, usize)>,
    /// By section, whether any row has its numbers.
    present: Vec<bool>,
    /// Sizes of the reactions, by pair and link.
    pub(crate) sizes: Vec<(PairId, LinkId, Sizes)>,
}

/// Relative difference below which balancing loads count as equal.
const TIE: f64 = 1e-9;

/// The number of greatest modulus in a column with that of its position: that of earlier rows unless one of these is greater.
fn farthest(rows: &Table, column: Column, earlier: Option<(usize, f64)>) -> Option<(usize, f64)> {
    let Some(column) = rows.schema().find(column) else { return earlier };
    let each = rows.numbers().iter().zip(rows.each(column));
    let known = each.filter_map(|(number, value)| Some((*number, value?)));
    known.fold(earlier, |most, next| {
        let is_greater = most.is_none_or(|(_, value)| next.1.abs() > value.abs() * (1.0 + TIE));
        if is_greater { Some(next) } else { most }
    })
}

/// Raises the greatest number of an owner by that of more rows.
fn raise<O: PartialEq>(known: &mut Vec<(O, (usize, f64))>, owner: O, rows: &Table, column: Column) {
    let before = known.iter().position(|(other, _)| *other == owner);
    match (before, farthest(rows, column, before.map(|at| known[at].1))) {
        (Some(at), Some(found)) => known[at].1 = found,
        (None, Some(found)) => known.push((owner, found)),
        (_, None) => {}
    }
}

impl Survey {
    /// Of no positions yet.
    pub(crate) fn new(schema: &Schema) -> Self {
        let sizes = schema.owners(Quantity::Force).into_iter().filter_map(|owner| match owner {
            Owner::PairOn(pair, link) => Some((pair, link, Sizes::default())),
            _ => None,
        });
        Self { present: vec![false; schema.sections], sizes: sizes.collect(), ..Self::default() }
    }

    /// Of positions that are all kept.
    pub fn of(positions: &Table) -> Self {
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
        self.greatest_balancing = farthest(rows, Column::BALANCING, self.greatest_balancing);
        for owner in schema.owners(Quantity::Moment) {
            let Owner::Pair(pair) = owner else { continue };
            raise(&mut self.greatest_moments, pair, rows, Column::of(Quantity::Moment, owner));
        }
        for owner in schema.owners(Quantity::Condition) {
            let Owner::Group(group) = owner else { continue };
            raise(&mut self.worst_conditions, group, rows, Column::of(Quantity::Condition, owner));
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
