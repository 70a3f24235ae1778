//! What a sheet says, against the JSON of the same results, and its words.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

mod common;

use std::collections::{BTreeMap, BTreeSet};

use assur_mechanism::{Friction, Mechanism, PairId, Surfaces};
use assur_picture::Results;
use assur_report::{json::analysis::to_json, topic};
use assur_scene::SheetField;
use assur_sheet::{Page, Part};
use assur_words::Language;
use common::{SCENES, results_and_pages, texts};
use serde_json::Value;

/// The number of a text, and half a unit of its last digit.
fn read(text: &str) -> (f64, f64) {
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, part)| part.len());
    let power = exponent.parse::<i32>().unwrap() - i32::try_from(decimals).unwrap();
    (text.parse().unwrap(), 0.5 * 10_f64.powi(power))
}

#[track_caller]
fn same(told: &str, value: f64, place: &str) {
    let (found, half) = read(told);
    assert!((found - value).abs() <= half * (1.0 + 1e-6), "{place}: {told} is not {value}");
}

/// The parts of the pages of a field, each with its texts.
fn of_field(pages: &[Page], field: SheetField) -> Vec<Vec<&str>> {
    let parts = pages.iter().flat_map(|page| &page.parts).filter(|part| part.field == Some(field));
    parts.map(|part: &Part| texts(part)).collect()
}

/// For each symbol what it stands for, and its value in each position.
type Forces = BTreeMap<String, (String, Vec<String>)>;

/// The table of forces, with the positions of its heads.
fn forces(pages: &[Page]) -> (Vec<usize>, Forces) {
    let parts = of_field(pages, SheetField::Forces);
    let Some(texts) = parts.into_iter().find(|texts| texts[0] == "Forces and moments") else {
        return Default::default();
    };
    let number =
        |head: &&str| head.replace('\u{a0}', " ").strip_prefix("position ").and_then(|of| of.parse().ok());
    // Two heads are empty.
    let positions: Vec<usize> = texts[3..].iter().map_while(number).collect();
    let rows = texts[3 + positions.len()..].chunks(2 + positions.len());
    let values = |row: &[&str]| row[2..].iter().map(|cell| (*cell).to_owned()).collect();
    (
        positions,
        rows.map(|row| (row[0].replace(['_', '{', '}'], ""), (row[1].to_owned(), values(row)))).collect(),
    )
}

fn size(force: &Value) -> f64 {
    force[0].as_f64().unwrap().hypot(force[1].as_f64().unwrap())
}

/// What the JSON of a position has for a symbol: a modulus of a force, or a moment; `None` of what only the drive has.
fn wanted(row: &Value, mechanism: &Mechanism, symbol: &str, told: &str) -> Option<f64> {
    let is_moment = symbol.starts_with('M');
    if let Some((pair, link)) = told.strip_prefix("reaction in ").and_then(|of| of.split_once(" on ")) {
        let of = &row["reactions"][pair];
        return if is_moment { of["moment"].as_f64() } else { Some(size(&of[link])) };
    }
    if let Some((pair, link)) = told.strip_prefix("friction in ").and_then(|of| of.split_once(" on ")) {
        // A moment is told on the link of the table, which may be that of the journal.
        let (of, link) = (&row["friction"][pair], link.trim_end_matches(", a part of the reaction"));
        let size = if is_moment { of["moment"].as_f64()? } else { of["force"].as_f64()?.abs() };
        return Some(if is_moment { size * sense(mechanism, pair, link) } else { size });
    }
    if told == "inertia of flywheel and rotor" {
        // With the drive it keeps up the motion, as the balancing load does.
        return None;
    }
    if let Some(link) = told.strip_prefix("inertia of ") {
        let of = &row["inertia_loads"][link];
        return if is_moment { of["moment"].as_f64() } else { Some(size(&of["force"])) };
    }
    if let Some(link) = told.strip_prefix("weight of ") {
        let gravity = mechanism.gravity?;
        return mechanism.links.iter().find(|own| own.name == *link).map(|own| own.mass * size_of(gravity));
    }
    let load = &row["loads"][told];
    if told == "balancing load" { row["balancing"].as_f64() } else { load.as_f64().map(f64::abs) }
}

/// The sign of the friction of a pin on a link: that of the JSON is on what turns on the owner of the journal.
fn sense(mechanism: &Mechanism, pair: &str, link: &str) -> f64 {
    let owner = |friction: &Friction| match (friction.pair, friction.surfaces) {
        (PairId::Pin(point), Surfaces::Journal { owner, .. }) if mechanism.points[point].name == *pair => {
            Some(owner)
        }
        _ => None,
    };
    let owner = mechanism.frictions.iter().find_map(owner).unwrap();
    if mechanism.links[owner].name == *link { -1.0 } else { 1.0 }
}

