//! Calculations that are watched: the same numbers, a count that is right, and an end where it is asked for.

use std::ops::ControlFlow;

use super::{study, text};
use crate::{AnalysisError, Calculation, Coverage, Options, Progress, Stopped, unwatched};

#[test]
fn watching_changes_no_number() {
    for name in ["shaper", "shaper-drive", "brake"] {
        let plain = study(&text(name)).unwrap();
        let mut go_on = |_: Progress| ControlFlow::Continue(());
        let mechanism = assur_scene::read("test", &text(name)).unwrap();
        let watched = Calculation::of(mechanism, &Options::default(), &mut go_on).unwrap();
        assert_eq!(watched.analyze(&mut go_on), plain.analyze(&mut unwatched), "{name}");
        assert_eq!(
            watched.checks(Coverage::Sample, &mut go_on),
            plain.checks(Coverage::Sample, &mut unwatched),
            "{name}"
        );
    }
}

#[test]
fn every_position_is_told_once() {
    let mut told = Vec::new();
    let mut watch = |progress: Progress| {
        if let Progress::Positions { done, total } = progress {
            told.push((done, total));
        }
        ControlFlow::Continue(())
    };
    assert!(study(&text("shaper")).unwrap().analyze(&mut watch).is_ok());
    assert_eq!(told, (0..48).map(|done| (done, 48)).collect::<Vec<_>>());
}

#[test]
fn an_analysis_ends_at_the_piece_where_it_is_stopped() {
    let shaper = study(&text("shaper")).unwrap();
    for last in [0, 7, 47] {
        let mut calls = 0;
        let mut watch = |_: Progress| {
            calls += 1;
            if calls > last { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        assert_eq!(shaper.analyze(&mut watch), Err(Stopped));
        assert_eq!(calls, last + 1);
        calls = 0;
        let mut watch = |_: Progress| {
            calls += 1;
            if calls > last { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        assert_eq!(shaper.checks(Coverage::Sample, &mut watch), Err(Stopped));
        assert_eq!(calls, last + 1);
    }
}

#[test]
fn a_motion_and_a_regime_are_stopped() {
    // `andrews` is integrated by steps, `shaper-drive` has a regime that is searched.
    for name in ["andrews", "shaper-drive"] {
        let mechanism = assur_scene::read("test", &text(name)).unwrap();
        let mut calls = 0;
        let mut watch = |_: Progress| {
            calls += 1;
            if calls > 20 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let error = Calculation::of(mechanism, &Options::default(), &mut watch).unwrap_err();
        assert_eq!(error, AnalysisError::Stopped(Stopped), "{name}");
        assert!(calls < 500, "{name}: {calls} more calls");
    }
}
