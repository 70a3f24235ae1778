#![expect(clippy::float_cmp, reason = "bounds are rows of tables, handed on untouched")]

use crate::breaks::Breaks;

#[test]
fn intervals_of_a_range() {
    let breaks = Breaks::new(vec![2.0, 1.0, 2.0], None);
    assert_eq!(breaks.count(), 3);
    let ends = |q: f64| breaks.interval(q).ends;
    assert_eq!(ends(0.0), [f64::NEG_INFINITY, 1.0]);
    assert_eq!(ends(1.0), [1.0, 2.0]);
    assert_eq!(ends(2.0), [2.0, f64::INFINITY]);
}

#[test]
fn intervals_repeat_with_the_period() {
    // 12 is a period after 2, so never reached.
    let breaks = Breaks::new(vec![2.0, 5.0, 12.0], Some(10.0));
    assert_eq!(breaks.count(), 2);
    let found = |q: f64| (breaks.interval(q).index, breaks.interval(q).ends, breaks.interval(q).shift);
    assert_eq!(found(3.0), (0, [2.0, 5.0], 0.0));
    assert_eq!(found(11.0), (1, [5.0, 12.0], 0.0));
    assert_eq!(found(-6.0), (0, [-8.0, -5.0], -10.0));
    assert_eq!(found(12.0), (0, [12.0, 15.0], 10.0));
}

#[test]
fn no_breaks_is_one_interval() {
    for period in [None, Some(1.0)] {
        let breaks = Breaks::new(Vec::new(), period);
        assert_eq!(breaks.count(), 1);
        assert_eq!(breaks.interval(77.0).ends, [f64::NEG_INFINITY, f64::INFINITY]);
    }
}

#[test]
fn a_place_inside_lies_inside() {
    for period in [None, Some(10.0)] {
        let breaks = Breaks::new(vec![2.0, 5.0, 6.0], period);
        for index in 0..breaks.count() {
            assert_eq!(breaks.interval(breaks.inside(index, [1.0, 12.0])).index, index);
        }
    }
}
