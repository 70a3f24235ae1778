//! What a scene that is wrong, or can't be assembled, shows.

use super::{opened, press, scene, text};
use crate::screen::study::{Source, Study};
use crate::screen::work::Report;

const SHORT: &str = "
[ground]
points = { O = [0, 0], C = [0.4, 0] }
[link.crank]
points = { O = 0, A = \"100 mm\" }
[link.rod]
points = { A = 0, B = \"200 mm\" }
[link.rocker]
points = { C = 0, B = \"250 mm\" }
[input]
link = \"crank\"
positions = 12
[assembly]
B = [0.3, 0.2]
";

#[test]
fn positions_without_assembly_are_told_and_keys_still_work() {
    let mut state = scene(SHORT);
    let frame = text(&state, 80, 24);
    assert!(frame.contains("no assembly"), "{frame}");
    assert!(frame.contains("misses by"), "{frame}");
    press(&mut state, "Right Right Right Right Right Right");
    assert!(text(&state, 80, 24).contains("position 6"));
}

#[test]
fn a_scene_that_is_wrong_keeps_the_old_result() {
    let mut state = opened("shaper.toml");
    let wrong = Study::read(Source::File("bad.toml".into()), "[link.a]\nlenght = 1\n").map(Box::new);
    assert!(state.take_report(Report::Opened(wrong)));
    let frame = text(&state, 80, 24);
    assert!(frame.contains("line 2, column 1"), "{frame}");
    press(&mut state, "Right");
    assert!(text(&state, 80, 24).contains("position 1"));
}

#[test]
fn an_answer_to_an_older_scene_is_dropped() {
    let mut state = opened("shaper.toml");
    let report = Report::Analyzed { generation: 99, other: false, found: Err("late".into()) };
    assert!(!state.take_report(report));
    assert!(state.message.is_none());
}

#[test]
fn the_drive_shows_motor_moments_flywheels_and_places() {
    let mut state = opened("shaper-drive.toml");
    press(&mut state, "6");
    let study = state.study.as_ref().unwrap();
    let dynamics = study.found.as_ref().unwrap().analysis.dynamics.clone().unwrap();
    let frame = text(&state, 80, 24);
    let shown: f64 = frame
        .split("unevenness ")
        .nth(1)
        .and_then(|rest| rest.split_whitespace().next()?.parse().ok())
        .unwrap();
    let unevenness = dynamics.unevenness.unwrap();
    assert!((shown - unevenness).abs() <= 1e-4 * unevenness, "{frame}");
    for (row, word) in dynamics.flywheel_methods.iter().zip(["kg m2"].iter().cycle()) {
        assert!(frame.contains(row.method) && frame.contains(word), "{frame}");
    }
    press(&mut state, "Tab");
    let frame = text(&state, 80, 24);
    assert!(
        ["working section", "1 motor", "2 resistance", "3 mean"].iter().all(|w| frame.contains(w)),
        "{frame}"
    );
    press(&mut state, "Tab");
    assert!(text(&state, 80, 24).contains("on the motor shaft"));
    press(&mut state, "5");
    assert!(text(&state, 80, 24).contains("iteration to the periodic regime"));
}
