//! The plan is obeyed, and failures are told.

use crate::results::Analysis;
use assur_all as _;

use crate::{AnalysisError, Calculation, Coverage, Options, unwatched};

mod forces;
mod jumps;
mod watched;

fn text(name: &str) -> String {
    assur_fixtures::scene(name).to_owned()
}

fn study(text: &str) -> Result<Calculation, AnalysisError> {
    Calculation::of(assur_scene::read("test", text).unwrap(), &Options::default(), &mut unwatched)
}

fn analyzed(text: &str) -> Analysis {
    study(text).unwrap().analyze(&mut unwatched).unwrap()
}

#[test]
fn a_limited_scene_tells_the_same_numbers() {
    let (whole, part) =
        (analyzed(&text("shaper")), analyzed(&(text("shaper") + "\n[output]\nlinks = [\"rocker\"]\n")));
    assert_eq!(part.positions.len(), whole.positions.len());
    for (a, b) in part.positions.iter().zip(&whole.positions) {
        assert_eq!(a.links.get("rocker"), b.links.get("rocker"));
        assert_eq!((a.links.len(), a.points.len(), a.condition.len()), (1, 0, 1));
    }
}

#[test]
fn a_group_that_is_not_needed_may_be_impossible() {
    // The second dyad is far too short to reach its pin on the ground.
    let impossible = "[ground]\npoints = { O = [0, 0], C = [3, 0], F = [90, 0] }\n\
        [link.crank]\npoints = { O = 0, A = 1 }\n[link.coupler]\npoints = { A = 0, B = 3 }\n\
        [link.rocker]\npoints = { C = 0, B = 2, D = 1 }\n[link.rod]\npoints = { D = 0, E = 1 }\n\
        [link.arm]\npoints = { F = 0, E = 1 }\n[input]\nlink = \"crank\"\n";
    let whole = analyzed(impossible);
    assert_eq!((whole.positions.len(), whole.failures.len()), (0, 12));
    assert!(
        whole.failures[3].message.contains("position 3, coordinate 90.0000 deg: no assembly"),
        "{}",
        whole.failures[3].message
    );
    let part = analyzed(&format!("{impossible}[output]\npoints = [\"B\"]\n"));
    assert_eq!((part.positions.len(), part.failures.len()), (12, 0));
    for position in &part.positions {
        // |AB| = 3 and |CB| = 2 whatever the position.
        let b = position.points.get("B").unwrap().pf0;
        let a = [position.coordinate.cos(), position.coordinate.sin()];
        assert!(((b[0] - a[0]).hypot(b[1] - a[1]) - 3.0).abs() < 1e-14);
        assert!(((b[0] - 3.0).hypot(b[1]) - 2.0).abs() < 1e-14);
    }
}

#[test]
fn angles_follow_the_links_over_far_positions() {
    // A parallelogram turns with its crank: three positions over three turns are a turn apart.
    let scene = "[ground]\npoints = { O = [0, 0], C = [3, 0] }\n[link.crank]\npoints = { O = 0, A = 1 }\n\
        [link.coupler]\npoints = { A = 0, B = 3 }\n[link.rocker]\npoints = { C = 0, B = 1 }\n\
        [input]\nlink = \"crank\"\nfrom = 2\ncycle = \"1080 deg\"\npositions = 3\n\
        [assembly]\nB = [2.6, 0.9]\n";
    let found = analyzed(scene);
    for (i, position) in found.positions.iter().enumerate() {
        for link in ["crank", "rocker"] {
            let angle = position.links.get(link).unwrap().pf0;
            assert!((angle - (2.0 + i as f64 * std::f64::consts::TAU)).abs() < 1e-9, "{link} {i}: {angle}");
        }
        assert!(position.links.get("coupler").unwrap().pf0.abs() < 1e-9);
    }
}

#[test]
fn the_first_angle_lies_in_the_first_turn() {
    let scene = text("shaper").replace("positions = 48", "positions = 48\nfrom = \"180 deg\"");
    let found = analyzed(&scene);
    assert!((found.positions[0].links.get("crank").unwrap().pf0 - std::f64::consts::PI).abs() < 1e-15);
    let turned = analyzed(&text("shaper").replace("positions = 48", "positions = 48\nfrom = \"200 deg\""));
    assert!((turned.positions[0].links.get("crank").unwrap().pf0 + 160_f64.to_radians()).abs() < 1e-14);
}

