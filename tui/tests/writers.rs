//! Sweeps that write one file, at once or one after the end of the other.

#![cfg(unix)]
#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use std::fs::{self, File};
use std::io::Read;
use std::os::unix::fs::{FileTypeExt, symlink};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;

/// Crank and rod; lengths of which some can't be assembled.
const SLIDER: &str = "[ground]\npoints = { O = [0, 0] }\n[link.crank]\npoints = { O = 0, A = \"100 mm\" }\n\
    [link.rod]\npoints = { A = 0, B = 0.3 }\n[link.piston]\npoints = { B = 0 }\nmass = \"2 kg\"\n\
    [[slide]]\nlink = \"piston\"\non = \"ground\"\n[input]\nlink = \"crank\"\n[assembly]\nB = [0.4, 0]\n";
const MANY: &str = "link.crank.points.A=100 mm..301 mm:3000";
const FEW: &str = "link.crank.points.A=100 mm..200 mm:3";

const WRITTEN: &str = "is writing it now";

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.toml"), SLIDER).unwrap();
    folder
}

/// `assur sweep a.toml`.
fn start(folder: &Path, arguments: &[&str]) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_assur"));
    command.args(["sweep", "a.toml", "--vary"]).args(arguments).current_dir(folder).env("LC_ALL", "C.UTF-8");
    command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

fn sweep(folder: &Path, arguments: &[&str]) -> Output {
    start(folder, arguments).wait_with_output().unwrap()
}

fn code(output: &Output) -> i32 {
    output.status.code().unwrap()
}

fn err(output: &Output) -> &str {
    str::from_utf8(&output.stderr).unwrap()
}

/// The files of a folder, without what is said beside rows of their origin.
fn names(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<_> = names.filter(|name| !name.ends_with(".csv.origin.json")).collect();
    names.sort();
    names
}

/// Bytes of the rows so far: those of the file, or of all parts in the folder.
fn size(part: &Path) -> u64 {
    let Ok(found) = fs::metadata(part) else { return 0 };
    let entries = fs::read_dir(part).into_iter().flatten().flatten();
    if found.is_dir() {
        entries.filter_map(|entry| Some(entry.metadata().ok()?.len())).sum()
    } else {
        found.len()
    }
}

/// Waits until a sweep has written more than so many bytes of rows; whether it still runs.
fn has_written(child: &mut Child, part: &Path, bytes: u64) -> bool {
    while size(part) <= bytes {
        if child.try_wait().unwrap().is_some() {
            return false;
        }
        std::thread::sleep(Duration::from_millis(1));
    }
    child.try_wait().unwrap().is_none()
}

/// Sends a signal to a sweep.
fn signal(child: &Child, signal: &str) {
    let kill = format!("kill {signal} {}", child.id());
    assert!(Command::new("sh").args(["-c", &kill]).status().unwrap().success());
}

