//! Any keys, pasted texts, clicks and sizes leave a state that can be drawn and left.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers, MouseButton, MouseEvent, MouseEventKind};

use super::{opened, press, run, scene, text};
use crate::screen::command;
use crate::screen::state::{Effect, LONGEST, State, View};

/// Numbers that look random and are the same in every run (Marsaglia's xorshift).
pub(super) struct Dice(pub(super) u64);

impl Dice {
    pub(super) fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from(self.0 >> 33).unwrap() % count
    }
}

pub(super) const NAMED: [KeyCode; 18] = [
    KeyCode::Enter,
    KeyCode::Enter,
    KeyCode::Esc,
    KeyCode::Tab,
    KeyCode::Tab,
    KeyCode::BackTab,
    KeyCode::Backspace,
    KeyCode::Left,
    KeyCode::Right,
    KeyCode::Up,
    KeyCode::Down,
    KeyCode::Home,
    KeyCode::End,
    KeyCode::PageUp,
    KeyCode::PageDown,
    KeyCode::Delete,
    KeyCode::F(1),
    KeyCode::Null,
];
const PASTED: [&str; 7] =
    ["q\nq", "ram", "value link.crank.points.A 0 mm", "\u{44f}\u{4e2d}", "42", "", "panels table curves"];
const SIZES: [(u16, u16); 6] = [(80, 24), (120, 40), (200, 60), (81, 25), (1, 1), (100, 30)];

fn event(state: &mut State, dice: &mut Dice) {
    match dice.below(40) {
        0 => command::paste(state, PASTED[dice.below(PASTED.len())]),
        1 => state.size = SIZES[dice.below(SIZES.len())],
        2 => {
            let (column, row) =
                (u16::try_from(dice.below(210)).unwrap(), u16::try_from(dice.below(65)).unwrap());
            let kind = MouseEventKind::Down(MouseButton::Left);
            command::click(state, MouseEvent { kind, column, row, modifiers: KeyModifiers::NONE });
        }
        3 => state.advance(),
        4..16 => command::press(state, KeyEvent::from(NAMED[dice.below(NAMED.len())])),
        16 => {
            let letter = char::from(b'a' + u8::try_from(dice.below(26)).unwrap());
            command::press(state, KeyEvent::new(KeyCode::Char(letter), KeyModifiers::CONTROL));
        }
        _ => {
            let letter = char::from(b' ' + u8::try_from(dice.below(95)).unwrap());
            command::press(state, KeyEvent::from(KeyCode::Char(letter)));
        }
    }
}

/// What holds in every state.
fn check(state: &State) {
    assert!(state.position < state.positions());
    assert!((0.0..1.0).contains(&state.part_way()));
    let Some(scene) = &state.scene else { return };
    assert!(state.chosen.transfer < scene.transfers.len().max(1));
    assert!(state.chosen.group < scene.linkage.structure.groups.len().max(1));
    assert!(state.probe.is_none_or(|probe| probe.link < scene.linkage.mechanism.links.len()));
    assert!(state.probe.is_none_or(|probe| probe.at.iter().all(|x| x.is_finite())));
    let (width, height) = state.size;
    let _ = text(state, width, height);
}

/// Plays random events; every job is done at once or, now and then, never.
fn play(mut state: State, seed: u64, count: usize) {
    let mut dice = Dice(seed);
    for _ in 0..count {
        event(&mut state, &mut dice);
        for effect in std::mem::take(&mut state.effects) {
            // Files are not written, and the program goes on.
            if let Effect::Work(job) = effect
                && dice.below(8) > 0
            {
                run(&mut state, &job);
            }
        }
        check(&state);
    }
    // From any state the way out is the same.
    state.size = (80, 24);
    press(&mut state, "n");
    for _ in 0..12 {
        press(&mut state, "Esc");
    }
    assert!(state.prompt.is_none() && state.help.is_none() && state.picker.is_none(), "{:?}", state.picker);
    press(&mut state, "1");
    assert_eq!(state.view, View::Mechanism);
    let frame = text(&state, 80, 24);
    assert!(frame.contains("position") || frame.contains("instant"), "{frame}");
}

