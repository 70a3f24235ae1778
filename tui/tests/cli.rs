//! The program from outside: exit status, errors, files.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A mechanism that can't turn fully: crank 2, ground 3, coupler 1.5, rocker 1.5.
const SHORT: &str = "[ground]\npoints = { O = [0, 0], C = [3, 0] }\n[link.crank]\npoints = { O = 0, A = 2 }\n\
    [link.coupler]\npoints = { A = 0, B = 1.5 }\n[link.rocker]\npoints = { C = 0, B = 1.5 }\n\
    [input]\nlink = \"crank\"\npositions = 6\n[assembly]\nB = [2.5, 1.4]\n";

fn fixture(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures").join(name)
}

/// Runs the program in a folder, in a UTF-8 locale.
fn assur(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_assur"))
        .args(arguments)
        .current_dir(folder)
        .env("LC_ALL", "C.UTF-8")
        .output()
        .unwrap()
}

fn code(output: &Output) -> i32 {
    output.status.code().unwrap()
}

fn out(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

fn err(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// An empty folder with a scene `a.toml`.
fn folder(scene: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.toml"), scene).unwrap();
    folder
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn a_starter_scene_runs_and_is_not_overwritten() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(code(&assur(folder.path(), &["new", "b.toml"])), 0);
    let analyzed = assur(folder.path(), &["b.toml"]);
    assert_eq!(code(&analyzed), 0);
    assert!(out(&analyzed).starts_with("My mechanism\n"));
    assert_eq!(code(&assur(folder.path(), &["check", "b.toml"])), 0);
    let again = assur(folder.path(), &["new", "b.toml"]);
    assert_eq!(code(&again), 2);
    assert_eq!(err(&again), "error: can't write b.toml: it exists already; name a new file\n");
}

#[test]
fn a_file_that_is_no_scene_is_told_by_name() {
    let folder = folder("");
    fs::write(folder.path().join("latin1.toml"), b"title = \"x\"\n# caf\xe9\n").unwrap();
    fs::write(folder.path().join("first.toml"), b"\xff").unwrap();
    // A mark before the first column, and a letter of two bytes.
    fs::write(folder.path().join("marked.toml"), b"\xef\xbb\xbf# \xc3\xa9 \xe9").unwrap();
    for (name, message) in [
        (
            "none.toml",
            "error: none.toml: there is no such file (`assur new FILE` writes a scene to begin with)\n",
        ),
        (".", "error: .: is a folder, not a scene file\n"),
        (
            "latin1.toml",
            "error: latin1.toml: is not UTF-8 text (line 2, column 6: byte 0xE9); save it as UTF-8\n",
        ),
        (
            "first.toml",
            "error: first.toml: is not UTF-8 text (line 1, column 1: byte 0xFF); save it as UTF-8\n",
        ),
        (
            "marked.toml",
            "error: marked.toml: is not UTF-8 text (line 1, column 5: byte 0xE9); save it as UTF-8\n",
        ),
    ] {
        for command in ["analyze", "check", "explain"] {
            let output = assur(folder.path(), &[command, name]);
            assert_eq!(
                (code(&output), err(&output).as_str(), out(&output).as_str()),
                (2, message, ""),
                "{command}"
            );
        }
    }
}

#[test]
fn faults_of_usage_end_with_2_and_help_with_0() {
    let folder = folder(SHORT);
    for arguments in [
        &["analyze"][..],
        &["analyze", "a.toml", "--format", "xml"],
        &["analyze", "a.toml", "--format", "csv"],
        &["analyze", "a.toml", "--analyzer", "magic"],
        &["check", "a.toml", "--integrator", "magic"],
        &["motors", "--catalogue", "magic"],
        &["motors", "--min-power", "1 kN"],
        &[],
    ] {
        let output = assur(folder.path(), arguments);
        assert_eq!(code(&output), 2, "{arguments:?}");
        assert!(out(&output).is_empty() && !err(&output).is_empty(), "{arguments:?}");
    }
    for arguments in [
        &["--help"][..],
        &["--version"],
        &["plugins"],
        &["motors"],
        &["man"],
        &["completions", "bash"],
        &["config"],
    ] {
        let output = assur(folder.path(), arguments);
        assert_eq!(code(&output), 0, "{arguments:?}");
        assert!(!out(&output).is_empty() && err(&output).is_empty(), "{arguments:?}");
    }
}

#[test]
fn words_in_the_wrong_place_are_told_apart() {
    let folder = folder(SHORT);
    for (arguments, message) in [
        (
            &["analyse", "a.toml"][..],
            "neither a command nor a scene file `analyse`; did you mean `assur analyze`?",
        ),
        (&["chek"], "did you mean the command `assur check`?"),
        (&["--analyzer", "groups", "check", "a.toml"], "write it after: `assur check ... --analyzer NAME`"),
        (&["--fps", "5", "check", "a.toml"], "`--fps` is for the terminal UI"),
        (&["a.toml", "check", "a.toml"], "`a.toml` comes before the command `check`"),
    ] {
        let output = assur(folder.path(), arguments);
        assert_eq!(code(&output), 2, "{arguments:?}");
        assert!(err(&output).contains(message), "{arguments:?}: {}", err(&output));
    }
    let before = assur(folder.path(), &["--ascii", "explain", "a.toml"]);
    assert_eq!((code(&before), err(&before).as_str()), (0, ""));
}

#[test]
fn a_fault_of_mobility_is_told_at_its_link() {
    let loose = format!("{SHORT}[link.tail]\npoints = {{ A = 0, T = \"10 mm\" }}\n");
    let folder = folder(&loose);
    let line = loose.lines().position(|line| line.contains("link.tail")).unwrap() + 1;
    for command in ["analyze", "check", "explain", "chart", "stability"] {
        let output = assur(folder.path(), &[command, "a.toml"]);
        assert_eq!(code(&output), 2, "{command}");
        assert!(
            err(&output).contains(&format!("a.toml, line {line}, column 7")),
            "{command}: {}",
            err(&output)
        );
        assert!(err(&output).contains("`tail` can still move"), "{command}: {}", err(&output));
    }
}

#[test]
fn a_crank_without_length_is_refused_at_its_line() {
    let folder = folder(
        "[ground]\npoints = { O = 0 }\n[link.crank]\npoints = { O = 0, A = 0 }\n\
                         [link.arm]\npoints = { A = 0, B = \"9 mm\" }\n\
                         [link.rocker]\npoints = { B = 0, O = \"9 mm\" }\n[input]\nlink = \"crank\"\n",
    );
    let output = assur(folder.path(), &["analyze", "a.toml"]);
    let told = err(&output);
    assert_eq!(code(&output), 2, "{told}");
    assert!(
        told.contains("link `crank` has its pins O, A at one place") && told.contains("line 3"),
        "{told}"
    );
}

/// A central slider-crank with a load on its slider.
const SLIDER: &str = "[ground]\npoints = { O = [0, 0] }\n[link.crank]\npoints = { O = 0, A = 0.1 }\n[link.rod]\n\
    points = { A = 0, B = 0.3 }\n[link.slider]\npoints = { B = 0 }\n[[slide]]\nlink = \"slider\"\non = \"ground\"\n\
    [input]\nlink = \"crank\"\n[[force]]\nlink = \"slider\"\nat = \"B\"\nangle = 0\n";

#[test]
fn an_error_that_is_found_after_reading_names_its_line() {
    let stroke = format!("{SLIDER}value = {{ over = \"stroke\", axis = \"90 deg\", forward = 5 }}\n");
    let folder = folder(&stroke);
    let found = assur(folder.path(), &["analyze", "a.toml"]);
    assert_eq!(code(&found), 2);
    assert!(err(&found).contains("a.toml, line 18, column 1"), "{}", err(&found));
    let motor = "[motion]\nkind = \"steady\"\nmean_speed = 10\n[drive]\nmotor = \"auto\"\nratio = 3\n";
    let driven = stroke.replace("\"90 deg\"", "0") + motor;
    fs::write(folder.path().join("a.toml"), driven).unwrap();
    let found = assur(folder.path(), &["check", "a.toml"]);
    assert_eq!(code(&found), 1);
    assert!(err(&found).contains("a.toml, line 23, column 1"), "{}", err(&found));
}

#[test]
fn what_can_be_calculated_is_shown_though_positions_are_missing() {
    // Assembles for cos q >= 1/3: of 0, 60, ... 300 degrees only at 0, 60, 300.
    let folder = folder(SHORT);
    let output = assur(folder.path(), &["analyze", "a.toml", "--format", "json"]);
    assert_eq!(code(&output), 1);
    assert!(err(&output).starts_with(
        "error: group 1 (RRR coupler, rocker), position 2, coordinate 120.0000 deg: no assembly"
    ));
    let found: serde_json::Value = serde_json::from_str(&out(&output)).unwrap();
    let indices = |key: &str| -> Vec<u64> {
        found[key].as_array().unwrap().iter().map(|row| row["index"].as_u64().unwrap()).collect()
    };
    assert_eq!(indices("positions"), [0, 1, 5]);
    assert_eq!(indices("failures"), [2, 3, 4]);
    assert_eq!(code(&assur(folder.path(), &["check", "a.toml"])), 1);
    assert_eq!(code(&assur(folder.path(), &["explain", "a.toml"])), 0);
}

#[test]
fn a_scene_that_is_faulty_leaves_the_old_results() {
    let folder = folder("[input]\nlink = \"crank\"\n");
    fs::write(folder.path().join("out.json"), "old").unwrap();
    let output = assur(folder.path(), &["analyze", "a.toml", "--format", "json", "-o", "out.json"]);
    assert_eq!(code(&output), 2);
    assert_eq!(fs::read_to_string(folder.path().join("out.json")).unwrap(), "old");
    assert_eq!(names(folder.path()), ["a.toml", "out.json"]);
}

#[test]
fn a_file_is_replaced_as_a_whole_and_nothing_lies_beside_it() {
    let folder = folder(SHORT);
    let shaper = fixture("shaper.toml");
    fs::write(folder.path().join("out.json"), "old").unwrap();
    assur(folder.path(), &["analyze", shaper.to_str().unwrap(), "--format", "json", "-o", "out.json"]);
    let text = fs::read_to_string(folder.path().join("out.json")).unwrap();
    assert!(serde_json::from_str::<serde_json::Value>(&text).is_ok());
    assert_eq!(names(folder.path()), ["a.toml", "out.json"]);
    let nowhere = assur(folder.path(), &["analyze", "a.toml", "-o", "none/out.txt"]);
    assert_eq!(code(&nowhere), 2);
    let told = err(&nowhere);
    assert!(told.ends_with("error: can't write none/out.txt: there is no folder none\n"), "{told}");
    let onto = assur(folder.path(), &["analyze", "a.toml", "--format", "csv", "-o", "a.toml"]);
    assert_eq!((code(&onto), fs::read_to_string(folder.path().join("a.toml")).unwrap().as_str()), (2, SHORT));
}

#[test]
fn csv_that_fails_half_way_leaves_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let shaper = fixture("shaper.toml");
    let arguments = ["analyze", shaper.to_str().unwrap(), "--format", "csv", "-o", "tables"];
    assert_eq!(code(&assur(folder.path(), &arguments)), 0);
    let tables = folder.path().join("tables");
    assert_eq!(names(&tables), ["positions.csv", "reactions.csv"]);
    // A folder where a file should go: the other file keeps what it has.
    fs::remove_file(tables.join("reactions.csv")).unwrap();
    fs::create_dir(tables.join("reactions.csv")).unwrap();
    fs::write(tables.join("positions.csv"), "old").unwrap();
    assert_eq!(code(&assur(folder.path(), &arguments)), 2);
    assert!(fs::read_to_string(tables.join("positions.csv")).unwrap() == "old", "the old file was replaced");
    assert_eq!(names(&tables), ["positions.csv", "reactions.csv"]);
}

#[test]
fn csv_has_one_row_a_position_and_units_in_the_header() {
    let folder = tempfile::tempdir().unwrap();
    let shaper = fixture("shaper.toml");
    assur(folder.path(), &["analyze", shaper.to_str().unwrap(), "--format", "csv", "-o", "t"]);
    let read = |name: &str| fs::read_to_string(folder.path().join("t").join(name)).unwrap();
    let (positions, reactions) = (read("positions.csv"), read("reactions.csv"));
    for (text, column) in
        [(&positions, "A_x_m"), (&reactions, "O_crank_fx_N"), (&reactions, "ram/ground_moment_Nm")]
    {
        let header: Vec<_> = text.lines().next().unwrap().split(',').collect();
        assert!(header.contains(&column), "{column}");
        assert_eq!(text.lines().count(), 49);
        assert!(text.lines().all(|line| line.split(',').count() == header.len()));
    }
}

#[test]
fn ascii_is_ascii_everywhere() {
    let folder = folder(
        &SHORT
            .replace("[ground]", "title = \"Кривошип, größe 5°\"\n[ground]")
            .replace("positions = 6", "positions = 6\nto = 1"),
    );
    for arguments in [
        &["analyze", "a.toml", "--ascii"][..],
        &["analyze", "a.toml", "--ascii", "--format", "json"],
        &["check", "a.toml", "--ascii"],
        &["explain", "a.toml", "--ascii"],
        &["motors", "--ascii"],
        &["plugins", "--ascii"],
    ] {
        let output = assur(folder.path(), arguments);
        assert_eq!(code(&output), 0, "{arguments:?}: {}", err(&output));
        assert!(out(&output).is_ascii(), "{arguments:?}");
    }
    assert!(
        out(&assur(folder.path(), &["analyze", "a.toml", "--ascii"]))
            .starts_with("Krivoship, groesse 5 deg\n")
    );
    assert!(out(&assur(folder.path(), &["analyze", "a.toml"])).starts_with("Кривошип, größe 5°\n"));
}

#[test]
fn a_locale_without_utf8_gets_ascii_text_and_the_same_json() {
    let folder =
        folder(&SHORT.replace("[ground]", "title = \"größe\"\n[ground]").replace("positions = 6", "to = 1"));
    let run = |arguments: &[&str]| {
        Command::new(env!("CARGO_BIN_EXE_assur"))
            .args(arguments)
            .current_dir(folder.path())
            .env_remove("LC_ALL")
            .env("LC_CTYPE", "C")
            .env("LANG", "C.UTF-8")
            .output()
            .unwrap()
    };
    assert!(out(&run(&["analyze", "a.toml"])).starts_with("groesse\n"));
    assert!(out(&run(&["analyze", "a.toml", "--format", "json"])).contains("größe"));
}

#[cfg(unix)]
#[test]
fn a_reader_that_goes_away_is_no_error() {
    use std::process::Stdio;
    let mut child = Command::new(env!("CARGO_BIN_EXE_assur"))
        .args(["analyze", fixture("shaper.toml").to_str().unwrap()])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), err(&output).as_str()), (Some(0), ""));
}

