//! The linear system works every group, so that a kind without its own equations needs nothing.

use assur_force::LoadState;
use assur_testkit::specimen::Recipe;

use assur_words::Language;

use super::evaluate::{equations, printed, recomputes};
use super::fixtures::scene;
use super::{compiled, forces_agree};
use crate::{PositionOrSample, Task, Working};

fn generally(
    linkage: &assur_kinematics::Linkage,
    loads: Option<&assur_force::Loads>,
    index: usize,
) -> Working {
    let state = LoadState::prescribed(&linkage.mechanism, linkage.mechanism.input.coordinate(index));
    Working::by(
        &Task {
            linkage,
            loads,
            state,
            place: PositionOrSample::Position(index),
            drive: None,
            analyzer: None,
        },
        false,
    )
    .unwrap()
}

#[test]
fn random_groups_by_the_linear_system() {
    for seed in 0..8 {
        let Some(specimen) = Recipe::of(3).specimen(seed) else { continue };
        let (linkage, loads) = compiled(specimen.mechanism);
        let what = format!("seed {seed}");
        let working = generally(&linkage, loads.as_ref(), 1);
        assert_eq!(working.general, vec![0, 1, 2], "{what}");
        recomputes(&what, &working.text(Language::english()));
        if let Some(loads) = &loads {
            forces_agree(&what, &linkage, loads, 1, &working);
        }
    }
}

#[test]
fn both_sides_of_each_equation_agree() {
    let (linkage, loads) = compiled(scene("slider-crank"));
    let text = generally(&linkage, loads.as_ref(), 3).text(Language::english());
    let all = equations(&text);
    let value = |name: &str| {
        let row = all.iter().find(|parts| parts[0] == name).unwrap_or_else(|| panic!("no {name} in\n{text}"));
        printed(row.last().unwrap())
    };
    for (left, right) in [
        ("x_B_rod", "x_B_piston"),
        ("y′_B_rod", "y′_B_piston"),
        ("y″_B_rod", "y″_B_piston"),
        ("b_1_left_piston_ground", "b_1_right_piston_ground"),
        ("b_2_left_piston_ground", "b_2_right_piston_ground"),
    ] {
        let ((a, half), (b, other)) = (value(left), value(right));
        assert!((a - b).abs() <= 2.0 * (half + other), "{left} {a}, {right} {b}");
    }
    // Equilibrium: the reactions carry the opposite of the loads.
    assert!((value("R_X_rod").0 + value("X_rod").0).abs() < 1e-2);
    assert!((value("R_Y_rod").0 + value("Y_rod").0).abs() < 1e-2);
}
