//! What a command does to the files that are there.

#![cfg(unix)]
#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use std::fs::{self, File, OpenOptions};
use std::io::Write as _;
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;

/// A crank that turns; its analysis succeeds.
const CRANK: &str = "[ground]\npoints = { O = [0, 0] }\n[link.crank]\npoints = { O = 0, A = \"100 mm\" }\n\
    [input]\nlink = \"crank\"\npositions = 4\n[motion]\nspeed = 2\n";
/// A mechanism that can't turn fully: positions are missing, so that the exit status is 1.
const SHORT: &str = "[ground]\npoints = { O = [0, 0], C = [3, 0] }\n[link.crank]\npoints = { O = 0, A = 2 }\n\
    [link.coupler]\npoints = { A = 0, B = 1.5 }\n[link.rocker]\npoints = { C = 0, B = 1.5 }\n\
    [input]\nlink = \"crank\"\npositions = 6\n";

fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_assur"));
    command.args(arguments).current_dir(folder).env("LC_ALL", "C.UTF-8");
    command
}

fn assur(folder: &Path, arguments: &[&str]) -> Output {
    command(folder, arguments).output().unwrap()
}

fn code(output: &Output) -> i32 {
    output.status.code().unwrap()
}

fn err(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// A folder with both scenes.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("crank.toml"), CRANK).unwrap();
    fs::write(folder.path().join("short.toml"), SHORT).unwrap();
    folder
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn no_command_writes_over_its_scene() {
    let folder = folder();
    let path = folder.path();
    symlink("crank.toml", path.join("link.toml")).unwrap();
    fs::hard_link(path.join("crank.toml"), path.join("name.csv")).unwrap();
    fs::create_dir(path.join("sub")).unwrap();
    let vary = "link.crank.points.A=100 mm..110 mm:2";
    for target in ["crank.toml", "./crank.toml", "sub/../crank.toml", "link.toml", "name.csv"] {
        for first in
            [vec!["analyze"], vec!["chart", "--quick"], vec!["stability"], vec!["sweep", "--vary", vary]]
        {
            let output = assur(path, &[&first[..], &["crank.toml", "-o", target]].concat());
            assert_eq!(code(&output), 2, "{first:?} {target}");
            assert!(err(&output).contains("it is the scene itself"), "{first:?} {target}: {}", err(&output));
        }
    }
    assert_eq!(fs::read_to_string(path.join("crank.toml")).unwrap(), CRANK);
    fs::write(path.join("positions.csv"), CRANK).unwrap();
    let output = assur(path, &["analyze", "positions.csv", "--format", "csv", "-o", "."]);
    assert_eq!((code(&output), fs::read_to_string(path.join("positions.csv")).unwrap().as_str()), (2, CRANK));
}

#[test]
fn results_that_are_not_whole_replace_nothing() {
    let folder = folder();
    let path = folder.path();
    let run = |target| assur(path, &["analyze", "short.toml", "--format", "json", "-o", target]);
    fs::write(path.join("old.json"), "old").unwrap();
    let kept = run("old.json");
    assert_eq!((code(&kept), fs::read_to_string(path.join("old.json")).unwrap().as_str()), (1, "old"));
    assert!(err(&kept).contains("the results are incomplete"), "{}", err(&kept));
    // A new file tells what there is.
    assert_eq!(code(&run("new.json")), 1);
    assert!(fs::read_to_string(path.join("new.json")).unwrap().starts_with('{'));
    let sweep = ["sweep", "short.toml", "--vary", "link.coupler.points.B=0.1..0.2:2", "-o", "old.csv"];
    fs::write(path.join("old.csv"), "old").unwrap();
    assert_eq!(code(&assur(path, &sweep)), 1);
    assert_eq!(fs::read_to_string(path.join("old.csv")).unwrap(), "old");
}

#[test]
fn a_folder_of_csv_has_the_files_of_one_run() {
    let folder = folder();
    let path = folder.path();
    let tables = path.join("tables");
    fs::create_dir(&tables).unwrap();
    for name in ["trajectory.csv", "notes.csv"] {
        fs::write(tables.join(name), "old").unwrap();
    }
    let run = |scene| code(&assur(path, &["analyze", scene, "--format", "csv", "-o", "tables"]));
    assert_eq!(run("crank.toml"), 0);
    assert_eq!(names(&tables), ["notes.csv", "positions.csv", "reactions.csv"]);
    let before = fs::read_to_string(tables.join("positions.csv")).unwrap();
    assert_eq!(run("short.toml"), 1);
    assert_eq!(fs::read_to_string(tables.join("positions.csv")).unwrap(), before);
    assert_eq!(names(&tables), ["notes.csv", "positions.csv", "reactions.csv"]);
}

#[test]
fn links_and_modes_of_a_file_stay() {
    let folder = folder();
    let path = folder.path();
    let run = |target| assert_eq!(code(&assur(path, &["analyze", "crank.toml", "-o", target])), 0);
    fs::write(path.join("one"), "old").unwrap();
    fs::set_permissions(path.join("one"), fs::Permissions::from_mode(0o640)).unwrap();
    symlink("one", path.join("link")).unwrap();
    run("link");
    assert!(fs::symlink_metadata(path.join("link")).unwrap().is_symlink());
    let text = fs::read_to_string(path.join("one")).unwrap();
    assert!(text.contains("crank"), "{text}");
    assert_eq!(fs::metadata(path.join("one")).unwrap().mode() & 0o777, 0o640);
    fs::write(path.join("one"), "a longer text than before".repeat(1000)).unwrap();
    fs::hard_link(path.join("one"), path.join("two")).unwrap();
    run("one");
    for name in ["one", "two"] {
        assert_eq!(fs::read_to_string(path.join(name)).unwrap(), text);
        assert_eq!(fs::metadata(path.join(name)).unwrap().nlink(), 2);
    }
    assert_eq!(names(path), ["crank.toml", "link", "one", "short.toml", "two"]);
}

/// As a shell does, an output goes to where a link leads, though nothing is there yet; links that lead nowhere are refused.
#[test]
fn a_link_to_nothing_leads_to_a_new_file() {
    let folder = folder();
    let path = folder.path();
    fs::create_dir(path.join("far")).unwrap();
    symlink("far/new.json", path.join("link.json")).unwrap();
    symlink("link.json", path.join("chain.json")).unwrap();
    symlink("far/tables", path.join("tables")).unwrap();
    symlink("far/rows.csv", path.join("rows.csv")).unwrap();
    symlink("none/new.json", path.join("lost.json")).unwrap();
    symlink("none/rows.csv", path.join("lost.csv")).unwrap();
    symlink("round.csv", path.join("about.csv")).unwrap();
    symlink("about.csv", path.join("round.csv")).unwrap();
    let before = names(path);
    let analyze = |format, target| assur(path, &["analyze", "crank.toml", "--format", format, "-o", target]);
    let sweep = |target| assur(path, &["sweep", "crank.toml", "--vary", "motion.speed=1..2:2", "-o", target]);
    assert_eq!(code(&analyze("json", "chain.json")), 0);
    assert!(fs::read_to_string(path.join("far/new.json")).unwrap().starts_with('{'));
    assert_eq!(code(&analyze("csv", "tables")), 0);
    assert_eq!(names(&path.join("far/tables")), ["positions.csv", "reactions.csv"]);
    let rows = sweep("rows.csv");
    assert_eq!(code(&rows), 0, "{}", err(&rows));
    assert_eq!(names(&path.join("far")), ["new.json", "rows.csv", "rows.csv.origin.json", "tables"]);
    for (refused, why) in [
        (analyze("json", "lost.json"), "there is no folder"),
        (sweep("lost.csv"), "there is no folder"),
        (analyze("json", "round.csv"), "what is there is not a file"),
        (sweep("round.csv"), "what is there is not a file"),
    ] {
        assert_eq!(code(&refused), 2, "{}", err(&refused));
        assert!(err(&refused).contains(why), "{}", err(&refused));
    }
    assert_eq!(names(path), before);
    assert!(before.iter().all(|name| path.join(name).extension().is_some_and(|of| of == "toml")
        || name == "far"
        || path.join(name).is_symlink()));
}

/// Notes are in the JSON, once each, and none is told beside it; CSV has no place for them, so that what is probably not meant in the
/// scene is told.
#[test]
fn a_note_is_told_once() {
    let folder = folder();
    let path = folder.path();
    let idle = "[[moment]]\nname = \"idle\"\nlink = \"crank\"\nvalue = 0\n";
    fs::write(path.join("idle.toml"), format!("{CRANK}\n{idle}")).unwrap();
    let run = |rest: &[&str]| assur(path, &[&["analyze", "idle.toml"], rest].concat());
    let json = run(&["--format", "json"]);
    assert_eq!((code(&json), err(&json)), (0, String::new()));
    let found: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
    let notes: Vec<_> = found["notes"].as_array().unwrap().iter().map(|note| &note["text"]).collect();
    let says = |text: &str| text.matches("Load `idle` never acts").count();
    assert_eq!(notes.iter().map(|note| says(note.as_str().unwrap())).sum::<usize>(), 1, "{notes:?}");
    let csv = run(&["--format", "csv", "-o", "tables"]);
    assert_eq!((code(&csv), says(&err(&csv)), err(&csv).lines().count()), (0, 1, 1), "{}", err(&csv));
    let refused = run(&["--format", "json", "--strict"]);
    assert_eq!((code(&refused), says(&err(&refused))), (2, 1), "{}", err(&refused));
    // Nothing is written, so that the notes are told.
    let unwritten = run(&["--format", "json", "-o", "none/a.json"]);
    assert_eq!((code(&unwritten), says(&err(&unwritten))), (2, 1), "{}", err(&unwritten));
}

#[test]
fn streams_are_written_to_and_never_replaced() {
    let folder = folder();
    let path = folder.path();
    fs::write(path.join("log"), "kept\n").unwrap();
    for target in ["/dev/stdout", "/dev/fd/1"] {
        let log = OpenOptions::new().append(true).open(path.join("log")).unwrap();
        let run = command(path, &["analyze", "crank.toml", "-o", target]).stdout(Stdio::from(log)).status();
        assert_eq!(run.unwrap().code(), Some(0), "{target}");
    }
    let log = fs::read_to_string(path.join("log")).unwrap();
    assert!(log.starts_with("kept\n") && log.matches("1. Results").count() == 2, "{log}");
}

#[test]
#[cfg(target_os = "linux")]
fn an_output_that_is_full_is_told() {
    let folder = folder();
    for arguments in [&["analyze", "crank.toml"][..], &["plugins"], &["man"], &["--help"], &["--version"]] {
        let full = File::options().write(true).open("/dev/full").unwrap();
        let output =
            command(folder.path(), arguments).stdout(Stdio::from(full)).stderr(Stdio::piped()).output();
        let output = output.unwrap();
        assert_eq!(code(&output), 2, "{arguments:?}");
        assert!(err(&output).contains("can't write to standard output"), "{arguments:?}: {}", err(&output));
    }
    assert_eq!(code(&assur(folder.path(), &["analyze", "crank.toml", "-o", "/dev/full"])), 2);
}

/// Starts an analysis of very many positions and waits until it writes: its temporary file has content.
fn writing(folder: &Path, format: &[&str]) -> Child {
    let scene = CRANK.replace("positions = 4", "positions = 500000");
    fs::write(folder.join("crank.toml"), scene).unwrap();
    let mut child = command(folder, &[&["analyze", "crank.toml"], format].concat()).spawn().unwrap();
    let has_begun = || {
        let mut entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap());
        entries.any(|entry| {
            is_temporary(&entry.file_name()) && entry.metadata().is_ok_and(|found| found.len() > 0)
        })
    };
    while !has_begun() {
        assert_eq!(child.try_wait().unwrap(), None, "the analysis has ended");
        std::thread::sleep(Duration::from_millis(1));
    }
    child
}

