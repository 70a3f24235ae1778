//! What a reader looks for: the nearest singular position, a long report, warnings, ways between scenes and views.

use assur_motor::check_rotor_inertia;
use assur_words::name;

use super::words::TURNS;
use super::{opened, press, scene, settle, text, write};
use crate::screen::draw::folded;
use crate::screen::state::{Measured, State, View};

/// The least sine of the angle between rod (350) and rocker (250) of [`TURNS`], by the law of cosines, and where it is.
fn least_sine() -> (f64, usize) {
    let sine = |position: usize| {
        let q = std::f64::consts::TAU * position as f64 / 12.0;
        let square = 100.0_f64.powi(2) + 400.0_f64.powi(2) - 2.0 * 100.0 * 400.0 * q.cos();
        let cosine = (350.0_f64.powi(2) + 250.0_f64.powi(2) - square) / (2.0 * 350.0 * 250.0);
        (1.0 - cosine * cosine).sqrt()
    };
    (0..12).map(|position| (sine(position), position)).min_by(|a, b| a.0.total_cmp(&b.0)).unwrap()
}

#[test]
fn the_group_nearest_to_a_singular_position_is_named_and_gone_to() {
    let (least, at) = least_sine();
    let mut state = scene(TURNS);
    press(&mut state, "9 Right");
    let frame = text(&state, 80, 24);
    let line = frame.lines().find(|line| line.contains("nearest to singular")).unwrap();
    assert!(line.contains(&format!("{least:.3} at position {at}, group 1")), "{line}: {least}");
    assert!(frame.contains(&format!("least determinant {least:.3} at position {at}")), "{frame}");
    press(&mut state, "Enter");
    assert_eq!(state.position, at);
}

/// A state with a report of so many lines.
fn report(lines: usize) -> State {
    let mut state = scene(TURNS);
    // Words of which no two have room in a line.
    let rest = "-".repeat(40);
    let chart = (0..lines).map(|line| format!("line_{line}.{rest}")).collect::<Vec<_>>().join(" ");
    state.measured = Some(Box::new(Measured { chart: Err(name(chart)), stability: None }));
    press(&mut state, "8");
    state
}

#[test]
fn a_long_report_is_read_by_pages() {
    let mut state = report(100);
    // 24 rows, two of them header, two footer.
    assert!(text(&state, 80, 24).contains("line_19.") && !text(&state, 80, 24).contains("line_20."));
    press(&mut state, "PgDn");
    let frame = text(&state, 80, 24);
    assert!(
        !frame.contains("line_18.") && frame.contains("line_19.") && frame.contains("line_38."),
        "{frame}"
    );
    press(&mut state, "End");
    let frame = text(&state, 80, 24);
    assert!(frame.contains("line_80.") && frame.contains("line_99."), "{frame}");
    press(&mut state, "Down Up");
    assert!(text(&state, 80, 24).contains("line_79."));
    press(&mut state, "PgUp Home");
    assert!(text(&state, 80, 24).contains("line_0."));
    assert_eq!(state.position, 0, "the position stays");
    press(&mut state, "Right");
    assert_eq!(state.position, 1);
}

#[test]
fn the_report_begins_with_what_follows_and_fits() {
    let mut state = scene(TURNS);
    press(&mut state, "8 b");
    settle(&mut state);
    let frame = text(&state, 80, 24);
    assert!(frame.lines().nth(2).unwrap().contains("Conclusion"), "{frame}");
    let measured = state.measured.clone().unwrap();
    assert!(measured.chart.is_ok() && matches!(measured.stability, Some(Ok(_))));
    // At a width of 80 nothing is lost that is there at 200.
    let all = |width: u16| {
        let words: Vec<String> = crate::screen::view::report::lines(&state, View::Accuracy, width);
        assert!(words.iter().all(|line| line.chars().count() <= usize::from(width) - 2), "{words:#?}");
        words.join(" ").split_whitespace().filter(|word| word.ends_with(':')).map(str::to_owned).collect()
    };
    let [narrow, wide]: [Vec<String>; 2] = [all(80), all(200)];
    assert_eq!(narrow, wide);
}

#[test]
fn a_warning_of_the_drive_is_on_its_first_part() {
    let mut state = opened("shaper-drive");
    press(&mut state, "6");
    assert!(text(&state, 80, 24).contains(" ! starting torque"));
    let scene = state.scene.as_mut().unwrap();
    let dynamics = scene.found.as_mut().unwrap().analysis.dynamics.as_mut().unwrap();
    dynamics.motor.as_mut().unwrap().warnings =
        check_rotor_inertia(None, name("A long name ".repeat(9))).into_iter().collect();
    let frame = text(&state, 80, 24);
    let line = frame.lines().find(|line| line.starts_with(" ! the rotor inertia of A long name")).unwrap();
    assert!(line.ends_with("…  (Tab Tab: full text)"), "{line}");
    let scene = state.scene.as_mut().unwrap();
    let dynamics = scene.found.as_mut().unwrap().analysis.dynamics.as_mut().unwrap();
    dynamics.motor.as_mut().unwrap().warnings.clear();
    assert!(text(&state, 80, 24).lines().all(|line| !line.starts_with(" ! ")));
}

