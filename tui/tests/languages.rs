//! What every command prints in another language, on both streams, has no English word: what is in Latin letters is quoted, a
//! symbol, a name of the scene or of a registry, or from the system.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

mod english;

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use assur_all as _;
use english::{english, of_the_registries, words};

/// Commands with the scene `a.toml`.
const COMMANDS: &[&[&str]] = &[
    &["analyze", "a.toml", "--plans", "1", "--by-cause"],
    &["analyze", "a.toml", "--positions", "0..1"],
    &["check", "a.toml"],
    &["explain", "a.toml"],
    &["explain", "a.toml", "--position", "1"],
    &["geometry", "a.toml"],
    &["shaking", "a.toml"],
    &["draw", "a.toml", "--view", "plans", "-o", "b.svg"],
    &["report", "a.toml", "-o", "b.html"],
    &["report", "a.toml", "-o", "b.odt"],
    // What can't be done.
    &["analyze", "a.toml", "--positions", "900"],
    &["analyze", "a.toml", "--plans", "900"],
    &["analyze", "a.toml", "--format", "csv"],
    &["analyze", "a.toml", "--analyzer", "nothing"],
    &["analyze", "a.toml", "--integrator", "nothing"],
    &["analyze", "a.toml", "--analyzer", "virtual-power"],
    &["check", "a.toml", "--analyzer", "longitudinal"],
    &["explain", "a.toml", "--position", "900"],
    &["draw", "a.toml", "--view", "plans", "--part", "nothing", "-o", "b.svg"],
    &["draw", "a.toml", "--view", "drive", "-o", "b.svg"],
    &["draw", "a.toml", "-o", "b.gif"],
    &["sweep", "a.toml", "--vary", "link.crank.mass=1..2:2", "-o", "a.toml"],
    &["sweep", "a.toml", "--vary", "link.crank.mass=1..2:2", "-o", "b.xlsx"],
    &["sweep", "a.toml", "--vary", "link.crank.mass=1..2", "--measure", "nothing"],
    &["sweep", "a.toml", "--vary", "link.crank.mass=1 kg..2 m:2", "-o", "b.csv"],
    &["sweep", "a.toml", "--vary", "input.from=0..7:2", "-o", "b.csv"],
    &["sweep", "a.toml", "--vary", "link.crank.points.A=9 m..99 m:2", "-o", "b.csv"],
    &["sweep", "a.toml", "--vary", "link.crank.points.A=-1 m..1e9 m:2", "-o", "b.csv"],
    &["sweep", "a.toml", "--vary", "link.crank.mass=1..2:2", "--where", "row", "-o", "b.csv"],
    &["sweep", "a.toml", "--vary", "link.crank.mass=1..2:2", "--where", "row > 1 m", "-o", "b.csv"],
    &["sweep", "a.toml", "--vary", "input.link=crank,ground", "-o", "b.csv"],
    &["sweep", "a.toml", "--points", "none.csv", "-o", "b.csv"],
    &["sweep", "a.toml", "--points", "a.toml", "-o", "b.csv"],
];

/// Commands without a scene, or with a scene that is none.
const OTHERS: &[&[&str]] = &[
    &["plugins"],
    &["motors"],
    &["motors", "--catalogue", "nothing"],
    &["motors", "--min-power", "3 m"],
    &["motors", "--min-power", "1 GW"],
    &["new", "a.toml"],
    &["new", "folder/b.toml"],
    &["new", "."],
    &["analyze", "none.toml"],
    &["analyze", "folder"],
    &["analyze", "a.toml", "-o", "folder"],
    &["analyze", "a.toml", "-o", "none/b.txt"],
    &["analyze", "a.toml", "-o", "a.toml"],
    &["analyse", "a.toml"],
    &["chek"],
    &["nothing"],
    &["--fps", "5", "check", "a.toml"],
    &["--analyzer", "groups", "check", "a.toml"],
    &["a.toml", "check", "a.toml"],
    &["a.toml", "--plans", "1"],
    &["sweep", "a.toml", "--vary", "a=1..2:2", "--shard", "3/2"],
    &["analyze", "a.toml", "--positions", "x"],
    &["draw", "a.toml", "-o", "b.svg", "--size", "1x1"],
    &["check", "cyclic.toml"],
    &["check", "unit.toml"],
    &["stability", "short.toml"],
    &["chart", "short.toml"],
    &["check", "short.toml"],
    &["geometry", "short.toml"],
];

/// A mechanism that can't turn fully: crank 2, ground 3, coupler 1.5, rocker 1.5.
const SHORT: &str = "[ground]\npoints = { O = [0, 0], C = [3, 0] }\n[link.crank]\npoints = { O = 0, A = 2 }\n\
    [link.coupler]\npoints = { A = 0, B = 1.5 }\n[link.rocker]\npoints = { C = 0, B = 1.5 }\n\
    [input]\nlink = \"crank\"\npositions = 6\n";

/// Methods of charts that no registry has.
const METHODS: &str = "closed-form general-derivatives groups-general newton differences-2 shooting settle exact \
                       mertsalov wittenbauer excess less inertia f64";
/// Parts of a view, as the command line names them.
const PARTS: &str = "forces velocities accelerations construction";
/// Words of the system, and names of files and of what does not exist.
const SYSTEM: &str = "nothing chek b part sqrt min html odt gif xlsx none folder svg short unit cyclic tail os error No such file or \
                      directory Is a";