#[test]
fn the_force_at_its_offset_does_what_force_and_moment_do() {
    for position in &analyzed(&text("guide-shaper")).positions {
        for (name, reaction) in position.reactions.as_ref().unwrap().iter() {
            let Some(moment) = reaction.moment else { continue };
            let force = reaction.forces[0].1;
            let modulus = force[0].hypot(force[1]);
            // A slide pushes across its guide, so the arm of the force is the offset itself.
            if let Some(offset) = reaction.offset {
                assert!(((offset * modulus).abs() - moment.abs()).abs() < 1e-9 * modulus, "{name}");
            }
        }
    }
}

#[test]
fn forces_of_a_pair_sum_to_zero() {
    for scene in ["shaper", "conveyor", "stephenson3"] {
        for position in &analyzed(&text(scene)).positions {
            for (name, reaction) in position.reactions.as_ref().unwrap().iter() {
                for axis in 0..2 {
                    let parts = reaction.forces.iter().map(|(_, force)| force[axis]);
                    let largest = parts.clone().fold(1.0, |a: f64, b| a.max(b.abs()));
                    assert!(parts.sum::<f64>().abs() < 1e-12 * largest, "{scene}: {name}");
                }
            }
        }
    }
}

#[test]
fn checks_hold_and_belong_to_the_whole() {
    let study_whole = study(&text("shaper")).unwrap();
    let checks = study_whole.checks(Coverage::Sample, &mut unwatched).unwrap();
    assert!(checks.len() > 5 && checks.iter().all(|check| check.ok));
    assert!(
        study(&(text("shaper") + "\n[output]\nlinks = [\"rocker\"]\n"))
            .unwrap()
            .checks(Coverage::Sample, &mut unwatched)
            .unwrap()
            .is_empty()
    );
}

#[test]
fn an_unknown_analyzer_is_refused() {
    let mechanism = assur_scene::read("test", &text("shaper")).unwrap();
    let options = Options { analyzer: Some("magic".to_owned()), integrator: None };
    assert!(matches!(Calculation::of(mechanism, &options, &mut unwatched), Err(AnalysisError::Analyzer(_))));
}

#[test]
fn a_position_on_a_change_point_is_told() {
    let scene = "[ground]\npoints = { O = [0, 0], C = [3, 0] }\n[link.crank]\npoints = { O = 0, A = 1 }\n\
        [link.coupler]\npoints = { A = 0, B = 3 }\n[link.rocker]\npoints = { C = 0, B = 1 }\n\
        [input]\nlink = \"crank\"\nfrom = \"30 deg\"\npositions = 12\n[assembly]\nB = [3.9, 0.5]\n";
    let notes = analyzed(scene).notes;
    assert_eq!(notes.len(), 1);
    // 30 deg apart from 30 deg: position 5 at 180 deg, position 11 at 360 deg.
    for part in
        ["180.0000 deg (group 1 (RRR coupler, rocker))", "0.0000 deg (group", "In positions 5, 11 the"]
    {
        assert!(notes[0].contains(part), "{part}: {}", notes[0]);
    }
    let between = analyzed(&scene.replace("30 deg", "40 deg")).notes;
    assert!(between[0].contains("Change points") && !between[0].contains("positions"), "{between:?}");
    let far = analyzed(&scene.replace("positions = 12", "to = \"120 deg\"")).notes;
    assert!(far.is_empty(), "{far:?}");
}

/// The published longitudinal form has its pole at infinity where the motion begins: no change point, and not told as one.
#[test]
fn samples_without_forces_say_why() {
    let scene = "gravity = 9.81\n[ground]\npoints = { O = [0, 0] }\n[link.crank]\npoints = { O = 0, A = 1 }\n\
        mass = 1\ncenter = \"O\"\ninertia = 1\n[link.rod]\npoints = { A = 0, B = 4 }\nmass = 2\ncenter = 2\n\
        [link.slider]\npoints = { B = 0 }\n[[slide]]\nlink = \"slider\"\non = \"ground\"\n\
        [input]\nlink = \"crank\"\nfrom = \"90 deg\"\n[motion]\nkind = \"transient\"\nspeed = 1\nuntil = \"1 s\"\n";
    let options = Options { analyzer: Some("longitudinal-published".to_owned()), integrator: None };
    let mechanism = assur_scene::read("test", scene).unwrap();
    let found =
        Calculation::of(mechanism, &options, &mut unwatched).unwrap().analyze(&mut unwatched).unwrap();
    assert!(found.trajectory[0].balancing.is_none() && found.trajectory[1].balancing.is_some());
    let note = found.notes.iter().find(|note| note.contains("No forces")).unwrap();
    assert!(note.starts_with("No forces at 1 sample of the motion; at the first: "), "{note}");
    assert!(!note.contains("change point"), "{note}");
}