fn is_temporary(name: &std::ffi::OsStr) -> bool {
    name.to_string_lossy().starts_with(".assur-")
}

#[test]
fn a_signal_while_a_file_is_written_leaves_what_was_there() {
    for (name, number) in [("HUP", 1), ("INT", 2), ("TERM", 15)] {
        for format in [["--format", "json", "-o", "old.json"], ["--format", "csv", "-o", "."]] {
            let folder = folder();
            let path = folder.path();
            fs::write(path.join("old.json"), "old").unwrap();
            let mut child = writing(path, &format);
            let kill = format!("kill -{name} {}", child.id());
            assert!(Command::new("sh").args(["-c", &kill]).status().unwrap().success());
            // A shell reports this as 128 more: 143 for SIGTERM.
            assert_eq!(child.wait().unwrap().signal(), Some(number), "{name} {format:?}");
            assert_eq!(names(path), ["crank.toml", "old.json", "short.toml"], "{name} {format:?}");
            assert_eq!(fs::read_to_string(path.join("old.json")).unwrap(), "old");
        }
    }
}

#[test]
fn a_kill_while_a_file_is_written_leaves_at_most_a_temporary_file() {
    let folder = folder();
    let path = folder.path();
    fs::write(path.join("old.json"), "old").unwrap();
    let mut child = writing(path, &["--format", "json", "-o", "old.json"]);
    child.kill().unwrap();
    child.wait().unwrap();
    let mut left = names(path);
    left.retain(|name| !is_temporary(name.as_ref()));
    assert_eq!(left, ["crank.toml", "old.json", "short.toml"]);
    assert_eq!(fs::read_to_string(path.join("old.json")).unwrap(), "old");
    // The next run goes on as if nothing had happened.
    assert_eq!(code(&assur(path, &["analyze", "short.toml", "--format", "json", "-o", "new.json"])), 1);
}

