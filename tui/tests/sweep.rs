//! `assur sweep` from outside: exit status, errors, files.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use std::time::Duration;

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

/// `assur sweep a.toml`.
fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_assur"));
    command.args(["sweep", "a.toml"]).args(arguments).current_dir(folder).env("LC_ALL", "C.UTF-8");
    command
}

fn sweep(folder: &Path, arguments: &[&str]) -> Output {
    command(folder, arguments).output().unwrap()
}

/// Exit status and standard error without the summary.
fn end(output: &Output) -> (i32, &str) {
    let told = str::from_utf8(&output.stderr).unwrap();
    let last = told.trim_end().rfind('\n').map_or(0, |end| end + 1);
    let kept = if told[last..].contains(" points in ") { last } else { told.len() };
    (output.status.code().unwrap(), &told[..kept])
}

/// The summary without its time.
fn summary(output: &Output) -> (String, String) {
    let last = str::from_utf8(&output.stderr).unwrap().lines().last().unwrap();
    let (points, rest) = last.split_once(" points in ").unwrap_or_else(|| panic!("{last}"));
    (points.to_owned(), rest.split_once(" s: ").unwrap().1.to_owned())
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
    assert!(text.starts_with("row,link.crank.points.A_m,status,message,failed_positions,smallest_health,"));
    let first: Vec<_> = text.lines().map(|line| line.split(',').nth(1).unwrap()).collect();
    assert_eq!(first, ["link.crank.points.A_m", "0.1", "0.15", "0.2"]);
    let written = sweep(folder.path(), &["--vary", LENGTHS, "-o", "b.csv", "--threads", "1"]);
    assert_eq!((end(&written), written.stdout.len()), ((0, ""), 0));
    assert_eq!(fs::read(folder.path().join("b.csv")).unwrap(), printed.stdout, "one thread or more");
    let written = sweep(folder.path(), &["--vary", LENGTHS, "-o", "b.parquet"]);
    assert_eq!(end(&written), (0, ""));
    let bytes = fs::read(folder.path().join("b.parquet")).unwrap();
    assert!(bytes.starts_with(b"PAR1") && bytes.ends_with(b"PAR1"));
    let beside = ["a.toml", "b.csv", "b.csv.origin.json", "b.parquet"];
    assert_eq!(names(folder.path()), beside, "nothing else is left beside");
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
    assert!(text.lines().nth(1).unwrap().starts_with("0,0.2,ok,"), "{text}");
    assert!(text.lines().nth(2).unwrap().starts_with("1,0.4,no assembly,"), "{text}");
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
            "error: a.toml: no point of the sweep can be calculated; the first, link.piston.mass = -1 kg:\n\
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

/// Some points can't be assembled: the rod of 300 mm is too short for the longest cranks.
const MANY: &str = "link.crank.points.A=100 mm..301 mm:20000";

#[test]
fn a_sweep_that_is_killed_again_and_again_ends_as_if_it_had_not_been() {
    let folder = folder();
    let path = folder.path();
    let (all, good) = (&["--vary", MANY][..], ["--vary", MANY, "--where", "transmission > 45 deg"]);
    for (points, whole, killed) in [
        (all, "whole.csv", "killed.csv"),
        (all, "whole.parquet", "killed.parquet"),
        (&good, "good.csv", "good-killed.csv"),
        (&good, "good.parquet", "good-killed.parquet"),
    ] {
        let first = sweep(path, &[points, &["-o", whole]].concat());
        let (mut kills, mut seed) = (0, 1_u64);
        let last = loop {
            let part = path.join(format!("{killed}.part"));
            let mut child = command(path, &[points, &["-o", killed, "--resume"]].concat())
                .stderr(std::process::Stdio::piped())
                .spawn()
                .unwrap();
            // On a busy machine the first rows take their time.
            while !part.exists() && child.try_wait().unwrap().is_none() {
                std::thread::sleep(Duration::from_millis(1));
            }
            // Later kills come later, so that there is always some progress.
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            std::thread::sleep(Duration::from_millis(20 + seed % 97 + 20 * kills));
            child.kill().unwrap();
            let output = child.wait_with_output().unwrap();
            // It may have ended before it was killed.
            if output.status.code().is_some() {
                break output;
            }
            kills += 1;
            // The kill may come when the file is complete and the program has not ended yet.
            match fs::read(path.join(killed)) {
                Ok(bytes) => {
                    assert!(bytes == fs::read(path.join(whole)).unwrap(), "{killed} is not complete");
                }
                Err(_) => assert!(part.exists(), "rows so far are beside the file"),
            }
        };
        assert!(kills >= 2, "{kills} kills: too few points for this machine");
        assert_eq!(end(&last), end(&first));
        assert_eq!(fs::read(path.join(killed)).unwrap(), fs::read(path.join(whole)).unwrap(), "{killed}");
    }
    let of = |name: &str| ["csv", "csv.origin.json", "parquet"].map(|end| format!("{name}.{end}"));
    let tables = ["good-killed", "good", "killed", "whole"].into_iter().flat_map(of);
    assert_eq!(names(path), std::iter::once("a.toml".to_owned()).chain(tables).collect::<Vec<_>>());
}

#[test]
fn every_beginning_of_a_file_is_gone_on_with() {
    let folder = folder();
    let path = folder.path();
    let vary = ["--vary", "link.crank.points.A=100 mm..301 mm:9"];
    let run = |more: &[&str]| sweep(path, &[&vary[..], more].concat());
    run(&["-o", "whole.csv"]);
    let whole = fs::read(path.join("whole.csv")).unwrap();
    let rows = str::from_utf8(&whole).unwrap().lines().count() - 1;
    assert_eq!(rows, 9);
    // Ends within the header, at line ends, and within rows.
    for length in (0..=whole.len()).step_by(whole.len() / 23) {
        fs::write(path.join("b.csv.part"), &whole[..length]).unwrap();
        let output = run(&["-o", "b.csv", "--resume"]);
        assert!(end(&output).1.contains("no solution at 1 of 9 points"), "{}", end(&output).1);
        assert_eq!(fs::read(path.join("b.csv")).unwrap(), whole, "{length}");
        fs::remove_file(path.join("b.csv")).unwrap();
    }
}

#[test]
fn rows_of_another_sweep_are_not_gone_on_with() {
    let folder = folder();
    let path = folder.path();
    let vary = ["--vary", LENGTHS, "-o", "b.csv"];
    fs::write(path.join("b.csv.part"), "a,b\n").unwrap();
    let refused = sweep(path, &vary);
    let message = "an interrupted sweep is here: continue it with --resume, or remove it";
    assert_eq!(end(&refused), (2, &*format!("error: can't write b.csv.part: {message}\n")));
    for foreign in ["a,b\n", "1,2\n3,4\n"] {
        fs::write(path.join("b.csv.part"), foreign).unwrap();
        let refused = sweep(path, &[&vary[..], &["--resume"]].concat());
        assert!(end(&refused).1.contains("does not belong to this sweep"), "{}", end(&refused).1);
        assert_eq!(fs::read_to_string(path.join("b.csv.part")).unwrap(), foreign);
    }
    // The same columns with other numbers.
    fs::remove_file(path.join("b.csv.part")).unwrap();
    assert_eq!(end(&sweep(path, &vary)), (0, ""));
    fs::rename(path.join("b.csv"), path.join("b.csv.part")).unwrap();
    let others = ["--vary", "link.crank.points.A=100 mm..210 mm:3", "-o", "b.csv", "--resume"];
    assert!(end(&sweep(path, &others)).1.contains("row 3 does not belong to this sweep"));
}

#[test]
fn rows_with_another_number_of_columns_are_not_gone_on_with() {
    let folder = folder();
    let path = folder.path();
    assert_eq!(end(&sweep(path, &["--vary", LENGTHS, "-o", "b.csv"])), (0, ""));
    let whole = fs::read_to_string(path.join("b.csv")).unwrap();
    let lines: Vec<&str> = whole.lines().collect();
    for second in [format!("{},7", lines[2]), lines[2].rsplit_once(',').unwrap().0.to_owned()] {
        let changed = [lines[0], lines[1], &second, lines[3], ""].join("\n");
        fs::write(path.join("b.csv.part"), &changed).unwrap();
        let refused = sweep(path, &["--vary", LENGTHS, "-o", "b.csv", "--resume"]);
        assert!(end(&refused).1.contains("row 2 does not belong to this sweep"), "{}", end(&refused).1);
        assert_eq!(fs::read_to_string(path.join("b.csv.part")).unwrap(), changed);
    }
}

#[test]
fn rows_say_what_they_are_made_of_and_another_sweep_is_told_by_it() {
    let folder = folder();
    let path = folder.path();
    let vary = "link.crank.points.A=100 mm..301 mm:20000";
    let tie = "link.rod.points.B=link.crank.points.A*3";
    for name in ["b.csv", "b.parquet"] {
        let part = path.join(format!("{name}.part"));
        let all = [
            "--vary",
            vary,
            "--tie",
            tie,
            "--measure",
            "health,distance",
            "--target",
            "B=100 mm,0",
            "-o",
            name,
        ];
        let mut child = command(path, &all).stderr(std::process::Stdio::null()).spawn().unwrap();
        let has_rows = || match fs::read_dir(&part) {
            Ok(mut parts) => parts.any(|part| part.is_ok_and(|part| part.file_name() == "000000.parquet")),
            Err(_) => fs::metadata(&part).is_ok_and(|found| found.len() > 1000),
        };
        while !has_rows() {
            assert!(child.try_wait().unwrap().is_none(), "too few points for this machine");
            std::thread::sleep(Duration::from_millis(1));
        }
        child.kill().unwrap();
        child.wait().unwrap();
        let mut others = all;
        for (at, value, problem) in [
            (5, "health,extremes", "`measure` was `health, distance` and is `health, extremes`"),
            (
                3,
                "link.rod.points.B=link.crank.points.A*4",
                "`tie` was `link.rod.points.B=link.crank.points.A*3` and is",
            ),
            (7, "B=200 mm,0", "`target` was `B=0.1 m,0 m` and is `B=0.2 m,0 m`"),
        ] {
            others[at] = value;
            let refused = sweep(path, &[&others[..], &["--resume"]].concat());
            let (code, message) = end(&refused);
            // Other measures have other columns too, and of Parquet these are compared first.
            let schema =
                name == "b.parquet" && at == 5 && message.contains("row 1 does not belong to this sweep");
            assert!(code == 2 && (message.contains(problem) || schema), "{name}: {message}");
            others = all;
        }
        fs::write(path.join("a.toml"), SLIDER.replace("2 kg", "3 kg")).unwrap();
        let refused = sweep(path, &[&all[..], &["--resume"]].concat());
        assert!(end(&refused).1.contains("the scene was a different one"), "{}", end(&refused).1);
        fs::write(path.join("a.toml"), SLIDER).unwrap();
    }
    let weighs = format!("gravity = \"9.81 m/s^2\"\n{SLIDER}");
    fs::write(path.join("a.toml"), weighs).unwrap();
    assert_eq!(end(&sweep(path, &["--vary", LENGTHS, "-o", "c.csv"])), (0, ""));
    let said = fs::read_to_string(path.join("c.csv.origin.json")).unwrap();
    for part in [
        "\"vary\": \"link.crank.points.A=100 mm..200 mm:3\"",
        "\"points\": \"0..3\"",
        "\"analyzer\": \"",
        "\"scene\": \"gravity =",
        "\"version\"",
    ] {
        assert!(said.contains(part), "{said}");
    }
}

#[test]
fn shards_one_after_the_other_are_the_whole() {
    let folder = folder();
    let path = folder.path();
    for points in
        [&["--vary", LENGTHS][..], &["--vary", "link.crank.points.A=100 mm..200 mm", "--sample", "200"]]
    {
        let whole = sweep(path, points).stdout;
        for count in [1, 2, 5] {
            let mut merged = Vec::new();
            for part in 1..=count {
                let shard = format!("{part}/{count}");
                let name = format!("{part}.csv");
                let output = sweep(path, &[points, &["--shard", &shard, "-o", &name]].concat());
                assert_eq!(end(&output), (0, ""), "{shard}");
                merged.extend(fs::read(path.join(name)).unwrap());
            }
            assert_eq!(str::from_utf8(&merged).unwrap(), str::from_utf8(&whole).unwrap(), "{count}");
        }
    }
    for shard in ["0/2", "3/2", "1", "a/b"] {
        let output = sweep(path, &["--vary", LENGTHS, "--shard", shard]);
        assert_eq!(end(&output).0, 2, "{shard}");
        assert!(end(&output).1.contains("write it as I/N"), "{}", end(&output).1);
    }
}

#[test]
fn the_help_names_every_measure() {
    let help = sweep(folder().path(), &["--help"]).stdout;
    let help = str::from_utf8(&help).unwrap();
    for measure in assur_sweep::MEASURES {
        let star = if measure.by_default { " *" } else { "" };
        let name = format!("  {}{star} ", measure.name);
        assert!(help.lines().any(|line| line.starts_with(&name)), "{name}");
    }
}

/// The parameters of a call, without the quotes around them.
fn parameters(call: &str) -> Vec<String> {
    let after = call.split("--vary ").skip(1);
    let quoted = after.filter_map(|text| text.strip_prefix('"')?.split('"').next());
    quoted.map(|text| text.trim_matches('\'').to_owned()).collect()
}

#[test]
fn every_example_of_the_documentation_runs_on_the_shipped_scene() {
    let folder = folder();
    fs::write(folder.path().join("shaper.toml"), assur_fixtures::scene("shaper")).unwrap();
    let text = include_str!("../../docs/sweep.md").replace("\\\n", " ");
    let calls: Vec<&str> = text.lines().filter(|line| line.contains("assur sweep shaper.toml")).collect();
    assert!(calls.len() > 3, "{calls:?}");
    for call in calls {
        // Few points of each.
        let sampled = call.contains("--sample");
        let few = |vary: String| match vary.rsplit_once(':') {
            Some((vary, _)) if !sampled => format!("{vary}:2"),
            _ => vary,
        };
        let vary: Vec<String> = parameters(call).into_iter().map(few).collect();
        assert!(!vary.is_empty(), "{call}");
        let mut command = Command::new(env!("CARGO_BIN_EXE_assur"));
        command.args(["sweep", "shaper.toml", "-o", "b.csv"]).current_dir(folder.path());
        command.args(vary.iter().flat_map(|vary| ["--vary", vary.as_str()]));
        command.args(if sampled { &["--sample", "3"][..] } else { &[] });
        assert_eq!(end(&command.output().unwrap()), (0, ""), "{call}");
    }
}

#[test]
fn a_scale_of_a_load_and_a_column_of_its_table_are_parameters() {
    let folder = folder();
    let greatest = |scene: &str, vary: &str| -> Vec<f64> {
        fs::write(folder.path().join("a.toml"), scene).unwrap();
        let output = sweep(folder.path(), &["--vary", vary]);
        assert_eq!(end(&output), (0, ""), "{vary}");
        let text = String::from_utf8(output.stdout).unwrap();
        let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
        let column = rows[0].iter().position(|name| name.starts_with("reaction_O_greatest")).unwrap();
        rows[1..].iter().map(|row| row[column].parse().unwrap()).collect()
    };
    // Without masses every reaction is proportional to the only load.
    let table = format!(
        "{}[[force]]\nname = \"load\"\nlink = \"piston\"\nat = \"B\"\nangle = 0\nscale = 1\n\
         value = {{ over = \"angle\", table = [[0, 100], [3, 300], [6, 300], [\"360 deg\", 300]] }}\n",
        SLIDER.replace("mass = \"2 kg\"\n", "")
    );
    let found = greatest(&table, "force.load.scale=0.5..2:4");
    let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-12;
    assert!(near(found[1], 2.0 * found[0]) && near(found[3], 4.0 * found[0]), "{found:?}");
    // A constant load: the same in every place of the table.
    let found = greatest(&table, "force.load.value.table[*][1]=200..400:2");
    let constant = table
        .replace("{ over = \"angle\", table = [[0, 100], [3, 300], [6, 300], [\"360 deg\", 300]] }", "100");
    let wanted = greatest(&constant, "force.load.value=200..400:2");
    assert!(near(found[0], wanted[0]) && near(found[1], wanted[1]), "{found:?} {wanted:?}");
    // A factor on the constant load is the load, whether it is set as a number or read.
    let scaled = greatest(&constant, "force.load.scale=2..4:2");
    assert!(near(scaled[0], wanted[0]) && near(scaled[1], wanted[1]), "{scaled:?} {wanted:?}");
}

#[test]
fn a_load_without_a_value_is_the_message_of_its_point() {
    let folder = folder();
    let scene = format!(
        "{SLIDER}[[force]]\nname = \"z\"\nlink = \"piston\"\nat = \"B\"\nangle = 0\nvalue = {{ formula = \"1/q\" }}\n"
    );
    fs::write(folder.path().join("a.toml"), scene).unwrap();
    let output = sweep(folder.path(), &["--vary", LENGTHS]);
    let (code, told) = end(&output);
    assert!(code == 1 && told.contains("position 0: load `z` has no finite value"), "{told}");
    let rows = str::from_utf8(&output.stdout).unwrap();
    assert!(rows.contains("load `z`") && !rows.contains("NaN") && !rows.contains("determinant"), "{rows}");
}

#[test]
fn a_row_becomes_a_scene_with_its_comments() {
    let folder = folder();
    let commented = SLIDER.replace("\"100 mm\" }\n", "\"100 mm\" } # the crank\n");
    fs::write(folder.path().join("a.toml"), &commented).unwrap();
    for result in ["b.csv", "b.parquet"] {
        let tie = ["--tie", "link.rod.points.B=link.crank.points.A*3"];
        let all = [&["--vary", LENGTHS, "-o", result][..], &tie].concat();
        assert_eq!(end(&sweep(folder.path(), &all)), (0, ""));
        let mut set = Command::new(env!("CARGO_BIN_EXE_assur"));
        set.args(["set", "a.toml", "--row", "1", result, "link.piston.mass=3 kg", "-o", "-"]);
        let set = set.current_dir(folder.path()).env("LC_ALL", "C.UTF-8").output().unwrap();
        let wanted =
            commented.replace("100 mm", "150 mm").replace("B = 0.3", "B = 0.45").replace("2 kg", "3 kg");
        assert_eq!((end(&set), str::from_utf8(&set.stdout).unwrap()), ((0, ""), wanted.as_str()), "{result}");
    }
    for (arguments, problem) in [
        (&["link.crank.mas=2"][..], "link.crank.mas=2: `link.crank` has no `mas`"),
        (&["link.piston.mass=2 mm"], "`mass` wants a mass"),
        (&["--row", "9", "b.csv"], "it has no row 9"),
        (&["link.piston.mass"], "write it as KEY=VALUE"),
    ] {
        let mut set = Command::new(env!("CARGO_BIN_EXE_assur"));
        set.args(["set", "a.toml", "-o", "c.toml"]).args(arguments);
        let set = set.current_dir(folder.path()).env("LC_ALL", "C.UTF-8").output().unwrap();
        assert!(end(&set).0 == 2 && end(&set).1.contains(problem), "{:?}", end(&set));
        assert!(!folder.path().join("c.toml").exists());
    }
}

#[test]
fn rows_that_find_no_room_are_not_begun() {
    let folder = folder();
    // 10^12 points of more than two columns take more than 40 TB.
    for file in ["b.csv", "b.parquet"] {
        let output =
            sweep(folder.path(), &["--vary", "link.crank.points.A=100 mm..200 mm:1000000000000", "-o", file]);
        let (code, message) = end(&output);
        assert!(
            code == 2 && message.contains(&format!("can't write {file}: the rows may take")),
            "{message}"
        );
    }
    assert_eq!(names(folder.path()), ["a.toml"]);
}

/// 0.1 and 0.2 are nearer to 100 mm in m, 100 and 200 in mm; a place in all digits of m is one, 232 m is none.
#[test]
fn bare_numbers_of_another_unit_are_doubted() {
    let folder = folder();
    for (arguments, told) in [
        (&["--vary", "link.crank.points.A=0.1..0.2:3"][..], None),
        (&["--vary", "link.crank.points.A=100..200:3"], Some("write \"link.crank.points.A=100 mm..200 mm\"")),
        (&["--vary", LENGTHS, "--target", "B=0,0.232"], None),
        (&["--vary", LENGTHS, "--target", "B=0,232 mm"], None),
        (&["--vary", LENGTHS, "--target", "B=0,232"], Some("this is 232 m from the origin")),
    ] {
        let output = sweep(folder.path(), arguments);
        let (_, message) = end(&output);
        let notes = message.lines().filter(|line| line.starts_with("note: ")).collect::<Vec<_>>();
        match told {
            Some(told) => {
                assert!(matches!(notes[..], [note] if note.contains(told)), "{arguments:?}: {message}");
            }
            None => assert!(notes.is_empty(), "{arguments:?}: {message}"),
        }
    }
}

#[test]
fn the_best_point_is_that_of_the_rows_and_its_scene_is_written() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("a.toml"), assur_fixtures::scene("four-bar")).unwrap();
    let run = |arguments: &str| {
        let output = Command::new(env!("CARGO_BIN_EXE_assur"))
            .args(arguments.split(' '))
            .current_dir(&folder)
            .env("LC_ALL", "C.UTF-8")
            .output()
            .unwrap();
        let [out, err] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
        (out, err)
    };
    let key = "link.crank.points.A";
    let column = "least_transmission_angle_rad";
    let sweep =
        format!("sweep a.toml --vary {key}=70mm,90mm,80mm,85mm --measure transmission").replace("mm", "e-3");
    let (rows, _) = run(&sweep);
    let rows: Vec<Vec<&str>> = rows.lines().map(|line| line.split(',').collect()).collect();
    let place = |wanted: &str| rows[0].iter().position(|own| *own == wanted);
    let at = place(column).unwrap_or_else(|| panic!("{:?}", rows[0]));
    for (word, sign) in [("least", 1.0), ("greatest", -1.0)] {
        let value = |row: &&Vec<&str>| sign * row[at].parse::<f64>().unwrap();
        let best = rows[1..].iter().min_by(|one, other| value(one).total_cmp(&value(other))).unwrap();
        let (written, told) = run(&format!("{sweep} --best {word}:{column} --best-scene {word}.toml"));
        assert_eq!(written.lines().count(), 5, "all rows are written all the same");
        assert!(told.contains(best[1].trim_end_matches('0')), "{told}");
        let scene = std::fs::read_to_string(folder.path().join(format!("{word}.toml"))).unwrap();
        assert!(scene.contains(&format!("A = {}", best[1])), "{scene}");
    }
    let (_, told) = run(&format!("{sweep} --best least:least_transmision_angle_rad"));
    assert!(told.contains(column), "{told}");
}

