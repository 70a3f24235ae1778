//! The reference against the reader: every key stands in a shipped scene, and the reader reads there what the reference says.

use std::collections::BTreeSet;
use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use assur_mechanism::Key;
use assur_words::Describe;

use super::{Bound, KeyDefault, KeyTable, SceneKey, TABLES, ValueKind, key_of, search, table};
use crate::edit::{bare, split};
use crate::tests::fixtures;
use crate::units::quantity;

/// A key of the reference where a scene has it.
struct Found<'s> {
    scene: &'s str,
    table: &'static KeyTable,
    key: &'static SceneKey,
    /// Bytes of the key and its value.
    whole: Range<usize>,
    value: Range<usize>,
}

impl Found<'_> {
    /// Where the key begins, unless it stands in the header of a table.
    fn own_line(&self) -> Option<usize> {
        let at = self.whole.start;
        (!self.scene[..at].ends_with(['[', '.'])).then_some(at)
    }
}

/// The keys of a table of a scene, and of the tables in it.
fn keys<'s>(scene: &'s str, table: &'static KeyTable, toml: &DeTable<'_>, found: &mut Vec<Found<'s>>) {
    for (name, value) in toml {
        let own = |key: &&SceneKey| key.name == name.get_ref().as_ref() || key.name == "POINT";
        let key = table.keys.iter().find(own).unwrap_or_else(|| panic!("`{name}` of {}", table.header));
        let (whole, value_span) = (name.span().start..value.span().end, value.span());
        found.push(Found { scene, table, key, whole, value: value_span });
        for header in key
            .kinds
            .iter()
            .filter_map(|kind| if let ValueKind::Table(header) = kind { Some(header) } else { None })
            // Of one table and a list of them only one is written.
            .filter(|header| key.name != "input" || header.starts_with("[[") == value.get_ref().is_array())
        {
            let inner =
                TABLES.iter().find(|table| table.header == *header).unwrap_or_else(|| panic!("{header}"));
            within(scene, inner, value, header.contains(".NAME"), found);
        }
    }
}

fn within<'s>(
    scene: &'s str,
    table: &'static KeyTable,
    value: &Spanned<DeValue<'_>>,
    named: bool,
    found: &mut Vec<Found<'s>>,
) {
    match value.get_ref() {
        DeValue::Table(inner) if named => {
            inner.iter().for_each(|(_, one)| within(scene, table, one, false, found));
        }
        DeValue::Table(inner) => keys(scene, table, inner, found),
        DeValue::Array(list) => list.iter().for_each(|one| within(scene, table, one, false, found)),
        _ => {}
    }
}

/// Every key in the shipped scenes.
fn all(scenes: &[(String, String)]) -> Vec<Found<'_>> {
    let mut found = Vec::new();
    for (_, scene) in scenes {
        keys(scene, table(""), DeTable::parse(scene).unwrap().get_ref(), &mut found);
    }
    found
}

fn shipped() -> Vec<(String, String)> {
    fixtures().into_iter().chain([("starter".to_owned(), crate::STARTER.to_owned())]).collect()
}

fn label(found: &Found<'_>) -> String {
    format!("{} {}", found.table.header, found.key.name)
}

#[test]
fn every_line_of_the_reference_is_read() {
    let lines = include_str!("keys.txt").lines().filter(|line| !line.starts_with('#'));
    let keys: usize = TABLES.iter().map(|table| table.keys.len()).sum();
    assert_eq!(lines.clone().filter(|line| line.contains(" | ")).count(), keys);
    assert_eq!(lines.filter(|line| line.contains(" : ")).count(), TABLES.len());
    let headers = |kind: &ValueKind| if let ValueKind::Table(header) = kind { Some(*header) } else { None };
    let named =
        TABLES.iter().flat_map(|table| &table.keys).flat_map(|key| key.kinds.iter().filter_map(headers));
    for header in named {
        assert_eq!(table(header).header, header);
    }
}

#[test]
fn every_key_stands_in_a_shipped_scene() {
    let scenes = shipped();
    let shown: BTreeSet<_> = all(&scenes).iter().map(label).collect();
    let lacking: Vec<_> = TABLES
        .iter()
        .flat_map(|table| table.keys.iter().map(move |key| format!("{} {}", table.header, key.name)))
        .filter(|key| !shown.contains(key))
        .collect();
    assert!(lacking.is_empty(), "{lacking:#?}");
}