#[test]
fn words_of_the_command_line_are_told_without_control_characters() {
    let folder = folder();
    for arguments in [
        &["analyze", "crank.toml", "--analyzer", "\u{1b}[31mred"][..],
        &["analyze", "crank.toml", "--integrator", "\u{1b}]0;title\u{7}"],
        &["analyze", "\u{1b}[2Jscene.toml"],
        &["analyze", "\u{202e}scene.toml"],
        &["\u{1b}[31mcommand", "crank.toml"],
        &["analyze", "crank.toml", "-o", "\u{1b}[31m/none"],
    ] {
        let output = assur(folder.path(), arguments);
        assert_eq!(code(&output), 2, "{arguments:?}");
        let hidden = |c: char| (c.is_control() && c != '\n') || c == '\u{202e}';
        assert!(!err(&output).contains(hidden), "{arguments:?}: {:?}", err(&output));
        // The parser of the command line leaves such characters out, the program shows them as escapes.
        let escaped = arguments[0] != "analyze" || err(&output).contains("\\u{");
        assert!(escaped, "{arguments:?}: {}", err(&output));
    }
}

#[test]
fn what_is_too_large_to_be_drawn_is_refused() {
    let folder = folder();
    let path = folder.path();
    let large = assur(path, &["draw", "crank.toml", "-o", "a.png", "--size", "1000x1000"]);
    assert_eq!(code(&large), 2);
    assert!(err(&large).contains("a png has at most 64 million, such as 800 x 800 mm"), "{}", err(&large));
    assert_eq!(code(&assur(path, &["draw", "crank.toml", "-o", "a.svg", "--size", "1000x1000"])), 0);
    // Ground, crank and their joint beside the points.
    let points = |count: usize| (0..count).fold(String::new(), |text, i| text + &format!(", P{i} = 0.1"));
    let scene = |count| CRANK.replace("A = \"100 mm\"", &format!("A = \"100 mm\"{}", points(count)));
    fs::write(path.join("crank.toml"), scene(997)).unwrap();
    for arguments in [&["draw", "crank.toml", "-o", "b.svg"][..], &["report", "crank.toml", "-o", "b.html"]] {
        let output = assur(path, arguments);
        assert_eq!(code(&output), 2, "{arguments:?}");
        assert!(
            err(&output).contains("the scene has 1001 links, points, slides and loads"),
            "{}",
            err(&output)
        );
    }
    fs::write(path.join("crank.toml"), scene(96).replace("positions = 4", "positions = 1001")).unwrap();
    let note = assur(path, &["report", "crank.toml", "-o", "b.html"]);
    assert!(
        code(&note) == 2 && err(&note).contains("at most 1000 positions of a scene of 100 "),
        "{}",
        err(&note)
    );
    assert_eq!(names(path), ["a.svg", "crank.toml", "short.toml"]);
}

