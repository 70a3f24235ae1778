//! Tests of `figure`.

use super::hull;

#[test]
fn a_hull_drops_what_lies_inside_or_on_a_line() {
    assert_eq!(hull(&[[0.0, 0.0], [1.0, 0.0], [0.5, 0.0]]), [[0.0, 0.0], [1.0, 0.0]]);
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 0.5]];
    assert_eq!(hull(&square), square[..4]);
    assert!(hull(&[]).is_empty());
}
