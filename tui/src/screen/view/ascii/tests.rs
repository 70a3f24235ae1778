//! Tests of `ascii`.

use super::nearest;

#[test]
fn designations_get_their_latin_twin() {
    let latin: String = "4АА50А2У3".chars().map(nearest).collect();
    assert_eq!(latin, "4AA50A2U3");
    assert!("─│┌█→╱·°²⣿ж漢".chars().map(nearest).all(|c| c.is_ascii()));
}