/// Rows that are ok, with the lesser mass and a greater transmission angle.
fn with_angle(text: &str, least: f64) -> String {
    let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    let at = rows[0].iter().position(|name| *name == "least_transmission_angle_rad").unwrap();
    let is_good = |row: &Vec<&str>| row[2] == "1" && row[at].parse::<f64>().is_ok_and(|angle| angle > least);
    let kept = rows.iter().zip(text.split_inclusive('\n'));
    kept.filter(|(row, _)| row[0] == "row" || is_good(row)).map(|(_, line)| line).collect()
}

/// Good rows are behind others, and between others.
const CRANKS: [&str; 4] =
    ["--vary", "link.crank.points.A=330 mm..100 mm:47", "--vary", "link.piston.mass=1 kg..2 kg:2"];

fn good<'a>(more: &[&'a str]) -> Vec<&'a str> {
    let conditions = ["--where", "transmission > 50 deg", "--where", "link.piston.mass_kg < 2"];
    [&CRANKS[..], &["--measure", "extremes"], &conditions, more].concat()
}

#[test]
fn rows_that_hold_conditions_are_those_of_the_whole_in_parts_too() {
    let folder = folder();
    let path = folder.path();
    let whole = sweep(path, &[&CRANKS[..], &["--measure", "transmission,extremes"]].concat());
    assert_eq!(summary(&whole), ("94".to_owned(), "82 ok, 12 no assembly".to_owned()));
    let wanted = with_angle(str::from_utf8(&whole.stdout).unwrap(), 50_f64.to_radians());
    let rows = wanted.lines().count() - 1;
    assert!((5..36).contains(&rows), "{wanted}");
    let left = 94 - rows;
    for threads in ["1", "3"] {
        let found = sweep(path, &good(&["--threads", threads]));
        assert_eq!((end(&found), str::from_utf8(&found.stdout).unwrap()), ((0, ""), &*wanted));
        let outcomes = format!("82 ok, 12 no assembly; rows written: {rows}, left out by --where: {left}");
        assert_eq!(summary(&found), ("94".to_owned(), outcomes));
    }
    let part = |part: u32| sweep(path, &good(&["--shard", &format!("{part}/4")])).stdout;
    assert_eq!(String::from_utf8((1..=4).flat_map(part).collect()).unwrap(), wanted);
    let none = sweep(path, &[&good(&[])[..], &["--where", "row > 93"]].concat());
    assert_eq!(end(&none), (0, ""));
    assert_eq!(str::from_utf8(&none.stdout).unwrap(), wanted.split_inclusive('\n').next().unwrap());
}

