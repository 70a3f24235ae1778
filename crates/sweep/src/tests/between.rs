//! What a sweep finds between the positions, against reports and against very many positions.

use assur_analysis::results::{Column, Owner, Part, Quantity};
use assur_analysis::{Calculation, Options, unwatched};
use assur_fixtures::SCENES;
use assur_report::csv::CsvCell;

use super::{numbers, requested, rows};
use crate::{Measure, Rows, SweepRequest};

/// A row of a scene with so many positions.
fn row(scene: &str, positions: usize, between: bool, measures: &[&str]) -> Rows {
    let measures = Measure::named(measures).unwrap();
    let request = SweepRequest { measures, between, ..SweepRequest::default() };
    rows(&requested(scene, &[&format!("input.positions={positions}..{positions}:1")], request).unwrap(), 1)
}

/// The shipped scenes that state how many positions they have.
pub(super) fn scenes() -> impl Iterator<Item = (&'static str, &'static str, usize)> {
    SCENES.iter().filter_map(|(name, text)| {
        let mechanism = assur_scene::read(name, text).unwrap();
        text.contains("\npositions").then_some((*name, *text, mechanism.input.positions))
    })
}

#[test]
fn a_sweep_between_positions_and_a_report_say_the_same() {
    let mut compared = 0;
    for (name, scene, positions) in scenes() {
        let table = row(scene, positions, true, &["balancing", "balancing-rms", "reactions"]);
        let mechanism = assur_scene::read(name, scene).unwrap();
        let calculation = Calculation::of(mechanism, &Options::default(), &mut unwatched).unwrap();
        let analysis = calculation.analyze(&mut unwatched).unwrap();
        let edges = calculation.edges(&analysis.positions);
        let peaks = assur_book::peaks(&calculation, &analysis.positions, &edges);
        let schema = analysis.positions.schema();
        let mut same = |column: &str, known: f64| {
            let Some(column) = table.columns.names.iter().position(|head| head == column) else { return };
            // A report has no numbers of a mechanism that can't be assembled everywhere, and a sweep has none.
            let CsvCell::Number(found) = table.cell(0, column) else { return };
            let head = &table.columns.names[column];
            assert!(
                (found - known).abs() <= 1e-9 * known.abs(),
                "{name}: {head} is {found}, {known} in a report"
            );
            compared += 1;
        };
        let unit = if schema.balances_by_moment { "Nm" } else { "N" };
        for (column, turn) in &peaks.farthest {
            let of = schema.name(column.owner);
            match column.quantity {
                Quantity::Balancing => same(&format!("balancing_greatest_{unit}"), turn.value.abs()),
                Quantity::Moment => same(&format!("reaction_{of}_moment_greatest_Nm"), turn.value.abs()),
                Quantity::Force => {
                    let Owner::PairOn(pair, _) = column.owner else { continue };
                    let is_pair = |of: &Column| matches!(of.owner, Owner::PairOn(own, _) if own == pair);
                    let of_pair =
                        peaks.farthest.iter().filter(|(of, _)| of.part == Part::Modulus && is_pair(of));
                    let most = of_pair.map(|(_, turn)| turn.value).fold(0.0, f64::max);
                    same(&format!("reaction_{of}_greatest_N"), most);
                }
                _ => {}
            }
        }
        if let Some(means) = peaks.balancing {
            // What is zero but for rounding has no digits to compare.
            if means.mean.abs() > 1e-6 * means.rms {
                same(&format!("balancing_mean_{unit}"), means.mean);
            }
            same(&format!("balancing_rms_{unit}"), means.rms);
        }
    }
    assert!(compared > 100, "{compared}");
}

