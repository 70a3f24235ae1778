//! Walks through the commands of docs/sources.md.

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

#[test]
fn every_command_of_the_table_shows_what_it_names() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let page = std::fs::read_to_string(root.join("docs/sources.md")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let mut count = 0;
    for row in page.lines().filter(|line| line.starts_with("| ") && line.contains("`assur ")) {
        let (_, command) = row.split_once("`assur ").unwrap();
        let (command, expected) = command.split_once('`').unwrap();
        let picture = folder.path().join("picture.svg");
        let command = command.replace("PICTURE.svg", picture.to_str().unwrap());
        let output = Command::new(env!("CARGO_BIN_EXE_assur"))
            .args(words(&command))
            .current_dir(root.join("fixtures"))
            .env("LC_ALL", "C.UTF-8")
            .output()
            .unwrap();
        let (out, err) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
        assert_eq!(output.status.code(), Some(0), "assur {command}: {err}");
        match expected.split('"').nth(1) {
            Some(expected) => {
                assert!(out.to_lowercase().contains(&expected.to_lowercase()), "assur {command}: {expected}");
            }
            None => assert!(std::fs::read_to_string(&picture).unwrap().contains("<svg"), "assur {command}"),
        }
        count += 1;
    }
    assert!(count >= 20, "{count} commands");
}
