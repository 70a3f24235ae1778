//! Tests of `note`.

mod numbers;

use std::collections::BTreeSet;

use assur_all as _;
use assur_scene::Note;

use super::words::Words;
use super::{Form, Written};
use crate::screen::state::State;
use crate::screen::still::{analyzed, open};

fn note(language: &'static str) -> Note {
    let text = |text: &str| Some(text.to_owned());
    Note { author: text("A. <B>"), group: None, variant: text("7"), language, positions: vec![3, 27] }
}

/// A scene with its analysis done.
fn state(scene: &str) -> State {
    analyzed(open(assur_fixtures::path(&format!("{scene}.toml"))).unwrap(), [None, None], true)
}

fn of(scene: &str, language: &'static str, form: Form) -> Written {
    super::write(&mut state(scene), &note(language), form, "figures").unwrap()
}

const RESOURCES: [&str; 3] =
    [include_str!("../../lang/en.ftl"), include_str!("../../lang/uk.ftl"), include_str!("../../lang/ru.ftl")];

#[test]
fn every_language_has_every_text() {
    let identifiers = |text: &'static str| -> BTreeSet<&str> {
        text.lines().filter_map(|line| line.split_once(" = ")).map(|(id, _)| id).collect()
    };
    let [en, uk, ru] = RESOURCES.map(identifiers);
    assert_eq!(en, uk);
    assert_eq!(en, ru);
    assert!(Words::of("tlh").is_err());
}

#[test]
fn both_translations_have_every_phrase_with_all_its_places() {
    let phrases = |text: &str| -> toml::Table {
        let table: toml::Table = text.parse().unwrap();
        table["phrases"].as_table().unwrap().clone()
    };
    let [uk, ru] = [include_str!("../../lang/uk.toml"), include_str!("../../lang/ru.toml")].map(phrases);
    assert!(uk.keys().eq(ru.keys()));
    for (english, own) in uk.iter().chain(&ru) {
        let places = |text: &str| text.matches("{}").count();
        assert_eq!(places(english), places(own.as_str().unwrap()), "{english}");
    }
}

#[test]
fn a_phrase_of_a_figure_is_translated_whole_and_names_are_not() {
    let words = Words::of("uk").unwrap();
    assert_eq!(words.phrase("velocity: 0.5 m/s"), "швидкість: 0,5 м/с");
    assert_eq!(words.phrase("speed of the motor, rad/s"), "швидкість двигуна, рад/с");
    assert_eq!(words.phrase("motorway on_mean 1.2.3"), "motorway on_mean 1,2,3");
    assert_eq!(words.phrase("μ_{v} = 0.0075 m/s/mm"), "μ_{v} = 0,0075 (м/с)/мм");
    assert_eq!(
        words
            .phrase("outer pin A: PF0 (-0.02, 1) m, PF1 (0, 0) m/rad, PF2 (0, 0) m/rad²")
            .matches('м')
            .count(),
        3
    );
    assert_eq!(
        words.phrase("Input link crank: reaction and balancing load").split(' ').nth(2),
        Some("crank:")
    );
    assert_eq!(
        words.name("I(ground,crank) -> II2(grounded,ram/ground)"),
        "I(стояк,crank) -> II2(grounded,ram/стояк)"
    );
    assert_eq!(words.unit("kg m2/rad"), "кг·м²/рад");
    assert_eq!(words.number("-1.50e-15"), "−1,50·10⁻¹⁵");
    assert_eq!(Words::of("en").unwrap().phrase("load on `ram`, 5 N m"), "load on ram, 5 N·m");
}

/// The texts between the tags.
fn visible(html: &str) -> String {
    let body = html.split_once("<body>").unwrap().1;
    let parts = body.split('<').map(|part| part.split_once('>').map_or("", |(_, text)| text));
    parts.collect::<Vec<_>>().join(" ")
}

#[test]
fn no_english_word_is_left_in_another_language() {
    for scene in
        ["shaper-drive", "press", "conveyor", "guide-shaper", "stephenson3", "brake", "andrews", "run-up"]
    {
        let state = state(scene);
        let mechanism = &state.scene.as_ref().unwrap().linkage.mechanism;
        let links = mechanism.links.iter().map(|link| link.name.as_str());
        let points = mechanism.points.iter().map(|point| point.name.as_str());
        let slides = mechanism.slides.iter().map(|slide| slide.name.as_str());
        let forces = mechanism.forces.iter().map(|load| load.name.as_str());
        let moments = mechanism.moments.iter().map(|load| load.name.as_str());
        let springs = mechanism.springs.iter().map(|load| load.name.as_str());
        let names = links.chain(points).chain(slides).chain(forces).chain(moments).chain(springs);
        // The name of the check of the source, of the analyzer, of functions, kinds of groups.
        let mut known: String = names.collect::<Vec<_>>().join(" ");
        known.extend([" TestPf atan2 groups ", &mechanism.title]);
        let known: BTreeSet<&str> = known.split(|c: char| !c.is_ascii_alphanumeric()).collect();
        for language in ["uk", "ru"] {
            let html = of(scene, language, Form::Html).text;
            for word in visible(&html).split(|c: char| !c.is_alphanumeric()) {
                let english = word.len() > 3 && word.chars().all(|c| c.is_ascii_lowercase());
                assert!(!english || known.contains(word), "{scene} {language}: {word}");
            }
        }
    }
}

#[test]
fn every_tag_is_closed_and_every_text_is_there() {
    for (scene, language) in [("shaper-drive", "uk"), ("press", "ru"), ("four-bar", "en"), ("brake", "uk")] {
        let html = of(scene, language, Form::Html).text;
        for tag in ["figure", "svg", "table", "thead", "tbody", "section", "h2", "p", "i", "sub", "sup", "td"]
        {
            let opened =
                html.matches(&format!("<{tag}>")).count() + html.matches(&format!("<{tag} ")).count();
            assert_eq!(opened, html.matches(&format!("</{tag}>")).count(), "{scene} {language}: {tag}");
        }
        assert!(html.contains("A. &lt;B&gt;") && !html.contains("NaN"), "{scene}");
        // An identifier without a text would be printed itself.
        let identifiers = RESOURCES[0].lines().filter_map(|line| line.split_once(" = "));
        for (id, _) in identifiers.filter(|(id, _)| id.contains('-')) {
            assert!(!html.contains(&format!(">{id}<")), "{scene} {language}: {id}");
        }
    }
}

#[test]
fn all_forms_have_the_same_figures_and_tables() {
    let [html, md, typ] =
        [Form::Html, Form::Markdown, Form::Typst].map(|form| of("shaper-drive", "en", form));
    let figures = html.text.matches("<figure>").count();
    assert!(figures > 8, "{figures}");
    assert_eq!(md.figures.len(), figures);
    for (name, drawn) in &md.figures {
        assert_eq!(md.text.matches(&format!("](<figures/{name}>)")).count(), 1, "{name}");
        assert!(drawn.starts_with("<svg"), "{name}");
    }
    assert_eq!(typ.text.matches("image(bytes(").count(), figures);
    let tables = html.text.matches("<table").count() - 1;
    assert_eq!(md.text.matches("| --").count().min(1), 1);
    assert_eq!(
        md.text.lines().filter(|line| line.starts_with("| ---") || line.starts_with("| --:")).count(),
        tables
    );
    assert_eq!(typ.text.matches("#figure(table(").count(), tables);
    let equations = html.text.matches("<p class=\"eq\">").count();
    assert_eq!(
        md.text.lines().filter(|line| line.starts_with('$') && line.ends_with('$')).count(),
        equations
    );
}
