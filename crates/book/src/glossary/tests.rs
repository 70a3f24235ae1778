use std::collections::BTreeSet;

use assur_analysis::results::{Owner, Quantity, Residual};
use assur_words::{LANGUAGES, Language, to_ascii};

use assur_analysis::results::Column;

use super::*;

/// Every text of a word in a language; the identity where the language lacks it.
fn told(entry: &Entry, language: &Language) -> [String; 2] {
    [&entry.word, &entry.meaning].map(|text| {
        let id = text.identity().unwrap();
        language.own(id).unwrap_or_else(|| panic!("{id} is missing"))
    })
}

#[test]
fn every_word_has_its_texts_in_every_language_and_none_is_there_twice() {
    for code in LANGUAGES {
        let language = Language::find(code).unwrap();
        let mut words = BTreeSet::new();
        for entry in ENTRIES {
            let [word, meaning] = told(entry, language);
            assert!(!meaning.is_empty() && !meaning.ends_with('.'), "{code}: {word}");
            assert!(words.insert(word.to_lowercase()), "{code}: {word} is there twice");
        }
    }
    let ids: BTreeSet<_> = ENTRIES.iter().map(|entry| entry.id).collect();
    assert_eq!(ids.len(), ENTRIES.len());
}

#[test]
fn what_is_symbols_has_a_spelling_in_ascii() {
    for entry in ENTRIES {
        let [word, meaning] = told(entry, Language::english());
        for text in [word.as_str(), &meaning, entry.formula] {
            let ascii = to_ascii(text);
            assert!(ascii.is_ascii() && !ascii.contains('?'), "{text}: {ascii}");
        }
        let opened = entry.formula.matches('(').count();
        assert_eq!(opened, entry.formula.matches(')').count(), "{}", entry.formula);
    }
}

#[test]
fn every_source_is_printed_in_every_language() {
    for code in LANGUAGES {
        let language = Language::find(code).unwrap();
        for source in ENTRIES.iter().filter_map(|entry| entry.source) {
            let printed = source.text().render(language);
            assert!(!printed.contains("glossary-"), "{code}: {printed}");
        }
    }
}

#[test]
fn the_tables_name_words_that_exist_and_nothing_twice() {
    for table in subjects::TABLES {
        let words = table.iter().flat_map(|(_, words)| *words);
        words.for_each(|id| assert!(find(id).is_some(), "{id}"));
        let mut seen = BTreeSet::new();
        let subjects = table.iter().flat_map(|(of, _)| *of);
        subjects.for_each(|id| assert!(seen.insert(id), "{id} is in two rows"));
    }
}

#[test]
fn quantities_find_their_words() {
    let word = |quantity, owner| of_column(Column::of(quantity, owner)).first().map(|entry| entry.id);
    let link = Owner::Link(assur_mechanism::GROUND);
    assert_eq!(word(Quantity::Transfer(0), Owner::Input), Some("word-coordinate"));
    assert_eq!(word(Quantity::Transfer(0), link), Some("word-pf0"));
    assert_eq!(word(Quantity::Acceleration, link), Some("word-pf1"));
    assert_eq!(word(Quantity::Residual(Residual::Global), Owner::Input), Some("word-global"));
    assert_eq!(of_fact("fact-of-nobody", Some(Column::BALANCING))[0].id, "word-balance");
    assert_eq!(of_fact("fact-stroke", Some(Column::BALANCING))[0].id, "word-stroke");
    assert!(of_fact("fact-of-nobody", None).is_empty());
}