/// What a fault of a value that is of no kind must name.
fn named(kind: &ValueKind) -> Vec<String> {
    match kind {
        ValueKind::Quantity(dimension) => vec![dimension.describe().to_string()],
        ValueKind::Word(word) => vec![(*word).to_owned()],
        ValueKind::Count => vec!["a whole number".to_owned()],
        ValueKind::Flag => vec!["true or false".to_owned()],
        _ => Vec::new(),
    }
}

#[test]
fn the_reader_wants_what_the_reference_says() {
    let scenes = shipped();
    let mut seen = BTreeSet::new();
    for found in all(&scenes) {
        let name = label(&found);
        if !seen.insert(name.clone()) {
            continue;
        }
        // A date is of no kind.
        let mut scene = found.scene.to_owned();
        scene.replace_range(found.value.clone(), "1979-05-27");
        if found
            .key
            .kinds
            .iter()
            .any(|kind| matches!(kind, ValueKind::Table(header) if header.starts_with('[')))
        {
            continue;
        }
        let errors = crate::read("a", &scene).map(|_| ()).expect_err(&name).to_string();
        let kinds = || found.key.kinds.iter();
        if !kinds().any(|kind| {
            matches!(
                kind,
                ValueKind::Quantity(_) | ValueKind::ByInput(..) | ValueKind::Named(_) | ValueKind::Text
            )
        }) {
            let wanted: Vec<_> = kinds().flat_map(named).collect();
            assert!(wanted.iter().all(|word| errors.contains(word)), "{name} wants {wanted:?}: {errors}");
        }
        // A number of an unknown unit is answered with the dimension, an unknown word with the words that are known.
        for (written, is_number) in [("\"1 zz\"", true), ("\"zz\"", false)] {
            let mut scene = found.scene.to_owned();
            scene.replace_range(found.value.clone(), written);
            let errors = crate::read("a", &scene).map_or_else(|errors| errors.to_string(), |_| String::new());
            let wanted =
                kinds().filter(|kind| matches!(kind, ValueKind::Quantity(_)) == is_number).flat_map(named);
            let open = kinds().any(|kind| matches!(kind, ValueKind::Named("plugin" | "motor")));
            let lacking: Vec<_> = wanted.filter(|word| !open && !errors.contains(word.as_str())).collect();
            assert!(lacking.is_empty(), "{name} wants {lacking:?}: {errors}");
        }
    }
}

/// What a number that may not be negative, or not zero, is answered with, written with its unit or without: key, value, what to do.
#[test]
fn a_number_beyond_its_limits_is_refused_at_its_place() {
    let scenes = shipped();
    let mut judged = BTreeSet::new();
    for found in all(&scenes) {
        let name = label(&found);
        if !matches!(found.key.limits, Bound::NotNegative | Bound::Positive) || judged.contains(&name) {
            continue;
        }
        let written = &found.scene[found.value.clone()];
        // A word stands in the place of some, a table of others.
        let Some((number, unit)) = split(bare(written).trim()).filter(|(number, _)| *number != 0.0) else {
            continue;
        };
        let quoted = |number: f64| format!("\"{number} {unit}\"");
        let mut wrong = vec![format!("-{}", number.abs())];
        wrong.extend((!unit.is_empty()).then(|| quoted(-number.abs())));
        if matches!(found.key.limits, Bound::Positive) {
            wrong.push("0".to_owned());
            wrong.extend((!unit.is_empty()).then(|| quoted(0.0)));
        }
        for value in wrong {
            let mut scene = found.scene.to_owned();
            scene.replace_range(found.value.clone(), &value);
            let errors = crate::read("a", &scene).expect_err(&name);
            let line = scene[..found.value.start].matches('\n').count() + 1;
            let told = errors.errors.iter().find(|error| error.line == line);
            let told = told.unwrap_or_else(|| panic!("{name} = {value}: {errors}"));
            let message = told.message.to_string();
            let limit = if value.trim_start_matches('"').starts_with('-') {
                "must"
            } else {
                "must be greater than 0"
            };
            assert!(
                message.contains(limit) && message.contains(&format!("`{}`", found.key.name)),
                "{name}: {message}"
            );
            assert!(
                message.contains(&value) && told.label.to_string().contains("such as"),
                "{name}: {errors}"
            );
        }
        judged.insert(name);
    }
    let wanted = TABLES.iter().flat_map(|table| &table.keys);
    let wanted = wanted.filter(|key| matches!(key.limits, Bound::NotNegative | Bound::Positive)).count();
    assert!(judged.len() * 10 >= wanted * 8, "{} of {wanted}: {judged:?}", judged.len());
}

