//! The working against the equations as printed, and its own proof against the groups.

use assur_force::{LoadState, Loads};
use assur_working::{PositionOrSample, Task, Working};
use assur_worksheet::Entry;

use super::print::{CONSTANT, PRESS};
use super::{compile, fixture};
use crate::Longitudinal;

/// The working of a position by a form of the method.
fn worked(linkage: &assur_kinematics::Linkage, index: usize, form: Longitudinal) -> Working {
    let loads = Loads::compile(linkage).unwrap();
    let state = LoadState::prescribed(&linkage.mechanism, linkage.mechanism.input.coordinate(index));
    let (place, analyzer) = (PositionOrSample::Position(index), Some(form.name()));
    Working::of(&Task { linkage, loads: Some(&loads), state, place, drive: None, analyzer }).unwrap()
}

/// The values of the last lines of each symbol in a section, by the symbol in English.
fn values(working: &Working, section: usize) -> Vec<(String, f64)> {
    let english = assur_words::Language::english();
    let lines = working.sections[section].entries.iter().filter_map(|entry| match entry {
        Entry::Line(line) => Some((line.symbol.plain(english), line.value)),
        _ => None,
    });
    lines.collect()
}

#[test]
fn every_number_of_the_equations_is_that_of_the_print() {
    let linkage = compile(&fixture("press.toml"));
    for index in 0..linkage.mechanism.input.positions {
        let f1 = linkage.mechanism.input.coordinate(index) + std::f64::consts::FRAC_PI_2;
        let printed = PRESS.at(f1, CONSTANT(f1.to_degrees()));
        let working = worked(&linkage, index, Longitudinal::Published);
        let found = values(&working, working.sections.len() - 2);
        for (symbol, wanted) in [
            ("φ_1", f1),
            ("X_2", printed.x2),
            ("Y_2", printed.y2),
            ("X_KP", printed.x2),
            ("Y_KP", printed.y2),
            ("l_AP", printed.ap),
            ("M_c", printed.mc),
            ("M_b", printed.balancing),
            ("F_b", printed.balancing_force),
            ("R_1", printed.r1),
            ("R_3", printed.r3),
            ("R_A", printed.ra),
            ("R_B", printed.r3),
        ] {
            let value = found.iter().find(|(name, _)| name == symbol).unwrap_or_else(|| panic!("{symbol}")).1;
            assert!(
                (value - wanted).abs() <= 1e-10 * wanted.abs().max(0.1),
                "{index} {symbol}: {value} {wanted}"
            );
        }
    }
}

#[test]
fn the_working_is_proved_against_the_groups() {
    let mut compared = 0;
    for name in ["press.toml", "press-compression.toml", "slider-crank.toml", "four-bar.toml"] {
        let linkage = compile(&fixture(name));
        for index in 0..linkage.mechanism.input.positions {
            for form in [Longitudinal::Stable, Longitudinal::Published] {
                let working = worked(&linkage, index, form);
                let last = working.sections.len() - 1;
                let size = working
                    .reactions
                    .iter()
                    .map(|found| found.force[0].value().hypot(found.force[1].value()));
                let size = size.fold(0.0, f64::max);
                let differences = values(&working, last);
                if differences.is_empty() {
                    // Only the published form has positions without a solution.
                    assert_eq!(form, Longitudinal::Published, "{name} {index}");
                    continue;
                }
                assert_eq!(differences.len(), 9, "{name} {index}: four pairs and the balancing moment");
                // Near a pole at infinity the published form loses digits.
                let limit = if form == Longitudinal::Stable { 1e-10 } else { 1e-6 };
                for (symbol, difference) in differences {
                    assert!(difference.abs() <= limit * size, "{name} {index} {symbol}: {difference}");
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 1000, "{compared}");
}
