//! Comparison of results bit for bit.

use assur_analysis::results::{Analysis, Column, Quantity, Table};

/// How many numbers were compared.
#[derive(Default)]
pub(crate) struct Count(pub(crate) usize);

impl Count {
    /// Everything that the part has is in the whole. Where the whole has no forces (a change point of a group that the
    /// part does without), the part may have some.
    fn tables(&mut self, part: &Table, whole: &Table) {
        assert_eq!(part.numbers(), whole.numbers());
        for (index, column) in part.schema().columns().iter().enumerate() {
            let is_force = matches!(
                column.quantity,
                Quantity::Force | Quantity::Moment | Quantity::Offset | Quantity::Balancing
            );
            for (row, value) in part.each(index).enumerate() {
                let (Some(value), found) = (value, whole.get(row, *column)) else { continue };
                match found {
                    Some(found) => self.number(column, value, found),
                    None => assert!(is_force, "{column:?} is not in the whole"),
                }
            }
        }
    }

    fn number(&mut self, column: &Column, part: f64, whole: f64) {
        assert_eq!(part.to_bits(), whole.to_bits(), "{column:?}: {part:e} is not {whole:e}");
        self.0 += 1;
    }

    /// Compares all positions and samples; both must have the same.
    pub(crate) fn analyses(&mut self, part: &Analysis, whole: &Analysis) {
        self.tables(&part.positions, &whole.positions);
        self.tables(&part.trajectory, &whole.trajectory);
    }
}
