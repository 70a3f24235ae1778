//! What a scene that is wrong, or can't be assembled, shows.

use super::{opened, press, scene, text};
use crate::screen::command;
use crate::screen::state::{Outcome, Report, Source, Wanted};

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

/// Turns fully, by Grashof: 100 + 400 < 350 + 250; with a rod of 200 mm it does not.
pub(super) const TURNS: &str = "
[ground]
points = { O = [0, 0], C = [0.4, 0] }
[link.crank]
points = { O = 0, A = \"100 mm\" }
[link.rod]
points = { A = 0, B = \"350 mm\" }
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
    let mut state = opened("shaper");
    let wrong = super::read(Source::File("bad.toml".into()), "[link.a]\nlenght = 1\n").map(Box::new);
    assert!(command::take(&mut state, Report::Read(Wanted::Open(Source::File("bad.toml".into())), wrong)));
    let frame = text(&state, 80, 24);
    assert!(frame.contains("line 2, column 1"), "{frame}");
    press(&mut state, "Right");
    assert!(text(&state, 80, 24).contains("position 1"));
}

#[test]
fn an_answer_to_an_older_scene_is_dropped() {
    let mut state = opened("shaper");
    let report = Report::Calculated(99, Outcome::Failed(assur_words::name("late")));
    assert!(!command::take(&mut state, report));
    assert!(state.message.is_none());
}

#[test]
fn the_drive_shows_motor_moments_flywheels_and_places() {
    let mut state = opened("shaper-drive");
    press(&mut state, "6");
    let scene = state.scene.as_ref().unwrap();
    let dynamics = scene.found.as_ref().unwrap().analysis.dynamics.clone().unwrap();
    let frame = text(&state, 80, 24);
    let shown: f64 = frame
        .split("unevenness ")
        .nth(1)
        .and_then(|rest| rest.split([' ', ',']).next()?.parse().ok())
        .unwrap();
    let unevenness = dynamics.figures.unevenness;
    assert!((shown - unevenness).abs() <= 1e-4 * unevenness, "{frame}");
    assert!(frame.contains("kg·m²"), "{frame}");
    for cell in &assur_report::topic::flywheel_methods(&dynamics).keys[0].cells {
        let assur_book::Cell::Text(told) = cell else { panic!("{cell:?}") };
        assert!(frame.contains(&told.to_string()), "{told}: {frame}");
    }
    press(&mut state, "Tab");
    let frame = text(&state, 80, 24);
    assert!(
        ["working section", "1 motor", "2 resistance", "3 mean"].iter().all(|w| frame.contains(w)),
        "{frame}"
    );
    press(&mut state, "Tab");
    assert!(text(&state, 80, 60).contains("two possible locations of the flywheel"));
    press(&mut state, "5");
    assert!(!text(&state, 80, 24).contains("Iteration"), "each view keeps its own part");
    press(&mut state, "Tab Tab");
    assert!(text(&state, 80, 24).contains("Iteration to the periodic regime"));
}

const BARE: &str = "
[ground]
points = { O = [0, 0] }
[link.crank]
points = { O = 0, A = \"100 mm\" }
[input]
link = \"crank\"
";

#[test]
fn a_view_without_content_says_what_to_add() {
    let mut state = scene(BARE);
    for (key, example) in
        [("3", "[[force]]"), ("4", "[[force]]"), ("5", "speed = \"60 rpm\""), ("6", "flywheel = \"solve\"")]
    {
        press(&mut state, key);
        let frame = text(&state, 80, 24);
        assert!(frame.contains(&format!("    {example}\n")), "{key}: {frame}");
    }
    // A mass alone has an inertia to show, but no speed.
    let mut state = scene(&BARE.replace("[input]", "mass = 2\ncenter = \"A\"\n[input]"));
    press(&mut state, "5");
    let frame = text(&state, 80, 24);
    assert!(frame.contains("no [motion] in the scene") && frame.contains("speed = \"60 rpm\"\n"), "{frame}");
}

#[test]
fn all_views_are_named_in_80_columns() {
    let state = opened("shaper-drive");
    let frame = text(&state, 80, 24);
    assert!(frame.lines().nth(1).unwrap().ends_with("tTab WWork ZSheet"), "{frame}");
    assert!(text(&state, 120, 24).contains("9 Groups t Table W Working"));
}

#[test]
fn the_unevenness_stands_in_the_heading() {
    for key in ["5", "6"] {
        let mut state = opened("shaper-drive");
        press(&mut state, key);
        assert!(text(&state, 80, 24).lines().nth(2).unwrap().starts_with(" unevenness 0.05"), "{key}");
    }
}

#[test]
fn plans_of_velocities_need_no_loads() {
    let mut state = scene(&BARE.replace("[input]", "[motion]\nspeed = 2\n[input]"));
    press(&mut state, "4 Tab");
    let frame = text(&state, 80, 24);
    // 100 mm at 2 rad/s.
    assert!(frame.contains("v(A)") && frame.contains("0.2  m/s"), "{frame}");
    press(&mut state, "Tab");
    let frame = text(&state, 80, 24);
    assert!(frame.contains("a(A)") && frame.contains("0.4  m/s²"), "{frame}");
}
