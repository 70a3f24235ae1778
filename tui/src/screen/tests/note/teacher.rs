//! What a strict teacher would send a note back for: a table without a name, a figure that the text doesn't name before it, a
//! word of another language, a row of the cover that can't be filled in.

use std::collections::BTreeSet;

use assur_picture::Results;
use assur_scene::Note;
use assur_words::{LANGUAGES, Language, text};

use super::{Form, results, visible};

/// A regime with a motor, contacts, friction, a group of class III, a motion over time.
const SCENES: [&str; 5] = ["shaper-drive", "press", "shaper-friction", "triad", "brake"];

/// Functions, subscripts of extremes, the command that prints the same working, and a residual of the source by its own name.
const SYMBOLS: &str = "atan2 cos sin sqrt min max assur explain position Pogr1 TestPf";

fn html(results: &Results, language: &'static str) -> String {
    let note = Note { language: Some(language), ..Note::default() };
    assur_note::write(results, &note, Form::Html, "").unwrap().text
}

/// The text without the pictures.
fn without_pictures(html: &str) -> String {
    let mut parts = html.split("<svg");
    let first = parts.next().unwrap().to_owned();
    parts.fold(first, |text, part| text + part.split_once("</svg>").unwrap().1)
}

fn numbers_behind<'t>(text: &'t str, word: &'t str) -> impl Iterator<Item = (usize, usize)> + 't {
    text.match_indices(word).filter_map(|(at, _)| {
        let digits: String = text[at + word.len()..].chars().take_while(char::is_ascii_digit).collect();
        Some((at, digits.parse().ok()?))
    })
}

#[test]
fn every_figure_is_named_before_it_by_its_own_number() {
    for scene in SCENES {
        let results = results(scene);
        for (code, in_caption, in_text) in
            [("en", "Figure ", "igure "), ("uk", "Рисунок ", "рис. "), ("ru", "Рисунок ", "рис. ")]
        {
            let text = without_pictures(&html(&results, code));
            let caption = format!("<figcaption>{in_caption}");
            let figures: Vec<_> = numbers_behind(&text, &caption).collect();
            assert!(figures.len() > 5, "{scene} {code}");
            for (order, (at, figure)) in figures.iter().enumerate() {
                assert_eq!(*figure, order + 1, "{scene} {code}");
                let mut named = numbers_behind(&text[..*at], in_text).map(|(_, number)| number);
                assert!(named.any(|number| number == *figure), "{scene} {code}: figure {figure}");
            }
        }
    }
}

#[test]
fn no_page_but_the_last_is_less_than_two_thirds_full() {
    /// First line of a page, and its last one, mm.
    const TOP: f64 = 22.0;
    const LAST: f64 = 275.0;
    for scene in SCENES {
        let results = results(scene);
        for language in LANGUAGES {
            let note = Note { language: Some(language), ..Note::default() };
            let pages = assur_note::pages(&results, &note).unwrap();
            for (number, page) in pages.iter().enumerate().take(pages.len() - 1) {
                let ends = page.iter().filter_map(|element| Some(element.bounds()?[3]));
                // The number of the page stands below.
                let end = ends.filter(|end| *end <= LAST + 1.0).fold(0.0, f64::max);
                let part = (end - TOP) / (LAST - TOP);
                assert!(part >= 0.666, "{scene} {language}: page {} to {part:.3}", number + 1);
            }
        }
    }
}

#[test]
fn every_table_has_a_number_and_a_name() {
    for scene in SCENES {
        let results = results(scene);
        for code in LANGUAGES {
            let text = html(&results, code);
            let tables = text.matches("<table").count() - 1;
            let captions: Vec<&str> = text.split("<caption>").skip(1).collect();
            assert_eq!(captions.len(), tables, "{scene} {code}");
            for (order, caption) in captions.iter().enumerate() {
                let caption = caption.split_once("</caption>").unwrap().0;
                let (number, name) = caption.split_once(". ").unwrap_or((caption, ""));
                assert!(number.ends_with(&format!(" {}", order + 1)), "{scene} {code}: {caption}");
                assert!(
                    name.chars().filter(|letter| letter.is_alphabetic()).count() > 2,
                    "{scene} {code}: {caption}"
                );
            }
        }
    }
}

