//! What has no solution is reported by every command: with the exit status and the first reason of `analyze`, and without a number
//! that is not finite.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// A four-bar that can't turn fully: crank 2, ground 3, coupler and rocker 1.5.
const SHORT: &str = "[ground]\npoints = { O = [0, 0], C = [3, 0] }\n\
    [link.crank]\npoints = { O = 0, A = 2 }\nmass = 1\ncenter = [1, 0]\n\
    [link.coupler]\npoints = { A = 0, B = 1.5 }\nmass = 1\ncenter = [1, 0]\n\
    [link.rocker]\npoints = { C = 0, B = 1.5 }\n\
    [input]\nlink = \"crank\"\npositions = 6\n[assembly]\nB = [2.5, 1.4]\n[motion]\nspeed = 1\n";

/// A corpus scene.
fn corpus(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/corpus").join(format!("{name}.toml"));
    fs::read_to_string(path).unwrap()
}

/// A shipped crank and rod, with another load.
fn loaded(load: &str) -> String {
    format!("{}\n{load}\n", assur_fixtures::scene("slider-crank"))
}

fn assur(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_assur"))
        .args(arguments)
        .current_dir(folder)
        .env("LC_ALL", "C.UTF-8")
        .output()
        .unwrap()
}

/// The first message on standard error, without what stands around it: file, line and column.
fn reason(output: &Output) -> String {
    let text = String::from_utf8(output.stderr.clone()).unwrap();
    // Notes on the scene stand before the reason.
    let first = text.lines().find(|line| !line.contains("note: ")).unwrap_or_default();
    first.trim_start_matches("error: ").trim_start_matches("a.toml: ").to_owned()
}

/// The words of a text that are numbers no more.
fn not_finite(text: &str) -> Vec<&str> {
    let words = text.split(|c: char| !c.is_alphanumeric());
    words.filter(|word| ["nan", "NaN", "inf"].contains(word)).collect()
}

/// Every command that calculates, with what it writes; `{n}` is the number of the lost position.
const COMMANDS: &[(&str, Needs)] = &[
    ("analyze a.toml --format json", Needs::Loads),
    ("analyze a.toml --format csv -o folder", Needs::Loads),
    ("a.toml", Needs::Loads),
    ("check a.toml", Needs::Loads),
    ("explain a.toml --position {n}", Needs::Loads),
    ("report a.toml -o x.html", Needs::Loads),
    ("report a.toml -o x.md", Needs::Loads),
    ("draw a.toml -o x.svg", Needs::Loads),
    ("draw a.toml --view curves -o x.svg", Needs::Loads),
    ("draw a.toml --view plans -o x.svg", Needs::Figure),
    ("draw a.toml --view forces -o x.svg", Needs::Figure),
    ("shaking a.toml", Needs::Cycle),
    ("chart a.toml --quick", Needs::Loads),
    ("sweep a.toml --vary input.positions=6..6:1", Needs::Row),
    ("geometry a.toml", Needs::Positions),
    ("stability a.toml", Needs::Positions),
    ("explain a.toml", Needs::Nothing),
];

/// What a command needs of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Needs {
    /// Its positions, loads and motion: it ends as `analyze` does.
    Loads,
    /// The same, and has no figure where some are missing.
    Figure,
    /// The same, and a motion over the whole cycle.
    Cycle,
    /// The same; the reason is in the message of a row.
    Row,
    /// Its positions.
    Positions,
    /// The scene alone.
    Nothing,
}

/// What is wrong with a command on a scene, whose lost position has this number.
fn wrong(folder: &Path, command: &str, needs: Needs, lost: usize, mechanism: bool) -> Option<String> {
    let wanted = assur(folder, &["analyze", "a.toml"]);
    for name in ["x.html", "x.md", "x.svg"] {
        let _ = fs::remove_file(folder.join(name));
    }
    let _ = fs::remove_dir_all(folder.join("folder"));
    let command = command.replace("{n}", &lost.to_string());
    let found = assur(folder, &command.split(' ').collect::<Vec<_>>());
    let (code, wanted_code) = (found.status.code(), wanted.status.code());
    let told = [&found.stdout, &found.stderr].map(|bytes| String::from_utf8_lossy(bytes).into_owned());
    let files = ["x.html", "x.md", "x.svg", "folder/positions.csv", "folder/reactions.csv"];
    let written = files.iter().filter_map(|name| fs::read_to_string(folder.join(name)).ok());
    // A picture in a note is a text of letters in which any word may occur.
    let without_pictures = |text: String| text.split("data:").next().unwrap_or_default().to_owned();
    let texts: Vec<String> = told.iter().cloned().chain(written.map(without_pictures)).collect();
    let strange: Vec<&str> = texts.iter().flat_map(|text| not_finite(text)).collect();
    if !strange.is_empty() {
        return Some(format!("{command}: has {strange:?}"));
    }
    let same_reason = match needs {
        Needs::Nothing => return (code != Some(0)).then(|| format!("{command}: ends with {code:?}")),
        Needs::Positions if !mechanism => {
            return (code != Some(0)).then(|| format!("{command}: ends with {code:?}, {}", told[1]));
        }
        Needs::Row => told.iter().any(|text| text.contains(&reason(&wanted))),
        _ => reason(&found) == reason(&wanted),
    };
    if code != wanted_code || !same_reason {
        let reasons = [&found, &wanted].map(reason);
        return Some(format!("{command}: ends with {code:?}, not {wanted_code:?}; says {reasons:?}"));
    }
    None
}

