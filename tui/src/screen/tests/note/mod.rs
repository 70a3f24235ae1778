//! Tests of the note.

mod facts;
mod figures;
mod numbers;
mod teacher;

use std::collections::BTreeSet;

use assur_all as _;
use assur_analysis::{Options, unwatched};
use assur_note::{Form, Written};
use assur_picture::Results;
use assur_scene::Note;

use crate::session::{Session, Source};

fn note(language: &'static str) -> Note {
    let text = |text: &'static str| Some(assur_words::name(text));
    let language = Some(language);
    Note { author: text("A. <B>"), variant: text("7"), language, positions: vec![3, 27], ..Note::default() }
}

/// A scene with its analysis done.
fn results(scene: &str) -> Results {
    let session = Session::open(Source::File(assur_fixtures::path(&format!("{scene}.toml")))).unwrap();
    session.analyzed(&Options::default(), true, &mut unwatched).unwrap()
}

fn written(results: &Results, language: &'static str, form: Form) -> Written {
    assur_note::write(results, &note(language), form, "figures").unwrap()
}

fn of(scene: &str, language: &'static str, form: Form) -> Written {
    written(&results(scene), language, form)
}

/// The texts between the tags.
fn visible(html: &str) -> String {
    let body = html.split_once("<body>").unwrap().1;
    let parts = body.split('<').map(|part| part.split_once('>').map_or("", |(_, text)| text));
    parts.collect::<Vec<_>>().join(" ")
}

#[test]
fn advice_on_the_scene_is_not_part_of_the_note() {
    let text = assur_fixtures::scene("shaper").replace("D = [0.17, 0.28]", "D = [9, 9]");
    let session = Session::read(Source::New, text).unwrap();
    let results = session.analyzed(&Options::default(), true, &mut unwatched).unwrap();
    let warnings = &results.found.as_ref().unwrap().analysis.warnings;
    let advice: Vec<String> =
        warnings.iter().filter(|one| one.is_mistake()).map(|one| one.text.to_string()).collect();
    assert!(advice.iter().any(|text| text.contains("[assembly]")), "{advice:?}");
    let note = written(&results, "en", Form::Markdown).text;
    assert!(!note.contains("assembly]"), "{note}");
}

#[test]
fn no_english_word_is_left_in_another_language() {
    for scene in
        ["shaper-drive", "press", "conveyor", "guide-shaper", "stephenson3", "brake", "andrews", "run-up"]
    {
        let mechanism = &results(scene).linkage.mechanism;
        let links = mechanism.links.iter().map(|link| link.name.as_str());
        let points = mechanism.points.iter().map(|point| point.name.as_str());
        let slides = mechanism.slides.iter().map(|slide| slide.name.as_str());
        let loads = mechanism.loads.iter().map(|load| load.name.as_str());
        let names = links.chain(points).chain(slides).chain(loads);
        // The name of the check of the source, of the analyzers, of functions, kinds of groups.
        let analyzers = assur_force::analyzers().unwrap();
        let names = names.chain(analyzers.iter().map(|plugin| plugin.name));
        let mut known: String = names.collect::<Vec<_>>().join(" ");
        // The command that prints the same working.
        known.extend([" TestPf atan2 groups assur explain position ", &mechanism.title]);
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
        assert!(html.contains("A. &lt;B&gt;") && !html.contains("NaN") && !html.contains('`'), "{scene}");
        assert!(language != "en" || html.contains("(number of steps)"), "{scene}: what symbols mean");
        // An identifier without a text would be printed itself.
        let identifiers =
            include_str!("../../../../lang/en.ftl").lines().filter_map(|line| line.split_once(" = "));
        for (id, _) in identifiers.filter(|(id, _)| id.contains('-')) {
            assert!(!html.contains(&format!(">{id}<")), "{scene} {language}: {id}");
        }
    }
}

#[test]
fn no_name_is_markup() {
    let path = assur_fixtures::path("../tests/corpus/markdown-script.toml");
    let session = Session::open(Source::File(path)).unwrap();
    let results = session.analyzed(&Options::default(), true, &mut unwatched).unwrap();
    for form in [Form::Html, Form::Markdown] {
        let written = self::written(&results, "en", form);
        assert!(written.text.contains("script"));
        let all = std::iter::once(&written.text).chain(written.figures.iter().map(|(_, drawn)| drawn));
        for text in all {
            // A backslash in Markdown makes a sign a letter.
            assert!(text.match_indices("<script").all(|(at, _)| text[..at].ends_with('\\')), "{form:?}");
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
