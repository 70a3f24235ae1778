//! What is shown is whole and in no markup: in no view of any shipped scene, in no language is a number cut or parted from its unit.

use assur_figure::cells::cut;
use assur_fixtures::SCENES;
use assur_words::LANGUAGES;

use super::{VIEWS, opened, press, text, write};
use crate::screen::state::{State, View};

/// The frames of all views of the shipped scenes and their parts, in every language.
fn each_frame(mut check: impl FnMut(&str, &State)) {
    for (name, _) in SCENES {
        let mut state = opened(name);
        for language in LANGUAGES {
            state.look.language = language;
            for view in VIEWS.into_iter().chain([View::Results, View::Working, View::Accuracy]) {
                state.view = view;
                check(name, &state);
                for part in view.parts() {
                    state.parts.insert(view, *part);
                    check(name, &state);
                }
            }
        }
    }
}

/// The lines of a frame in which a text is cut, and whether it ends with a number or a sign.
fn cut_lines(state: &State, [width, height]: [u16; 2]) -> Vec<(bool, String)> {
    let frame = text(state, width, height);
    let cut = frame.lines().flat_map(|line| line.match_indices('…').map(move |(at, _)| (at, line)));
    let is_bad = |text: &str| !text.ends_with(|last: char| last.is_alphabetic() || last == ')');
    cut.map(|(at, line)| (is_bad(&line[..at]), line.to_owned())).collect()
}

#[test]
fn no_number_is_cut() {
    let (mut bad, mut seen) = (Vec::new(), 0);
    each_frame(|name, state| {
        for size in [[80, 24], [100, 30], [120, 40]] {
            for (is_bad, line) in cut_lines(state, size) {
                seen += 1;
                let (view, language) = (state.view, state.look.language);
                bad.extend(is_bad.then(|| format!("{name} {view:?} {size:?} {language}: {line}")));
            }
        }
    });
    assert!(bad.is_empty(), "{}", bad.join("\n"));
    assert!(seen > 100, "names are shortened in these views: {seen}");
}

#[test]
fn no_mark_of_a_subscript_is_seen() {
    let mut seen = 0;
    each_frame(|name, state| {
        let frame = text(state, 120, 40);
        assert!(!frame.contains("_{") && !frame.contains("^{"), "{name} {:?}: {frame}", state.view);
        seen += frame.matches("F_").count();
    });
    assert!(seen > 0, "forces have subscripts");
}

#[test]
fn the_results_before_and_after_a_change_are_whole() {
    for name in ["shaper", "shaper-drive", "press", "slider-crank"] {
        let mut state = opened(name);
        press(&mut state, "e");
        write(&mut state, "/crank.points.A");
        press(&mut state, "+");
        for language in LANGUAGES {
            state.look.language = language;
            let frame = text(&state, 80, 24);
            assert!(frame.matches(" -> ").count() > 2 && frame.contains(" %"), "{name}: {frame}");
            assert!(
                cut_lines(&state, [80, 24]).iter().all(|(is_bad, _)| !is_bad),
                "{name} {language}: {frame}"
            );
        }
    }
}

#[test]
fn a_shortened_text_ends_with_a_word() {
    for (whole, width, shown) in [
        ("excess work 198.991 J", 30, "excess work 198.991 J"),
        ("excess work 198.991 J", 20, "excess work…"),
        ("less than the 9.085 N·m of the load", 24, "less than the 9.085 N·m…"),
        ("less than the 9.085 N·m of the load", 21, "less than the…"),
        ("energies, J: 1 driving work  2 resisting work", 30, "energies, J: 1 driving work…"),
        ("3 mean  0; 20.4425; 31.5", 16, "3 mean…"),
        ("3 mean  -20.4425", 12, "3 mean…"),
        ("shaper-with-a-long-name", 10, "shaper-wi…"),
        ("0.123456789", 6, "…"),
    ] {
        assert_eq!(cut(whole, width), shown, "{whole}");
    }
}

#[test]
fn values_are_found_by_words() {
    let mut state = opened("shaper");
    press(&mut state, "e");
    write(&mut state, "/crank length");
    let key = state.draft.values[state.draft.chosen].key.to_string();
    assert!(key.starts_with("link.crank.points."), "{key}");
}
