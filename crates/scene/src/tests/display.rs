//! How faults are printed.

use super::BASE;
use super::faults::{faults, snapshot};
use crate::read;

#[test]
fn several_faults_at_once_in_the_order_of_the_file() {
    let text =
        BASE.replace("\"3 kg\"", "\"3 mm\"").replace("at = \"B\"", "at = \"A\"").replace("title", "name");
    snapshot("several_faults_at_once_in_the_order_of_the_file", &faults(&text, &[(1, 1), (9, 8), (37, 6)]));
}

#[test]
fn an_empty_scene() {
    snapshot("an_empty_scene", &faults("", &[(1, 1), (1, 1)]));
}

#[test]
fn carets_stand_below_wide_characters_and_tabs() {
    // Each Han character is two columns wide, the tab is printed as four spaces.
    let text = BASE
        .replace("value = 700", "\tvalue = { \"\u{4e2d}\u{6587}\" = 1, over = \"time\", table = [[0, 1]] }");
    let shown = faults(&text, &[(39, 12)]);
    let lines: Vec<&str> = shown.lines().collect();
    let carets = lines.iter().position(|line| line.contains('^')).unwrap();
    // "39 | " + four spaces + "value = { "
    assert_eq!(lines[carets], format!("   | {}^^^^^^", " ".repeat(14)), "{shown}");
}

#[test]
fn long_lines_are_cut_around_the_fault() {
    let points: Vec<String> = (0..40).map(|index| format!("P{index} = {index}")).collect();
    let text =
        BASE.replace("B = \"240 mm\"", &format!("B = \"240 mm\", {}, Q = true, Z = 3", points.join(", ")));
    let errors = read("engine.toml", &text).unwrap_err().to_string();
    assert!(errors.lines().all(|line| line.chars().count() <= 110), "{errors}");
    let lines: Vec<&str> = errors.lines().collect();
    let column = lines[4].find('^').unwrap();
    assert_eq!(&lines[3][column..column + 4], "true", "{errors}");
}

#[test]
fn many_faults_are_counted() {
    let many: Vec<String> = (0..25).map(|index| format!("x{index} = 1")).collect();
    let errors = read("engine.toml", &(many.join("\n") + "\n" + BASE)).unwrap_err();
    assert_eq!(errors.errors.len(), 25);
    assert!(errors.to_string().ends_with("\n... and 5 more\n"));
}

#[test]
fn line_ends_and_marks_of_other_systems() {
    let text =
        format!("\u{feff}{}", BASE.replace("title", "titel").replace('\n', "\r\n").replace("3 kg", "3 mm"));
    let shown = faults(&text, &[(1, 1), (9, 8)]);
    assert!(shown.contains("\n1 | titel = \"Engine\"\n  | ^^^^^ did you mean `title`?\n"), "{shown}");
    assert!(shown.contains("\n9 | mass = \"3 mm\"\n  |        ^^^^^^ such as"), "{shown}");
}

#[test]
fn a_fault_of_the_input_is_not_repeated_by_what_depends_on_it() {
    let text = BASE.replace("[input]\nlink = \"crank\"", "[input]\nlink = \"carnk\"");
    let shown = faults(&text, &[(28, 8)]);
    assert!(shown.contains("did you mean `crank`?"), "{shown}");
}