/// Runs the program with a text as its standard input.
fn piped(folder: &Path, arguments: &[&str], input: &str) -> Output {
    let mut child = command(folder, arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // A program that reads nothing may be gone already.
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    child.wait_with_output().unwrap()
}

#[test]
fn a_scene_comes_from_standard_input() {
    let folder = folder();
    for line in [
        "analyze",
        "check",
        "explain",
        "structure",
        "geometry",
        "set motion.speed=3",
        "sweep --vary motion.speed=1..2:2",
    ] {
        let mut arguments: Vec<&str> = line.split(' ').collect();
        arguments.insert(1, "crank.toml");
        let by_name = assur(folder.path(), &arguments);
        arguments[1] = "-";
        let by_input = piped(folder.path(), &arguments, CRANK);
        assert_eq!(by_input.stdout, by_name.stdout, "{line}: {}", err(&by_input));
        assert_eq!(code(&by_input), code(&by_name), "{line}");
    }
    let alone = piped(folder.path(), &["-"], CRANK);
    assert_eq!(alone.stdout, assur(folder.path(), &["crank.toml"]).stdout);
    let faulty = piped(folder.path(), &["analyze", "-"], &CRANK.replace("speed = 2", "sped = 2"));
    assert_eq!(code(&faulty), 2);
    assert!(
        err(&faulty).contains("<stdin>, line 8") || err(&faulty).contains("<stdin>:8"),
        "{}",
        err(&faulty)
    );
}

#[test]
fn rows_of_chosen_positions_alone_are_written_in_every_form() {
    let folder = folder();
    let run = |arguments: &[&str]| {
        let all = [&["analyze", "crank.toml"], arguments].concat();
        let output = assur(folder.path(), &all);
        assert_eq!(code(&output), 0, "{arguments:?}: {}", err(&output));
        output.stdout
    };
    let json: serde_json::Value =
        serde_json::from_slice(&run(&["--format", "json", "--positions", "1,3"])).unwrap();
    let all: serde_json::Value = serde_json::from_slice(&run(&["--format", "json"])).unwrap();
    let rows = all["positions"].as_array().unwrap();
    assert_eq!(json["positions"], serde_json::json!([rows[1], rows[3]]));
    run(&["--format", "csv", "-o", "all"]);
    run(&["--format", "csv", "-o", "some", "--positions", "1,3"]);
    let read = |name: &str| fs::read_to_string(folder.path().join(name).join("positions.csv")).unwrap();
    let (all, some) = (read("all"), read("some"));
    let all: Vec<&str> = all.lines().collect();
    assert_eq!(some.lines().collect::<Vec<_>>(), [all[0], all[2], all[4]]);
    let output = assur(folder.path(), &["analyze", "crank.toml", "--format", "json", "--positions", "4"]);
    assert_eq!(code(&output), 2, "there are positions 0 to 3");
}
