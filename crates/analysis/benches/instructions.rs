//! The cost of scenes in instructions, counted by callgrind: `cargo bench -p assur-analysis --bench instructions`.
//!
//! The number of instructions does not depend on the load of the machine. Each row is counted in two runs of different
//! length, so that reading and compiling the scene cancel. Without `valgrind` the program prints a message and counts
//! nothing.
//!
//! Figures: `docs/measured/cost.md`.

use std::hint::black_box;
use std::path::Path;
use std::process::{Command, ExitCode};

use assur_all as _;
use assur_analysis::{Calculation, Options, unwatched};
use assur_force::{LoadState, Reactions};
use assur_group::{Order, Wrench};

/// All kinematic results, and no reaction.
const MOTION_ONLY: &str = "[output]\nlinks = [\"crank\", \"stone2\", \"rocker\", \"stone4\", \"ram\"]\n\
    points = [\"O\", \"A\", \"C\", \"S3\", \"D\", \"E\", \"K\"]\nslides = [\"stone2/rocker\", \"stone4/ram\", \"ram/ground\"]\n";

/// One piece of work: its name, what it is, what one unit of it is.
struct Row {
    name: &'static str,
    what: &'static str,
    unit: &'static str,
    work: fn(usize),
}

const ANALYSES: [Row; 4] = [
    Row { name: "all", what: "shaper, everything told", unit: "analysis", work: |n| analyze(&shaper(), n) },
    Row {
        name: "motion",
        what: "the same scene, motion asked for, no reaction",
        unit: "analysis",
        work: |n| analyze(&(shaper() + MOTION_ONLY), n),
    },
    Row {
        name: "bare",
        what: "the same motion in a scene without masses and loads",
        unit: "analysis",
        work: |n| analyze(&(bare(&shaper(), &[]) + MOTION_ONLY), n),
    },
    Row {
        name: "front",
        what: "the same scene, asked for the point S3 only",
        unit: "analysis",
        work: |n| analyze(&(shaper() + "[output]\npoints = [\"S3\"]\n"), n),
    },
];

const POSITIONS: [Row; 6] = [
    Row { name: "pf0", what: "PF0", unit: "position", work: |n| positions(n, Order::Place) },
    Row { name: "pf1", what: "PF0, PF1", unit: "position", work: |n| positions(n, Order::First) },
    Row { name: "pf2", what: "PF0, PF1, PF2", unit: "position", work: |n| positions(n, Order::Second) },
    Row { name: "reduced", what: "PF2 with J, dJ/dq, Q", unit: "position", work: reduced },
    Row {
        name: "forces",
        what: "PF2 with reactions of both groups",
        unit: "position",
        work: |n| forces(n, true),
    },
    Row {
        name: "idle",
        what: "PF2 with reactions, no load reaches the second group",
        unit: "position",
        work: |n| forces(n, false),
    },
];

fn shaper() -> String {
    assur_fixtures::scene("shaper").to_owned()
}

/// The scene without loads, and with the masses of the named links alone.
fn bare(text: &str, heavy: &[&str]) -> String {
    let (mut link, mut table) = (true, true);
    let lines = text.lines().filter(|line| {
        if line.starts_with('[') {
            table = !line.starts_with("[[force]]");
            link = line.strip_prefix("[link.").is_none_or(|name| heavy.iter().any(|h| name.starts_with(h)));
        }
        let mass = ["mass", "center", "inertia"].iter().any(|key| line.starts_with(key));
        let gravity = line.starts_with("gravity") && heavy.is_empty();
        table && (link || !mass) && !gravity
    });
    lines.collect::<Vec<_>>().join("\n") + "\n"
}

fn study(text: &str) -> Calculation {
    let mechanism = assur_scene::read("bench", text).expect("a good scene");
    Calculation::of(mechanism, &Options::default(), &mut unwatched).expect("a good mechanism")
}

fn analyze(text: &str, runs: usize) {
    let study = study(text);
    for _ in 0..runs {
        let _ = black_box(study.analyze(&mut unwatched));
    }
}

/// Coordinates that do not repeat.
fn coordinates(runs: usize) -> impl Iterator<Item = f64> {
    (0..runs).map(|run| black_box(0.3 + 0.01 * run as f64))
}