#[test]
fn rows_that_hold_conditions_are_gone_on_with_from_every_beginning() {
    let folder = folder();
    let path = folder.path();
    assert_eq!(end(&sweep(path, &good(&["-o", "whole.csv"]))), (0, ""));
    let wanted = fs::read_to_string(path.join("whole.csv")).unwrap();
    let header = wanted.find('\n').unwrap() + 1;
    for length in (0..=wanted.len()).step_by(wanted.len() / 19).chain([header, header + 1, header + 3]) {
        fs::write(path.join("b.csv.part"), &wanted[..length]).unwrap();
        let resumed = sweep(path, &good(&["-o", "b.csv", "--resume"]));
        assert_eq!(end(&resumed), (0, ""), "{length}");
        assert_eq!(fs::read_to_string(path.join("b.csv")).unwrap(), wanted, "{length}");
        let (points, outcomes) = summary(&resumed);
        let has_rows = wanted[..length].matches('\n').count() > 1;
        assert_eq!(
            (points.as_str(), outcomes.contains(" left out by an earlier run; ")),
            ("94", has_rows),
            "{outcomes}"
        );
    }
    let said = fs::read_to_string(path.join("b.csv.origin.json")).unwrap();
    let conditions = "\"where\": \"transmission > 50 deg\\nlink.piston.mass_kg < 2\"";
    assert!(said.contains(conditions), "{said}");
    // A later part has no header; rows out of order or of another part are none of its own.
    let last = sweep(path, &good(&["--shard", "4/4"])).stdout;
    for length in 0..40 {
        fs::write(path.join("c.csv.part"), &last[..length]).unwrap();
        assert_eq!(
            end(&sweep(path, &good(&["--shard", "4/4", "-o", "c.csv", "--resume"]))),
            (0, ""),
            "{length}"
        );
        assert_eq!(fs::read(path.join("c.csv")).unwrap(), last, "{length}");
    }
    let lines: Vec<&[u8]> = last.split_inclusive(|byte| *byte == b'\n').collect();
    for foreign in
        [[lines[1], lines[0]].concat(), wanted[header..].lines().next().unwrap().as_bytes().to_vec()]
    {
        fs::write(path.join("c.csv.part"), foreign).unwrap();
        let told = sweep(path, &good(&["--shard", "4/4", "-o", "c.csv", "--resume"]));
        assert!(
            end(&told).0 == 2 && end(&told).1.contains("does not belong to this sweep"),
            "{}",
            end(&told).1
        );
    }
}

