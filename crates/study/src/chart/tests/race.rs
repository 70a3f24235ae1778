//! How rows are measured.

use std::cell::RefCell;
use std::ops::ControlFlow;

use assur_words::Text;

use super::scenes::{shipped, ticks};
use crate::chart::race::{Entry, Field, Verdict};
use crate::chart::race::{Judge, STOPPED, median};
use crate::chart::{ChartOptions, Measurement, Progress, Reference, Setting, Stage, chart};

/// Takes the times of its list in turn, and notes each run.
fn slow<'a>(name: char, times: Vec<f64>, now: &'a RefCell<f64>, log: &'a RefCell<String>) -> Entry<'a> {
    let mut next = 0;
    Entry::run(Measurement::new(Stage::Motion, "slow", Setting::default()), move |_| {
        *now.borrow_mut() += times[next % times.len()];
        next += 1;
        log.borrow_mut().push(name);
        Verdict { evaluations: Some(7), error: Some(1e-9), failure: None }
    })
}

#[test]
fn methods_take_turns_and_the_median_counts() {
    let (now, log) = (RefCell::new(0.0), RefCell::new(String::new()));
    // The first of "a" is disturbed once: the median does not see it.
    let entries = vec![
        slow('a', vec![0.9, 0.1, 0.1, 0.1, 0.1], &now, &log),
        Entry { units: 2.0, ..slow('b', vec![0.2], &now, &log) },
    ];
    let field = Field { reference: Reference { how: Text::default(), error: 1e-12 }, entries };
    let options = ChartOptions { stage_seconds: 7.2, rounds: 4, ..ChartOptions::THOROUGH };
    let mut go_on = |_: Progress| ControlFlow::Continue(());
    let mut clock = || *now.borrow();
    let mut judge = Judge { clock: &mut clock, options, progress: &mut go_on, start: 0.0, stopped: false };
    let rows = judge.race(Stage::Motion, field);
    assert_eq!(*log.borrow(), "abababababab"[..10].to_owned());
    assert!((rows[0].seconds.unwrap() - 0.1).abs() < 1e-12, "{rows:?}");
    // The middle one of 0.8, 0, 0, 0, 0 would be none; three parts in a hundred are assumed.
    assert!((rows[0].noise.unwrap() - 0.003).abs() < 1e-12, "{rows:?}");
    // Two units of work in one run.
    assert!((rows[1].seconds.unwrap() - 0.1).abs() < 1e-12, "{rows:?}");
    assert!(rows.iter().all(|row| row.ok && row.evaluations == Some(7) && !row.at_most));
}

#[test]
fn the_noise_is_the_median_deviation_from_the_median() {
    let (now, log) = (RefCell::new(0.0), RefCell::new(String::new()));
    // The first run is judged and counts as one timing.
    let times = vec![0.10, 0.13, 0.12, 0.16, 0.30];
    let entry = Entry { units: 2.0, ..slow('a', times, &now, &log) };
    let field = Field { reference: Reference { how: Text::default(), error: 1e-12 }, entries: vec![entry] };
    let options = ChartOptions { stage_seconds: 1.0, rounds: 4, ..ChartOptions::THOROUGH };
    let mut go_on = |_: Progress| ControlFlow::Continue(());
    let mut clock = || *now.borrow();
    let mut judge = Judge { clock: &mut clock, options, progress: &mut go_on, start: 0.0, stopped: false };
    let rows = judge.race(Stage::Motion, field);
    assert_eq!(log.borrow().len(), 5);
    // Median 0.13; the others are off by 0.03, 0.01, 0.03, 0.17.
    assert!((rows[0].seconds.unwrap() - 0.065).abs() < 1e-12, "{rows:?}");
    assert!((rows[0].noise.unwrap() - 0.015).abs() < 1e-12, "{rows:?}");
}

#[test]
fn an_error_below_the_reference_is_told_as_its_estimate() {
    let (now, log) = (RefCell::new(0.0), RefCell::new(String::new()));
    let entry = slow('a', vec![0.1], &now, &log);
    let field = Field { reference: Reference { how: Text::default(), error: 1e-6 }, entries: vec![entry] };
    let mut go_on = |_: Progress| ControlFlow::Continue(());
    let mut clock = || *now.borrow();
    let mut judge = Judge {
        clock: &mut clock,
        options: ChartOptions::QUICK,
        progress: &mut go_on,
        start: 0.0,
        stopped: false,
    };
    let rows = judge.race(Stage::Motion, field);
    assert!(rows[0].at_most);
    assert!((rows[0].error.unwrap() - 1e-6).abs() < 1e-20);
}

#[test]
fn what_was_measured_before_a_stop_is_kept() {
    let mut calls = 0;
    let mut stop_at_ten = |_: Progress| {
        calls += 1;
        if calls > 10 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let data = chart(&shipped("shaper"), &mut ticks(), ChartOptions::THOROUGH, &mut stop_at_ten).unwrap();
    assert!(!data.complete);
    let measured = data.rows.iter().filter(|row| row.ok && row.seconds.is_some()).count();
    assert_eq!(measured, 10);
    assert!(data.rows.iter().any(|row| row.reason.as_ref() == Some(&STOPPED)));
}

#[test]
fn the_median() {
    assert_eq!(median(vec![]), None);
    assert_eq!(median(vec![3.0, 1.0, 2.0]), Some(2.0));
    assert_eq!(median(vec![4.0, 1.0, 2.0, 3.0]), Some(2.5));
}