/// The scene without a key; a comma beside it goes as well.
fn without(found: &Found<'_>) -> String {
    let (before, after) = (&found.scene[..found.whole.start], &found.scene[found.whole.end..]);
    match (after.trim_start().strip_prefix(','), before.trim_end().strip_suffix(',')) {
        (Some(after), _) => format!("{before}{after}"),
        (None, Some(before)) => format!("{before}{after}"),
        _ => format!("{before}{after}"),
    }
}

#[test]
fn a_default_is_what_holds_without_its_key() {
    let scenes = shipped();
    let mut judged = BTreeSet::new();
    for found in all(&scenes) {
        let name = label(&found);
        let left_out = crate::reading("a", &without(&found));
        match found.key.default {
            KeyDefault::Needed => assert!(left_out.is_err(), "{name} is needed"),
            KeyDefault::Absent => {}
            KeyDefault::Is(default) => {
                let mut scene = found.scene.to_owned();
                scene.replace_range(found.value.clone(), default);
                // A key that others need can be neither left out nor have its default in that scene.
                let (Ok(mut left_out), Ok(mut written)) = (left_out, crate::reading("a", &scene)) else {
                    continue;
                };
                // What is left out may be doubted, what is written is meant.
                left_out.mechanism.warnings.clear();
                written.mechanism.warnings.clear();
                assert_eq!(left_out.note, written.note, "{name}");
                let [left_out, written] =
                    [left_out, written].map(|reading| format!("{:?}", reading.mechanism));
                assert_eq!(left_out, written, "{name}");
                judged.insert(name);
            }
        }
    }
    let wanted = TABLES
        .iter()
        .flat_map(|table| &table.keys)
        .filter(|key| matches!(key.default, KeyDefault::Is(_)))
        .count();
    assert!(judged.len() * 10 >= wanted * 8, "{} of {wanted}: {judged:?}", judged.len());
}

/// Whether a value is of a kind.
fn is_of(kind: &ValueKind, value: &DeValue<'_>) -> bool {
    let text = value.as_str();
    match kind {
        ValueKind::Quantity(dimension) => {
            text.is_none_or(|text| quantity(text, *dimension).is_ok()) && !value.is_table()
        }
        ValueKind::ByInput(turns, slides) => {
            [turns, slides].iter().any(|kind| is_of(&ValueKind::Quantity(**kind), value))
        }
        ValueKind::Count => value.is_integer(),
        ValueKind::Flag => value.is_bool(),
        ValueKind::Text | ValueKind::Named(_) => text.is_some(),
        ValueKind::Word(word) => text == Some(word),
        ValueKind::Place => !value.is_table(),
        ValueKind::Points => value.is_table(),
        ValueKind::Rows => value.is_array(),
        ValueKind::Two(kind) => value
            .as_array()
            .is_some_and(|list| list.len() == 2 && list.iter().all(|one| is_of(kind, one.get_ref()))),
        ValueKind::List(kind) => {
            value.as_array().is_some_and(|list| list.iter().all(|one| is_of(kind, one.get_ref())))
        }
        ValueKind::Table(header) => value.is_table() || header.starts_with("[[") && value.is_array(),
    }
}

#[test]
fn every_example_is_of_a_kind_of_its_key() {
    for table in TABLES.iter() {
        for key in &table.keys {
            let toml = format!("x = {}", key.example);
            let toml = DeTable::parse(&toml).unwrap_or_else(|error| panic!("{}: {error}", key.name));
            let value = toml.get_ref().get("x").unwrap().get_ref();
            assert!(
                key.kinds.iter().any(|kind| is_of(kind, value)),
                "{} {}: {}",
                table.header,
                key.name,
                key.example
            );
        }
    }
}

#[test]
fn no_table_takes_a_key_that_the_reference_lacks() {
    let scenes = shipped();
    let mut seen = BTreeSet::new();
    for found in all(&scenes) {
        if found.key.name == "POINT" || seen.contains(found.table.header) {
            continue;
        }
        let scene = found.scene;
        // Within a table in one line the keys have commas between them.
        let Some(at) = found.own_line() else { continue };
        let inline = scene[..at].trim_end().ends_with(['{', ',']);
        let planted = format!("zzz = 1{}", if inline { ", " } else { "\n" });
        let mut planted_scene = scene.to_owned();
        planted_scene.insert_str(at, &planted);
        let errors = crate::read("a", &planted_scene).expect_err(found.table.header).to_string();
        assert!(errors.contains("unknown key `zzz`"), "{}: {errors}", found.table.header);
        seen.insert(found.table.header);
    }
    // The keys of two tables are names of points.
    assert_eq!(seen.len() + 2, TABLES.len());
}

