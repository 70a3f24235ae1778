//! Reactions, their causes, and the arrows of the drawing.

use assur_analysis::results::Quantity;

use super::{opened, press, scene, text};

#[test]
fn every_pair_of_the_results_is_in_the_table_of_forces() {
    let mut state = opened("shaper");
    press(&mut state, "3");
    let frame = text(&state, 80, 40);
    let scene = state.scene.as_ref().unwrap();
    let positions = &scene.found.as_ref().unwrap().analysis.positions;
    let owners = positions.schema().owners(Quantity::Force);
    assert!(owners.len() >= 12);
    for pair in owners.into_iter().map(|owner| positions.schema().name(owner)) {
        assert!(frame.contains(&format!("{pair} on ")), "{pair}: {frame}");
    }
}

#[test]
fn two_analyzers_agree_on_the_screen() {
    let mut state = opened("shaper");
    press(&mut state, "3 d");
    let frame = text(&state, 80, 24);
    assert!(frame.contains("1 groups (line)  2 newton-euler (stars)   largest difference"), "{frame}");
    press(&mut state, "d f");
    assert!(!text(&state, 80, 24).contains("force analyzer: groups"));
}

/// The numbers of the row of a frame that begins with a word.
fn row(frame: &str, start: &str) -> Vec<f64> {
    let line = frame.lines().find(|line| line.trim_start().starts_with(start)).unwrap();
    line.trim_start()[start.len()..].split_whitespace().filter_map(|word| word.parse().ok()).collect()
}

#[test]
fn causes_sum_to_the_whole() {
    for name in ["shaper", "shaper-drive", "press"] {
        let mut state = opened(name);
        press(&mut state, "3 b");
        for position in [0, 5, 11] {
            state.position = position;
            press(&mut state, "Down");
            let frame = text(&state, 80, 24);
            let found = state.scene.as_ref().unwrap().found.as_ref().unwrap();
            let reaction = &found.reactions[state.chosen.reaction];
            let most = found.series[*reaction.series.last().unwrap()].size();
            // The whole is the one of the analysis; the causes were solved one by one.
            for (shown, series) in row(&frame, "sum").into_iter().zip(&reaction.series) {
                let whole = found.series[*series].at(position);
                assert!((shown - whole).abs() <= 1e-5 * most, "{name} {position}: {frame}");
            }
        }
    }
}

#[test]
fn every_cause_has_a_row() {
    let mut state = opened("shaper");
    press(&mut state, "3 b");
    let frame = text(&state, 80, 24);
    for cause in ["1 weight", "2 inertia", "3 cutting", "sum", "total, by `groups`"] {
        assert!(frame.contains(cause), "{cause}: {frame}");
    }
}

#[test]
fn arrows_are_velocities_where_there_is_a_motion() {
    let mut state = opened("shaper");
    let frame = text(&state, 80, 24);
    assert!(frame.contains("velocity") && frame.contains(" m/s\n"), "{frame}");
    press(&mut state, "v");
    let frame = text(&state, 80, 24);
    assert!(frame.contains("acceleration") && frame.contains(" m/s²\n"), "{frame}");
}

#[test]
fn arrows_are_transfer_functions_without_a_motion() {
    let text_of = assur_fixtures::scene("shaper");
    let start = text_of.find("[motion]").unwrap();
    let mut state = scene(&text_of[..start].replace("against_motion = true", "angle = 0"));
    let frame = text(&state, 80, 24);
    assert!(frame.contains("PF1: for unit speed") && frame.contains(" mm/rad\n"), "{frame}");
    press(&mut state, "v");
    let frame = text(&state, 80, 24);
    assert!(frame.contains("PF2: for unit speed") && frame.contains(" mm/rad²\n"), "{frame}");
}

#[test]
fn many_causes_keep_their_sum_in_sight() {
    let moment = |number: u32| {
        format!("\n[[moment]]\nname = \"m{number}\"\nlink = \"crank\"\nvalue = {}\n", number + 1)
    };
    let moments: String = (0..20).map(moment).collect();
    let text_of = assur_fixtures::scene("shaper").to_owned() + &moments;
    let mut state = scene(&text_of);
    press(&mut state, "3 b End");
    // The balancing load: 1 + 2 + ... + 20 N m of it are for the moments, which end in a row of their own.
    press(&mut state, "Up");
    let frame = text(&state, 80, 24);
    let more = row(&frame, "..");
    assert!(frame.contains(" more together") && more.len() == 2, "{frame}");
    let shown: f64 = (0..20).filter(|n| frame.contains(&format!(" m{n} "))).map(|n| f64::from(n + 1)).sum();
    assert!((more[1] + (210.0 - shown)).abs() < 1e-9, "{frame}");
    let whole = row(&frame, "total, by `groups`");
    assert!((row(&frame, "sum")[0] - whole[0]).abs() <= 1e-5 * whole[0].abs(), "{frame}");
}
