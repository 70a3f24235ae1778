//! Tests of `note`.

use std::collections::BTreeSet;

use assur_all as _;
use assur_scene::Note;

use super::words::Words;
use crate::number::digits;
use crate::screen::still::{analyzed, open};

fn note(language: &'static str) -> Note {
    let text = |text: &str| Some(text.to_owned());
    Note { author: text("A. <B>"), group: None, variant: text("7"), language, positions: vec![3, 27] }
}

fn of(scene: &str, language: &'static str) -> String {
    let path = assur_fixtures::path(&format!("{scene}.toml"));
    let mut state = analyzed(open(path).unwrap(), [None, None], true);
    super::write(&mut state, &note(language)).unwrap()
}

/// Identifiers of a resource, apart from the words of figures.
fn identifiers(text: &str) -> BTreeSet<&str> {
    let ids = text.lines().filter_map(|line| line.split_once(" = ")).map(|(id, _)| id);
    ids.filter(|id| !id.starts_with('#') && !id.starts_with("w-")).collect()
}

#[test]
fn every_language_has_every_text() {
    let [en, uk, ru] = [
        include_str!("../../lang/en.ftl"),
        include_str!("../../lang/uk.ftl"),
        include_str!("../../lang/ru.ftl"),
    ];
    assert_eq!(identifiers(en), identifiers(uk));
    assert_eq!(identifiers(en), identifiers(ru));
    assert!(Words::of("tlh").is_err());
}

#[test]
fn a_phrase_of_a_figure_is_translated_whole_and_names_are_not() {
    let words = Words::of("uk").unwrap();
    assert_eq!(words.phrase("velocity: 0.5 m/s"), "швидкість: 0,5 m/s");
    assert_eq!(words.phrase("speed of the motor, rad/s"), "швидкість двигуна, rad/s");
    assert_eq!(words.phrase("motorway on_mean 1.2.3"), "motorway on_mean 1,2,3");
}

#[test]
fn the_numbers_of_the_note_are_those_of_the_results() {
    let path = assur_fixtures::path("shaper-drive.toml");
    let mut state = analyzed(open(path).unwrap(), [None, None], true);
    let html = super::write(&mut state, &note("en")).unwrap();
    let found = state.found().unwrap();
    let dynamics = found.analysis.dynamics.as_ref().unwrap();
    for value in [dynamics.mean_speed, dynamics.unevenness, dynamics.excess_work, dynamics.flywheel.unwrap()]
    {
        assert!(html.contains(&format!("<td>{}</td>", digits(value, 6))), "{value}");
    }
    for reaction in found.reactions.iter().filter(|reaction| !reaction.pair.is_empty()) {
        let series = &found.series[reaction.series[2]];
        for position in [3, 27] {
            assert!(html.contains(&format!("<td>{}</td>", digits(series.at(position), 5))), "{}", series.of);
        }
    }
    for check in &found.analysis.checks {
        assert!(html.contains(&format!("<tr><td>{}</td>", check.name)), "{}", check.name);
    }
}

#[test]
fn every_tag_is_closed_and_every_text_is_there() {
    for (scene, language) in [("shaper-drive", "uk"), ("press", "ru"), ("four-bar", "en"), ("brake", "uk")] {
        let html = of(scene, language);
        for tag in ["figure", "svg", "table", "thead", "tbody", "section", "h2", "p", "i", "sub", "sup"] {
            let opened =
                html.matches(&format!("<{tag}>")).count() + html.matches(&format!("<{tag} ")).count();
            assert_eq!(opened, html.matches(&format!("</{tag}>")).count(), "{scene} {language}: {tag}");
        }
        assert!(html.contains("A. &lt;B&gt;") && !html.contains("NaN"), "{scene}");
        // An identifier without a text would be printed itself.
        assert!(!html.contains(">points-of-links<") && !html.contains("task-text"), "{scene}");
    }
}
