//! What a new student wants to know, each by less than ten keys that the screen names.

use super::{opened, press, text};
use crate::screen::state::Effect;

/// The task, the scene, the keys, and what is on the screen then.
const TASKS: [(&str, &str, &str, &[&str]); 10] = [
    (
        "the greatest moment of the guide of the ram, and where",
        "shaper",
        "p r a m Space m o Enter g",
        &["greatest |ram/ground M|: -90.57", " N·m at 88.82", "(between 11 and 12)"],
    ),
    (
        "the velocity of K in m/s over the turn",
        "shaper",
        "p k Space v e l Enter",
        &["point K vx  m/s", "coordinate, deg"],
    ),
    ("undo a change of 5 %", "shaper", "e % + u", &["What if: step 5 %, changed: 0"]),
    (
        "the force polygon of the last group in position 12",
        "shaper",
        ": 1 2 Enter 4 Down",
        &["position 12 (0 to 47)", "Force polygon of group"],
    ),
    ("the plan of accelerations", "shaper", "4 Tab Tab", &["cceleration", "m/s"]),
    (
        "where the mechanism is nearest to a singular position",
        "shaper",
        "9 Enter",
        &["least determinant", "determinant here"],
    ),
    ("the worst position of the first check", "shaper", "7 Enter", &["residual", "ok"]),
    ("what J means", "shaper", "? / J ,", &["moment of inertia (mass) of all links"]),
    ("every equation of the position", "shaper", "W", &["working of position 0"]),
    ("another motor for the drive", "shaper-drive", "6 p", &["Motors of at least 0.4974 kW"]),
];

#[test]
fn ten_tasks_take_less_than_ten_keys_each() {
    for (task, scene, keys, wanted) in TASKS {
        assert!(keys.split(' ').count() < 10, "{task}");
        let mut state = opened(scene);
        // The first key of each is among the hints, or on a tab.
        let first = keys.split(' ').next().unwrap();
        let frame = text(&state, 80, 24);
        let named = frame.lines().filter(|line| line.contains(first)).count();
        assert!(named > 0, "{task}: {frame}");
        press(&mut state, keys);
        let frame = text(&state, 80, 24);
        for words in wanted {
            assert!(frame.contains(words), "{task}: {words}: {frame}");
        }
    }
}

#[test]
fn the_help_explains_a_word_of_the_field() {
    let mut state = opened("shaper");
    press(&mut state, "? r e d u c e d");
    assert!(text(&state, 80, 24).contains("moment (force) of all loads, reduced to the input link"));
}

#[test]
fn the_note_and_the_picture_are_written_by_one_key() {
    let mut state = opened("shaper");
    let key = |code| crossterm::event::KeyEvent::from(crossterm::event::KeyCode::Char(code));
    crate::screen::command::press(&mut state, key('N'));
    let Some(Effect::Work(job)) = state.effects.pop() else { panic!("no job") };
    super::run(&mut state, &job);
    let Some(Effect::Write(file)) = state.effects.pop() else { panic!("no file") };
    assert_eq!(file.path.to_str(), Some("shaper-note.html"));
    assert!(String::from_utf8(file.content).unwrap().contains("<title>Shaper"));
    assert_eq!(written(&mut state).0, "shaper-mechanism-0.svg");
}

/// Name and numbers of what `w` writes.
fn written(state: &mut crate::screen::State) -> (String, String) {
    let key = crossterm::event::KeyEvent::from(crossterm::event::KeyCode::Char('w'));
    crate::screen::command::press(state, key);
    let Some(Effect::Write(file)) = state.effects.pop() else { panic!("no file") };
    (file.path.display().to_string(), String::from_utf8(file.numbers.unwrap_or_default()).unwrap())
}

#[test]
fn a_written_file_is_named_by_what_is_shown_and_its_numbers_are_those_of_the_picture() {
    let mut state = opened("shaper");
    press(&mut state, "3");
    let (first, numbers) = written(&mut state);
    press(&mut state, "Down");
    let (next, others) = written(&mut state);
    assert!(first != next && numbers != others, "{first} {next}");
    press(&mut state, "Tab");
    let (causes, by_cause) = written(&mut state);
    assert!(causes.contains("forces-causes-") && !by_cause.starts_with("position,"), "{causes}");
    press(&mut state, "2 p b a l a n c Enter");
    let (name, numbers) = written(&mut state);
    let head = numbers.lines().next().unwrap();
    assert_eq!(head.split(',').count(), 3, "position, coordinate and what was picked: {head}");
    assert!(head.to_lowercase().contains("balanc") && name.contains("balanc"), "{name}: {head}");
}