fn size_of(vector: [f64; 2]) -> f64 {
    vector[0].hypot(vector[1])
}

/// The rows of the table of results against the facts, whose numbers those of the JSON are.
fn compare_results(results: &Results, pages: &[Page], scene: &str) -> usize {
    let facts = topic::summary(&results.found.as_ref().unwrap().analysis, &results.linkage);
    let english = Language::english();
    let parts = of_field(pages, SheetField::Results);
    let mut compared = 0;
    for row in parts[0][1..].chunks(2) {
        let fact = facts.iter().find(|fact| fact.what().render(english).replace('`', "") == row[0]);
        let fact = fact.unwrap_or_else(|| panic!("{scene}: {row:?}"));
        let assur_book::Value::Number(value) = fact.value else { continue };
        let told = row[1].split(' ').next().unwrap();
        same(told, value * fact.unit.factor, &format!("{scene}: {row:?}"));
        compared += 1;
    }
    compared
}

#[test]
fn the_numbers_of_the_sheet_are_those_of_the_json() {
    for (scene, least) in SCENES.into_iter().zip([55, 10, 45, 35, 2]) {
        let (results, [pages]) = results_and_pages(scene, ["en"]);
        let analysis = &results.found.as_ref().unwrap().analysis;
        let json: Value = serde_json::from_str(&to_json(analysis, false).unwrap()).unwrap();
        let rows = if results.samples().is_some() { &json["trajectory"] } else { &json["positions"] };
        let (places, forces) = forces(&pages);
        let mut compared = compare_results(&results, &pages, scene);
        for (symbol, (told, values)) in &forces {
            for (position, value) in places.iter().zip(values).filter(|(_, value)| *value != "–") {
                let Some(wanted) = wanted(&rows[*position], &results.linkage.mechanism, symbol, told) else {
                    continue;
                };
                let number = value.split([' ', '\u{a0}']).next().unwrap();
                same(number, wanted, &format!("{scene} {position}: {symbol} {told} {value}"));
                compared += 1;
            }
        }
        assert!(compared >= least, "{scene}: {compared}");
    }
}

#[test]
fn drive_and_inertia_of_the_flywheel_are_the_balancing_load() {
    let (results, [pages]) = results_and_pages("shaper-drive", ["en"]);
    let analysis = &results.found.as_ref().unwrap().analysis;
    let json: Value = serde_json::from_str(&to_json(analysis, false).unwrap()).unwrap();
    let (places, forces) = forces(&pages);
    for (at, position) in places.iter().enumerate() {
        let moment = |symbol: &str| -> f64 {
            let value = &forces[symbol].1[at];
            value.replace('\u{2212}', "-").split([' ', '\u{a0}']).next().unwrap().parse().unwrap()
        };
        let balancing = json["positions"][*position]["balancing"].as_f64().unwrap();
        let found = moment("Md") + moment("Mfl");
        assert!((found - balancing).abs() < 1e-3 * balancing.abs(), "{position}: {found} {balancing}");
    }
}

#[test]
fn the_table_of_the_lever_says_what_the_table_of_forces_does_not() {
    for (scene, told) in [("press", Some("contact 1 on rod")), ("shaper", None)] {
        let (_, [pages]) = results_and_pages(scene, ["en"]);
        let tables = of_field(&pages, SheetField::Lever);
        let table =
            tables.iter().find(|texts| texts[0] == "Forces on Zhukovsky's lever and their arms").unwrap();
        // In the order of the forces; without words the second text of a row is a number.
        let words = table.iter().find(|text| **text == "contact 1 on rod" || text.starts_with("weight"));
        assert_eq!(words.copied(), told, "{scene}: {table:?}");
    }
}

#[test]
fn a_sheet_has_no_words_of_another_language() {
    const SYMBOLS: [&str; 2] = ["min", "max"];
    for scene in SCENES {
        let (results, all) = results_and_pages(scene, ["uk", "ru"]);
        let groups = &results.linkage.structure.groups;
        let kinds = groups.iter().map(|group| group.plugin.name.to_uppercase());
        let points = results.linkage.mechanism.points.iter().map(|point| point.name.to_string());
        let known: BTreeSet<String> = kinds.chain(points).chain(SYMBOLS.map(str::to_owned)).collect();
        for part in all.iter().flatten().flat_map(|page| &page.parts) {
            for word in texts(part).into_iter().flat_map(|text| text.split(|c: char| !c.is_alphanumeric())) {
                let letters = word.chars().filter(char::is_ascii_alphabetic);
                // Designations have one letter or two, classes and kinds of groups have capitals alone.
                let is_word = letters.clone().count() > 2 && letters.clone().any(|c| c.is_ascii_lowercase());
                assert!(!is_word || known.contains(word), "{scene} {:?}: {word}", part.field);
            }
        }
    }
}
