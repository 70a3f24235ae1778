//! Tests of courses.

mod table;

use std::f64::consts::TAU;

use crate::{Course, Node};

fn sine(count: u32, shift: f64, closed: bool) -> Course {
    let node = |i: u32| {
        let at = f64::from(i) * TAU / f64::from(count);
        Node { number: i as usize, at, value: (at + shift).sin() }
    };
    Course::from_nodes((0..count).map(node), closed.then(|| node(count)))
}

#[test]
fn zeros_of_a_sine() {
    let found = sine(12, 0.1, true).zeros();
    assert_eq!(found.len(), 2, "{found:?}");
    assert!((found[0] - (TAU / 2.0 - 0.1)).abs() < 0.01, "{found:?}");
    assert!((found[1] - (TAU - 0.1)).abs() < 0.01, "{found:?}");
    assert_eq!(sine(12, 0.1, false).zeros().len(), 1);
}

#[test]
fn a_zero_that_is_met_counts_once() {
    let of = |values: &[f64]| Course::from_points(values.iter().enumerate().map(|(at, y)| [at as f64, *y]));
    assert_eq!(of(&[1.0, 0.0, -1.0, 0.0, 1.0]).zeros(), [1.0, 3.0]);
    assert!(of(&[0.0, 0.0]).zeros().is_empty());
    assert!(of(&[]).zeros().is_empty());
}

#[test]
fn a_position_without_a_value_interrupts_the_line() {
    let nodes = [0, 1, 3].map(|number| Node { number, at: number as f64, value: 1.0 - number as f64 });
    let course = Course::from_nodes(nodes, None);
    let points = course.points([2.0, 10.0]);
    assert_eq!(points.len(), 4);
    assert!(points[2].iter().all(|x| x.is_nan()));
    assert_eq!(points[3].map(f64::to_bits), [6.0_f64, -20.0].map(f64::to_bits));
    assert_eq!(course.get(2), None);
    assert_eq!(course.between(2.0), None);
    assert_eq!(course.between(0.25), Some(0.75));
}

#[test]
fn closing_is_found_and_not_assumed() {
    assert_eq!(sine(12, 0.3, true).closes(), Some(true));
    assert_eq!(sine(12, 0.3, false).closes(), None);
    let line = Course::from_nodes(
        (0..4).map(|number| Node { number, at: number as f64, value: 30.0 - number as f64 }),
        Some(Node { number: 4, at: 4.0, value: 26.0 }),
    );
    assert_eq!(line.closes(), Some(false));
}

#[test]
fn extremes_of_a_line_have_their_places() {
    let course = Course::from_points([[0.0, 32.0], [1.0, -90.0], [2.0, 32.0], [3.0, 0.0]]);
    assert_eq!(course.highest_and_lowest(), Some([[0.0, 32.0], [1.0, -90.0]]));
    // Between the positions the line goes farther: at both sides of a jump.
    let course = course.with_between(vec![[0.5, 40.0], [0.5, -95.0]]);
    assert_eq!(course.highest_and_lowest(), Some([[0.5, 40.0], [0.5, -95.0]]));
}

#[test]
fn every_key_of_the_json_has_its_place() {
    let keys: Vec<&str> = crate::catalogue::KEYS.split_whitespace().collect();
    for path in crate::catalogue::PATHS.iter().filter(|path| !path.is_empty()) {
        let first = path.split('.').next().unwrap();
        assert!(keys.contains(&first), "{path}: a row in JSON would not have it");
    }
}
