//! `assur analyze --format json` against results that were found independently.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

const SCENES: [&str; 9] = [
    "shaper",
    "guide-shaper",
    "slider-crank",
    "conveyor",
    "stephenson3",
    "press",
    "triad",
    "contour",
    "six-links",
];
/// Scenes whose independent results have no reduced quantities.
const WITHOUT_REDUCED: [&str; 3] = ["triad", "contour", "six-links"];

fn analyzed(scene: &str, analyzer: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures").join(scene).with_extension("toml");
    let output = Command::new(env!("CARGO_BIN_EXE_assur"))
        .args(["analyze", path.to_str().unwrap(), "--format", "json", "--analyzer", analyzer])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(0), "{scene}: {}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn expected(scene: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures").join(scene).with_extension("json");
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// Error and largest value of each quantity; names of links, points and pairs are left out of it.
type Quantities = BTreeMap<String, (f64, f64)>;

fn compare(found: &Value, wanted: &Value, quantity: &str, all: &mut Quantities) {
    match wanted {
        Value::Object(map) => {
            for (key, value) in map {
                let is_name = ["links", "points", "slides", "reactions"].contains(&quantity);
                let inner = match quantity {
                    "" => key.clone(),
                    _ if is_name => format!("{quantity}/"),
                    // Forces are one quantity, whatever the link; moments another.
                    "reactions/" if key != "moment" => "reactions/force".to_owned(),
                    _ => format!("{quantity}{key}"),
                };
                assert!(found.get(key).is_some(), "{quantity}: {key} is missing");
                compare(&found[key], value, &inner, all);
            }
        }
        Value::Array(list) => {
            assert_eq!(found.as_array().map(Vec::len), Some(list.len()), "{quantity}");
            list.iter().enumerate().for_each(|(i, value)| compare(&found[i], value, quantity, all));
        }
        _ => {
            let (found, wanted) = (found.as_f64().unwrap(), wanted.as_f64().unwrap());
            let entry = all.entry(quantity.to_owned()).or_default();
            *entry = (entry.0.max((found - wanted).abs()), entry.1.max(wanted.abs()));
        }
    }
}

fn agrees(scene: &str, analyzer: &str) {
    let (found, wanted) = (analyzed(scene, analyzer), expected(scene));
    let mut all = Quantities::new();
    compare(&found["positions"], &wanted["positions"], "", &mut all);
    let reduced = if WITHOUT_REDUCED.contains(&scene) { None } else { Some("reduced") };
    for needed in ["points/pf2", "links/pf1", "reactions/force", "balancing"].into_iter().chain(reduced) {
        assert!(
            all.keys().any(|quantity| quantity.starts_with(needed)),
            "{scene}: {needed} was not compared"
        );
    }
    for (quantity, (error, largest)) in all {
        // A quantity that is zero throughout is compared with 1.
        let scale = if largest > 1e-9 { largest } else { 1.0 };
        assert!(error <= 1e-10 * scale, "{scene}: {quantity} deviates by {error:e} of {largest:e}");
    }
}

#[test]
fn every_scene_agrees_group_by_group() {
    for scene in SCENES {
        agrees(scene, "groups");
    }
}

#[test]
fn every_scene_agrees_by_one_system_for_all_links() {
    for scene in SCENES {
        agrees(scene, "newton-euler");
    }
}

#[test]
fn rates_follow_from_transfer_functions() {
    let found = analyzed("shaper", "groups");
    let w = std::f64::consts::TAU;
    for position in found["positions"].as_array().unwrap() {
        for (name, rate) in position["velocities"]["points"].as_object().unwrap() {
            for axis in 0..2 {
                let pf = |order: &str| position["points"][name][order][axis].as_f64().unwrap();
                let v = rate[axis].as_f64().unwrap();
                let a = position["accelerations"]["points"][name][axis].as_f64().unwrap();
                assert!((v - pf("pf1") * w).abs() < 1e-14 && (a - pf("pf2") * w * w).abs() < 1e-13, "{name}");
            }
        }
        for sort in ["links", "slides"] {
            assert_eq!(
                position["velocities"][sort].as_object().unwrap().len(),
                position[sort].as_object().unwrap().len()
            );
        }
    }
}

#[test]
fn angles_do_not_jump_and_start_in_the_first_turn() {
    let found = analyzed("guide-shaper", "groups");
    let positions = found["positions"].as_array().unwrap();
    for link in positions[0]["links"].as_object().unwrap().keys() {
        let angle = |i: usize| positions[i]["links"][link]["pf0"].as_f64().unwrap();
        assert!(angle(0) > -std::f64::consts::PI && angle(0) <= std::f64::consts::PI);
        assert!((1..positions.len()).all(|i| (angle(i) - angle(i - 1)).abs() < 1.0), "{link}");
    }
}