/// The sampled greatest value is below the true one by less than the square of a step.
#[test]
fn what_is_found_between_positions_is_the_limit_of_more_and_more_positions() {
    const DENSE: usize = 2880;
    /// Of a place or an angle that is zero, m or rad: mechanisms have the size of some meters.
    const ROUNDING: f64 = 1e-12;
    let mut compared = 0;
    // Forty four-bars have a thousand columns, each of which is searched by itself; two of them have the same kinds.
    for (name, scene, positions) in scenes().filter(|(name, ..)| *name != "n-four-bar-40") {
        let is_cycle = assur_scene::read(name, scene).unwrap().input.is_cycle();
        let measures = ["default", "balancing-rms", "reaction-rms", "transmission", "extremes"];
        let [found, dense] =
            [(positions, true), (DENSE, false)].map(|(count, between)| row(scene, count, between, &measures));
        assert_eq!(found.columns.names, dense.columns.names, "{name}");
        for (column, head) in found.columns.names.iter().enumerate().skip(2) {
            let cells = [&found, &dense].map(|table| match table.cell(0, column) {
                CsvCell::Number(number) => number,
                _ => f64::NAN,
            });
            let [exact, sampled] = cells;
            let size = exact.abs().max(sampled.abs());
            let (is_least, is_greatest) = (
                head.contains("_min_") || head.contains("least_") || head.contains("smallest"),
                head.contains("_max_") || head.contains("greatest_"),
            );
            // A place of an extreme is not unique, and a mean of samples counts both ends of a part of a cycle whole.
            let is_mean = head.contains("mean_") || head.contains("_rms_");
            if head.contains("_at_") || is_mean && !is_cycle || cells.iter().any(|cell| cell.is_nan()) {
                continue;
            }
            let over = if is_least { sampled - exact } else { exact - sampled };
            // Neighbors on a curve that differ by 1e-9 of its greatest value are equal, and some such steps add up.
            let least = if is_least || is_greatest { -1e-8 } else { -5e-3 };
            // A mean may be zero.
            let is_mean = head.starts_with("balancing_mean_");
            let scale = if is_mean {
                numbers(&found, &head.replace("mean_modulus", "mean").replace("mean", "greatest"))[0]
            } else {
                size
            };
            assert!(
                over >= least * scale - ROUNDING && over <= 5e-3 * scale + ROUNDING,
                "{name}: {head} is {exact}, sampled {sampled}"
            );
            compared += 1;
        }
    }
    assert!(compared > 300, "{compared}");
}

/// Strokes are found from the transfer functions of a part, extremes between positions from the rows of the results.
#[test]
fn a_stroke_is_what_lies_between_the_extremes() {
    let mut compared = 0;
    for (name, scene, positions) in scenes().filter(|(name, ..)| *name != "n-four-bar-40") {
        let table = row(scene, positions, true, &["extremes", "stroke"]);
        let number = |head: String| {
            let column = table.columns.names.iter().position(|name| *name == head)?;
            if let CsvCell::Number(number) = table.cell(0, column) { Some(number) } else { None }
        };
        for (part, unit) in table.columns.names.iter().filter_map(|head| head.rsplit_once("_stroke_")) {
            let angle = if unit == "rad" { "_angle" } else { "" };
            let [max, min] = ["max", "min"].map(|end| number(format!("{part}{angle}_{end}_{unit}")));
            let stroke = number(format!("{part}_stroke_{unit}"));
            let (Some(stroke), Some(max), Some(min)) = (stroke, max, min) else { continue };
            // What is smaller than 1 mm or 1e-3 rad has no more digits than that.
            let miss = (max - min - stroke).abs();
            assert!(miss <= 1e-9 * stroke.max(1e-3), "{name}: {part} {stroke}, from {min} to {max}");
            compared += 1;
        }
    }
    assert!(compared > 30, "{compared}");
}

#[test]
fn every_quantity_of_a_position_can_be_measured() {
    let scene = assur_fixtures::scene("shaper");
    let table = row(scene, 48, false, &["positions.reduced", "positions.accelerations"]);
    let mechanism = assur_scene::read("shaper", scene).unwrap();
    let calculation = Calculation::of(mechanism, &Options::default(), &mut unwatched).unwrap();
    let positions = calculation.rows(&mut unwatched).unwrap();
    let moment = Column::of(Quantity::ReducedMoment, Owner::Input);
    let values: Vec<f64> = (0..48).map(|row| positions.get(row, moment).unwrap()).collect();
    let at = |name: &str| numbers(&table, name)[0];
    assert_eq!(
        at("reduced_moment_max_Nm").to_bits(),
        values.iter().copied().fold(f64::MIN, f64::max).to_bits()
    );
    let rms = (values.iter().map(|value| value * value).sum::<f64>() / 48.0).sqrt();
    assert!((at("reduced_moment_rms_Nm") / rms - 1.0).abs() < 1e-12);
    let between = row(scene, 48, true, &["positions.reduced"]);
    assert!(numbers(&between, "reduced_moment_max_Nm")[0] >= at("reduced_moment_max_Nm"));
    assert!(Measure::named(&["positions.none"]).is_err());
}
