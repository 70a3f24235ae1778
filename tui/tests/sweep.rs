//! `assur sweep` from outside: exit status, errors, files.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// Crank and rod: the rod of 300 mm is too short for a crank of 400 mm.
const SLIDER: &str = "[ground]\npoints = { O = [0, 0] }\n[link.crank]\npoints = { O = 0, A = \"100 mm\" }\n\
    [link.rod]\npoints = { A = 0, B = 0.3 }\n[link.piston]\npoints = { B = 0 }\nmass = \"2 kg\"\n\
    [[slide]]\nlink = \"piston\"\non = \"ground\"\n[input]\nlink = \"crank\"\n[assembly]\nB = [0.4, 0]\n";
const LENGTHS: &str = "link.crank.points.A=100 mm..200 mm:3";

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.toml"), SLIDER).unwrap();
    folder
}

/// Runs `assur sweep a.toml`.
fn sweep(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_assur"))
        .args(["sweep", "a.toml"])
        .args(arguments)
        .current_dir(folder)
        .env("LC_ALL", "C.UTF-8")
        .output()
        .unwrap()
}

/// Exit status and standard error.
fn end(output: &Output) -> (i32, &str) {
    (output.status.code().unwrap(), str::from_utf8(&output.stderr).unwrap())
}

fn names(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<_> = names.collect();
    names.sort();
    names
}

#[test]
fn rows_go_to_standard_output_or_to_a_file() {
    let folder = folder();
    let printed = sweep(folder.path(), &["--vary", LENGTHS]);
    assert_eq!(end(&printed), (0, ""));
    let text = str::from_utf8(&printed.stdout).unwrap();
    assert!(text.starts_with("link.crank.points.A_m,status,message,failed_positions,smallest_health,"));
    let first: Vec<_> = text.lines().map(|line| line.split(',').next().unwrap()).collect();
    assert_eq!(first, ["link.crank.points.A_m", "0.1", "0.15", "0.2"]);
    let written = sweep(folder.path(), &["--vary", LENGTHS, "-o", "b.csv", "--threads", "1"]);
    assert_eq!((end(&written), written.stdout.len()), ((0, ""), 0));
    assert_eq!(fs::read(folder.path().join("b.csv")).unwrap(), printed.stdout, "one thread or more");
    let written = sweep(folder.path(), &["--vary", LENGTHS, "-o", "b.parquet"]);
    assert_eq!(end(&written), (0, ""));
    let bytes = fs::read(folder.path().join("b.parquet")).unwrap();
    assert!(bytes.starts_with(b"PAR1") && bytes.ends_with(b"PAR1"));
    assert_eq!(names(folder.path()), ["a.toml", "b.csv", "b.parquet"], "nothing is left beside");
}

#[test]
fn a_point_without_solution_keeps_its_row_and_ends_with_1() {
    let folder = folder();
    let output = sweep(folder.path(), &["--vary", "link.crank.points.A=200 mm..400 mm:2", "-o", "b.csv"]);
    let (code, message) = end(&output);
    assert_eq!(code, 1);
    let start = "error: no solution at 1 of 2 points; the first, link.crank.points.A = 400 mm: group 1 (RRP rod, piston), position 2, ";
    assert!(message.starts_with(start), "{message}");
    let text = fs::read_to_string(folder.path().join("b.csv")).unwrap();
    assert_eq!(text.lines().count(), 3);
    assert!(text.lines().nth(1).unwrap().starts_with("0.2,ok,"), "{text}");
    assert!(text.lines().nth(2).unwrap().starts_with("0.4,no assembly,"), "{text}");
}

#[test]
fn bad_usage_ends_with_2_and_touches_no_file() {
    let folder = folder();
    fs::write(folder.path().join("b.csv"), "mine").unwrap();
    for (arguments, message) in [
        (
            &["--vary", "link.crank.mas=1..2:3", "-o", "b.csv"],
            "error: `link.crank.mas`: `link.crank` has no `mas`; a default must be written in the scene \
             before it can be varied; it has: points\n",
        ),
        (
            &["--vary", "link.piston.mass=-1..-2:3", "-o", "b.csv"],
            "error: a.toml: no point of the grid can be calculated; the first, link.piston.mass = -1:\n\
             error: `mass` must not be negative, got -1\n  a.toml, line 9, column 8\n  |\n9 | mass = -1\n  \
             |        ^^ such as \"4 kg\", or a number in kg\n",
        ),
        (&["--vary", LENGTHS, "-o", "b.txt"], "error: can't write b.txt: name it *.csv or *.parquet\n"),
        (&["--vary", LENGTHS, "-o", "c/b.csv"], "error: can't write c/b.csv: there is no folder c\n"),
    ] {
        let output = sweep(folder.path(), arguments);
        assert_eq!(end(&output), (2, message));
        assert!(output.stdout.is_empty());
    }
    assert_eq!(fs::read_to_string(folder.path().join("b.csv")).unwrap(), "mine");
    assert_eq!(names(folder.path()), ["a.toml", "b.csv"]);
}