#[test]
fn another_scene_is_opened_by_its_name() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.toml");
    std::fs::write(&file, TURNS).unwrap();
    let mut state = opened("shaper");
    write(&mut state, &format!(":open {}", file.display()));
    assert_eq!(state.positions(), 12);
    write(&mut state, ":open");
    assert!(state.picker.is_some() && text(&state, 80, 24).contains(":open FILE"));
    write(&mut state, &format!(":open {}", file.display()));
    assert!(state.picker.is_none(), "also the scene that is open already");
    write(&mut state, ":open four-bar.toml");
    assert_eq!(state.scene.as_ref().unwrap().session.source.name(), "four-bar.toml");
    write(&mut state, ":open press");
    assert_eq!(state.scene.as_ref().unwrap().session.source.name(), "press.toml");
    write(&mut state, &format!(":open {}", folder.path().display()));
    assert!(text(&state, 120, 24).contains("is a folder, not a scene file"));
    press(&mut state, "x");
    for word in ["open", "scenes"] {
        press(&mut state, "?");
        word.chars().for_each(|letter| press(&mut state, &letter.to_string()));
        assert!(text(&state, 80, 24).contains(":open FILE"), "{word}");
        press(&mut state, "Esc");
    }
}

#[test]
fn only_near_names_are_offered() {
    let mut state = opened("shaper");
    for (typed, offered) in [(":foo", false), (":opxy", false), (":mechanims", true), (":sorf", true)] {
        write(&mut state, typed);
        assert_eq!(text(&state, 80, 24).contains("did you mean"), offered, "{typed}");
    }
    write(&mut state, ":lower");
    assert!(text(&state, 80, 24).contains("`lower` has no meaning here (view What if)"));
    write(&mut state, ":compare");
    assert!(text(&state, 120, 24).contains("wants a scene file or the name of a shipped one; `off` ends it"));
}

#[test]
fn changes_that_are_taken_back_are_none() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("changed.toml");
    let mut state = opened("shaper");
    write(&mut state, ":value link.crank.points.A 101 mm");
    write(&mut state, &format!(":save {}", file.display()));
    press(&mut state, "u");
    crate::screen::tests::command::press(
        &mut state,
        crossterm::event::KeyEvent::from(crossterm::event::KeyCode::Char('q')),
    );
    assert!(matches!(state.effects[..], [crate::screen::tests::Effect::Quit]), "{:?}", state.message);
}

#[test]
fn another_scene_does_not_drop_changes_unasked() {
    let mut state = opened("shaper");
    write(&mut state, ":value link.crank.points.A 101 mm");
    write(&mut state, ":open four-bar.toml");
    assert!(text(&state, 80, 24).contains("changes are not saved"));
    assert_eq!(state.scene.as_ref().unwrap().session.source.name(), "shaper.toml");
    write(&mut state, ":open four-bar.toml");
    assert_eq!(state.scene.as_ref().unwrap().session.source.name(), "four-bar.toml");
}

#[test]
fn help_says_where_a_key_works_and_goes_to_its_end() {
    let mut state = opened("shaper");
    press(&mut state, "?");
    press(&mut state, "End");
    assert!(text(&state, 80, 24).contains("The same as plain lines"));
    press(&mut state, "Home");
    let frame = text(&state, 80, 24);
    assert!(frame.contains("the first position (not 8 W Z)"), "{frame}");
    for letter in "differ".chars() {
        press(&mut state, &letter.to_string());
    }
    assert!(text(&state, 80, 24).contains("(view 3)"));
}

#[test]
fn numbers_stay_in_their_columns() {
    let mut state = scene(TURNS);
    press(&mut state, "t");
    let changed = TURNS.replace("350 mm", "350.001 mm");
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("other.toml");
    std::fs::write(&file, changed).unwrap();
    write(&mut state, &format!(":compare {}", file.display()));
    let frame = text(&state, 80, 24);
    let rows: Vec<&str> = frame.lines().skip(4).take(12).collect();
    // Each column is 12 wide after the first 6: its last cell but one is the end of a number.
    for row in rows {
        let cells: Vec<char> = row.chars().chain(std::iter::repeat_n(' ', 80)).collect();
        for end in (17..78).step_by(12) {
            assert!(cells[end] == ' ' && cells[end - 1] != ' ', "{frame}");
        }
    }
    press(&mut state, "s");
    assert!(text(&state, 80, 24).contains("sorted by q↑"), "{}", text(&state, 80, 24));
    state.look.ascii = true;
    assert!(text(&state, 80, 24).contains("sorted by q^"));
}

#[test]
fn a_long_line_hangs() {
    assert_eq!(folded("  short", 7), ["  short"]);
    assert_eq!(folded("  one two three", 9), ["  one two", "      three"]);
    assert_eq!(folded("a  b    cc", 8), ["a  b", "    cc"]);
    // A word that is wider than everything stands alone, to be cut.
    assert_eq!(folded("abcdefghij kl", 5), ["abcdefghij", "    kl"]);
    assert_eq!(folded("", 5), [""]);
}

#[test]
fn every_fault_is_told_where_there_is_room_for_its_line_alone() {
    let mut state = opened("shaper");
    let fault = |number: usize| {
        format!("error: fault {number}\n  file, line {number}\n  |\n{number} | a = 1\n  | ^\n\n")
    };
    state.fault = Some((name("title"), name((1..9).map(fault).collect::<Vec<_>>().concat())));
    let frame = text(&state, 80, 24);
    assert!((1..9).all(|number| frame.contains(&format!("file, line {number}"))), "{frame}");
    state.fault = Some((name("title"), name((1..30).map(fault).collect::<Vec<_>>().concat())));
    assert!(text(&state, 80, 24).contains(".. 41 more lines"), "{}", text(&state, 80, 24));
}