#[test]
fn output_limits_what_is_solved_and_told() {
    let whole = fs::read_to_string(fixture("shaper.toml")).unwrap();
    let folder = folder(&format!("{whole}\n[output]\npoints = [\"S3\"]\n"));
    let found: serde_json::Value =
        serde_json::from_str(&out(&assur(folder.path(), &["analyze", "a.toml", "--format", "json"])))
            .unwrap();
    let first = found["positions"][0].as_object().unwrap();
    let keys = |key: &str| -> Vec<String> { first[key].as_object().unwrap().keys().cloned().collect() };
    assert_eq!(keys("points"), ["S3"]);
    // The second group is not needed.
    assert_eq!(keys("condition"), ["0"]);
    assert!(keys("links").is_empty() && keys("slides").is_empty());
    assert!(["reactions", "balancing", "reduced"].iter().all(|key| !first.contains_key(*key)));
    assert!(out(&assur(folder.path(), &["explain", "a.toml"])).contains("1 of 2 groups are needed"));
}

#[test]
fn a_configuration_that_is_wrong_spoils_no_result() {
    let folder = folder(SHORT);
    let own = folder.path().join("assur");
    fs::create_dir(&own).unwrap();
    fs::write(own.join("config.toml"), "fps = 'many'\n").unwrap();
    let run = |home: &Path| {
        Command::new(env!("CARGO_BIN_EXE_assur"))
            .args(["explain", "a.toml"])
            .current_dir(folder.path())
            .env("XDG_CONFIG_HOME", home)
            .output()
            .unwrap()
    };
    let (with, without) = (run(folder.path()), run(Path::new("/nowhere")));
    assert_eq!((code(&with), out(&with), err(&with)), (0, out(&without), String::new()));
}

