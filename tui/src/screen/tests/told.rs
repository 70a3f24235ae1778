//! What is not there, not possible or only rounding is said as such; what is shown is not cut.

use assur_picture::{Picture, ViewPart};

use super::pictures::request;
use super::{opened, press, scene, text, write};
use crate::screen::state::{Chosen, State, View};
use crate::still::{PictureArgs, StillError, draw};

/// The slider-crank of the fixtures with another rod, mm; its crank has 60.
fn with_rod(length: &str) -> State {
    let text = assur_fixtures::scene("slider-crank");
    let changed = text.replace("\"240 mm\"", &format!("\"{length} mm\"")).replace("\"80 mm\"", "\"20 mm\"");
    assert_ne!(changed, text);
    scene(&changed.replace("B = [0, 0.23]", "B = [0, 0.1]"))
}

/// The frame of a scene in a view after these keys.
fn seen(state: &mut State, keys: &str) -> String {
    press(state, keys);
    text(state, 80, 24)
}

#[test]
fn a_plan_without_forces_says_that_the_loads_are_moments() {
    let frame = seen(&mut opened("brake"), "4");
    assert!(frame.contains("No force acts on these links"), "{frame}");
    assert!(!seen(&mut opened("shaper"), "4").contains("No force acts"));
    let state = opened("brake");
    let request = PictureArgs { position: vec![0], ..request("plans") };
    let drawn = draw(state.scene.as_ref().unwrap(), &request, "plan.svg".as_ref(), state.language());
    assert!(matches!(drawn, Err(StillError::Nothing(why)) if why.to_string().contains("moments")));
}

#[test]
fn a_gap_has_digits_and_the_way_on_is_said() {
    // The rod is shorter than the crank by 10 mm, and by a ten-millionth of one.
    let mut state = with_rod("50");
    let frame = text(&state, 80, 24);
    assert!(frame.contains("misses by 10 mm in position 0, 0 deg; group 1; more: R"), "{frame}");
    let frame = seen(&mut state, "R");
    assert!(frame.contains("no analysis") && frame.contains("check the lengths"), "{frame}");
    assert!(!frame.contains("change point"), "{frame}");
    let mut state = with_rod("59.9999999");
    assert!(text(&state, 80, 24).contains("misses by 1.000e-7 mm"));
    assert!(seen(&mut state, "R").contains("it is a change point"));
    // Of equal lengths the piston may stay on the axis of the crank wherever that is across the guide.
    let frame = seen(&mut with_rod("60"), "R");
    let line = frame.lines().find(|line| line.contains("change points, where modes meet")).unwrap();
    assert!(line.contains("180; 360 deg"), "{line}");
    assert!(!seen(&mut with_rod("240"), "R").contains("change points"));
}

#[test]
fn hints_are_of_what_can_be_done() {
    let hints = |frame: &str| frame.lines().skip(22).collect::<String>();
    let frame = hints(&seen(&mut opened("six-links"), "9"));
    assert!(frame.contains("p pick"), "{frame}");
    for absent in ["mode", "A take", "events", "undo", "save"] {
        assert!(!frame.contains(absent), "{absent}: {frame}");
    }
    let mut state = opened("triad");
    let frame = hints(&seen(&mut state, "9"));
    assert!(frame.contains("[/] mode") && frame.contains("b events") && !frame.contains("A take"), "{frame}");
    assert!(hints(&seen(&mut state, "]")).contains("A take"));
    let frame = hints(&seen(&mut state, "A Right"));
    assert!(frame.contains("u undo") && frame.contains("S save"), "{frame}");
}

#[test]
fn the_list_of_values_goes_by_pages_and_tells_a_key_in_full() {
    let mut state = opened("triad");
    press(&mut state, "e PgDn");
    // Of the 20 rows of the body the list has 7, one of them its title.
    assert_eq!((state.draft.chosen, state.position), (6, 0));
    press(&mut state, "PgUp");
    assert_eq!(state.draft.chosen, 0);
    write(&mut state, "/link.rod.points.D");
    press(&mut state, "+");
    let key = state.draft.values[state.draft.chosen].key.to_string();
    let frame = text(&state, 80, 24);
    assert!(frame.contains("greatest values, before -> now"), "the results leave half of the width: {frame}");
    let rows: Vec<&str> = frame.lines().skip(15).collect();
    assert!(rows.iter().any(|row| row.contains(&key)), "{key}: {frame}");
}

#[test]
fn a_mode_has_one_number_over_the_cycle() {
    // At 180 deg modes 1 and 3 of the first position don't exist any more, but two others.
    let mut state = opened("contour");
    press(&mut state, "9");
    for position in [0, 12] {
        write(&mut state, &format!(":{position}"));
        assert!(text(&state, 80, 24).contains("assembly mode 4 of 4"));
    }
    assert!(seen(&mut state, "b").contains("mode 4 of group 1 (taken)"));
    let whole = "Modes are told of a whole turn";
    assert!(!text(&state, 80, 24).contains(whole));
    assert!(seen(&mut opened("triad"), "9 b").contains(whole));
}