#[test]
fn a_word_finds_the_keys_that_it_is_about() {
    let english = assur_words::Language::english();
    let names = |word: &str| -> Vec<String> {
        let found = search(word, english);
        found
            .flat_map(|(table, keys)| {
                keys.into_iter().map(move |key| format!("{}.{}", table.name(), key.name))
            })
            .collect()
    };
    assert!(names("omega").contains(&"motion.speed".to_owned()));
    assert_eq!(names("link.mass"), ["link.mass"]);
    assert!(
        table("[[slide]]").keys.iter().all(|key| names("[[slide]]").contains(&format!("slide.{}", key.name)))
    );
    assert!(names("kloss").contains(&"drive.characteristic".to_owned()));
    assert!(names("nothing like it").is_empty());
    // A word is looked for from its beginning; where none begins so, within words.
    let over = names("over");
    // The ministry stands on the cover.
    assert!(
        over.contains(&"value.over".to_owned()) && !over.contains(&"note.ministry".to_owned()),
        "{over:?}"
    );
    assert!(names("cover").contains(&"note.ministry".to_owned()));
    assert!(names("evenness").contains(&"motion.unevenness".to_owned()));
}

#[test]
fn keys_that_exclude_each_other_are_refused_together() {
    for table in TABLES.iter() {
        for key in table.either.iter().flatten().flatten() {
            let known = table.key(key).unwrap_or_else(|| panic!("{} {key}", table.header));
            assert!(!table.rivals(key).is_empty() && !table.rivals(key).contains(&known.name));
        }
    }
    let scenes = shipped();
    let mut judged = BTreeSet::new();
    for found in all(&scenes) {
        let Some(at) = found.own_line() else { continue };
        let inline = found.scene[..at].trim_end().ends_with(['{', ',']);
        for rival in found.table.rivals(found.key.name) {
            let rival = found.table.key(rival).unwrap();
            let line = format!("{} = {}{}", rival.name, rival.example, if inline { ", " } else { "\n" });
            let mut scene = found.scene.to_owned();
            scene.insert_str(at, &line);
            // What stands there already can't stand there twice.
            let errors = crate::read("a", &scene).expect_err(&label(&found)).to_string();
            judged.extend((!errors.contains("not TOML")).then_some((
                found.table.header,
                found.key.name,
                rival.name,
            )));
        }
    }
    let wanted: usize = TABLES
        .iter()
        .flat_map(|table| table.either.iter().flatten().flatten().map(|key| table.rivals(key).len()))
        .sum();
    assert!(judged.len() * 10 >= wanted * 8, "{} of {wanted}: {judged:?}", judged.len());
}

#[test]
fn a_value_finds_the_innermost_key_that_it_has() {
    let about = |key: &Key| key_of(key).map(|key| key.about);
    let spring = Key::of("spring").at(0).at("length");
    let load = Key::of("force").at(0).at("value").at("table").at(1).at(0);
    let part = Key::of("contact").at(0).at("friction").at("against_sliding");
    assert_eq!(about(&Key::of("link").at("mass").at("points").at("A")), Some("scene-key-points"));
    assert_eq!(about(&Key::of("assembly").at("B").at(0)), Some("scene-key-assembly-point"));
    assert_eq!(about(&spring), Some("scene-key-spring-length"));
    assert_eq!(about(&load), Some("scene-key-table"));
    assert_eq!(about(&part), Some("scene-key-against-sliding"));
    assert_eq!(about(&Key::of("input").at("from")), Some("scene-key-input-from"));
    assert_eq!(about(&Key::of("input").at(0).at("from")), Some("scene-key-inputs-from"));
    assert_eq!(about(&Key::of("gravity").at(1)), Some("scene-key-gravity"));
    assert_eq!(about(&Key::of("no_such_table").at("length")), None);
    let limits = key_of(&spring).map(|key| key.limits().to_string());
    assert_eq!(limits.as_deref(), Some("not negative"));
}

#[test]
fn every_number_of_the_shipped_scenes_has_a_key_in_the_reference() {
    for (name, scene) in shipped() {
        for value in crate::edit::ParsedText::of(&scene).values() {
            assert!(key_of(&value.key).is_some(), "{name}: {}", value.key);
        }
    }
}
