//! The study of a mechanism with a group that is found by iteration, against the known figures of a simpler one.

use std::ops::ControlFlow;

use assur_all as _;
use assur_group::PairSort::Pin;
use assur_group::{Pattern, inventory};
use assur_report::text::{Style, told};
use assur_study::stability::{DISTANCES, Stability, stability};
use assur_testkit::iterated;

// A ternary link on three binary ones.
inventory::submit! {
    iterated("triad", Pattern {
        links: 4,
        inner: &[([0, 1], Pin), ([0, 2], Pin), ([0, 3], Pin)],
        outer: &[(1, Pin), (2, Pin), (3, Pin)],
    })
}

/// A plate on two parallel struts of length 3, which moves without turning: every point of it moves on a circle of radius 3.
/// B, half a meter below the pins of the struts, does so about (4, 0), so that it moves as in the four-bar with the lengths
/// 1, 3.5, 3 and 4 on the ground.
const PLATE_ON_STRUTS: &str = r#"
    [ground]
    points = { O = [0, 0], C = [4, 0.5], D = [5, 1] }
    [link.crank]
    points = { O = 0, A = 1 }
    [link.rod]
    points = { A = 0, B = 3.5 }
    [link.plate]
    points = { B = [0, 0], E = [0, 0.5], F = [1, 1] }
    [link.strut]
    points = { C = 0, E = 3 }
    [link.brace]
    points = { D = 0, F = 3 }
    [input]
    link = "crank"
    from = "90 deg"
    [assembly]
    B = [3, 2.8]
    E = [3, 3.3]
    F = [4, 3.8]
"#;

fn studied(text: &str) -> Stability {
    let mechanism = assur_scene::read("scene.toml", text).expect("a scene");
    match stability(mechanism, &mut |_, _| ControlFlow::Continue(())) {
        ControlFlow::Continue(found) => found.expect("a study"),
        ControlFlow::Break(()) => panic!("nobody stops it"),
    }
}

#[test]
fn a_group_that_is_found_by_iteration_keeps_its_bounds_and_margins() {
    let found = studied(PLATE_ON_STRUTS);
    let text = told(Style::english(), |page| found.tell(page));
    assert!(found.is_ok(), "{text}");
    assert_eq!(found.groups.len(), 1);
    for distance in DISTANCES {
        let rows = found
            .rows
            .iter()
            .filter(|row| row.distance.total_cmp(&distance).is_eq() && row.finding.number().is_some());
        assert!(rows.count() >= 4, "{distance}: {text}");
    }
    // The crank turns fully while 4 + 1 <= rod + 3 (Grashof).
    let rod = found.lengths.iter().find(|margin| margin.length.to_string().starts_with("rod")).unwrap();
    assert!((rod.decrease.unwrap() - 1.5).abs() < 1e-6, "{rod:?}");
}