#[test]
fn a_row_is_found_by_its_number() {
    let folder = folder();
    let path = folder.path();
    for result in ["b.csv", "b.parquet"] {
        assert_eq!(end(&sweep(path, &good(&["-o", result]))), (0, ""));
        let set = |row: &str| {
            let mut set = Command::new(env!("CARGO_BIN_EXE_assur"));
            set.args(["set", "a.toml", "--row", row, result]).current_dir(path).output().unwrap()
        };
        // The last crank but one, with the lesser mass.
        let scene = String::from_utf8(set("90").stdout).unwrap();
        assert!(scene.contains("A = \"105 mm\"") && scene.contains("mass = \"1 kg\""), "{result}: {scene}");
        assert_eq!(set("91").status.code(), Some(2), "{result}: left out");
    }
    // As an earlier version wrote it: without numbers, by lines.
    fs::write(path.join("old.csv"), "link.crank.points.A_m,status\n0.12,ok\n0.13,ok\n").unwrap();
    let mut set = Command::new(env!("CARGO_BIN_EXE_assur"));
    let old = set.args(["set", "a.toml", "--row", "1", "old.csv"]).current_dir(path).output().unwrap();
    assert!(str::from_utf8(&old.stdout).unwrap().contains("A = \"130 mm\""));
}

