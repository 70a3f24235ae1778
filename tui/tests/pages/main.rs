//! Pages of docs: those that are played (their scenes are written to files, their commands run, and what they quote is printed), those
//! that are generated, and the links between all.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

mod generated;
mod json;
mod links;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn page(name: &str) -> String {
    fs::read_to_string(root().join(name)).unwrap()
}

/// The fenced blocks of a page: what stands behind the opening fence, and the lines.
fn blocks(page: &str) -> Vec<(&str, &str)> {
    let parts = page.split("```").skip(1).step_by(2);
    parts.map(|block| block.split_once('\n').unwrap()).collect()
}

/// The words of a command line; a word in quotation marks may contain blanks.
fn words(line: &str) -> Vec<&str> {
    let parts = line.split('"').enumerate();
    parts
        .flat_map(|(i, part)| if i % 2 == 1 { vec![part] } else { part.split_whitespace().collect() })
        .collect()
}

/// Writes the scene of a block. `NAME from OTHER`: that of another file, in which the tables of the block take the place of the
/// table that has the name of the first.
fn write(folder: &Path, names: &str, text: &str) {
    let (name, whole) = match names.split_once(" from ") {
        None => (names, text.to_owned()),
        Some((name, other)) => {
            let other = fs::read_to_string(folder.join(other)).unwrap();
            let first = text.lines().next().unwrap();
            let (before, after) = other.split_once(first).unwrap();
            let (_, after) = after.split_once("\n\n").unwrap();
            (name, format!("{before}{text}\n{after}"))
        }
    };
    fs::write(folder.join(name), whole).unwrap();
}

/// Whether lines stand in an output one after another; `...` is any number of lines.
fn shows(output: &str, quoted: &[&str]) -> bool {
    let mut rest: Vec<&str> = output.lines().map(str::trim_end).collect();
    for part in quoted.split(|line| *line == "...").filter(|part| !part.is_empty()) {
        let Some(at) = rest.windows(part.len()).position(|lines| lines == part) else { return false };
        rest.drain(..at + part.len());
    }
    true
}

/// Plays a page; returns how many commands it has.
fn played(page: &str) -> usize {
    let folder = tempfile::tempdir().unwrap();
    let mut count = 0;
    for (about, text) in blocks(page) {
        if let Some(names) = about.strip_prefix("toml ") {
            write(folder.path(), names, text);
        }
        for command in
            text.split("$ assur ").skip(usize::from(about == "console")).filter(|_| about == "console")
        {
            let (line, quoted) = command.split_once('\n').unwrap();
            let output = Command::new(env!("CARGO_BIN_EXE_assur"))
                .args(words(line))
                .current_dir(&folder)
                .env("LC_ALL", "C.UTF-8")
                .output()
                .unwrap();
            let printed = String::from_utf8_lossy(&output.stdout);
            assert!(output.status.success(), "assur {line}: {}", String::from_utf8_lossy(&output.stderr));
            let quoted: Vec<&str> = quoted.lines().map(str::trim_end).collect();
            assert!(
                shows(&printed, &quoted),
                "assur {line} does not print\n{}\nbut\n{printed}",
                quoted.join("\n")
            );
            count += 1;
        }
    }
    count
}

#[test]
fn frames_and_signs_are_as_the_page_says() {
    assert_eq!(played(&page("docs/frames.md")), 13, "commands of the page");
}

#[test]
fn the_recipes_run_as_they_stand() {
    assert_eq!(played(&page("docs/recipes.md")), 14, "commands of the page");
}

#[test]
fn the_first_hour_runs_as_it_stands() {
    assert_eq!(played(&page("docs/first-hour.md")), 10, "commands of the page");
}