#[test]
fn only_symbols_and_names_of_registries_have_latin_letters() {
    let registries = assur_force::analyzers().unwrap().iter().map(|plugin| plugin.name).collect::<Vec<_>>();
    let integrators =
        assur_integrator::integrators().unwrap().iter().map(|plugin| plugin.name).collect::<Vec<_>>();
    for scene in SCENES {
        let results = results(scene);
        let groups = &results.linkage.structure.groups;
        let kinds: Vec<String> = groups.iter().map(|group| group.plugin.name.to_uppercase()).collect();
        let points = results.linkage.mechanism.points.iter().map(|point| point.name.as_str());
        let frictions = ["coulomb"];
        let known = registries.iter().chain(&integrators).copied().chain(kinds.iter().map(String::as_str));
        let known = known.chain(points).chain(frictions).collect::<Vec<_>>().join(" ") + " " + SYMBOLS;
        let known: BTreeSet<&str> = known.split(|c: char| !c.is_alphanumeric()).collect();
        for code in ["uk", "ru"] {
            let page = html(&results, code);
            for word in visible(&page).split(|c: char| !c.is_alphanumeric()) {
                let letters = word.chars().filter(char::is_ascii_alphabetic);
                // Designations have one letter or two, classes and kinds of groups have capitals alone.
                let is_word = letters.clone().count() > 2 && letters.clone().any(|c| c.is_ascii_lowercase());
                assert!(!is_word || known.contains(word), "{scene} {code}: {word}");
            }
        }
    }
}

#[test]
fn what_the_cover_lacks_is_a_ruled_line() {
    let results = results("press");
    let page = html(&results, "en");
    assert_eq!(page.matches("<span class=\"rule\">").count(), 10);
    let (language, own) = (Language::english(), "A. Student");
    let note = Note { author: Some(assur_words::name(own)), ..Note::default() };
    let page = assur_note::write(&results, &note, Form::Html, "").unwrap().text;
    let word = text!("note-author").render(language);
    assert!(page.contains(&format!("<td>{word}:</td><td>{own}</td>")));
    assert_eq!(page.matches("<span class=\"rule\">").count(), 9);
}

#[test]
fn a_note_has_the_chapters_and_the_curves_that_are_asked_for() {
    let results = results("shaper-drive");
    let written = |note: &Note| assur_note::write(&results, note, Form::Html, "").map(|written| written.text);
    let chapters = Some(vec![assur_scene::Chapter::Task, assur_scene::Chapter::Sources]);
    let page = written(&Note { chapters, ..Note::default() }).unwrap();
    assert_eq!(page.matches("<h2 id").count(), 3, "the symbols and two chapters");
    let curves = vec![vec!["D.x".to_owned(), "point D y".to_owned()]];
    let with = written(&Note { curves, ..Note::default() }).unwrap();
    assert_eq!(
        with.matches("<figure>").count(),
        written(&Note::default()).unwrap().matches("<figure>").count() + 1
    );
    let curves = vec![vec!["no such column".to_owned()]];
    let told = written(&Note { curves, ..Note::default() }).unwrap_err().to_string();
    assert!(told.contains("no such column"), "{told}");
}

#[test]
fn tables_refer_to_formulas_that_are_there() {
    let page = html(&results("shaper"), "en");
    let last = page.matches("<span class=\"no\">").count();
    let named: Vec<usize> = numbers_behind(&page, "formulas (")
        .chain(numbers_behind(&page, ") to ("))
        .map(|(_, number)| number)
        .collect();
    assert_eq!(named.len(), 4);
    assert!(
        named.iter().all(|number| *number <= last) && named[0] < named[2] && named[1] < named[3],
        "{named:?}"
    );
}
