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