/// Stops a process, and waits until none of its threads runs, where the system lists them: a signal is delivered after the call
/// that sends it.
fn stop(child: &Child) {
    signal(child, "-STOP");
    let runs = |thread: std::io::Result<fs::DirEntry>| {
        let state = fs::read_to_string(thread.unwrap().path().join("stat")).unwrap_or_default();
        state.rsplit(')').next().is_some_and(|rest| !rest.trim_start().starts_with('T'))
    };
    let threads = || fs::read_dir(format!("/proc/{}/task", child.id()));
    while threads().is_ok_and(|mut threads| threads.any(runs)) {
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
}

/// The rows of a run that nothing disturbs.
fn whole(folder: &Path, name: &str) -> Vec<u8> {
    let name = format!("whole-{name}");
    assert_eq!(code(&sweep(folder, &[MANY, "-o", &name])), 1, "some points have no solution");
    fs::read(folder.join(name)).unwrap()
}

#[test]
fn a_second_sweep_is_told_who_writes() {
    for name in ["b.csv", "b.parquet"] {
        let folder = folder();
        let path = folder.path();
        let whole = whole(path, name);
        let mut first = start(path, &[MANY, "-o", name]);
        assert!(has_written(&mut first, &path.join(format!("{name}.part")), 0), "too few points");
        // It must not end before the others begin.
        stop(&first);
        for more in [&[][..], &["--resume"], &["--shard", "2/2"]] {
            let second = sweep(path, &[&[FEW, "-o", name], more].concat());
            let process = format!("error: can't write {name}: process {}", first.id());
            assert_eq!(code(&second), 2, "{}", err(&second));
            assert!(err(&second).starts_with(&process) && err(&second).contains(WRITTEN), "{}", err(&second));
        }
        // Under another name, too.
        fs::create_dir(path.join("sub")).unwrap();
        let second = sweep(path, &[FEW, "-o", &format!("sub/../{name}")]);
        assert!(code(&second) == 2 && err(&second).contains(WRITTEN), "{}", err(&second));
        signal(&first, "-CONT");
        let first = first.wait_with_output().unwrap();
        assert_eq!(code(&first), 1, "{}", err(&first));
        assert_eq!(fs::read(path.join(name)).unwrap(), whole);
        assert_eq!(names(path), ["a.toml", name, "sub", &format!("whole-{name}")], "nothing is left beside");
    }
}

#[test]
fn of_three_sweeps_that_begin_at_once_each_file_has_the_rows_of_one() {
    for name in ["b.csv", "b.parquet"] {
        let folder = folder();
        let path = folder.path();
        let whole = whole(path, name);
        for _ in 0..2 {
            let children: Vec<_> = (0..3).map(|_| start(path, &[MANY, "-o", name, "--resume"])).collect();
            let ends: Vec<_> = children.into_iter().map(|child| child.wait_with_output().unwrap()).collect();
            let (told, done): (Vec<_>, Vec<_>) = ends.iter().partition(|end| err(end).contains(WRITTEN));
            assert!(!done.is_empty() && told.iter().all(|end| code(end) == 2));
            assert!(done.iter().all(|end| err(end).starts_with("error: no solution at ")), "{done:?}");
            assert_eq!(fs::read(path.join(name)).unwrap(), whole);
            fs::remove_file(path.join(name)).unwrap();
            assert_eq!(names(path), ["a.toml", &format!("whole-{name}")]);
        }
    }
}

#[test]
fn a_sweep_that_is_killed_among_others_loses_no_row() {
    for name in ["b.csv", "b.parquet"] {
        let folder = folder();
        let path = folder.path();
        let whole = whole(path, name);
        let part = path.join(format!("{name}.part"));
        let (mut seed, mut kills) = (7_u64, 0);
        loop {
            let pair = [0, 1].map(|_| start(path, &[MANY, "-o", name, "--resume"]));
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            // At random numbers of rows; at last the sweep is left to end.
            let more = size(&part) + (seed >> 33) % (whole.len() as u64 / 6);
            let ends = pair.map(|mut child| {
                if kills < 6 && has_written(&mut child, &part, more) {
                    child.kill().unwrap();
                    kills += 1;
                }
                child.wait_with_output().unwrap()
            });
            let is_written = ends.iter().any(|end| end.status.code() == Some(1));
            for end in ends.iter().filter(|end| end.status.code() == Some(2)) {
                assert!(err(end).contains(WRITTEN), "{}", err(end));
            }
            if is_written {
                break;
            }
        }
        assert!(kills >= 3, "{kills} kills: too few points for this machine");
        assert_eq!(fs::read(path.join(name)).unwrap(), whole, "{name}");
        assert_eq!(names(path), ["a.toml", name, &format!("whole-{name}")]);
    }
}

#[test]
fn pipes_and_devices_are_written_through_or_refused_and_stay() {
    let folder = folder();
    let path = folder.path();
    let rows = sweep(path, &[FEW]).stdout;
    let pipe = path.join("pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    symlink("pipe", path.join("link.csv")).unwrap();
    symlink("pipe", path.join("link.parquet")).unwrap();
    for name in ["pipe", "link.csv"] {
        let child = start(path, &[FEW, "-o", name]);
        let mut read = Vec::new();
        File::open(&pipe).unwrap().read_to_end(&mut read).unwrap();
        let end = child.wait_with_output().unwrap();
        assert_eq!((code(&end), read), (0, rows.clone()), "{}", err(&end));
    }
    let end = sweep(path, &[FEW, "-o", "link.parquet", "--resume"]);
    assert!(code(&end) == 2 && err(&end).contains("can't go to a device or a pipe"), "{}", err(&end));
    assert!(fs::symlink_metadata(&pipe).unwrap().file_type().is_fifo());
    // A device of our own that is always full, where the user may make one: nothing is risked with that of the machine.
    let made =
        Command::new("mknod").arg(path.join("full")).args(["c", "1", "7"]).stderr(Stdio::null()).status();
    if made.is_ok_and(|status| status.success())
        && File::options().append(true).open(path.join("full")).is_ok()
    {
        symlink("full", path.join("full.csv")).unwrap();
        symlink("full", path.join("full.parquet")).unwrap();
        for name in ["full", "full.csv", "full.parquet"] {
            assert_eq!(code(&sweep(path, &[FEW, "-o", name])), 2, "{name}");
            assert!(fs::symlink_metadata(path.join("full")).unwrap().file_type().is_char_device(), "{name}");
        }
    }
    let left: Vec<_> = names(path).into_iter().filter(|name| name.contains(".part")).collect();
    assert!(left.is_empty(), "{left:?}");
}

#[test]
fn a_link_beside_the_output_is_not_followed() {
    for name in ["b.csv", "b.parquet"] {
        for beside in [format!("{name}.part"), format!("{name}.part.lock")] {
            for exists in [false, true] {
                let folder = folder();
                let path = folder.path();
                if exists {
                    fs::write(path.join("victim"), "").unwrap();
                }
                symlink("victim", path.join(&beside)).unwrap();
                for more in [&[][..], &["--resume"]] {
                    let end = sweep(path, &[&[FEW, "-o", name], more].concat());
                    assert_eq!(code(&end), 2, "{beside} {more:?}: {}", err(&end));
                    assert!(
                        err(&end).starts_with(&format!("error: can't write {beside}: ")),
                        "{}",
                        err(&end)
                    );
                }
                let victim = fs::read(path.join("victim")).ok();
                assert_eq!(victim, exists.then(Vec::new), "{beside}");
                assert!(!path.join(name).exists());
            }
        }
    }
}

#[test]
fn what_takes_the_place_of_rows_while_they_are_written_is_an_error() {
    for name in ["b.csv", "b.parquet"] {
        for as_link in [false, true] {
            let folder = folder();
            let path = folder.path();
            let part = path.join(format!("{name}.part"));
            let mut child = start(path, &[MANY, "-o", name]);
            assert!(has_written(&mut child, &part, 0), "too few points");
            stop(&child);
            fs::rename(&part, path.join("moved")).unwrap();
            if as_link {
                symlink("moved", &part).unwrap();
            } else {
                fs::create_dir(&part).unwrap();
            }
            signal(&child, "-CONT");
            let output = child.wait_with_output().unwrap();
            assert_eq!(code(&output), 2, "{name} {as_link}: {}", err(&output));
            assert!(err(&output).contains("something else was put in its place"), "{}", err(&output));
            assert!(!path.join(name).exists(), "{name} {as_link}");
        }
    }
}

#[test]
fn a_file_larger_than_the_system_allows_is_an_error_and_leaves_nothing() {
    let folder = folder();
    let path = folder.path();
    let program = env!("CARGO_BIN_EXE_assur");
    for (arguments, name) in [
        ("new b.toml --kind shaper-drive", "b.toml"),
        ("analyze a.toml --format json -o b.json", "b.json"),
        ("report a.toml -o b.html", "b.html"),
    ] {
        // Blocks of 512 bytes, or of 1024.
        let limited = format!("ulimit -f 1; exec {program} {arguments}");
        let output =
            Command::new("sh").args(["-c", &limited]).current_dir(path).env("LC_ALL", "C.UTF-8").output();
        let output = output.unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments}: {:?} {}", output.status, err(&output));
        assert!(err(&output).starts_with(&format!("error: can't write {name}: ")), "{}", err(&output));
        assert_eq!(names(path), ["a.toml"], "{arguments}");
    }
}

#[test]
fn files_of_others_beside_the_output_stay() {
    let folder = folder();
    let path = folder.path();
    // A text without a line end is no beginning of a sweep.
    fs::write(path.join("b.csv.part"), "mine").unwrap();
    for more in [&[][..], &["--shard", "2/2"]] {
        let end = sweep(path, &[&[FEW, "-o", "b.csv", "--resume"], more].concat());
        assert!(code(&end) == 2 && err(&end).contains("does not belong to this sweep"), "{}", err(&end));
        assert_eq!(fs::read_to_string(path.join("b.csv.part")).unwrap(), "mine");
    }
    fs::remove_file(path.join("b.csv.part")).unwrap();
    fs::write(path.join("b.csv.part.lock"), "mine").unwrap();
    let end = sweep(path, &[FEW, "-o", "b.csv"]);
    assert!(code(&end) == 2 && err(&end).contains("it is not a lock of this program"), "{}", err(&end));
    assert_eq!(fs::read_to_string(path.join("b.csv.part.lock")).unwrap(), "mine");
    assert_eq!(names(path), ["a.toml", "b.csv.part.lock"]);
}
