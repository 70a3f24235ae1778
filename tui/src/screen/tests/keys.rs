//! Every key in every view, and what the important ones do.

use assur_words::{LANGUAGES, Language, name};
use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use strum::VariantArray;

use super::random::NAMED;
use super::{View, opened, press, settle, text, write};
use crate::screen::command::{self, COMMANDS};
use crate::screen::state::{Effect, Key, Keymap, Measured, Probe, Series, State, Theme};

/// Everything that the state's frame and next steps depend on, for comparison.
fn fingerprint(state: &State) -> String {
    let rest = (
        &state.view,
        &state.effects,
        &state.prompt,
        &state.look,
        &state.chosen,
        state.playing,
        &state.panels,
    );
    format!("{}{rest:?}{:?}", text(state, 120, 40), state.draft)
}

/// Goes to a view; the list of values is opened below the mechanism, and the moved point over it.
fn enter(state: &mut State, view: View) {
    if state.values_open() != (view == View::Values) {
        command::toggle(state);
    }
    let inset = matches!(view, View::Values | View::Probe);
    state.view = if inset { View::Mechanism } else { view };
    if view == View::Build {
        state.view = View::Mechanism;
        press(state, "B");
        state.build.line = Some(7);
    }
    state.probe = (view == View::Probe).then_some(Probe { link: 2, at: [0.0, 0.1] });
}

#[test]
fn every_key_in_every_view_is_survived() {
    let mut state = opened("shaper");
    for view in View::VARIANTS.iter().copied() {
        for code in (' '..='~').map(KeyCode::Char).chain(NAMED) {
            for modifiers in [KeyModifiers::NONE, KeyModifiers::CONTROL] {
                (state.help, state.prompt, state.question, state.picker) = (None, None, None, None);
                enter(&mut state, view);
                command::press(&mut state, KeyEvent::new(code, modifiers));
                state.effects.clear();
            }
        }
        let _ = text(&state, 80, 24);
    }
}

#[test]
fn every_command_does_something() {
    // What is opened is closed, and of several sheets the next is shown: neither is there.
    for command in COMMANDS.iter().filter(|command| !["close", "next-sheet"].contains(&command.name)) {
        let mut acts = false;
        for view in View::VARIANTS.iter().copied().filter(|view| command.fits(*view)) {
            let mut state = opened("shaper");
            enter(&mut state, view);
            (state.position, state.zoom.factor, state.chosen.line, state.chosen.field) = (7, 2.0, 1, 1);
            let chart = Err(name("line\n".repeat(90)));
            state.measured = Some(Box::new(Measured { chart, stability: None }));
            let before = fingerprint(&state);
            (command.run)(&mut state);
            acts |= fingerprint(&state) != before;
            if acts {
                break;
            }
        }
        assert!(acts, "`{}` does nothing", command.name);
    }
}

#[test]
fn no_key_means_two_things_in_a_view() {
    let clashes = Keymap::of(COMMANDS).clashes(COMMANDS);
    let names: Vec<_> = clashes.iter().map(|(key, view, both)| (key, view, both.map(|c| c.name))).collect();
    assert!(names.is_empty(), "{names:?}");
    // The search for clashes sees one that is there.
    let mut keys = Keymap::of(COMMANDS);
    keys.bind("play", vec![Key::parse("q").unwrap()]);
    assert_eq!(keys.clashes(COMMANDS).len(), 1);
}

#[test]
fn other_keys_are_what_counts_and_what_is_shown() {
    let mut state = opened("shaper");
    for (name, key) in [("next-position", "i"), ("previous-position", "y"), ("help", "F1"), ("curves", "C-e")]
    {
        state.keys.bind(name, vec![Key::parse(key).unwrap()]);
    }
    let frame = text(&state, 80, 24);
    let hints: Vec<&str> = frame.lines().skip(22).collect();
    assert!(hints[0].starts_with(" y/i step") && hints[1].ends_with("F1 all keys"), "{frame}");
    assert!(text(&state, 80, 24).contains("C-e Curv "));
    press(&mut state, "i i Right y");
    assert_eq!(state.position, 1);
    press(&mut state, "C-e");
    assert_eq!(state.view, View::Curves);
    press(&mut state, "F1");
    let help = text(&state, 80, 24);
    assert!(help.lines().any(|line| line.contains(" i ") && line.contains("next-position")), "{help}");
    press(&mut state, "F1");
    assert!(state.help.is_none());
}

