//! Snapshots for the eye, and what a snapshot can't say.

use ratatui::style::{Color, Modifier};

use super::{View, frame, opened, press, scene, text};
use crate::screen::state::{Marker, Theme};

/// Views that a scene has something for, each drawn.
fn snapshots(scene: &'static str) {
    let mut state = opened(scene);
    state.position = 5;
    for view in crate::screen::tests::VIEWS {
        if state.has(view) {
            state.view = view;
            let name = format!("{}_{view:?}", scene.replace('-', "_"));
            insta::assert_snapshot!(name.to_lowercase(), without_rounding(&text(&state, 80, 24), view));
        }
    }
}

/// Numbers that are rounding become `~`; of a check the name and the word stay.
fn without_rounding(frame: &str, view: View) -> String {
    let rounding =
        |word: &str| word.contains("e-") && word.parse::<f64>().is_ok_and(|value| value.abs() < 1e-9);
    let mut lines = Vec::new();
    for line in frame.lines() {
        // Without the bar beside rows of which some are out of sight.
        let told = line.trim_end_matches(['█', '│', ' ']);
        if view == View::Checks && (told.ends_with(" ok") || told.ends_with(" FAILED")) {
            let name: String = line.chars().take(30).collect();
            lines.push(format!("{name} ~ {}", told.rsplit(' ').next().unwrap_or_default()));
        } else {
            lines.push(
                line.split(' ')
                    .map(|word| if rounding(word) { "~" } else { word })
                    .collect::<Vec<_>>()
                    .join(" "),
            );
        }
    }
    lines.join("\n")
}

#[test]
fn every_view_of_the_shaper() {
    snapshots("shaper");
}

#[test]
fn every_view_of_the_press() {
    snapshots("press");
}

#[test]
fn every_view_of_the_shaper_with_its_drive() {
    snapshots("shaper-drive");
}

#[test]
fn reactions_by_cause() {
    let mut state = opened("shaper");
    state.position = 5;
    press(&mut state, "3 b Down");
    insta::assert_snapshot!(without_rounding(&text(&state, 80, 24), View::Forces));
}

#[test]
fn styles_of_the_structure_view() {
    let mut state = opened("shaper");
    state.view = View::Structure;
    let buffer = frame(&state, 80, 24);
    let sign = |cell: &ratatui::buffer::Cell| match (cell.symbol(), cell.modifier, cell.fg) {
        (_, modifier, _) if modifier.contains(Modifier::REVERSED) => 'R',
        (" ", ..) => ' ',
        (_, modifier, _) if modifier.contains(Modifier::BOLD) => 'B',
        (.., Color::Reset) => '.',
        _ => 'c',
    };
    let rows =
        buffer.content.chunks(80).map(|row| row.iter().map(sign).collect::<String>().trim_end().to_owned());
    insta::assert_snapshot!(rows.collect::<Vec<_>>().join("\n"));
}

#[test]
fn the_help_lists_every_command() {
    let mut state = opened("shaper");
    press(&mut state, "?");
    state.size = (80, 400);
    let help = text(&state, 80, 400);
    for command in crate::screen::command::COMMANDS {
        assert!(help.contains(command.name), "{} is not on the help screen", command.name);
    }
}

#[test]
fn ascii_leaves_no_other_character() {
    for scene in ["shaper", "conveyor", "andrews"] {
        let mut state = opened(scene);
        state.look.ascii = true;
        for marker in [Marker::Ascii, Marker::Braille, Marker::HalfBlock] {
            state.look.marker = marker;
            for view in crate::screen::tests::VIEWS {
                state.view = view;
                assert!(text(&state, 100, 30).is_ascii(), "{scene} {view:?} {marker:?}");
            }
        }
    }
}

#[test]
fn mono_has_the_same_text_and_no_color() {
    let mut state = opened("shaper");
    for view in crate::screen::tests::VIEWS {
        state.view = view;
        state.look.theme = Theme::Default;
        let colored = text(&state, 120, 40);
        state.look.theme = Theme::Mono;
        assert_eq!(text(&state, 120, 40), colored, "{view:?}");
        let mono = frame(&state, 120, 40);
        assert!(
            mono.content.iter().all(|cell| cell.fg == Color::Reset && cell.bg == Color::Reset),
            "{view:?}"
        );
    }
}

const CRANK: &str = "
[ground]
points = { O = [0, 0] }
[link.crank]
points = { O = 0, A = \"100 mm\" }
[input]
link = \"crank\"
positions = 12
";

#[test]
fn a_circle_is_as_wide_as_twice_its_rows() {
    for marker in [Marker::Braille, Marker::HalfBlock, Marker::Ascii] {
        let mut state = scene(CRANK);
        state.look.marker = marker;
        state.arrows = crate::screen::state::Arrows::None;
        let buffer = frame(&state, 80, 24);
        let color = state.look.theme.style(crate::screen::state::Role::Drawn(assur_figure::Ink::Trace)).fg;
        let is_path = |x: u16, y: u16| Some(buffer[(x, y)].fg) == color && buffer[(x, y)].symbol() != " ";
        // The last row of the drawing has the scale.
        let columns: Vec<u16> = (0..54).filter(|&x| (2..21).any(|y| is_path(x, y))).collect();
        let rows: Vec<u16> = (2..21).filter(|&y| (0..54).any(|x| is_path(x, y))).collect();
        // The path is dotted, so that a column between its ends may be empty.
        let [columns, rows] = [columns, rows].map(|all| all[all.len() - 1] - all[0] + 1);
        assert!(columns.abs_diff(2 * rows) <= 2, "{marker:?}: {columns} columns, {rows} rows");
    }
}

#[test]
fn marks_stand_where_the_derivative_vanishes() {
    let mut state = scene(CRANK);
    state.view = View::Curves;
    let frame = text(&state, 80, 24);
    // cos q: zeros of PF0 at 90 and 270 degrees are inflections as well; extremes at 0 and 180.
    assert!(frame.lines().nth(4).unwrap_or_default().contains('o'), "{frame}");
}
