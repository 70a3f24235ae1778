//! Angles of links without jumps from position to position.

use assur_kinematics::{Linkage, continuous_angle, first_angle};
use assur_mechanism::LinkId;
use assur_number::elementary;

use crate::results::{Column, Owner, Quantity, Schema, Table};

/// Stands for the coordinate before the first row.
const NONE: f64 = f64::INFINITY;

/// Follows the angles of links along the coordinate, from row to row.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Angles {
    /// Column of the angle, and link.
    followed: Vec<(usize, LinkId)>,
    coordinate: Option<usize>,
    /// Coordinate and angles of the last row; none before the first.
    last: Option<(f64, Vec<f64>)>,
}

impl Angles {
    /// Before the first row of all.
    pub(crate) fn new(schema: &Schema) -> Self {
        let of = |column: &Column| column.quantity == Quantity::Transfer(0);
        let followed =
            schema.select(of).into_iter().filter_map(|index| match schema.columns()[index].owner {
                Owner::Link(link) => Some((index, link)),
                _ => None,
            });
        Self { followed: followed.collect(), coordinate: schema.find(Column::COORDINATE), last: None }
    }

    /// After the last row of a table.
    pub(crate) fn after(table: &Table) -> Self {
        let mut angles = Self::new(table.schema());
        if let Some(row) = table.len().checked_sub(1) {
            angles.be_at(table, row);
        }
        angles
    }

    /// Takes the angles of a row of a table for the last ones.
    fn be_at(&mut self, table: &Table, row: usize) {
        self.last = self.coordinate.map(|coordinate| {
            let of_links = self.followed.iter().map(|(column, _)| table.values(*column)[row]);
            (table.values(coordinate)[row], of_links.collect())
        });
    }

    /// Makes the angles of rows between those of another table continue the rows of that one; the coordinates of both grow
    /// (`sense` 1) or fall (-1).
    pub(crate) fn follow_beside(
        &mut self,
        linkage: &Linkage,
        positions: &Table,
        sense: f64,
        table: &mut Table,
    ) {
        let Some(coordinate) = self.coordinate.filter(|_| !self.followed.is_empty()) else { return };
        let mut next = 0;
        for row in 0..table.len() {
            let at = table.values(coordinate)[row];
            while next < positions.len() && sense * (at - positions.values(coordinate)[next]) >= 0.0 {
                self.be_at(positions, next);
                next += 1;
            }
            self.follow_row(linkage, table, row, at);
        }
    }

    /// Makes the angles of each row of a table continue those of a row of another table at the same place.
    pub(crate) fn follow_at(&mut self, linkage: &Linkage, samples: (&Table, &[usize]), table: &mut Table) {
        let Some(coordinate) = self.coordinate.filter(|_| !self.followed.is_empty()) else { return };
        for (row, sample) in samples.1.iter().enumerate() {
            let at = table.values(coordinate)[row];
            self.be_at(samples.0, *sample);
            self.follow_row(linkage, table, row, at);
        }
    }

    /// Makes the angles of a table continue those of the rows before it: in (-pi, pi] in the first row of all, then the
    /// equivalent angle that is nearest to the one before.
    ///
    /// Between distant positions the mechanism is solved at intermediate coordinates; where one can't be assembled, the
    /// nearest angle is used.
    pub(crate) fn follow(&mut self, linkage: &Linkage, table: &mut Table) {
        let Some(coordinate) = self.coordinate.filter(|_| !self.followed.is_empty()) else { return };
        for row in 0..table.len() {
            let at = table.values(coordinate)[row];
            self.follow_row(linkage, table, row, at);
        }
    }

    fn follow_row(&mut self, linkage: &Linkage, table: &mut Table, row: usize, coordinate: f64) {
        let mut angles = self.before(linkage, coordinate, table, row);
        for (angle, (column, _)) in angles.iter_mut().zip(&self.followed) {
            let value = &mut table.column_mut(*column)[row];
            *value = continuous_angle(*value, *angle);
            *angle = *value;
        }
        self.last = Some((coordinate, angles));
    }

    /// The angles just before a row.
    fn before(&mut self, linkage: &Linkage, coordinate: f64, table: &Table, row: usize) -> Vec<f64> {
        let Some((from, mut angles)) = self.last.take() else {
            return self.followed.iter().map(|(column, _)| first_angle(table.values(*column)[row])).collect();
        };
        linkage.each_between([from, coordinate], |position| {
            for (angle, (_, link)) in angles.iter_mut().zip(&self.followed) {
                let body = &position.bodies[*link];
                *angle = continuous_angle(elementary::atan2(body.s, body.c), *angle);
            }
        });
        angles
    }
}

/// The angles before each block of rows, from which a block that is calculated again continues.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Starts(Vec<f64>);

impl Starts {
    /// Keeps the angles before the next block.
    pub(crate) fn push(&mut self, angles: &Angles) {
        match &angles.last {
            Some((coordinate, angles)) => self.0.extend([*coordinate].iter().chain(angles)),
            None => self.0.extend(std::iter::repeat_n(NONE, angles.followed.len() + 1)),
        }
    }

    /// The angles before a block of this number.
    pub(crate) fn of(&self, number: usize, schema: &Schema) -> Angles {
        let angles = Angles::new(schema);
        let last = self.0.chunks_exact(angles.followed.len() + 1).nth(number);
        let last = last.filter(|last| last[0] < NONE).map(|last| (last[0], last[1..].to_vec()));
        Angles { last, ..angles }
    }
}
