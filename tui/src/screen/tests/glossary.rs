//! The help begins with what is chosen, and finds every word of the field with its formula and its source.

use std::collections::BTreeMap;

use assur_book::glossary;
use assur_fixtures::SCENES;
use assur_words::{LANGUAGES, Language, text};

use super::{View, opened, press, text};
use crate::screen::state::State;

/// The words of a frame, with single spaces: a sentence that is broken into rows is whole again.
fn words(state: &State) -> String {
    let frame = text(state, 80, 24);
    let rows = frame.lines().skip(2).map(|row| row.trim_matches(['│', '█', ' ']));
    rows.flat_map(str::split_whitespace).collect::<Vec<_>>().join(" ")
}

/// Opens the help, which has to begin with a title, and returns its words.
fn first(state: &mut State, title: &str) -> String {
    press(state, "?");
    let found = words(state);
    let begins = found.find("Chosen: ").map(|at| found[at..].starts_with(&format!("Chosen: {title}")));
    assert_eq!(begins, Some(true), "{title}: {found}");
    found
}

#[track_caller]
fn assert_has(found: &str, all: &[&str]) {
    let missing: Vec<_> = all.iter().filter(|one| !found.contains(**one)).collect();
    assert!(missing.is_empty(), "{missing:?}: {found}");
}

/// Chooses the result of an identity.
fn choose_fact(state: &mut State, id: &str) {
    state.view = View::Results;
    let results = &state.found().unwrap().results;
    state.chosen.result = results.iter().position(|(_, fact)| fact.id == id).unwrap();
}

#[test]
fn a_group_is_told_first() {
    let mut state = opened("shaper");
    press(&mut state, "9 Down");
    let found = first(&mut state, "group 2");
    let singular = ["singular: the guides parallel", "source: S stage 2; theory of two lines"];
    assert_has(&found, &["two links, an outer pin, a slide between them", "inner pairs: ", "outer pairs: "]);
    assert_has(&found, &singular);
    press(&mut state, "?");
    press(&mut state, "Up");
    assert_has(&first(&mut state, "group 1"), &["theory of the right triangle"]);
}

#[test]
fn a_result_is_told_first() {
    let mut state = opened("four-bar");
    choose_fact(&mut state, "fact-transmission");
    let found = first(&mut state, "least transmission angle (group 1)");
    let angle = ["angle: transmission angle between the links", "theory of two circles"];
    let word = ["between the directions of the force and of the motion that it transmits", "sin(γ) = |D|"];
    assert_has(&found, &angle);
    assert_has(&found, &word);
    assert_has(&found, &["source: S (Sychov, Vadimov), stage 2; in the note: Results"]);
    press(&mut state, "?");
    choose_fact(&mut state, "fact-swing");
    let found = first(&mut state, "swing of ");
    assert_has(
        &found,
        &["dead point position in which a slide or a link turns back", "formula: x′ = 0", "stage 3"],
    );
}

#[test]
fn the_help_of_a_result_is_read_without_scrolling() {
    let mut state = opened("four-bar");
    choose_fact(&mut state, "fact-transmission");
    press(&mut state, "?");
    insta::assert_snapshot!(text(&state, 80, 24));
}

#[test]
fn a_check_a_reaction_and_a_quantity_are_told_first() {
    let mut state = opened("shaper-friction");
    let checks = &state.found().unwrap().analysis.checks;
    state.chosen.check =
        checks.iter().position(|check| check.name.identity() == Some("check-virtual-power")).unwrap();
    state.view = View::Checks;
    let found = first(&mut state, "virtual power");
    assert_has(&found, &["power of all loads and inertia loads compared with that of the balancing load"]);
    assert_has(&found, &["formula: sum(F*v*cos(α)) + sum(M*ω) = 0"]);
    press(&mut state, "?");
    state.view = View::Forces;
    let found = first(&mut state, "");
    assert_has(&found, &["R_12 = -R_21", "friction circle circle about a pin", "h = f*r", "Artobolevsky"]);
    press(&mut state, "?");
    state.view = View::Mechanism;
    assert_has(&first(&mut state, ""), &["PF0 position function"]);
}