#[test]
fn a_configuration_that_is_wrong_is_told_until_the_next_key() {
    let mut state = opened("shaper");
    state.fault = Some((
        name("The configuration could not be used"),
        name("error: two\n  config.toml, line 2, column 1"),
    ));
    let frame = text(&state, 80, 24);
    assert!(
        frame.contains("The configuration could not be used") && frame.contains("line 2, column 1"),
        "{frame}"
    );
    press(&mut state, "Right");
    assert!(!text(&state, 80, 24).contains("configuration"));
    assert_eq!(state.position, 1);
}

#[test]
fn every_command_has_its_help_and_keys_that_are_read() {
    for command in COMMANDS {
        for language in LANGUAGES {
            let help = command.help(Language::find(language).unwrap());
            assert!(!help.is_empty() && !help.starts_with("do-"), "{language}: {}", command.name);
        }
        assert_eq!(command.default_keys().len(), command.keys.split_whitespace().count(), "{}", command.name);
    }
}

#[test]
fn positions_go_round() {
    let mut state = opened("shaper");
    press(&mut state, "Right");
    assert_eq!(state.position, 1);
    press(&mut state, "Left Left");
    assert_eq!(state.position, 47);
    press(&mut state, "Home PgDn PgDn PgUp");
    assert_eq!(state.position, 6);
    press(&mut state, "End");
    assert!(text(&state, 80, 24).contains("position 47"));
}

#[test]
fn one_position_through_all_views() {
    let mut state = opened("shaper");
    for view in crate::screen::tests::VIEWS.into_iter().filter(|view| *view != View::Drive) {
        state.view = view;
        let before = state.position;
        press(&mut state, "Right");
        assert_eq!(state.position, before + 1, "{view:?}");
    }
}

#[test]
fn quit_closes_the_help_and_the_list_of_values_first() {
    let mut state = opened("shaper");
    press(&mut state, "?");
    assert!(state.help.is_some());
    press(&mut state, "q");
    assert!(state.help.is_none());
    press(&mut state, "e");
    assert!(state.values_open());
    press(&mut state, "q");
    assert!(!state.values_open() && state.effects.is_empty());
    command::press(&mut state, KeyEvent::new(KeyCode::Char('q'), KeyModifiers::NONE));
    assert!(matches!(state.effects[..], [Effect::Quit]));
}

#[test]
fn the_line_understands_positions_points_views_and_settings() {
    let mut state = opened("shaper");
    write(&mut state, ":42");
    assert_eq!(state.position, 42);
    write(&mut state, ":position 12");
    assert_eq!(state.position, 12);
    write(&mut state, ":42");
    write(&mut state, ":point D");
    assert_eq!(state.scene.as_ref().unwrap().transfers[state.chosen.transfer].name.to_string(), "point D x");
    write(&mut state, ":view checks");
    assert_eq!(state.view, View::Checks);
    write(&mut state, ":set theme mono");
    assert_eq!(state.look.theme, Theme::Mono);
    write(&mut state, ":next-position");
    assert_eq!(state.position, 43);
}