fn positions(runs: usize, order: Order) {
    let linkage = study(&shaper()).linkage;
    let mut position = linkage.position();
    for q in coordinates(runs) {
        let _ = black_box(linkage.solve(q, order, &mut position));
    }
}

fn reduced(runs: usize) {
    let study = study(&shaper());
    let (Some(loads), linkage) = (&study.loads, &study.linkage) else { return };
    let mut position = linkage.position();
    for q in coordinates(runs) {
        let _ = linkage.solve(q, Order::Second, &mut position);
        black_box(loads.reduced(&LoadState::prescribed(&linkage.mechanism, q), &position.bodies));
    }
}

/// With all loads, or with the weight and inertia of the rocker alone.
fn forces(runs: usize, all: bool) {
    let study = study(&if all { shaper() } else { bare(&shaper(), &["rocker"]) });
    let (Some(loads), Some(analyzer), linkage) = (&study.loads, study.analyzer, &study.linkage) else {
        return;
    };
    let mut position = linkage.position();
    let mut wrenches = vec![Wrench::ZERO; linkage.structure.links];
    let mut out = Reactions::new(linkage).without_idle(&study.plan.groups_carrying);
    for q in coordinates(runs) {
        let _ = linkage.solve(q, Order::Second, &mut position);
        let state = LoadState::prescribed(&linkage.mechanism, q);
        loads.evaluate(&state, &position.bodies, &mut wrenches);
        let _ = black_box(analyzer.instance.solve(linkage, &position, &mut wrenches, &mut out));
    }
}

/// Runs one piece of work that many times under callgrind.
fn count(name: &str, runs: usize, folder: &Path) -> Result<f64, String> {
    let file = folder.join(format!("{name}-{runs}"));
    let program = std::env::current_exe().map_err(|error| error.to_string())?;
    let told = Command::new("valgrind")
        .args(["--tool=callgrind", &format!("--callgrind-out-file={}", file.display())])
        .arg(program)
        .args(["--work", name, &runs.to_string()])
        .output()
        .map_err(|error| format!("valgrind can't be run ({error})"))?;
    if !told.status.success() {
        return Err(format!("valgrind failed: {}", String::from_utf8_lossy(&told.stderr)));
    }
    let text = std::fs::read_to_string(&file).map_err(|error| error.to_string())?;
    let line = text.lines().find_map(|line| line.strip_prefix("totals: "));
    line.and_then(|total| total.trim().parse().ok()).ok_or("callgrind wrote no total".to_owned())
}

/// Instructions of one unit: the difference of a long and a short run.
fn measure(row: &Row, [few, many]: [usize; 2], folder: &Path) -> Result<f64, String> {
    let (short, long) = (count(row.name, few, folder)?, count(row.name, many, folder)?);
    Ok((long - short) / (many - few) as f64)
}

fn table(rows: &[Row], runs: [usize; 2], reference: &str, folder: &Path) -> Result<(), String> {
    let found = rows.iter().map(|row| measure(row, runs, folder)).collect::<Result<Vec<_>, _>>()?;
    let one = rows.iter().position(|row| row.name == reference).map_or(1.0, |at| found[at]);
    for (row, count) in rows.iter().zip(&found) {
        println!("{count:>9.0} per {:8} {:6.3} of `{reference}`  {}", row.unit, count / one, row.what);
    }
    Ok(())
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let [mode, name, runs] = &arguments[..]
        && mode == "--work"
    {
        let row = ANALYSES.iter().chain(&POSITIONS).find(|row| row.name == name);
        if let (Some(row), Ok(runs)) = (row, runs.parse()) {
            (row.work)(runs);
        }
        return ExitCode::SUCCESS;
    }
    let folder = std::env::temp_dir().join(format!("assur-instructions-{}", std::process::id()));
    let done = std::fs::create_dir_all(&folder)
        .map_err(|error| error.to_string())
        .and_then(|()| table(&ANALYSES, [1, 5], "bare", &folder))
        .and_then(|()| table(&POSITIONS, [100, 1100], "pf2", &folder));
    let _ = std::fs::remove_dir_all(&folder);
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(reason) => {
            println!(
                "NOT MEASURED: {reason}. Instructions are counted by valgrind's callgrind; install `valgrind`."
            );
            ExitCode::FAILURE
        }
    }
}
