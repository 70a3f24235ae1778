//! A curve has the values of its table.

use assur_mechanism::{LawTable, Shape};
use proptest::prelude::*;

use super::near;
use crate::curve::Curve;

/// Rows of small whole numbers, so that some arguments are equal: jumps.
fn rows() -> impl Strategy<Value = Vec<[f64; 2]>> {
    let row = (-3..4i8, -9..10i8).prop_map(|(x, y)| [f64::from(x), f64::from(y)]);
    prop::collection::vec(row, 1..7).prop_map(|mut rows| {
        rows.sort_by(|a, b| a[0].total_cmp(&b[0]));
        rows
    })
}

proptest! {
    #[test]
    fn a_curve_has_the_values_of_its_table(rows in rows(), linear: bool, x in -5.0..6.0f64) {
        let shape = if linear { Shape::Linear } else { Shape::Step };
        let table = LawTable { rows, shape };
        let curve = Curve::of(&table);
        for x in [x, x.round()] {
            let segment = curve.segment(x);
            prop_assert_eq!(segment, table.segment(x));
            near(curve.value(segment, x), table.at(x), 10.0);
            let [low, high] = curve.ends(segment);
            prop_assert!(low <= x && x < high);
        }
    }
}
