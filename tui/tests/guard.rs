//! The bytes of the results of every shipped scene and of every scene of the corpus, and of the rows of some sweeps, have
//! their hashes. The pictures have theirs beside the views that draw them.

// Formulas call trigonometric functions of the C library, which another one may round differently.
#![cfg(all(target_os = "linux", target_arch = "x86_64", target_env = "gnu"))]
#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use assur_testkit::guard::{self, Hash};

/// Sweeps: name, scene, arguments.
const SWEEPS: &[(&str, &str, &[&str])] = &[
    ("crank", "shaper", &["--vary", "link.crank.points.A=90 mm..110 mm:3"]),
    ("all", "shaper", &["--vary", "force.cutting.scale=0.5..2:2", "--measure", "all"]),
    ("lost", "four-bar", &["--vary", "link.crank.points.A=80 mm..400 mm:4"]),
    (
        "sample",
        "four-bar",
        &[
            "--vary",
            "link.coupler.mass=2 kg..3 kg",
            "--vary",
            "link.rocker.points.B=200 mm..230 mm",
            "--tie",
            "link.rocker.mass=link.coupler.mass*0.5",
            "--target",
            "K=200 mm,100 mm",
            "--measure",
            "all",
            "--sample",
            "4",
            "--seed",
            "3",
        ],
    ),
    (
        "speed",
        "slider-crank",
        &["--vary", "motion.speed=600 rpm..1200 rpm:3", "--measure", "default,shaking"],
    ),
    (
        "length",
        "press",
        &["--vary", "link.rod.points.B=150 mm..170 mm:3", "--measure", "default,time-ratio,pf"],
    ),
    ("turned", "conveyor", &["--vary", "link.trough.mass=200 kg..240 kg:2", "--measure", "all"]),
    ("iterated", "six-links", &["--vary", "link.rod.points.P=295 mm..305 mm:3"]),
    (
        "rubbing",
        "shaper-friction",
        &["--vary", "friction[0].coefficient=0.05..0.1:2", "--measure", "default,friction"],
    ),
    ("drive", "shaper-drive", &["--vary", "motion.unevenness=0.03..0.06:2"]),
    ("until", "brake", &["--vary", "brake[0].friction=0.1..0.3:3"]),
    ("spring", "stephenson3", &["--vary", "spring[0].stiffness=600..900:3", "--measure", "all"]),
];

/// What is hashed of a scene in one go.
enum Job {
    Results(PathBuf),
    Sweep(PathBuf, &'static str, &'static [&'static str]),
}

/// Runs the program on a scene beside it; exit status and standard output.
fn assur(scene: &Path, command: &str, arguments: &[&str]) -> (Option<i32>, Vec<u8>) {
    let output = Command::new(env!("CARGO_BIN_EXE_assur"))
        .arg(command)
        .arg(scene.file_name().unwrap())
        .args(arguments)
        .current_dir(scene.parent().unwrap())
        .env("LC_ALL", "C.UTF-8")
        .output()
        .unwrap();
    (output.status.code(), output.stdout)
}

/// JSON, CSV and Parquet.
fn results(scene: &Path) -> Vec<(String, String)> {
    let (status, json) = assur(scene, "analyze", &["--format", "json"]);
    if json.is_empty() {
        return vec![("json".to_owned(), format!("-{}", status.unwrap()))];
    }
    let [numbers, texts] = guard::numbers_and_texts(&json);
    let folder = tempfile::tempdir().unwrap();
    let [csv, parquet] = ["csv", "a.parquet"].map(|name| folder.path().join(name));
    assur(scene, "analyze", &["--format", "csv", "-o", csv.to_str().unwrap()]);
    assur(scene, "analyze", &["-o", parquet.to_str().unwrap()]);
    let parquet = fs::read(parquet).ok().map(|bytes| Hash::of(&bytes));
    let forms =
        [("json", Some(numbers)), ("texts", Some(texts)), ("csv", of_folder(&csv)), ("parquet", parquet)];
    forms.into_iter().filter_map(|(form, hash)| Some((form.to_owned(), hash?))).collect()
}

/// The hash of all files of a folder, with their names.
fn of_folder(folder: &Path) -> Option<String> {
    let mut files: Vec<PathBuf> = fs::read_dir(folder).ok()?.map(|entry| entry.unwrap().path()).collect();
    files.sort();
    let mut hash = Hash::default();
    for file in files {
        hash.add(file.file_name().unwrap().as_encoded_bytes());
        hash.add(&fs::read(file).unwrap());
    }
    Some(hash.digits())
}

#[test]
fn guard_of_results() {
    let mut jobs = Vec::new();
    for (name, path) in guard::scenes("fixtures") {
        for (sweep, _, arguments) in SWEEPS.iter().filter(|(_, scene, _)| *scene == name) {
            jobs.push((name.clone(), Job::Sweep(path.clone(), sweep, arguments)));
        }
        jobs.push((name, Job::Results(path)));
    }
    let corpus = guard::scenes("tests/corpus").into_iter();
    jobs.extend(corpus.map(|(name, path)| (format!("corpus/{name}"), Job::Results(path))));
    let found = guard::hashes(&jobs, |job| match job {
        Job::Results(scene) => results(scene),
        Job::Sweep(scene, name, arguments) => {
            vec![(format!("sweep-{name}"), Hash::of(&assur(scene, "sweep", arguments).1))]
        }
    });
    guard::compare("guard.txt", &found);
}