fn known(scene: &str) -> BTreeSet<String> {
    let help = Command::new(env!("CARGO_BIN_EXE_assur")).arg("--help").output().unwrap();
    let help = String::from_utf8(help.stdout).unwrap();
    let commands =
        help.lines().filter_map(|line| line.strip_prefix("  ")).filter_map(|line| line.split(' ').next());
    let fixtures = assur_fixtures::SCENES.iter().map(|(name, _)| *name);
    let flags = assur_motor::catalogues().unwrap();
    let flags = assur_motor::list_motors(&flags, &assur_motor::MotorFilter::default()).unwrap();
    let flags = flags.into_iter().flat_map(|motor| motor.flags.clone()).collect::<Vec<_>>().join(" ");
    let measures = assur_sweep::MEASURES.iter().map(|measure| measure.name);
    let names: Vec<&str> = commands.chain(fixtures).chain(measures).collect();
    let all = [of_the_registries().as_str(), scene, SHORT, METHODS, PARTS, SYSTEM, &flags, &names.join(" ")]
        .join(" ");
    words(&all).map(str::to_lowercase).collect()
}

/// A text without the options that it names: `--format`.
fn without_options(text: &str) -> String {
    let mut parts = text.split("--");
    let first = parts.next().unwrap_or_default().to_owned();
    let behind =
        |part: &str| part.trim_start_matches(|c: char| c.is_ascii_alphanumeric() || c == '-').to_owned();
    parts.map(behind).fold(first, |all, part| all + " " + &part)
}

/// Whether a word consists of known ones, with dots of a chart in characters between or beside them.
fn is_made_of(word: &str, known: &BTreeSet<String>) -> bool {
    let mut dots = word.match_indices('o');
    word.is_empty()
        || known.contains(word)
        || dots.any(|(at, _)| is_made_of(&word[..at], known) && is_made_of(&word[at + 1..], known))
}

/// The English words that a command prints in both languages, each with the command.
fn printed(folder: &Path, command: &[&str], known: &BTreeSet<String>) -> Vec<String> {
    let mut found = Vec::new();
    for language in ["uk", "ru"] {
        let output = Command::new(env!("CARGO_BIN_EXE_assur"))
            .args(command)
            .args(["--language", language])
            .current_dir(folder)
            .env("LC_ALL", "C.UTF-8")
            .output()
            .unwrap();
        let text = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap()).concat();
        let text = text.replace(&folder.display().to_string(), "");
        assert!(!text.is_empty() || output.status.success(), "{command:?}");
        // A line of the scene, with what is below it.
        let told = text.lines().filter(|line| {
            !line.trim_start_matches(|c: char| c == ' ' || c.is_ascii_digit()).starts_with('|')
        });
        let told = without_options(&told.collect::<Vec<_>>().join("\n"));
        // The symbol of a load has its name below; dots of a chart in characters touch names.
        let words = english(&told, |word| {
            is_made_of(word, known) || word.split('_').all(|part| part.len() < 2 || known.contains(part))
        });
        found.extend(words.into_iter().map(|word| format!("{language} {command:?}: {word}")));
    }
    found.dedup();
    found
}

fn no_english(folder: &Path, commands: &[&[&str]], known: &BTreeSet<String>) {
    let found: Vec<_> = commands.iter().flat_map(|command| printed(folder, command, known)).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// A folder with a scene `a.toml`, and the words that may be there.
fn opened(scene: &str) -> (tempfile::TempDir, BTreeSet<String>) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.toml"), scene).unwrap();
    (folder, known(scene))
}

#[test]
fn commands_speak_one_language_on_a_steady_machine() {
    let (folder, known) = opened(assur_fixtures::scene("shaper-drive"));
    no_english(folder.path(), COMMANDS, &known);
}

#[test]
fn commands_speak_one_language_on_a_transient_motion() {
    let (folder, known) = opened(assur_fixtures::scene("run-up"));
    no_english(folder.path(), COMMANDS, &known);
}

#[test]
fn commands_speak_one_language_on_prescribed_motions() {
    for name in ["press", "n-four-bar-2", "stephenson3", "andrews"] {
        let (folder, known) = opened(assur_fixtures::scene(name));
        no_english(folder.path(), COMMANDS, &known);
        no_english(folder.path(), &[&["motors", "--advise", "a.toml"]], &known);
    }
}

#[test]
fn studies_speak_one_language() {
    for name in ["slider-crank", "four-bar", "n-four-bar-2", "flywheel", "brake"] {
        let (folder, known) = opened(assur_fixtures::scene(name));
        no_english(folder.path(), &[&["chart", "a.toml", "--quick"], &["stability", "a.toml"]], &known);
    }
}

#[test]
fn faults_speak_one_language() {
    let (folder, known) = opened(assur_fixtures::scene("slider-crank"));
    fs::create_dir(folder.path().join("folder")).unwrap();
    fs::write(folder.path().join("short.toml"), SHORT).unwrap();
    fs::write(folder.path().join("unit.toml"), SHORT.replace("A = 2", "A = \"2 kg\"")).unwrap();
    let cyclic = format!("{SHORT}[link.tail]\npoints = {{ A = 0, T = 1 }}\n");
    fs::write(folder.path().join("cyclic.toml"), cyclic).unwrap();
    no_english(folder.path(), OTHERS, &known);
}
