//! `assur geometry` and `assur shaking` from outside: exit status, errors, forms.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use std::path::Path;
use std::process::{Command, Output};

fn assur(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_assur"))
        .args(arguments)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures"))
        .env("LC_ALL", "C.UTF-8")
        .output()
        .unwrap()
}

fn text(output: &Output) -> (i32, &str, &str) {
    let [out, err] = [&output.stdout, &output.stderr].map(|bytes| str::from_utf8(bytes).unwrap());
    (output.status.code().unwrap(), out, err)
}

#[test]
fn forms_of_the_geometry() {
    let output = assur(&["geometry", "shaper.toml", "--format", "json"]);
    let (code, out, _) = text(&output);
    let found: serde_json::Value = serde_json::from_str(out).unwrap();
    assert_eq!(code, 0);
    let ram = &found["slides"]["ram/ground"];
    assert!((ram["stroke"].as_f64().unwrap() - 0.35).abs() < 1e-12);
    assert!((ram["max"].as_f64().unwrap() - 0.175).abs() < 1e-12);
    assert_eq!(found["positions"].as_array().unwrap().len(), 48);

    let output = assur(&["geometry", "shaper.toml", "--ascii"]);
    let (code, out, _) = text(&output);
    assert!(code == 0 && out.is_ascii());
    assert!(out.contains("ram/ground     350 mm      194.478, 345.522"), "{out}");

    // The guide is pressed along its normal all the time: what is left of the angle is rounding, and no range.
    assert!(out.contains("pressure angle of the line of the pins to the guide 0 deg, constant"), "{out}");
    // A driven slide: points on its line have coordinates and derivatives of rounding.
    let output = assur(&["geometry", "scissor-lift.toml"]);
    let (_, out, _) = text(&output);
    let tiny = |word: &str| word.parse::<f64>().is_ok_and(|value| value != 0.0 && value.abs() < 1e-12);
    let lines: Vec<_> = out.lines().filter(|line| line.contains(" mm ") || line.contains(" deg ")).collect();
    assert!(!lines.is_empty() && !lines.iter().any(|line| line.split_whitespace().any(tiny)), "{out}");

    let output = assur(&["geometry", "shaper.toml", "--format", "csv", "--against", "rocker"]);
    let (code, out, _) = text(&output);
    assert_eq!((code, out.lines().count()), (0, 49));
    assert!(out.starts_with("position,coordinate_rad,crank_center_x_m,"));
    assert!(!out.contains("rocker_center"));
}

#[test]
fn faults_of_the_geometry() {
    let output = assur(&["geometry", "shaper.toml", "--against", "crnk"]);
    let (code, out, err) = text(&output);
    assert_eq!((code, out), (2, ""));
    assert!(err.contains("no such link, only ground, crank"), "{err}");
    let folder = tempfile::tempdir().unwrap();
    let scene = assur_fixtures::scene("slider-crank").replace("240 mm", "50 mm");
    let path = folder.path().join("short.toml");
    std::fs::write(&path, scene).unwrap();
    let output = assur(&["geometry", path.to_str().unwrap()]);
    let (code, out, err) = text(&output);
    assert_eq!((code, out), (1, ""));
    assert!(err.contains("the motion is measured over the whole cycle"), "{err}");
}

#[test]
fn forms_of_the_shaking() {
    let output = assur(&["shaking", "four-bar.toml", "--format", "json"]);
    let (code, out, _) = text(&output);
    let found: serde_json::Value = serde_json::from_str(out).unwrap();
    assert_eq!(code, 0);
    assert_eq!(found["balances"].as_array().unwrap().len(), 4);
    assert_eq!(found["balances"][2]["counterweights"][1]["link"], "rocker");
    let output = assur(&["shaking", "four-bar.toml", "--ascii"]);
    let (code, out, _) = text(&output);
    assert!(code == 0 && out.is_ascii() && out.contains("on crank, rocker: minimax"), "{out}");
    assert!(out.contains("Duality gap"), "{out}");
    let output = assur(&["shaking", "four-bar.toml", "--format", "csv"]);
    let (code, out, _) = text(&output);
    assert_eq!((code, out.lines().count()), (0, 37));
    assert!(found["balances"][1]["proof"]["gap"].as_f64().unwrap() <= 1e-9);
    // A steady regime: its speed over the cycle is found first.
    let output = assur(&["shaking", "shaper-drive.toml"]);
    let (code, _, err) = text(&output);
    assert_eq!(code, 0, "{err}");
}

#[test]
fn faults_of_the_shaking() {
    let folder = tempfile::tempdir().unwrap();
    let scene =
        assur_fixtures::scene("four-bar").replace("[motion]\nspeed = \"180 rpm\"\nacceleration = 30\n", "");
    let path = folder.path().join("still.toml");
    std::fs::write(&path, scene).unwrap();
    let output = assur(&["shaking", path.to_str().unwrap()]);
    let (code, out, err) = text(&output);
    assert_eq!((code, out), (2, ""));
    assert!(err.contains("give `[motion]`"), "{err}");
}

/// A load that outgrows all numbers in the cycle, not in a position of the scene, is shown where it stands.
#[test]
fn a_load_without_a_finite_value_has_its_place() {
    let folder = tempfile::tempdir().unwrap();
    let load = "\n[[moment]]\nlink = \"rocker\"\nvalue = { formula = \"1/(1 - sin(q))\", unit = \"N*m\" }\n";
    let scene = assur_fixtures::scene("four-bar").to_owned() + load;
    let line = scene.lines().position(|line| line.starts_with("value = { formula")).unwrap() + 1;
    let path = folder.path().join("pole.toml");
    std::fs::write(&path, scene).unwrap();
    let output = assur(&["shaking", path.to_str().unwrap()]);
    let (code, out, err) = text(&output);
    assert_eq!((code, out), (1, ""));
    assert!(err.contains("has no finite value at coordinate 1.570796327"), "{err}");
    assert!(err.contains(&format!("line {line}, column 1")), "{err}");
}

/// Over 40 deg about its lower dead point, crank and rod in one line, the press turns back once.
#[test]
fn a_slide_that_turns_back_once_is_told() {
    let output = assur(&["geometry", "press.toml"]);
    let (_, out, _) = text(&output);
    assert!(out.contains("slider/ground turns back at -90 deg"), "{out}");
}