/// A four-bar with a motion and loads, quickly calculated.
fn small() -> State {
    let loads = "[motion]\nspeed = 2\n[[moment]]\nlink = \"rocker\"\nvalue = 3\n";
    scene(&(super::words::TURNS.to_owned() + loads))
}

#[test]
fn random_keys_leave_no_broken_state() {
    for seed in [1, 20, 300] {
        play(small(), seed, 400);
    }
    play(opened("shaper-drive"), 4000, 60);
}

/// A crank of 2 m, a coupler and a rocker of 1.5 m each, 3 m between the pins, all loaded: it can be assembled up to 70.5 degrees
/// on both sides of where all lie in one line.
pub(super) fn lost(from: &str, rocker: &str) -> String {
    format!(
        "gravity = 9.81\n[ground]\npoints = {{ O = [0, 0], C = [3, 0] }}\n\
        [link.crank]\npoints = {{ O = 0, A = 2 }}\nmass = 1\ncenter = 1\n[link.coupler]\npoints = {{ A = 0, B = 1.5 }}\nmass = 1\ncenter = 1\n\
        [link.rocker]\npoints = {{ C = 0, B = {rocker} }}\nmass = 1\ncenter = 1\n[[moment]]\nlink = \"rocker\"\nvalue = 3\n\
        [input]\nlink = \"crank\"\nfrom = \"{from}\"\npositions = 36\n[motion]\nspeed = 1\n[assembly]\nB = [2.5, 1.4]\n"
    )
}

/// Scenes that have no groups, of which some positions can't be assembled (the first one too), or none.
fn scanty() -> Vec<State> {
    let shipped = ["brake", "flywheel", "run-up", "disc-case-3"];
    let lost = [lost("0 deg", "1.5"), lost("-90 deg", "1.5"), lost("0 deg", "0.1")];
    shipped.into_iter().map(opened).chain(lost.iter().map(|text| scene(text))).collect()
}

#[test]
fn keys_in_every_view_of_a_scene_that_lacks_groups_or_positions_leave_no_broken_state() {
    for (seed, mut state) in (7..).zip(scanty()) {
        for view in '1'..='9' {
            for letter in '!'..='~' {
                // What opens a list or a line is closed again; what calculates for long is never done.
                for key in [KeyCode::Esc, KeyCode::Char(view), KeyCode::Char(letter)] {
                    command::press(&mut state, KeyEvent::from(key));
                }
                state.effects.clear();
                check(&state);
            }
        }
        play(state, seed, 30);
    }
}

#[test]
fn a_text_that_is_typed_or_pasted_ends_at_its_limit_and_that_is_told() {
    // The list of scenes, the help, the list of quantities, both lines, and an exact value.
    for keys in ["/", "? /", "p", "t /", ":", "e Enter"] {
        let mut state = if keys == "/" { super::empty(None) } else { opened("shaper-drive") };
        command::start(&mut state);
        super::settle(&mut state);
        press(&mut state, keys);
        let typed = |state: &State| state.entry().map_or(0, |entry| entry.len());
        let before = typed(&state);
        for _ in 0..2 * LONGEST {
            command::press(&mut state, KeyEvent::from(KeyCode::Char('x')));
        }
        assert_eq!(typed(&state), LONGEST, "{keys}");
        let full = state.entry().unwrap().to_string();
        command::paste(&mut state, &"y".repeat(1 << 16));
        assert_eq!(state.entry().unwrap().to_string(), full, "{keys}");
        command::prepare(&mut state);
        let frame = text(&state, 80, 24);
        assert!(keys.starts_with('?') || frame.contains("no more than 1024 bytes"), "{keys}: {frame}");
        // What was left out is reported no more where there is room again.
        for _ in before..LONGEST {
            command::press(&mut state, KeyEvent::from(KeyCode::Backspace));
        }
        command::prepare(&mut state);
        assert!(!text(&state, 80, 24).contains("no more than"), "{keys}");
        assert_eq!(typed(&state), before, "{keys}");
        command::paste(&mut state, &"\u{44f}".repeat(LONGEST));
        assert!((LONGEST - 1..=LONGEST).contains(&typed(&state)), "a letter is whole: {keys}");
    }
}

#[test]
#[ignore = "takes minutes"]
fn ten_thousand_random_keys_leave_no_broken_state() {
    for seed in 1..=10 {
        play(small(), seed, 1000);
    }
}