#[test]
fn numbers_of_the_header_and_of_results_are_short_and_no_rounding() {
    let mut state = opened("triad");
    let frame = seen(&mut state, "9 ] A");
    let header = frame.lines().next().unwrap();
    assert!(header.contains("assembly.B[0] 0.4 -> 0."), "{header}");
    let is_long = |word: &&str| word.parse::<f64>().is_ok() && word.len() > 8;
    assert_eq!(header.split(' ').find(is_long), None);
    // The inertia of the disc balances the brake, so that nothing is left for the balancing moment.
    let mut state = opened("brake");
    assert!(!seen(&mut state, "R").contains("e-"));
    press(&mut state, "4");
    state.parts.insert(View::Plans, ViewPart::Construction);
    state.chosen = Chosen { step: 3, ..state.chosen };
    let frame = text(&state, 80, 24);
    assert!(frame.contains("F_bal (balancing load) 0 N") && frame.contains("moment 0 N·m"), "{frame}");
}

#[test]
fn results_tell_constants_and_self_locking() {
    let frame = seen(&mut opened("shaper-friction"), "R Up");
    let all = frame + &seen(&mut opened("shaper-friction"), "R");
    let line = |wanted: &str| all.lines().find(|line| line.contains(wanted)).unwrap().to_owned();
    // A stone transmits its force across its guide everywhere.
    assert!(line("least transmission angle").contains("90 deg          constant"), "{all}");
    let state = opened("shaper-friction");
    let friction = state.found().unwrap().analysis.friction.clone().unwrap();
    let [from, to] = friction.self_braking.last().unwrap().map(|end| format!("{:.3}", end.to_degrees()));
    assert!(line("self-locking").contains("; ") && all.contains(&format!("{from}; {to} deg")), "{all}");
}

#[test]
fn curves_of_residuals_are_lines() {
    let state = opened("shaper-drive");
    let figure = assur_picture::curves::residuals(state.scene.as_ref().unwrap(), &state.pictured());
    for panel in &figure.panels {
        let points = panel.items[0].points();
        let drawn = points.windows(2).filter(|two| two.iter().all(|at| at[1].is_finite())).count();
        assert!(drawn + 2 >= state.positions(), "{drawn} of {:?}", panel.title);
    }
    assert!(!figure.panels.is_empty());
}

#[test]
fn headings_keep_values_and_all_names() {
    // 0.2 · 2 · 20 N · 0.1 m.
    let frame = seen(&mut opened("brake"), "5 Tab");
    let line = frame.lines().find(|line| line.contains("moments of the loads")).unwrap();
    assert!(line.ends_with("  0.8000"), "{line}");
    let frame = seen(&mut opened("shaper-drive"), "6 Tab");
    let line = frame.lines().find(|line| line.contains("moments on the input")).unwrap();
    assert!(["1 motor", "2 resistance", "3 mean"].iter().all(|name| line.contains(name)), "{line}");
    assert_eq!(line.matches(';').count(), 2, "three values: {line}");
    let frame = seen(&mut opened("triad"), "9");
    assert!(!frame.lines().nth(4).unwrap().contains('…'), "{frame}");
}

#[test]
fn frames_of_an_animated_plan_have_one_scale_and_no_sizes() {
    let state = opened("shaper-drive");
    let part = Some("velocities".to_owned());
    let request = PictureArgs { part, animate: true, position: vec![0], ..request("plans") };
    let drawn = draw(state.scene.as_ref().unwrap(), &request, "plan.svg".as_ref(), state.language());
    let svg = String::from_utf8(drawn.unwrap()).unwrap();
    // The pole is the one ring; where it moved, its center would be animated.
    let rings: Vec<&str> = svg.lines().filter(|line| line.starts_with("<circle")).collect();
    assert!(!rings.is_empty() && rings.iter().all(|ring| !ring.contains("<animate")), "{rings:?}");
    assert!(
        !svg.contains(" m/s</text>") || svg.matches(" m/s").count() < 3,
        "sizes of one position stand still"
    );
}

#[test]
fn what_is_zero_has_no_name_in_a_plan() {
    // The ram does not turn: K has no acceleration relative to E.
    let state = opened("shaper-drive");
    let look = state.pictured();
    let figure = Picture::Plans.figure(state.scene.as_ref().unwrap(), &look, ViewPart::Accelerations);
    let names: Vec<String> = figure.panels[0]
        .items
        .iter()
        .filter_map(|item| match item {
            assur_figure::Item::Name { text, .. } => Some(text.to_string()),
            _ => None,
        })
        .collect();
    assert!(names.iter().any(|name| name == "a^n_AO"), "{names:?}");
    assert!(!names.iter().any(|name| name.ends_with("_KE")), "{names:?}");
}

#[test]
fn legends_name_each_vector_and_no_rounding() {
    let legend = |view: &str, part: &str, position: usize| {
        let state = opened("shaper-drive");
        let part = Some(part.to_owned());
        let request = PictureArgs { part, position: vec![position], ..request(view) };
        let drawn = draw(state.scene.as_ref().unwrap(), &request, "legend.svg".as_ref(), state.language());
        String::from_utf8(drawn.unwrap()).unwrap()
    };
    let svg = legend("forces", "causes", 12);
    // Once at the vector, once in the legend with its size.
    assert_eq!(svg.matches(">sum").count(), 2, "{svg}");
    // At 90 deg the crank is upright, and weights have no arm about the pole.
    let svg = legend("plans", "construction", 12);
    assert!(svg.contains("h = 0 m/rad") && !svg.contains("e-18"), "{svg}");
}
