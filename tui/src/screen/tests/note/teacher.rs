//! What a strict teacher would send a note back for: a table without a name, a figure that the text doesn't name before it, a
//! word of another language, a row of the cover that can't be filled in.

use std::collections::{BTreeMap, BTreeSet};

use assur_figure::{Element, Form as Drawn};
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

/// The lines of a page from above, each with its size; the number of the page is not among them.
fn lines(page: &[Element]) -> Vec<(f64, &str, f64)> {
    let mut lines: Vec<_> = page
        .iter()
        .filter_map(|element| match &element.form {
            Drawn::Text { at, words, size, .. } if at[1] < 280.0 => Some((at[1], words.as_str(), *size)),
            _ => None,
        })
        .collect();
    lines.sort_by(|a, b| a.0.total_cmp(&b.0));
    lines
}

#[test]
fn no_picture_divides_a_table() {
    let mut divided = 0;
    for scene in SCENES {
        let results = results(scene);
        for (language, mark) in
            [("en", ", continued"), ("uk", "Продовження таблиці"), ("ru", "Продолжение таблицы")]
        {
            let note = Note { language: Some(language), ..Note::default() };
            for page in &assur_note::pages(&results, &note).unwrap() {
                let lines = lines(page);
                let at = lines.iter().position(|(_, words, _)| words.contains(mark));
                assert!(
                    at.is_none_or(|at| at == 0),
                    "{scene} {language}: {} stands below {}",
                    lines[at.unwrap()].1,
                    lines[0].1
                );
                divided += usize::from(at.is_some());
            }
        }
    }
    assert!(divided > 5, "{divided}");
}

#[test]
fn no_chapter_begins_before_the_pictures_of_another_but_on_a_page_that_would_be_empty() {
    /// Size of the heading of a chapter, how far its line stands below what is above, and where that is low enough for the end of a page,
    /// mm.
    const HEADING: f64 = 4.8;
    const BELOW: f64 = 2.2 + 1.45 * HEADING;
    const FULL: f64 = 22.0 + 0.69 * 253.0 + BELOW;
    for scene in SCENES {
        let results = results(scene);
        let html = without_pictures(&html(&results, "en"));
        // The chapter of each figure, by the order in the text.
        let chapter_of = |at: usize| html[..at].matches("<h2 id").count();
        let wanted: BTreeMap<usize, usize> = numbers_behind(&html, "<figcaption>Figure ")
            .map(|(at, figure)| (figure, chapter_of(at)))
            .collect();
        let (mut chapter, mut early) = (0, 0);
        let pages = assur_note::pages(&results, &Note { language: Some("en"), ..Note::default() }).unwrap();
        for page in pages.iter().skip(1) {
            for (y, words, size) in lines(page) {
                let number = words.split_once(". ").and_then(|(number, _)| number.parse::<usize>().ok());
                if let (Some(number), true) = (number, (size - HEADING).abs() < 1e-9) {
                    chapter = number;
                    early = usize::from(y < FULL);
                } else if let Some((_, figure)) = numbers_behind(words, "Figure ").next() {
                    let own = wanted[&figure];
                    assert!(own == chapter || early > 0, "{scene}: figure {figure} of {own} in {chapter}");
                }
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
fn what_is_told_of_polygons_and_of_links_is_there() {
    let told = |language| text!("note-forces-polygons").render(Language::find(language).unwrap());
    for language in LANGUAGES {
        // A disc alone has no polygon.
        assert!(!html(&results("brake"), language).contains(&told(language)), "{language}");
        let triad = html(&results("triad"), language);
        assert!(triad.contains(&told(language)), "{language}");
        // The center of mass of link 1 has the number of the link, as in the drawings.
        for link in ["crank", "кривошип"] {
            assert!(!triad.contains(&format!("<sub>{link}")), "{language}");
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
