//! Change points, ways that meet and samples without forces are reported.

use assur_mechanism::Warning;

use super::analyzed;
use crate::results::Column;
use crate::{Calculation, Options, unwatched};

/// What is reported of the results of a scene, without what is probably not meant in it.
fn remarks(scene: &str) -> Vec<Warning> {
    analyzed(scene).warnings.into_iter().filter(|note| !note.is_mistake()).collect()
}

#[test]
fn a_position_on_a_change_point_is_told() {
    let scene = "[ground]\npoints = { O = [0, 0], C = [3, 0] }\n[link.crank]\npoints = { O = 0, A = 1 }\n\
        [link.coupler]\npoints = { A = 0, B = 3 }\n[link.rocker]\npoints = { C = 0, B = 1 }\n\
        [input]\nlink = \"crank\"\nfrom = \"30 deg\"\npositions = 12\n[assembly]\nB = [3.9, 0.5]\n";
    let notes = remarks(scene);
    assert_eq!(notes.len(), 1);
    // 30 deg apart from 30 deg: position 5 at 180 deg, position 11 at 360 deg.
    for part in
        ["180.0000 deg (group 1 (RRR coupler, rocker))", "0.0000 deg (group", "In positions 5, 11 the"]
    {
        assert!(notes[0].to_string().contains(part), "{part}: {}", notes[0]);
    }
    let between = remarks(&scene.replace("30 deg", "40 deg"));
    assert!(
        between[0].to_string().contains("Change points") && !between[0].to_string().contains("positions"),
        "{between:?}"
    );
    let far = remarks(&scene.replace("positions = 12", "to = \"120 deg\""));
    assert!(far.is_empty(), "{far:?}");
}

/// The published longitudinal form has its pole at infinity where the motion begins: no change point, and not told as one.
#[test]
fn samples_without_forces_say_why() {
    let scene = "gravity = 9.81\n[ground]\npoints = { O = [0, 0] }\n[link.crank]\npoints = { O = 0, A = 1 }\n\
        mass = 1\ncenter = \"O\"\ninertia = 1\n[link.rod]\npoints = { A = 0, B = 4 }\nmass = 2\ncenter = 2\n\
        [link.slider]\npoints = { B = 0 }\n[[slide]]\nlink = \"slider\"\non = \"ground\"\n\
        [input]\nlink = \"crank\"\nfrom = \"90 deg\"\n[motion]\nkind = \"transient\"\nspeed = 1\nuntil = \"1 s\"\n";
    let options = Options { analyzer: Some("longitudinal-published".to_owned()), ..Options::default() };
    let mechanism = assur_scene::read("test", scene).unwrap();
    let found =
        Calculation::of(mechanism, &options, &mut unwatched).unwrap().analyze(&mut unwatched).unwrap();
    let balancing = |row| found.trajectory.get(row, Column::BALANCING);
    assert!(balancing(0).is_none() && balancing(1).is_some());
    let note = found.warnings.iter().find(|note| note.to_string().contains("No forces")).unwrap();
    assert!(note.to_string().starts_with("No forces at 1 sample of the motion; at the first: "), "{note}");
    assert!(!note.to_string().contains("change point"), "{note}");
}

/// 200 + 400 = 350 + 250 mm: the ways meet once in a turn, so that the cycle is two turns with one place in both.
#[test]
fn a_change_point_of_both_turns_is_told_once() {
    let scene = "[ground]\npoints = { O = [0, 0], C = [\"400 mm\", 0] }\n\
        [link.crank]\npoints = { O = 0, A = \"200 mm\" }\n\
        [link.coupler]\npoints = { A = 0, B = \"350 mm\" }\n\
        [link.rocker]\npoints = { C = 0, B = \"250 mm\" }\n[input]\nlink = \"crank\"\npositions = 24\n";
    let notes = remarks(scene);
    assert_eq!(notes[0].to_string().matches("180.0000 deg").count(), 1, "{notes:?}");
    assert!(notes[0].to_string().contains("180.0000 deg (group 1 (RRR coupler, rocker)). "), "{notes:?}");
    assert!(notes[0].to_string().contains(" In position 12 the group is singular"), "{notes:?}");
}

/// Stones on the crank's guide and on the ground's share a pin: it is at infinity where the crank is parallel to the ground.
#[test]
fn a_way_through_infinity_is_told() {
    let scene = "[ground]\npoints = { O = [0, 0] }\n[link.crank]\npoints = { O = 0 }\n\
        [link.stone1]\npoints = { P = 0 }\n[link.stone2]\npoints = { P = 0 }\n\
        [[slide]]\nlink = \"stone1\"\non = \"crank\"\nthrough = [0, 0.3]\n\
        [[slide]]\nlink = \"stone2\"\non = \"ground\"\nthrough = [0, 0.5]\n\
        [input]\nlink = \"crank\"\nfrom = \"15 deg\"\n";
    let notes = remarks(scene);
    assert_eq!(notes.len(), 1, "{notes:?}");
    assert!(
        notes[0].to_string().contains("unbounded")
            && notes[0].to_string().contains("180.0000 deg")
            && notes[0].to_string().contains(" 0.0000 deg")
    );
    // Where the turn begins at one of them, it is the same place again at its end.
    let seam = remarks(&scene.replace("15 deg", "0 deg"));
    assert_eq!(seam[0].to_string().matches(" 0.0000 deg").count(), 1, "{seam:?}");
    // Both guides through O: the pin stays there, also where they lie on each other.
    let harmless = scene.replace("[0, 0.3]", "[0, 0]").replace("[0, 0.5]", "[0, 0]");
    assert!(remarks(&harmless).is_empty());
}

#[test]
fn positions_behind_a_gap_that_none_falls_into_are_told() {
    // The crank is a nanometer longer than the rod: 5.7 thousandths of a degree on both sides of 90 and 270 degrees.
    let scene = "[ground]\npoints = { O = 0 }\n[link.crank]\npoints = { O = 0, A = 0.200000001 }\n\
        [link.rod]\npoints = { A = 0, B = 0.2 }\n[link.slider]\npoints = { B = 0 }\n\
        [[slide]]\nlink = \"slider\"\non = \"ground\"\n[input]\nlink = \"crank\"\nfrom = \"10 deg\"\npositions = 12\n";
    let found = analyzed(scene);
    assert!(found.failures.is_empty());
    let told = remarks(scene);
    let [note] = &told[..] else { panic!("{told:?}") };
    // 30 deg apart from 10 deg: position 3 stands at 100 deg, position 8 at 250, position 9 at 280, which is -80.
    let parts = [
        "Past 89.994",
        "group 1 (RRP rod, slider)",
        "Positions 3 to 8 are valid positions",
        "Positions 9 to 11 can be reached only in reverse",
    ];
    for part in parts {
        assert!(note.to_string().contains(part), "{part}: {note}");
    }
    assert!(remarks(&scene.replace("0.200000001", "0.199999999")).is_empty());
}
