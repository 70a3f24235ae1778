//! Calculations that are watched: the same numbers, a count that is right, and an end where it is asked for.

use std::ops::ControlFlow;

use super::{study, text};
use crate::progress::Watch;
use crate::results::{Column, Part, Quantity, Table};
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

/// The shaper with so many positions that they are several pieces of work.
fn many() -> Calculation {
    study(&text("shaper").replace("positions = 48", "positions = 65_536")).unwrap()
}

#[test]
fn the_count_of_positions_grows_to_the_total() {
    let mut counts = Vec::new();
    let mut watch = |progress: Progress| {
        if let Progress::Positions { done, total } = progress {
            counts.push((done, total));
        }
        ControlFlow::Continue(())
    };
    assert!(many().analyze(&mut watch).is_ok());
    assert!(counts.len() > 1 && counts[0] == (0, 65_536), "{counts:?}");
    assert!(counts.windows(2).all(|two| two[0].0 < two[1].0 && two[1].0 < 65_536), "{counts:?}");
}

#[test]
fn an_analysis_ends_at_the_piece_where_it_is_stopped() {
    let (many, shaper) = (many(), study(&text("shaper")).unwrap());
    let stopped_at = |last: usize, work: &dyn Fn(&mut Watch<'_>) -> bool| {
        let mut calls = 0;
        let mut watch = |_: Progress| {
            calls += 1;
            if calls > last { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        assert!(work(&mut watch));
        assert_eq!(calls, last + 1);
    };
    for last in [0, 1] {
        stopped_at(last, &|watch| many.analyze(watch) == Err(Stopped));
    }
    for last in [0, 7, 47] {
        stopped_at(last, &|watch| shaper.checks(Coverage::Sample, watch) == Err(Stopped));
    }
}

#[test]
fn blocks_have_the_numbers_of_single_positions() {
    // Every 1024th position is one of 64; angles follow over the blocks.
    let scene = |positions: usize| {
        study(&text("shaper").replace("positions = 48", &format!("positions = {positions}"))).unwrap()
    };
    let (many, few) = (scene(65_536), scene(64));
    let [found, wanted] = [&many, &few].map(|study| study.analyze(&mut unwatched).unwrap());
    assert!(
        !found.is_complete() && found.positions.len() <= assur_mechanism::MOST_KEPT && wanted.is_complete()
    );
    let (mut rows, mut compared) = (0, 0);
    let is_force = |column: &Column| column.quantity == Quantity::Force && column.part == Part::X;
    let forces = found.positions.schema().select(is_force);
    let mut sizes: Vec<Vec<f64>> = vec![Vec::new(); forces.len()];
    let done = many.each_block(&found, &mut unwatched, Table::clone, |table| {
        assert_eq!(table.numbers().first(), Some(&rows));
        rows += table.len();
        for (row, number) in table.numbers().iter().enumerate().filter(|(_, number)| **number % 1024 == 0) {
            for column in table.schema().columns() {
                let same = wanted.positions.get(number / 1024, *column);
                assert_eq!(table.get(row, *column), same, "{column:?} in {number}");
                compared += 1;
            }
        }
        for (sizes, x) in sizes.iter_mut().zip(&forces) {
            sizes.extend(table.values(*x).iter().zip(table.values(x + 1)).map(|(x, y)| x.hypot(*y)));
        }
        Ok::<_, ()>(())
    });
    assert_eq!((done, rows), (Ok(Ok(())), 65_536));
    assert_eq!(compared, 64 * wanted.positions.schema().columns().len());
    assert_eq!(found.survey.rows, 65_536);
    assert_eq!(found.cycle.reaction_extremes.len(), sizes.len());
    for (own, sizes) in found.cycle.reaction_extremes.iter().zip(&sizes) {
        let greatest = sizes.iter().copied().fold(0.0, f64::max);
        let mean = sizes.iter().map(|size| size * size).sum::<f64>() / sizes.len() as f64;
        assert!(
            (own.greatest - greatest).abs() <= 0.0 && (own.rms - mean.sqrt()).abs() <= 1e-12 * own.rms,
            "{own:?}"
        );
        assert!((sizes[own.index] - greatest).abs() <= 1e-9 * greatest);
    }
    assert_eq!(found.cycle.sign_changes.len(), wanted.cycle.sign_changes.len());
    for ((_, own), (_, other)) in found.cycle.sign_changes.iter().zip(wanted.cycle.sign_changes.iter()) {
        for (own, other) in own.iter().zip(other) {
            assert!((own.coordinate - other.coordinate).abs() < 1e-9);
            assert!(own.jump || own.before * own.after < 0.0);
            let position = many.linkage.mechanism.input.coordinate(own.after_index);
            assert!(own.coordinate >= position && own.coordinate - position < 1.6e-4);
        }
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

#[test]
fn of_a_large_mechanism_fewer_positions_are_kept() {
    let points = (0..400).fold(String::new(), |text, i| text + &format!(", P{i} = [0.1, 0.{i:03}]"));
    let scene = format!(
        "[ground]\npoints = {{ O = 0 }}\n[link.crank]\npoints = {{ O = 0{points} }}\n[input]\nlink = \"crank\"\npositions = 4096\n"
    );
    let large = study(&scene).unwrap();
    let found = large.analyze(&mut unwatched).unwrap();
    // Ground, crank and 401 points in 4096 positions are twice of what is kept.
    assert!(!found.is_complete());
    assert_eq!(found.positions.len(), 4096_usize.div_ceil(3));
    assert!(found.positions.len() * large.linkage.mechanism.parts() <= assur_mechanism::MOST_PARTS_KEPT);
}
