//! docs/schema.json against what the program writes: nothing that it does not know, nothing in it that never occurs, units of the
//! catalogue. docs/json.md is made of it.

mod page;
mod walk;

use std::fs;
use std::path::Path;
use std::process::Command;
use std::sync::LazyLock;

use assur_analysis::results::{Column, Schema};
use assur_analysis::{Calculation, Options, unwatched};
use assur_book::catalogue::{self, PathStep};
use assur_fixtures::SCENES;
use serde_json::Value;

use super::generated::holds;
use super::root;
use walk::{Seen, child, number, walk};

/// The schema of docs.
static SCHEMA: LazyLock<Value> = LazyLock::new(|| {
    serde_json::from_str(&fs::read_to_string(root().join("docs/schema.json")).unwrap()).unwrap()
});

/// Scenes for keys that no shipped scene has: a passive link that does not fit, a pin of three links with friction, positions that
/// jam, a motor of a catalogue, and a motor and an unevenness that the program chooses.
const FURTHER: [&str; 5] = [
    include_str!("passive.toml"),
    include_str!("triple.toml"),
    include_str!("jam.toml"),
    include_str!("motor.toml"),
    include_str!("widest.toml"),
];

/// The same from the corpus: several solutions, a regime that is not found, friction in a transient motion.
const OF_CORPUS: [&str; 3] = ["incline-coefficient-1000", "check_meanspeed", "brake-rod-friction"];

/// The JSON of a scene; with status 1 too, where positions have no solution or a check fails.
fn results(scene: &Path, options: &[&str]) -> Value {
    let output = Command::new(env!("CARGO_BIN_EXE_assur"))
        .args(["analyze".as_ref(), scene.as_os_str()])
        .args(["--format", "json"])
        .args(options)
        .output()
        .unwrap();
    let told = String::from_utf8_lossy(&output.stderr);
    serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|error| panic!("{}: {error}: {told}", scene.display()))
}

/// The results of scenes that have every key among them.
fn all_results() -> Vec<Value> {
    let fixtures = root().join("fixtures");
    let of = |name: &str| fixtures.join(format!("{name}.toml"));
    // The chain of forty four-bars has 20 MB of the keys of its short one.
    let names = SCENES.iter().map(|(name, _)| *name).filter(|name| *name != "n-four-bar-40");
    let mut all: Vec<_> = names.map(|name| results(&of(name), &["--plans", "0", "--by-cause"])).collect();
    all.push(results(&of("slider-crank"), &["--analyzer", "longitudinal"]));
    for name in OF_CORPUS {
        all.push(results(&root().join("tests/corpus").join(format!("{name}.toml")), &[]));
    }
    let folder = tempfile::tempdir().unwrap();
    for (number, text) in FURTHER.into_iter().enumerate() {
        let path = folder.path().join(format!("{number}.toml"));
        fs::write(&path, text).unwrap();
        all.push(results(&path, &[]));
    }
    all
}

#[test]
fn the_schema_has_every_key_that_is_written_and_no_other() {
    let mut seen = Seen::default();
    for result in all_results() {
        walk(&SCHEMA, &result, &mut seen).unwrap();
    }
    assert_eq!(seen.never(&SCHEMA), [""; 0], "keys of the schema that no result has");
}

#[test]
fn what_the_schema_does_not_know_is_found() {
    let mut result = results(&root().join("fixtures/four-bar.toml"), &[]);
    result["positions"][3]["links"]["coupler"]["pf3"] = 1.0.into();
    let error = walk(&SCHEMA, &result, &mut Seen::default()).unwrap_err();
    assert_eq!(error, "/positions/3/links/coupler/pf3 is not in the schema");
    result["positions"][3]["links"]["coupler"] = "here".into();
    let error = walk(&SCHEMA, &result, &mut Seen::default()).unwrap_err();
    assert_eq!(error, "/positions/3/links/coupler is \"here\"");
}

/// The unit of a column as the end of its name, and those that a part of the schema allows.
fn units(schema: &Schema, column: Column, part: &Value) -> (String, Vec<String>) {
    let allowed = part["unit"].as_str().unwrap_or_default().split(" or ");
    let ending = |si: &str| {
        if si.is_empty() { String::new() } else { format!("_{}", si.replace('/', "_per_").replace(' ', "")) }
    };
    (catalogue::unit(schema, column).column(String::new()), allowed.map(ending).collect())
}

/// Every column of a table has its unit in the schema.
fn has_units(scene: &str, table: &Schema, of_rows: &str) {
    for column in table.columns() {
        let Some(path) = catalogue::path(table, *column) else { continue };
        let mut part = &SCHEMA["$defs"][of_rows];
        for step in &path {
            if let PathStep::Key(key) = step {
                part = child(&SCHEMA, part, key).unwrap_or_else(|| panic!("{scene}: {path:?} in {of_rows}"));
            }
        }
        let (unit, allowed) = units(table, *column, number(&SCHEMA, part));
        assert!(allowed.contains(&unit), "{scene}: {path:?} has {unit:?}, not one of {allowed:?}");
    }
}

#[test]
fn units_are_those_of_the_catalogue() {
    for (name, text) in SCENES {
        let mechanism = assur_scene::read(name, text).unwrap();
        let found = Calculation::of(mechanism, &Options::default(), &mut unwatched).unwrap();
        has_units(name, &found.columns(), "position");
        if matches!(*name, "run-up" | "shaper-drive") {
            has_units(name, found.analyze(&mut unwatched).unwrap().trajectory.schema(), "sample");
        }
    }
}

#[test]
fn the_page_of_the_json_is_made_of_the_schema() {
    holds("json.md", &page::of(&SCHEMA));
}