#[test]
fn a_measure_by_its_key_has_the_columns_of_that_key_alone() {
    let output = Command::new(env!("CARGO_BIN_EXE_assur"))
        .args([
            "sweep",
            "shaper.toml",
            "--vary",
            "force.cutting.scale=0.5..2:2",
            "--measure",
            "positions.balancing",
        ])
        .current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../fixtures"))
        .output()
        .unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    let columns: Vec<&str> = text.lines().next().unwrap().split(',').skip(5).collect();
    let wanted = ["min", "max", "mean", "rms"].map(|word| format!("balancing_{word}_Nm"));
    assert_eq!(columns, wanted);
}

#[test]
fn keys_find_words_of_the_field_too() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let found = out(&assur(folder, &["keys", "friction circle"]));
    for part in ["Words", "circle about a pin", "formula: h = f*r, M = h*R", "source: Artobolevsky"] {
        assert!(found.contains(part), "{part}: {found}");
    }
    // Beside the keys only what is called so; a letter of a formula finds its word where no key has it.
    let beside = out(&assur(folder, &["keys", "unevenness"]));
    assert!(beside.contains("unevenness = 0.05") && beside.contains("(max(ω) - min(ω))/ω_m"), "{beside}");
    assert!(!beside.contains("flywheel\n"), "{beside}");
    assert!(out(&assur(folder, &["keys", "s/s_k"])).contains("Kloss formula"));
    let russian = out(&assur(folder, &["keys", "--language", "ru", "круг трения"]));
    assert!(russian.contains("формула: h = f*r") && russian.contains("в записке:"), "{russian}");
    let page = out(&assur(folder, &["keys", "dead point", "--format", "markdown"]));
    assert!(page.contains("* **dead point**: position in which"), "{page}");
    let none = assur(folder, &["keys", "no such thing"]);
    assert!(code(&none) != 0 && err(&none).contains("no word of the field"), "{}", err(&none));
    assert!(!out(&assur(folder, &["keys"])).contains("Words\n"));
}
