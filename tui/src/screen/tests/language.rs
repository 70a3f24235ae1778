//! No English word is left in another language: in no view, list or text report of any shipped scene, and in no text of the
//! resources. What may be there in Latin letters comes from the scene, from the registries and from the command line.

use std::collections::BTreeSet;

use assur_fixtures::SCENES;
use assur_words::{LANGUAGES, Language, Resource, inventory};

use english::{of_the_registries, words};

use super::{opened, press, text};
use crate::screen::command::COMMANDS;
use crate::screen::state::{Key, SETTINGS, State, View};

#[path = "../../../tests/english/mod.rs"]
mod english;

/// The languages that have letters of their own.
const OTHERS: [&str; 2] = ["uk", "ru"];

/// The English words of a text; a name may be cut at the edge of a view.
fn english(text: &str, allowed: &[&BTreeSet<String>]) -> Vec<String> {
    let begins = |all: &BTreeSet<String>, word: &str| {
        all.range(word.to_owned()..).next().is_some_and(|known| known.starts_with(word))
    };
    english::english(text, |word| allowed.iter().any(|all| begins(all, word)))
}

/// What the registries, the keys and the command line name.
fn of_the_program() -> BTreeSet<String> {
    let mut all = format!("{} {} {}", of_the_registries(), Key::names(), assur_formula::FUNCTIONS);
    let mut add = |text: &str| all.extend([" ", text]);
    for command in COMMANDS {
        add(command.name);
    }
    for setting in &SETTINGS {
        add(setting.name);
        for word in setting.kind.words() {
            add(word);
        }
    }
    let program = crate::cli::program();
    for command in program.get_subcommands() {
        add(command.get_name());
    }
    let options = program.get_subcommands().chain([&program]).flat_map(clap::Command::get_arguments);
    for option in options {
        option.get_long().into_iter().for_each(&mut add);
        option.get_value_names().into_iter().flatten().for_each(|name| add(name));
        for value in &option.get_possible_values() {
            add(value.get_name());
        }
    }
    for (name, text) in SCENES {
        add(name);
        add(&assur_scene::read(name, text).unwrap().title);
    }
    words(&all).map(str::to_lowercase).collect()
}

/// What a scene names: its title, links, points, slides and loads.
fn of_scene(state: &State) -> BTreeSet<String> {
    let mechanism = &state.scene.as_ref().unwrap().linkage.mechanism;
    let links = mechanism.links.iter().skip(1).map(|one| &one.name);
    let points = mechanism.points.iter().map(|one| &one.name);
    let slides = mechanism.slides.iter().map(|one| &one.name);
    let loads = mechanism.loads.iter().map(|one| &one.name);
    let all = links.chain(points).chain(slides).chain(loads);
    // The words that the program gives are not those of the scene. Headings of columns have the names of parts, other texts their labels.
    let own = all
        .map(|own| format!("{own} {}", assur_words::Text::from(own).render(Language::find("ru").unwrap())));
    let own = own.chain([mechanism.title.to_string()]).collect::<Vec<_>>().join(" ");
    words(&own).map(str::to_lowercase).collect()
}

#[test]
fn no_text_of_the_resources_has_english_words_in_another_language() {
    let program = of_the_program();
    for resource in inventory::iter::<Resource>.into_iter().filter(|one| OTHERS.contains(&one.language)) {
        let mut kept = String::new();
        for line in resource.texts.lines().filter(|line| !line.starts_with('#')) {
            // Names of texts, of their attributes and of their values are no words.
            let text =
                line.split_once('=').filter(|(id, _)| !id.contains('{')).map_or(line, |(_, text)| text);
            let mut depth = 0_usize;
            for letter in text.chars() {
                depth = if letter == '}' { depth.saturating_sub(1) } else { depth };
                if depth == 0 && letter != '{' {
                    kept.push(letter);
                }
                depth += usize::from(letter == '{');
            }
            kept.push('\n');
        }
        let kept = kept.replace("[one]", "").replace("[few]", "").replace("*[many]", "");
        let found = english(&kept, &[&program]);
        assert!(found.is_empty(), "{} {}: {found:?}", resource.crate_name, resource.language);
    }
}

/// The views whose texts are made by the terminal UI alone.
const OWN: [View; 5] = [View::Mechanism, View::Curves, View::Motion, View::Accuracy, View::Table];

