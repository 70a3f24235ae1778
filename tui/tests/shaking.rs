//! `assur shaking` from outside: exit status, errors, forms.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use std::path::Path;
use std::process::{Command, Output};

fn shaking(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_assur"))
        .arg("shaking")
        .args(arguments)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures"))
        .env("LC_ALL", "C.UTF-8")
        .output()
        .unwrap()
}

fn text(output: &Output) -> (i32, &str, &str) {
    let [out, err] = [&output.stdout, &output.stderr].map(|bytes| str::from_utf8(bytes).unwrap());
    (output.status.code().unwrap(), out, err)
}

#[test]
fn forms() {
    let output = shaking(&["four-bar.toml", "--format", "json"]);
    let (code, out, _) = text(&output);
    let found: serde_json::Value = serde_json::from_str(out).unwrap();
    assert_eq!(code, 0);
    assert_eq!(found["balances"].as_array().unwrap().len(), 4);
    assert_eq!(found["balances"][2]["counterweights"][1]["link"], "rocker");
    let output = shaking(&["four-bar.toml", "--ascii"]);
    let (code, out, _) = text(&output);
    assert!(code == 0 && out.is_ascii() && out.contains("on crank and rocker: least maximum"), "{out}");
    let output = shaking(&["four-bar.toml", "--format", "csv"]);
    let (code, out, _) = text(&output);
    assert_eq!((code, out.lines().count()), (0, 37));
    // A steady regime: its speed over the cycle is found first.
    let output = shaking(&["shaper-drive.toml"]);
    let (code, _, err) = text(&output);
    assert_eq!(code, 0, "{err}");
}

#[test]
fn faults() {
    let folder = tempfile::tempdir().unwrap();
    let scene =
        assur_fixtures::scene("four-bar").replace("[motion]\nspeed = \"180 rpm\"\nacceleration = 30\n", "");
    let path = folder.path().join("still.toml");
    std::fs::write(&path, scene).unwrap();
    let output = shaking(&[path.to_str().unwrap()]);
    let (code, out, err) = text(&output);
    assert_eq!((code, out), (2, ""));
    assert!(err.contains("give `[motion]`"), "{err}");
}