#[test]
fn rows_of_a_sweep_are_points_of_another() {
    let folder = folder();
    let path = folder.path();
    let vary = ["--vary", "link.crank.points.A=100 mm..330 mm:9", "--vary", "link.piston.mass=1..2:2"];
    for whole in ["whole.csv", "whole.parquet"] {
        sweep(path, &[&vary[..], &["-o", whole]].concat());
    }
    let wanted = fs::read_to_string(path.join("whole.csv")).unwrap();
    for table in ["whole.csv", "whole.parquet"] {
        let again = sweep(path, &["--points", table]);
        assert_eq!(str::from_utf8(&again.stdout).unwrap(), wanted, "{table}");
    }
    fs::write(
        path.join("p.csv"),
        "\u{feff}link.piston.mass,\"link.crank.points.A\"\n2 kg,330 mm\n1000 g,0.1\n",
    )
    .unwrap();
    let own = sweep(path, &["--points", "p.csv", "-o", "own.csv"]);
    assert_eq!(summary(&own), ("2".to_owned(), "1 ok, 1 no assembly".to_owned()));
    let own = fs::read_to_string(path.join("own.csv")).unwrap();
    let values = |line: &str| line.splitn(4, ',').nth(3).unwrap().to_owned();
    let lines: Vec<String> = own.lines().map(values).collect();
    let known: Vec<String> = wanted.lines().map(values).collect();
    assert_eq!(lines[1..], [known[18].clone(), known[1].clone()]);
    // Other points are not gone on with.
    fs::rename(path.join("own.csv"), path.join("own.csv.part")).unwrap();
    fs::rename(path.join("own.csv.origin.json"), path.join("own.csv.part.origin.json")).unwrap();
    fs::write(path.join("p.csv"), "link.piston.mass,link.crank.points.A\n2 kg,330 mm\n1000 g,0.11\n")
        .unwrap();
    let other = sweep(path, &["--points", "p.csv", "-o", "own.csv", "--resume"]);
    assert!(
        end(&other).0 == 2 && end(&other).1.contains("`table` was `2 points, hash "),
        "{}",
        end(&other).1
    );
    fs::write(path.join("p.csv"), "link.piston.mass,link.crank.points.A\n2 kg,330 mm\n1000 mm,0.1\n")
        .unwrap();
    let told = sweep(path, &["--points", "p.csv"]);
    let problem = "error: `link.piston.mass`: p.csv, line 3: wants a mass";
    assert!(end(&told).0 == 2 && end(&told).1.starts_with(problem), "{}", end(&told).1);
    for (table, problem) in [("p.csv;a\n", "separated by semicolons"), ("", "has no points")] {
        fs::write(path.join("p.csv"), table).unwrap();
        let told = sweep(path, &["--points", "p.csv"]);
        assert!(end(&told).0 == 2 && end(&told).1.contains(problem), "{}", end(&told).1);
    }
    assert_eq!(end(&sweep(path, &["--points", "none.csv"])).0, 2);
    assert_eq!(end(&sweep(path, &["--points", "whole.csv", "--vary", LENGTHS])).0, 2);
}