/// The English words in views of every shipped scene.
fn english_in(views: &[View]) -> String {
    let program = of_the_program();
    let mut all = BTreeSet::new();
    for (name, _) in SCENES {
        let mut state = opened(name);
        let scene = of_scene(&state);
        for language in OTHERS {
            state.look.language = language;
            for &shown in views {
                state.view = shown;
                let parts = state.available_parts(shown);
                for part in parts.into_iter().map(Some).chain([None]) {
                    part.map(|part| state.parts.insert(shown, part));
                    let found = english(&text(&state, 80, 24), &[&program, &scene]);
                    all.extend(found.into_iter().map(|word| format!("{name} {shown:?} {part:?}: {word}")));
                }
            }
        }
    }
    all.into_iter().collect::<Vec<_>>().join("\n")
}

#[test]
fn no_view_of_the_ui_alone_has_english_words_in_another_language() {
    let found = english_in(&OWN);
    assert!(found.is_empty(), "{found}");
}

#[test]
fn no_view_has_english_words_in_another_language() {
    let found = english_in(&View::TABS);
    assert!(found.is_empty(), "{found}");
}

/// The word is a key's value too, so that the search for English words lets it pass.
#[test]
fn the_formula_of_structure_names_the_ground_in_the_language_that_is_shown() {
    let mut state = opened("shaper");
    state.view = View::Structure;
    for (language, formula) in [("uk", "I(стояк,кривошип)"), ("ru", "I(стойка,кривошип)")]
    {
        state.look.language = language;
        assert!(text(&state, 80, 24).contains(formula), "{}", text(&state, 80, 24));
    }
}

#[test]
fn help_and_lists_have_no_english_words_in_another_language() {
    let program = of_the_program();
    let mut state = opened("shaper-drive");
    let scene = of_scene(&state);
    for language in OTHERS {
        state.look.language = language;
        for keys in ["1 ?", "1 p", "6 p", "1 o"] {
            press(&mut state, keys);
            let found = english(&text(&state, 100, 400), &[&program, &scene]);
            assert!(found.is_empty(), "{keys}: {found:?}");
            press(&mut state, "Esc Esc");
        }
    }
}

#[test]
fn a_quantity_is_found_in_the_language_that_is_shown() {
    let mut state = opened("shaper");
    for (language, typed) in [("ru", "с к о р о с т ь"), ("uk", "ш в и д к і с т ь")] {
        state.look.language = language;
        press(&mut state, &format!("p {typed}"));
        let picker = state.picker.as_ref().unwrap();
        assert!(!picker.left().is_empty() && picker.left().len() < picker.rows.len(), "{language}");
        press(&mut state, "Esc");
    }
}

#[test]
fn the_report_of_a_scene_has_no_english_words_in_another_language() {
    let program = of_the_program();
    let mut all = Vec::new();
    for (name, _) in SCENES {
        let state = opened(name);
        let (scene, names) = (state.scene.as_ref().unwrap(), of_scene(&state));
        let Some(found) = state.found() else { continue };
        for language in OTHERS {
            let language = Language::find(language).unwrap();
            let style = assur_report::text::Style { language, ascii: false };
            let report =
                assur_report::text::report(&found.analysis, &scene.linkage, Some(&[0]), style).unwrap();
            all.extend(
                english(&report, &[&program, &names]).into_iter().map(|word| format!("{name}: {word}")),
            );
        }
    }
    all.sort();
    all.dedup();
    assert!(all.is_empty(), "{}", all.join("\n"));
}

#[test]
fn numbers_of_the_regime_are_whole_at_80_columns() {
    let mut state = opened("shaper-drive");
    let facts = assur_report::topic::regime_facts(&state.found().unwrap().analysis);
    let shown = ["fact-unevenness", "fact-dynamic-unevenness", "fact-greatest-speed", "fact-required-power"];
    for code in LANGUAGES {
        state.look.language = code;
        for view in [View::Motion, View::Drive] {
            state.view = view;
            let frame = text(&state, 80, 24);
            for id in shown {
                let fact = facts.iter().find(|fact| fact.id == id).unwrap();
                let value = fact.with_unit().render(Language::find(code).unwrap());
                assert!(frame.contains(&value), "{code} {view:?}: {value}: {frame}");
            }
        }
    }
}

#[test]
fn whatever_is_told_fits_into_80_columns() {
    let told = |name: &'static str| {
        let state = opened(name);
        let (scene, found) = (state.scene.as_ref().unwrap(), state.found()?);
        let source = assur_report::topic::Source::of(&found.analysis, &scene.linkage, Some(&[0]));
        Some(assur_report::topic::report(&source))
    };
    for (name, _) in SCENES {
        let Some(document) = told(name) else { continue };
        for code in LANGUAGES {
            let style = assur_report::text::Style { language: Language::find(code).unwrap(), ascii: false };
            for line in assur_report::text::lines(&document.blocks, style, 78) {
                let width = unicode_width::UnicodeWidthStr::width(line.text.as_str());
                assert!(width <= 78, "{name} {code}: {}", line.text);
            }
        }
    }
}
