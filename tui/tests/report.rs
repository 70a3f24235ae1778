//! What a person reads.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use std::path::Path;
use std::process::Command;

fn assur(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_assur"))
        .args(arguments)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures"))
        .env("LC_ALL", "C.UTF-8")
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// The report without its checks, whose residuals are rounding.
fn report(scene: &str) -> String {
    let text = assur(&["analyze", scene]);
    let end = text.find(" Checks\n").unwrap();
    text[..end].to_owned()
}

#[test]
fn report_of_the_shaper() {
    insta::assert_snapshot!(report("shaper.toml"));
}

#[test]
fn report_of_the_slider_crank() {
    insta::assert_snapshot!(report("slider-crank.toml"));
}

#[test]
fn explanation_of_the_press() {
    insta::assert_snapshot!(assur(&["explain", "press.toml"]));
}

#[test]
fn no_line_is_longer_than_a_page() {
    for scene in ["shaper.toml", "guide-shaper.toml", "stephenson3.toml", "press.toml", "conveyor.toml"] {
        for command in ["analyze", "explain"] {
            for line in assur(&[command, scene]).lines() {
                assert!(line.chars().count() <= 100, "{scene}: {line}");
            }
        }
    }
}

#[test]
fn rounding_is_shown_as_zero() {
    // The piston of the slider-crank moves along y exactly; what remains of x is rounding.
    let text = report("slider-crank.toml");
    assert!(!text.contains("e-1"), "{text}");
    assert!(!text.contains("-0.000 ") && !text.contains("-0.0000 "), "a minus before zero");
}

#[test]
fn the_report_begins_with_what_is_asked_for_first() {
    let text = assur(&["analyze", "shaper-drive.toml"]);
    let page = &text[..text.find("2. Structure").unwrap()];
    let value = |what: &str| {
        let line =
            page.lines().find(|line| line.starts_with(what)).unwrap_or_else(|| panic!("{what}: {page}"));
        line[what.len()..].split_whitespace().next().unwrap().to_owned()
    };
    // The rocker of 700 mm swings as far as the crank of 100 mm turns it about a point 400 mm away: 2 * 700 * 100 / 400.
    assert_eq!(value("stroke of ram/ground, dead points"), "350");
    assert_eq!(value("unevenness"), "0.05");
    // The speed is kept in the mean: 60 rpm.
    assert_eq!(value("mean speed"), "6.28319");
    let checks = page.lines().find(|line| line.starts_with("checks passed")).unwrap();
    let numbers: Vec<usize> = checks.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    assert!(numbers.len() == 2 && numbers[0] == numbers[1] && numbers[0] > 10, "{checks}");
}

#[test]
fn positions_limit_the_tables_and_not_the_results() {
    let all = assur(&["analyze", "shaper.toml"]);
    let some = assur(&["analyze", "shaper.toml", "--positions", "0,18,30..32"]);
    let results = |text: &str| text[..text.find("2. Structure").unwrap()].to_owned();
    assert_eq!(results(&all), results(&some));
    let table = |text: &str| -> Vec<String> {
        let from = text.find("\nPoints\nNo.").unwrap();
        let rows = text[from..].lines().skip(5).take_while(|line| !line.is_empty());
        rows.map(|row| row.split_whitespace().next().unwrap().to_owned()).collect()
    };
    assert_eq!(table(&all).len(), 48);
    assert_eq!(table(&some), ["0", "18", "30", "31", "32"]);
}