#[test]
fn a_number_of_the_scene_is_told_first() {
    let mut state = opened("shaper-friction");
    let keys: Vec<_> = state.draft.values.iter().map(|value| value.key.to_string()).collect();
    press(&mut state, "e");
    let is_radius = |key: &&String| key.starts_with("friction") && key.ends_with(".radius");
    let key = keys.iter().find(is_radius).unwrap();
    state.draft.chosen = keys.iter().position(|own| own == key).unwrap();
    let found = first(&mut state, &format!("{key}: "));
    // The dimension with its units, the limit, and that it has no default.
    assert_has(
        &found,
        &["length", "mm", "; not negative; needed, of: pin", "friction circle circle about a pin"],
    );
}

#[test]
fn where_nothing_is_chosen_the_view_is_told_first() {
    for (key, view, word) in [
        ("W", "Working", "kinetostatics"),
        ("8", "Methods", "residual"),
        ("6", "Drive", "flywheel"),
        ("4", "Plans", "force polygon"),
    ] {
        let mut state = opened("shaper-drive");
        press(&mut state, key);
        assert_has(&first(&mut state, view), &[word]);
    }
    let mut menu = super::empty(None);
    press(&mut menu, "?");
    assert!(!words(&menu).contains("Chosen"));
}

#[test]
fn words_are_found_by_letters_formulas_and_sources() {
    let searches = [
        (
            "f r i c t i o n Space c i r c l e",
            "circle about a pin, of radius h, which the reaction R touches",
        ),
        ("m _ k / ( s", "torque of an asynchronous motor over its slip s"),
        ("s q r t ( ( j", "the change of the kinetic energy T is the work A of the drive and all loads"),
        ("o r t e g a", "below 1 there is exactly one solution"),
        ("d e a d Space p o i n t", "its PF0 is extreme and its PF1 is zero"),
    ];
    for (typed, wanted) in searches {
        let mut state = opened("shaper");
        press(&mut state, &format!("? / {typed}"));
        assert_has(&words(&state), &[wanted, "source: "]);
    }
}

/// Each word by itself, so that its rows are all there: nothing of it is cut at the edge.
#[test]
fn no_sentence_of_a_word_is_cut() {
    let mut state = opened("shaper");
    for code in LANGUAGES {
        state.look.language = code;
        for entry in glossary::ENTRIES {
            press(&mut state, "? /");
            let told = |text: &assur_words::Text| state.told(text);
            let (word, meaning) = (told(&entry.word), told(&entry.meaning));
            let help = state.help.as_mut().unwrap();
            help.filter.text = meaning.as_str().into();
            let found = words(&state);
            assert_has(&found, &[&word, &meaning, entry.formula]);
            press(&mut state, "Esc");
        }
    }
}

#[test]
fn every_result_and_every_check_of_the_shipped_scenes_is_about_a_word() {
    let mut none = BTreeMap::new();
    for (name, _) in SCENES {
        let state = opened(name);
        let Some(found) = state.found() else { continue };
        for (_, fact) in &found.results {
            if glossary::of_fact(fact.id, fact.column).is_empty() {
                none.insert(fact.id, *name);
            }
        }
        for check in &found.analysis.checks {
            let words = check.name.identity().map(glossary::of_check).unwrap_or_default();
            assert!(words.len() > 1, "{}", check.name);
        }
    }
    // What a motor is, not what it does.
    let plain =
        ["fact-catalogue", "fact-rated-power", "fact-motor-mass", "fact-motor-length", "fact-motor-diameter"];
    none.retain(|id, _| !plain.contains(id));
    assert!(none.is_empty(), "{none:?}");
}

/// A table that names a text that has gone would find nothing.
#[test]
fn every_identity_with_words_is_that_of_a_text() {
    let english = Language::english();
    for id in glossary::subjects() {
        assert!(english.own(id).is_some(), "{id}");
        assert_ne!(text!(id).render(english), id);
    }
}
