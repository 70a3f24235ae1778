use assur_words::name;

use super::*;

/// Offers some residuals of the positions of a range: fine, too wide to judge, and one that is worst.
fn collected(positions: std::ops::Range<usize>) -> Collector {
    let mut collector = Collector::new(name("name"), name("reason"));
    for at in positions {
        match at % 4 {
            0 => collector.leave_out(at, name("left out")),
            1 => collector.offer(at, 0.1, 0.2 + at as f64, || name(format!("wide {at}"))),
            _ => collector.offer(at, 1e-9 * (at % 7) as f64, 1e-8, || name(format!("place {at}"))),
        }
    }
    collector
}

#[test]
fn parts_one_after_another_are_the_whole() {
    let whole = collected(0..40);
    for middle in [1, 2, 7, 20, 38] {
        let mut parts = collected(0..middle);
        parts.append(collected(middle..40));
        assert_eq!(
            format!("{:?}", Collector { last: whole.last, ..parts }),
            format!("{whole:?}"),
            "{middle}"
        );
    }
    assert_eq!((whole.check.left_out, whole.check.at, whole.offers), (20, Some(6), 20));
}

#[test]
fn of_equal_residuals_the_first_is_shown() {
    let mut collector = Collector::new(name("name"), name("reason"));
    for at in 0..3 {
        collector.offer(at, 1e-9, 1e-8, || name(format!("place {at}")));
    }
    assert_eq!(collector.into_check().unwrap().at, Some(0));
    let mut failing = Collector::new(name("name"), name("reason"));
    failing.offer(0, 1e-9, 1e-8, Text::default);
    failing.offer(1, 3e-8, 1e-8, Text::default);
    failing.offer(2, 3e-8, 1e-8, Text::default);
    let check = failing.into_check().unwrap();
    assert_eq!(
        (check.at, check.finding.holds.is_some(), check.finding.holds == Some(true)),
        (Some(1), true, false)
    );
}

#[test]
fn what_could_be_checked_nowhere_is_neither_right_nor_wrong() {
    let mut collector = Collector::new(name("name"), name("reason"));
    collector.leave_out(0, name("left out"));
    let check = collector.into_check().unwrap();
    assert_eq!(
        (
            check.finding.holds == Some(true),
            check.finding.holds.is_some(),
            check.finding.failed(),
            check.left_out
        ),
        (false, false, false, 1)
    );
    let mut wide = Collector::new(name("name"), name("reason"));
    wide.offer(0, 0.1, 0.5, || name("wide"));
    let check = wide.into_check().unwrap();
    assert_eq!(
        (
            check.finding.holds == Some(true),
            check.finding.holds.is_some(),
            check.finding.place.to_string().as_str()
        ),
        (false, false, "wide")
    );
}
