//! `assur structure`: other inputs, passive links, exit statuses.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

const THREE_CRANKS: &str = r#"
[ground]
points = { O1 = [0, 0], O2 = [0.3, 0], O3 = [0.15, 0.1] }
[link.crank]
points = { O1 = 0, A = 0.1 }
[link.coupler]
points = { A = [0, 0], B = [0.3, 0], C = [0.15, 0.1] }
mass = 1
center = "C"
[link.crank2]
points = { O2 = 0, B = 0.1 }
[link.crank3]
points = { O3 = 0, C = 0.1 }
[assembly]
B = [0.39, 0.05]
[input]
link = "crank"
from = "30 deg"
[motion]
speed = 1
"#;

/// Exit status, standard output, standard error.
fn run(arguments: &[&str], scene: &Path) -> (Option<i32>, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_assur"));
    let output = command.arg(arguments[0]).arg(scene).args(&arguments[1..]).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

fn written(folder: &tempfile::TempDir, name: &str, scene: &str) -> PathBuf {
    let path = folder.path().join(name);
    std::fs::write(&path, scene).unwrap();
    path
}

#[test]
fn a_simpler_class_from_another_input_is_hinted_at() {
    // From the rocker four links form one group of class IV, from the crank one of class III.
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/triad.toml"))
        .unwrap();
    let from_the_rocker =
        written(&folder, "triad.toml", &text.replace("link = \"crank\"", "link = \"rocker\""));
    let (status, out, _) = run(&["structure", "--all-inputs", "--format", "json"], &from_the_rocker);
    assert_eq!(status, Some(0), "{out}");
    let json: Value = serde_json::from_str(&out).unwrap();
    let inputs = json["inputs"].as_array().unwrap();
    let of = |link: &str| inputs.iter().find(|input| input["link"] == link).unwrap();
    assert_eq!((&of("rocker")["class"], &of("rocker")["present"]), (&4.into(), &true.into()));
    assert_eq!((&of("crank")["class"], &of("crank")["simpler"]), (&3.into(), &true.into()));
    let (_, text, _) = run(&["structure", "--all-inputs"], &from_the_rocker);
    assert!(
        text.contains("With the link crank as the input the groups would be of a lower class."),
        "{text}"
    );
}

#[test]
fn a_misfit_ends_with_status_1_and_the_length_that_closes_ends_it() {
    let folder = tempfile::tempdir().unwrap();
    let fits = written(&folder, "fits.toml", THREE_CRANKS);
    let (status, out, _) = run(&["structure"], &fits);
    assert_eq!(status, Some(0));
    assert!(out.contains("Passive: link crank3"), "{out}");
    let long = written(&folder, "long.toml", &THREE_CRANKS.replace("O3 = 0, C = 0.1 ", "O3 = 0, C = 0.101 "));
    for command in ["structure", "analyze", "check", "geometry"] {
        let (status, _, told) = run(&[command], &long);
        assert_eq!(status, Some(1), "{command}: {told}");
        assert!(told.contains("misses by 1 mm") && told.contains("link.crank3.points.C = 100 mm"), "{told}");
    }
    let general =
        THREE_CRANKS.replace("O2 = 0, B = 0.1 ", "O2 = 0, B = 0.13 ").replace("C = 0.1 ", "C = 0.17 ");
    let general = written(&folder, "general.toml", &general);
    assert_eq!(run(&["structure"], &general).0, Some(1));
    assert_eq!(run(&["analyze"], &general).0, Some(2));
}

#[test]
fn reactions_that_are_not_determined_are_null_and_empty_unless_those_of_least_norm_are_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let scene = written(&folder, "three.toml", THREE_CRANKS);
    let analyzed = |more: &[&str]| -> Value {
        let (status, out, told) = run(&[&["analyze", "--format", "json"], more].concat(), &scene);
        assert_eq!(status, Some(0), "{told}");
        serde_json::from_str(&out).unwrap()
    };
    let [plain, least] = [analyzed(&[]), analyzed(&["--indeterminate", "least-norm"])];
    assert_eq!(plain["positions"][0]["reactions"]["C"]["crank3"], Value::Null);
    assert!(plain["positions"][0]["reactions"]["C"].get("crank3").is_some());
    assert!(least["positions"][0]["reactions"]["C"]["crank3"][1].is_f64());
    let csv = folder.path().join("csv");
    let (status, ..) = run(&["analyze", "--format", "csv", "-o", csv.to_str().unwrap()], &scene);
    assert_eq!(status, Some(0));
    let text = std::fs::read_to_string(csv.join("reactions.csv")).unwrap();
    let mut rows = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let (head, first) = (rows.next().unwrap(), rows.next().unwrap());
    let column = head.iter().position(|name| *name == "C_crank3_fx_N").unwrap();
    assert_eq!(first[column], "");
    // A method that does not treat them says so.
    let (status, _, told) = run(&["analyze", "--analyzer", "groups"], &scene);
    assert_eq!(status, Some(2));
    assert!(told.contains("passive links"), "{told}");
}