/// Walks all commands over a scene that loses something.
fn walk(scene: &str, lost: usize, status: i32, mechanism: bool, left_out: &[Needs]) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.toml"), scene).unwrap();
    let analyzed = assur(folder.path(), &["analyze", "a.toml"]);
    assert_eq!(analyzed.status.code(), Some(status));
    assert_ne!(reason(&analyzed), "", "the reason is told");
    let each = COMMANDS.iter().filter(|(_, needs)| !left_out.contains(needs));
    let wrong: Vec<String> =
        each.filter_map(|(command, needs)| wrong(folder.path(), command, *needs, lost, mechanism)).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_position_without_assembly_is_lost_for_every_command() {
    walk(SHORT, 2, 1, true, &[]);
}

#[test]
fn a_load_without_a_value_is_told_by_every_command_that_needs_loads() {
    for scene in [
        corpus("check_silent_1_0"),
        corpus("explain_nan"),
        loaded("[[moment]]\nlink = \"rod\"\nvalue = { formula = \"ln(-1 + 0*q)\", unit = \"N*m\" }"),
        // On the input link, where no group carries it.
        loaded("[[moment]]\nlink = \"crank\"\nvalue = { formula = \"1/q\", unit = \"N*m\" }"),
    ] {
        walk(&scene, 0, 1, false, &[]);
    }
}

#[test]
fn a_motion_that_is_not_found_is_told_by_every_command_that_needs_it() {
    walk(&corpus("report_silent"), 0, 1, false, &[]);
}

#[test]
fn a_scene_that_can_not_be_calculated_is_refused_by_every_command_that_calculates_it() {
    walk(&corpus("noplace_cycle"), 0, 2, false, &[]);
}

#[test]
fn a_fault_of_motion_loads_and_lengths_has_its_place_in_the_file() {
    let folder = tempfile::tempdir().unwrap();
    for (name, command, line, column) in [
        ("noplace_cycle", "analyze", "[input]", 2),
        ("noplace_zero_rod", "analyze", "points = { Q = 0.0, C = 0.0, D", 1),
        ("noplace_zero_rod", "report", "points = { Q = 0.0, C = 0.0, D", 1),
        ("noplace_zero_rod", "geometry", "points = { Q = 0.0, C = 0.0, D", 1),
        ("check_silent_1_0", "analyze", "value={ formula = \"1/0\"", 1),
        ("explain_nan", "check", "angle={ formula", 1),
        ("report_silent", "report", "until = ", 1),
    ] {
        let scene = corpus(name);
        let number = scene.lines().position(|text| text.contains(line)).unwrap() + 1;
        fs::write(folder.path().join("a.toml"), &scene).unwrap();
        let mut arguments = vec![command, "a.toml"];
        if command == "report" {
            arguments.extend(["-o", "x.html"]);
        }
        let told = assur(folder.path(), &arguments);
        let text = String::from_utf8(told.stderr).unwrap();
        let place = format!("a.toml, line {number}, column {column}");
        assert!(text.contains(&place), "{name}, {command}: {place}\n{text}");
    }
}

