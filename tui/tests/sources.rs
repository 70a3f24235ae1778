//! Walks through the commands of docs/sources.md and docs/course.md.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use std::collections::HashMap;
use std::path::Path;
use std::process::Command;

/// The words of a command line; a word in quotation marks may contain blanks.
fn words(line: &str) -> Vec<String> {
    let parts = line.split('"').enumerate();
    let split = parts.flat_map(|(i, part)| {
        if i % 2 == 1 { vec![part.to_owned()] } else { part.split_whitespace().map(str::to_owned).collect() }
    });
    split.collect()
}

/// The texts of a picture, each on a line.
fn text_of(svg: &str) -> String {
    let texts = svg.split("<text").skip(1).filter_map(|rest| rest.split_once('>')?.1.split_once("</text>"));
    // Subscripts have tags of their own.
    let untagged = |text: &str| {
        let mut parts = text.split('<');
        let first = parts.next().unwrap_or_default().to_owned();
        parts.fold(first, |text, part| text + part.split_once('>').map_or("", |(_, rest)| rest))
    };
    texts.map(|(text, _)| untagged(text).replace("&apos;", "'") + "\n").collect()
}

/// Runs the commands of a page, each in a line that begins with a sign and names what must be shown; their number.
fn walk(page: &str, begin: &str) -> usize {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let page = std::fs::read_to_string(root.join("docs").join(page)).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("picture.svg");
    let (mut count, mut faults) = (0, Vec::new());
    // A command that stands in several lines runs once.
    let mut known: HashMap<String, String> = HashMap::new();
    for row in page.lines().filter(|line| line.starts_with(begin) && line.contains("`assur ")) {
        let (_, command) = row.split_once("`assur ").unwrap();
        let (command, expected) = command.split_once('`').unwrap();
        let shown = known.entry(command.to_owned()).or_insert_with(|| {
            let with_picture = command.replace("PICTURE.svg", picture.to_str().unwrap());
            let output = Command::new(env!("CARGO_BIN_EXE_assur"))
                .args(words(&with_picture))
                .current_dir(root.join("fixtures"))
                .env("LC_ALL", "C.UTF-8")
                .output()
                .unwrap();
            if output.status.code() != Some(0) {
                faults.push(format!("assur {command}: {}", String::from_utf8_lossy(&output.stderr)));
            }
            let drawn = std::fs::read_to_string(&picture).unwrap_or_default();
            let _ = std::fs::remove_file(&picture);
            String::from_utf8_lossy(&output.stdout).into_owned() + &text_of(&drawn)
        });
        let named: Vec<&str> = expected.split('"').skip(1).step_by(2).collect();
        if named.is_empty() {
            faults.push(format!("assur {command}: nothing is named"));
        }
        let missing = named.into_iter().filter(|named| !shown.contains(named));
        faults.extend(missing.map(|named| format!("assur {command}: no {named}")));
        count += 1;
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    count
}

#[test]
fn every_command_of_the_table_shows_what_it_names() {
    let count = walk("sources.md", "| ");
    assert!(count >= 45, "{count} commands");
}

#[test]
fn every_command_of_the_course_shows_what_it_names() {
    let count = walk("course.md", "* ");
    assert!(count >= 30, "{count} commands");
}