#[test]
fn the_best_of_a_resumed_sweep_is_that_of_the_whole() {
    let folder = folder();
    let path = folder.path();
    let vary = ["--vary", "link.crank.points.A=100 mm..200 mm:400"];
    let best = [&vary[..], &["--best", "greatest:smallest_health"]].concat();
    let first = sweep(path, &[&best[..], &["-o", "whole.csv"]].concat());
    assert!(end(&first).1.starts_with("best: smallest_health = "), "{}", end(&first).1);
    let whole = fs::read_to_string(path.join("whole.csv")).unwrap();
    for rows in [1, 2, 200, 401] {
        let begun: String = whole.split_inclusive('\n').take(rows).collect();
        fs::write(path.join("b.csv.part"), begun).unwrap();
        let resumed = sweep(path, &[&best[..], &["-o", "b.csv", "--resume"]].concat());
        assert_eq!(end(&resumed), end(&first), "{rows}");
    }
    // Parts of Parquet, of which some are there.
    let part = path.join("b.parquet.part");
    let mut child = command(path, &["--vary", "link.crank.points.A=100 mm..200 mm:4000", "-o", "b.parquet"])
        .stderr(std::process::Stdio::null())
        .spawn()
        .unwrap();
    while child.try_wait().unwrap().is_none() && !part.join("000001.parquet").exists() {
        std::thread::sleep(Duration::from_millis(1));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(part.join("000001.parquet").exists(), "too few points for this machine");
    let best = ["--vary", "link.crank.points.A=100 mm..200 mm:4000", "--best", "least:link.crank.points.A_m"];
    let resumed = sweep(path, &[&best[..], &["-o", "b.parquet", "--resume"]].concat());
    let told = "best: link.crank.points.A_m = 0.1 at point 0: link.crank.points.A = 100 mm\n";
    assert_eq!(end(&resumed), (0, told));
}

#[test]
fn examples_of_the_four_bar_are_played() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("four-bar.toml"), assur_fixtures::scene("four-bar")).unwrap();
    let text = include_str!("../../docs/sweep.md").replace("\\\n", " ");
    let calls: Vec<&str> =
        text.lines().filter(|line| line.starts_with("assur sweep four-bar.toml")).collect();
    assert!(calls.len() > 3, "{calls:?}");
    for call in calls {
        // Words, some in quotes.
        let parts = call.split('"').enumerate();
        let words = parts.flat_map(|(part, text)| match part % 2 {
            0 => text.split_whitespace().collect(),
            _ => vec![text],
        });
        let mut command = Command::new(env!("CARGO_BIN_EXE_assur"));
        let output = command.args(words.skip(1)).current_dir(folder.path()).output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{call}: {}", String::from_utf8_lossy(&output.stderr));
    }
    let rows = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap().lines().count() - 1;
    assert!((1..26).contains(&rows("good.csv")));
    assert_eq!(rows("all-of-good.csv"), rows("good.csv"));
    // The table of points of the page is one.
    let table = text.split("```csv\n").nth(1).unwrap().split("```").next().unwrap();
    fs::write(folder.path().join("points.csv"), table).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_assur"));
    command.args(["sweep", "four-bar.toml", "--points", "points.csv"]).current_dir(folder.path());
    let rows = String::from_utf8(command.output().unwrap().stdout).unwrap();
    let first: Vec<&str> = rows.lines().map(|line| line.split(",ok").next().unwrap()).skip(1).collect();
    assert_eq!(first, ["0,0.09,2", "1,0.1,2.2"]);
}
