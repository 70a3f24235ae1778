//! The columns of a slide that drives.

use super::analyzed;
use crate::results::{Column, Owner, Quantity};

/// Between two moving links too its displacement is the coordinate, to the last bit.
#[test]
fn a_driven_slide_is_the_coordinate() {
    let found = analyzed(assur_fixtures::scene("boom"));
    let table = &found.positions;
    let column = |order| Column::of(Quantity::Transfer(order), Owner::Slide(0));
    for row in 0..17 {
        let coordinate = 0.85 + 0.4 * row as f64 / 16.0;
        let [place, first, second] = [0, 1, 2].map(|order| table.get(row, column(order)).unwrap());
        assert!((place - coordinate).abs() < 1e-15, "{place} {coordinate}");
        assert_eq!([first, second].map(f64::to_bits), [1.0_f64, 0.0].map(f64::to_bits), "row {row}");
    }
}