#[test]
fn a_load_without_a_value_has_its_place_in_what_shaking_says() {
    let folder = tempfile::tempdir().unwrap();
    // A brake is in a list of its own.
    let brake = "[[brake]]\nlink = \"crank\"\nradius = 0.1\nfriction = 0.1\nforce = { formula = \"1/0\", unit = \"N\" }";
    let scene = loaded(&format!("[[moment]]\nlink = \"rod\"\nvalue = 1\n{brake}"));
    let number = scene.lines().position(|text| text.contains("1/0")).unwrap() + 1;
    fs::write(folder.path().join("a.toml"), &scene).unwrap();
    let text = String::from_utf8(assur(folder.path(), &["analyze", "a.toml"]).stderr).unwrap();
    assert!(text.contains(&format!("a.toml, line {number}, column 1")), "{text}");
    let scene = loaded("[[moment]]\nlink = \"rod\"\nvalue = { formula = \"1/0\", unit = \"N*m\" }");
    let number = scene.lines().position(|text| text.contains("1/0")).unwrap() + 1;
    fs::write(folder.path().join("a.toml"), &scene).unwrap();
    let told = assur(folder.path(), &["shaking", "a.toml"]);
    let text = String::from_utf8(told.stderr).unwrap();
    assert_eq!(told.status.code(), Some(1), "{text}");
    assert!(text.contains(&format!("a.toml, line {number}, column 1")), "{text}");
    // A mechanism without masses has no shaking force: a fault of the scene, at its links.
    let scene = "[ground]\npoints = { O = [0, 0] }\n[link.crank]\npoints = { O = 0, A = 1 }\n[link.rod]\n\
                 points = { A = 0, B = 3 }\n[link.piston]\npoints = { B = 0 }\n[[slide]]\nlink = \"piston\"\non = \"ground\"\n\
                 [input]\nlink = \"crank\"\n[motion]\nspeed = 1\n";
    fs::write(folder.path().join("a.toml"), scene).unwrap();
    let told = assur(folder.path(), &["shaking", "a.toml"]);
    let text = String::from_utf8(told.stderr).unwrap();
    assert!(told.status.code() == Some(2) && text.contains("a.toml, line 3, column"), "{text}");
}

#[test]
fn a_check_is_ok_or_failed_or_null_with_its_reason() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.toml"), assur_fixtures::scene("slider-crank")).unwrap();
    let told = assur(folder.path(), &["analyze", "a.toml", "--format", "json"]);
    let found: serde_json::Value = serde_json::from_slice(&told.stdout).unwrap();
    let checks = found["checks"].as_array().unwrap();
    assert!(checks.len() > 5);
    for check in checks {
        assert!(check["ok"] == true && check["why"].is_null() && check["left_out"].is_u64(), "{check}");
        assert!(check.get("why").is_some() && check["reason"].is_string(), "{check}");
    }
}

#[test]
fn the_results_do_not_say_that_all_checks_hold_over_a_lost_position() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.toml"), corpus("check_silent_1_0")).unwrap();
    let told = assur(folder.path(), &["analyze", "a.toml"]);
    let text = String::from_utf8(told.stdout).unwrap();
    let row = |words: &str| text.lines().find(|line| line.starts_with(words)).map(str::to_owned);
    assert!(row("positions with a solution").unwrap().contains(" 0 of 24"), "{text}");
    assert_eq!(row("checks passed  "), None, "{text}");
}

#[test]
fn half_a_cycle_keeps_its_positions_its_travel_and_the_limit_of_the_crank() {
    let folder = tempfile::tempdir().unwrap();
    let scene = assur_fixtures::scene("four-bar").replace("A = \"90 mm\"", "A = \"200 mm\"");
    fs::write(folder.path().join("a.toml"), scene).unwrap();
    let told = assur(folder.path(), &["analyze", "a.toml"]);
    let text = String::from_utf8(told.stdout).unwrap();
    let row = |words: &str| text.lines().find(|line| line.starts_with(words)).unwrap().to_owned();
    // Crank, coupler and rocker, and the pivot of the rocker, mm; the triangle of coupler and rocker over the tip of the crank.
    let ([a, b, c], [x, y]): ([f64; 3], [f64; 2]) = ([200.0, 280.0, 210.0], [320.0, -40.0]);
    let mut angles: Vec<f64> = Vec::new();
    for step in 0..36 {
        let at = (10.0 * f64::from(step)).to_radians();
        let [dx, dy] = [a * at.cos() - x, a * at.sin() - y];
        let away = dx.hypot(dy);
        let cosine = (c * c + away * away - b * b) / (2.0 * c * away);
        if cosine.abs() <= 1.0 {
            let angle = (dy.atan2(dx) - cosine.acos()).to_degrees();
            let turns = angles.last().map_or(0.0, |before| ((before - angle) / 360.0).round());
            angles.push(angle + 360.0 * turns);
        }
    }
    assert!(row("positions with a solution").ends_with(&format!(" {} of 36", angles.len())), "{text}");
    let ends = angles.iter().fold([f64::MAX, f64::MIN], |[low, high], at| [low.min(*at), high.max(*at)]);
    let travel = row("travel of rocker in the calculated positions");
    assert!(travel.contains(&format!(" {:.3} deg", ends[1] - ends[0])), "{travel}");
    // Grashof, solved for the crank: b + c - d.
    let most = format!(
        "crank condition (Grashof) with coupler, rocker: does not turn fully: 200 mm, at most {:.2} mm",
        b + c - x.hypot(y)
    );
    assert!(text.split_whitespace().collect::<Vec<_>>().join(" ").contains(&most), "{most}: {text}");
}