#[test]
fn what_the_screen_names_is_found_by_this_name() {
    for scene in ["shaper", "shaper-friction", "triad", "press-compression"] {
        let mut state = opened(scene);
        let found = state.found().unwrap();
        let reactions: Vec<_> = found.reactions.iter().map(|reaction| state.told(&reaction.name)).collect();
        let columns = state.scene.as_ref().unwrap().columns();
        let names = |series: &Series| [state.told(series.told()), state.told(&series.head)];
        let columns: Vec<_> = columns.map(|series| (names(series), series.short.clone())).collect();
        state.view = View::Forces;
        for (index, name) in reactions.iter().enumerate() {
            write(&mut state, &format!("/{name}"));
            assert_eq!(state.chosen.reaction, index, "{scene}: {name}");
        }
        state.view = View::Table;
        for (index, (names, short)) in columns.iter().enumerate() {
            for name in names.iter().chain([short]) {
                state.chosen.column = 0;
                write(&mut state, &format!("/{name}"));
                let found = &columns[state.chosen.column];
                assert!(state.chosen.column == index || found.0.contains(name), "{scene}: {name}: {found:?}");
            }
        }
    }
}

#[test]
fn the_line_says_what_it_does_not_know() {
    let mut state = opened("shaper");
    for (line, answer) in [
        (":xx", "there is no command `xx`"),
        (":48", "there is no position 48: the last one is 47"),
        (":point Q", "there is no `point Q` here"),
        (":set theme pink", "`theme` takes default, mono, okabe-ito, not `pink`"),
        (":view chekcs", "did you mean `checks`?"),
        ("/nothing", "`nothing` was not found"),
        ("/b", "`b` was not found"),
        ("/point E PF3", "`point E PF3` was not found; did you mean `point E"),
    ] {
        write(&mut state, line);
        let frame = text(&state, 80, 24);
        assert!(frame.contains(answer), "{line}: {frame}");
    }
}

#[test]
fn tab_completes() {
    let mut state = opened("shaper");
    press(&mut state, ": s e t Space t h Tab Tab");
    assert_eq!(state.prompt.as_ref().unwrap().text.to_string(), "set theme mono");
    press(&mut state, "S-Tab Enter");
    assert_eq!(state.look.theme, Theme::Default);
}

#[test]
fn search_finds_rows_and_columns() {
    let mut state = opened("shaper");
    press(&mut state, "t");
    write(&mut state, "/31");
    assert_eq!(state.position, 31);
    write(&mut state, "/ram");
    let scene = state.scene.as_ref().unwrap();
    assert!(scene.column(state.chosen.column).unwrap().of.to_string().contains("ram"));
}

#[test]
fn search_among_the_forces_finds_pairs() {
    let mut state = opened("shaper");
    press(&mut state, "3");
    for (wanted, pair) in [("c", "C"), ("A", "A"), ("stone4", "stone4/ram"), ("ram", "ram/ground")] {
        write(&mut state, &format!("/{wanted}"));
        let found = state.scene.as_ref().unwrap().found.as_ref().unwrap();
        assert_eq!(found.reactions[state.chosen.reaction].of.as_ref().unwrap().0, pair);
    }
    write(&mut state, "/31");
    assert_eq!(state.position, 31);
}

#[test]
fn the_worst_position_of_a_check_is_reached() {
    let mut state = opened("shaper");
    press(&mut state, "7 Down Down Enter 1");
    let scene = state.scene.as_ref().unwrap();
    let at = scene.found.as_ref().unwrap().analysis.checks[2].at.unwrap();
    assert!(text(&state, 80, 24).contains(&format!("position {at} (")));
}

#[test]
fn the_menu_opens_a_scene() {
    let mut state = super::empty(None);
    command::start(&mut state);
    settle(&mut state);
    // Above the shipped scenes: a new one, and the tour.
    press(&mut state, "Down Down");
    assert!(text(&state, 80, 24).contains("Shaper with rocker"));
    press(&mut state, "Down Down Down Enter");
    assert!(text(&state, 80, 24).contains("Compressor"));
}

#[test]
fn sorting_orders_the_rows() {
    let mut state = opened("shaper");
    press(&mut state, "t Tab s");
    let scene = state.scene.as_ref().unwrap();
    let order = state.order();
    let values: Vec<f64> = order.iter().map(|i| scene.series[1].at(*i)).collect();
    assert!(values.windows(2).all(|two| two[0] <= two[1]));
}
