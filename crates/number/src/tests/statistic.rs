use crate::{Extreme, Lanes, Statistic};

const VALUES: [f64; 19] =
    [3.0, -1.0, 4.0, -1.0, 5.0, -9.0, 2.0, -6.0, 5.0, 3.0, 5.0, 9.0, 7.0, -9.0, 3.0, 2.0, 9.0, 4.0, 0.5];

fn by_value() -> Statistic {
    VALUES.into_iter().enumerate().collect()
}

fn in_lanes() -> Statistic {
    let mut found = Statistic::default();
    for (index, eight) in VALUES.chunks(Lanes::WIDTH).enumerate() {
        let lanes = std::array::from_fn(|lane| lane < eight.len());
        let values = Lanes::of(|lane| eight.get(lane).copied().unwrap_or(f64::NAN));
        found.add(lanes, index * Lanes::WIDTH, values);
    }
    found
}

fn in_parts() -> Statistic {
    let part = |range: std::ops::Range<usize>| range.map(|number| (number, VALUES[number])).collect();
    let mut found: Statistic = part(0..7);
    found.append(&part(7..8));
    found.append(&part(8..19));
    found
}

#[test]
fn values_and_lanes_give_the_same_and_the_first_of_equals_wins() {
    for found in [by_value(), in_lanes(), in_parts()] {
        assert_eq!(found.greatest(), Some(Extreme { value: 9.0, number: 11 }));
        assert_eq!(found.least(), Some(Extreme { value: -9.0, number: 5 }));
        assert_eq!(found.farthest(), found.least());
        let (count, sum, squares) =
            (19.0, VALUES.iter().sum::<f64>(), VALUES.iter().map(|v| v * v).sum::<f64>());
        assert!((found.mean().unwrap() - sum / count).abs() < 1e-15);
        assert!((found.rms().unwrap() - (squares / count).sqrt()).abs() < 1e-15);
    }
}

#[test]
fn rounding_does_not_decide_between_two_extremes() {
    let found: Statistic = [(2, 1.0), (7, -1.0 - 2e-12), (9, 1.0 + 1e-12)].into_iter().collect();
    assert_eq!(found.greatest(), Some(Extreme { value: 1.0 + 1e-12, number: 2 }));
    assert_eq!(found.farthest().unwrap().number, 2);
    let mut apart = Statistic::default();
    apart.add([true; Lanes::WIDTH], 0, Lanes::of(|lane| -1.0 - 1e-13 * lane as f64));
    assert_eq!(apart.least().unwrap().number, 0);
    apart.push(8, -1.0 - 1e-8);
    assert_eq!(apart.least(), Some(Extreme { value: -1.0 - 1e-8, number: 8 }));
}

#[test]
fn nothing_and_what_is_no_number() {
    let none = Statistic::default();
    assert!(none.is_empty() && none.greatest().is_none() && none.mean().is_none());
    let found: Statistic =
        [(0, f64::NAN), (1, 2.0), (2, f64::INFINITY), (3, f64::INFINITY)].into_iter().collect();
    assert_eq!(found.greatest(), Some(Extreme { value: f64::INFINITY, number: 2 }));
    assert_eq!(found.least(), Some(Extreme { value: 2.0, number: 1 }));
    assert!(found.mean().unwrap().is_nan());
}
