//! Every key in every view, and what the important ones do.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use super::{View, opened, press, settle, text, write};
use crate::screen::command::{self, COMMANDS};
use crate::screen::state::{Look, State, Wish};

/// Everything that the state's frame and next steps depend on, for comparison.
fn fingerprint(state: &State) -> String {
    let rest =
        (&state.view, &state.wishes, &state.prompt, &state.look, &state.chosen, state.playing, state.plan);
    format!("{}{rest:?}", text(state, 120, 40))
}

#[test]
fn every_key_in_every_view_is_survived() {
    let mut state = opened("shaper.toml");
    for view in super::VIEWS.into_iter().chain([View::Menu, View::Accuracy]) {
        for code in (' '..='~').map(KeyCode::Char).chain([
            KeyCode::Enter,
            KeyCode::Esc,
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
            KeyCode::F(1),
            KeyCode::Delete,
            KeyCode::Null,
        ]) {
            for modifiers in [KeyModifiers::NONE, KeyModifiers::CONTROL] {
                (state.help, state.prompt, state.question) = (None, None, None);
                state.view = view;
                command::press(&mut state, KeyEvent::new(code, modifiers));
                state.wishes.clear();
            }
        }
        let _ = text(&state, 80, 24);
    }
}

#[test]
fn every_command_does_something() {
    for command in COMMANDS.iter().filter(|command| command.name != "close") {
        let mut acts = false;
        for view in
            super::VIEWS.into_iter().chain([View::Menu, View::Accuracy]).filter(|view| command.fits(*view))
        {
            let mut state = opened("shaper.toml");
            state.view = view;
            (state.position, state.zoom.factor, state.chosen.line) = (7, 2.0, 1);
            state.accuracy.lines = vec![String::new(); 9];
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
    for view in super::VIEWS.into_iter().chain([View::Menu, View::Accuracy]) {
        let fit: Vec<_> = COMMANDS.iter().filter(|command| command.fits(view)).collect();
        for (i, one) in fit.iter().enumerate() {
            for two in &fit[i + 1..] {
                let shared = one.keys.iter().find(|key| two.keys.contains(key));
                assert!(shared.is_none(), "{view:?}: `{}` and `{}` share {shared:?}", one.name, two.name);
            }
        }
    }
}

#[test]
fn every_command_has_its_texts() {
    let texts = crate::screen::text::ENGLISH.commands;
    for command in COMMANDS {
        assert!(
            texts.iter().any(|(name, help, _)| *name == command.name && !help.is_empty()),
            "{}",
            command.name
        );
    }
    assert_eq!(texts.len(), COMMANDS.len());
}

#[test]
fn positions_go_round() {
    let mut state = opened("shaper.toml");
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
    let mut state = opened("shaper.toml");
    for view in super::VIEWS.into_iter().filter(|view| *view != View::Drive) {
        state.view = view;
        let before = state.position;
        press(&mut state, "Right");
        assert_eq!(state.position, before + 1, "{view:?}");
    }
}

#[test]
fn quit_closes_the_help_first() {
    let mut state = opened("shaper.toml");
    press(&mut state, "?");
    assert!(state.help.is_some());
    press(&mut state, "q");
    assert!(state.help.is_none());
    command::press(&mut state, KeyEvent::new(KeyCode::Char('q'), KeyModifiers::NONE));
    assert!(matches!(state.wishes[..], [Wish::Quit]));
}

#[test]
fn the_line_understands_positions_points_views_and_settings() {
    let mut state = opened("shaper.toml");
    write(&mut state, ":42");
    assert_eq!(state.position, 42);
    write(&mut state, ":point D");
    assert_eq!(state.study.as_ref().unwrap().transfers[state.chosen.transfer].name, "point D x");
    write(&mut state, ":view checks");
    assert_eq!(state.view, View::Checks);
    write(&mut state, ":set theme mono");
    assert_eq!(state.look.theme.name(), "mono");
    write(&mut state, ":next-position");
    assert_eq!(state.position, 43);
}

#[test]
fn the_line_says_what_it_does_not_know() {
    let mut state = opened("shaper.toml");
    for (line, answer) in [
        (":xx", "there is no command `xx`"),
        (":48", "there is no position 48: the last one is 47"),
        (":point Q", "there is no `point Q` here; did you mean `A`?"),
        (":set theme pink", "`theme` takes default, mono, okabe-ito, not `pink`"),
        (":view chekcs", "did you mean `checks`?"),
        ("/nothing", "`nothing` was not found"),
    ] {
        write(&mut state, line);
        let frame = text(&state, 80, 24);
        assert!(frame.contains(answer), "{line}: {frame}");
    }
}

#[test]
fn tab_completes() {
    let mut state = opened("shaper.toml");
    press(&mut state, ": s e t Space t h Tab Tab");
    assert_eq!(state.prompt.as_ref().unwrap().text, "set theme mono");
    press(&mut state, "S-Tab Enter");
    assert_eq!(state.look.theme.name(), "default");
}

#[test]
fn search_finds_rows_and_columns() {
    let mut state = opened("shaper.toml");
    press(&mut state, "t");
    write(&mut state, "/31");
    assert_eq!(state.position, 31);
    write(&mut state, "/ram");
    let study = state.study.as_ref().unwrap();
    assert!(study.column(state.chosen.column).unwrap().of.contains("ram"));
}

#[test]
fn the_worst_position_of_a_check_is_reached() {
    let mut state = opened("shaper.toml");
    press(&mut state, "7 Down Down Enter 1");
    let study = state.study.as_ref().unwrap();
    let at = study.found.as_ref().unwrap().checks[2].at.unwrap();
    assert!(text(&state, 80, 24).contains(&format!("position {at} of")));
}

#[test]
fn the_menu_opens_a_scene() {
    let mut state = State::new(None, Look::default());
    crate::screen::act::preview_menu(&mut state);
    settle(&mut state);
    assert!(text(&state, 80, 24).contains("Shaper with rocker"));
    press(&mut state, "Down Down Enter");
    assert!(text(&state, 80, 24).contains("Compressor"));
}

#[test]
fn sorting_orders_the_rows() {
    let mut state = opened("shaper.toml");
    press(&mut state, "t Tab s");
    let study = state.study.as_ref().unwrap();
    let order = crate::screen::view::table::order(&state);
    let values: Vec<f64> = order.iter().map(|i| study.series[1].values[*i]).collect();
    assert!(values.windows(2).all(|two| two[0] <= two[1]));
}
