//! The page that the bench `accuracy` writes.

use std::collections::BTreeSet;

use super::scenes::charted;
use crate::chart::Stage;

/// What stands in backquotes.
fn quoted(text: &str) -> impl Iterator<Item = String> {
    text.split('`').skip(1).step_by(2).map(str::to_owned)
}

/// A new fixture or plugin needs its rows: the page is written again then.
#[test]
fn the_page_names_the_shipped_scenes_and_every_method_and_no_others() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/measured/accuracy.md");
    let page = std::fs::read_to_string(path).unwrap();
    let files: BTreeSet<String> =
        page.lines().filter(|line| line.starts_with("## ")).flat_map(quoted).collect();
    let shipped = assur_fixtures::SCENES.iter().map(|(name, _)| format!("fixtures/{name}.toml")).collect();
    assert_eq!(files, shipped);
    let table = page.split("\n### All methods\n").nth(1).unwrap().split("\n## ").next().unwrap();
    let row = |line: &str| Some((line.split('|').nth(1)?.trim().to_owned(), quoted(line).next()?));
    let told: BTreeSet<(String, String)> = table.lines().filter_map(row).collect();
    // Together these scenes have all stages.
    let charts = ["shaper-drive", "shaper-friction"].map(charted);
    let rows = charts.iter().flat_map(|data| &data.rows);
    let charted = rows.map(|row| (row.stage.heading().to_string(), row.method.clone())).collect();
    assert_eq!(told, charted);
    let has = |stage: Stage, method: &str| {
        assert!(told.contains(&(stage.heading().to_string(), method.to_owned())), "{stage:?} {method}");
    };
    for plugin in assur_force::analyzers().unwrap() {
        has(Stage::Forces, plugin.name);
        if plugin.treats_friction {
            has(Stage::Friction, plugin.name);
        }
    }
    assur_integrator::integrators().unwrap().iter().for_each(|plugin| has(Stage::Motion, plugin.name));
}

/// No number of an axis is cut off: the least is written as a power of ten.
#[test]
fn the_charts_of_the_page_have_powers_of_ten() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/measured/accuracy.md");
    let page = std::fs::read_to_string(path).unwrap();
    let numbers = page.lines().filter_map(|line| Some(line.split_once('│')?.0.trim()));
    let numbers: Vec<&str> = numbers.filter(|number| !number.is_empty()).collect();
    assert!(numbers.len() > 100 && numbers.iter().all(|number| number.starts_with("1e")), "{numbers:?}");
}