/// 200 + 400 = 350 + 250 mm: the ways meet once in a turn, so that the cycle is two turns with one place in both.
#[test]
fn a_change_point_of_both_turns_is_told_once() {
    let scene = "[ground]\npoints = { O = [0, 0], C = [\"400 mm\", 0] }\n\
        [link.crank]\npoints = { O = 0, A = \"200 mm\" }\n\
        [link.coupler]\npoints = { A = 0, B = \"350 mm\" }\n\
        [link.rocker]\npoints = { C = 0, B = \"250 mm\" }\n[input]\nlink = \"crank\"\npositions = 24\n";
    let notes = analyzed(scene).notes;
    assert_eq!(notes[0].matches("180.0000 deg").count(), 1, "{notes:?}");
    assert!(notes[0].contains("180.0000 deg (group 1 (RRR coupler, rocker)). "), "{notes:?}");
    assert!(notes[0].contains(" In position 12 the equations"), "{notes:?}");
}

/// Stones on the crank's guide and on the ground's share a pin: it is at infinity where the crank is parallel to the ground.
#[test]
fn a_way_through_infinity_is_told() {
    let scene = "[ground]\npoints = { O = [0, 0] }\n[link.crank]\npoints = { O = 0 }\n\
        [link.stone1]\npoints = { P = 0 }\n[link.stone2]\npoints = { P = 0 }\n\
        [[slide]]\nlink = \"stone1\"\non = \"crank\"\nthrough = [0, 0.3]\n\
        [[slide]]\nlink = \"stone2\"\non = \"ground\"\nthrough = [0, 0.5]\n\
        [input]\nlink = \"crank\"\nfrom = \"15 deg\"\n";
    let notes = analyzed(scene).notes;
    assert_eq!(notes.len(), 1, "{notes:?}");
    assert!(
        notes[0].contains("infinity")
            && notes[0].contains("180.0000 deg")
            && notes[0].contains(" 0.0000 deg")
    );
    // Where the turn begins at one of them, it is the same place again at its end.
    let seam = analyzed(&scene.replace("15 deg", "0 deg")).notes;
    assert_eq!(seam[0].matches(" 0.0000 deg").count(), 1, "{seam:?}");
    // Both guides through O: the pin stays there, also where they lie on each other.
    let harmless = scene.replace("[0, 0.3]", "[0, 0]").replace("[0, 0.5]", "[0, 0]");
    assert!(analyzed(&harmless).notes.is_empty());
}

#[test]
fn positions_behind_a_gap_that_none_falls_into_are_told() {
    // The crank is a nanometer longer than the rod: 5.7 thousandths of a degree on both sides of 90 and 270 degrees.
    let scene = "[ground]\npoints = { O = 0 }\n[link.crank]\npoints = { O = 0, A = 0.200000001 }\n\
        [link.rod]\npoints = { A = 0, B = 0.2 }\n[link.slider]\npoints = { B = 0 }\n\
        [[slide]]\nlink = \"slider\"\non = \"ground\"\n[input]\nlink = \"crank\"\nfrom = \"10 deg\"\npositions = 12\n";
    let found = analyzed(scene);
    assert!(found.failures.is_empty());
    let [note] = &found.notes[..] else { panic!("{:?}", found.notes) };
    // 30 deg apart from 10 deg: position 3 stands at 100 deg, position 8 at 250, position 9 at 280, which is -80.
    let parts = [
        "Behind 89.994",
        "group 1 (RRP rod, slider)",
        "Positions 3 to 8 are places",
        "Positions 9 to 11 are reached by",
    ];
    for part in parts {
        assert!(note.contains(part), "{part}: {note}");
    }
    assert!(analyzed(&scene.replace("0.200000001", "0.199999999")).notes.is_empty());
}

/// A piston alone has mass, so that the machine has no inertia where it turns back.
#[test]
fn a_regime_that_is_not_finite_is_no_motion() {
    let scene = "[ground]\npoints = { O = 0 }\n[link.crank]\npoints = { O = 0, A = 0.1 }\n[link.rod]\npoints = { A = 0, B = 0.4 }\n\
        [link.piston]\npoints = { B = 0 }\nmass = 1\n[[slide]]\nlink = \"piston\"\non = \"ground\"\n\
        [input]\nlink = \"crank\"\nfrom = \"START\"\n[motion]\nkind = \"steady\"\nmean_speed = 10\n";
    for start in ["0 deg", "30 deg", "-77 deg"] {
        let found = analyzed(&scene.replace("START", start));
        assert!(found.no_motion.is_some() && found.dynamics.is_none(), "{start}");
        assert_eq!(found.positions.len(), 12, "{start}: what does not depend on the motion is calculated");
    }
}
