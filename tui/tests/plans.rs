//! Plans of a position, reactions by cause, reactions over the cycle.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

fn assur(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_assur"))
        .args(arguments)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures"))
        .env("LC_ALL", "C.UTF-8")
        .output()
        .unwrap()
}

fn out(arguments: &[&str]) -> String {
    let output = assur(arguments);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn json(arguments: &[&str]) -> Value {
    serde_json::from_str(&out(&[arguments, &["--format", "json"]].concat())).unwrap()
}

/// Every text and every JSON of plans is flat: subscripts stand on the line.
#[test]
fn no_mark_of_a_subscript_is_written() {
    let mut seen = 0;
    for (scene, _) in assur_fixtures::SCENES {
        let scene = format!("{scene}.toml");
        for arguments in [
            ["analyze", &scene, "--plans", "3", "--language", "uk"],
            ["analyze", &scene, "--plans", "3", "--format", "json"],
            ["explain", &scene, "--position", "3", "--language", "ru"],
        ] {
            // A scene without such a position has no plans there.
            let told = String::from_utf8(assur(&arguments).stdout).unwrap();
            for mark in ["_{", "^{"] {
                assert!(!told.contains(mark), "{arguments:?}: {mark}");
            }
            seen += told.matches("F_bal").count();
        }
    }
    assert!(seen > 0, "the balancing force is named in plans: {seen}");
}

/// The plans without their residuals, which are rounding.
fn plans(scene: &str, index: &str) -> String {
    let text = out(&["analyze", scene, "--plans", index]);
    let text = &text[text.find("Plans of position").unwrap()..];
    text.lines().map(|line| line.split("; ").next().unwrap_or_default().to_owned() + "\n").collect()
}

fn vector(value: &Value) -> [f64; 2] {
    [0, 1].map(|axis| value[axis].as_f64().unwrap())
}

#[test]
fn plans_of_the_press() {
    insta::assert_snapshot!(plans("press.toml", "5"));
}

#[test]
fn plans_of_the_shaper() {
    insta::assert_snapshot!(plans("shaper.toml", "12"));
}

#[test]
fn polygons_close() {
    for scene in ["press.toml", "shaper.toml", "guide-shaper.toml", "conveyor.toml", "slider-crank.toml"] {
        let found = json(&["analyze", scene, "--plans", "3,12", "--plans", "7"]);
        let sheets = found["plans"].as_array().unwrap();
        assert_eq!(sheets.iter().map(|one| one["index"].as_u64().unwrap()).collect::<Vec<_>>(), [3, 7, 12]);
        for polygon in sheets.iter().flat_map(|sheet| sheet["polygons"].as_array().unwrap()) {
            let (mut sum, mut greatest) = ([0.0; 2], 0.0_f64);
            for side in polygon["items"].as_array().unwrap().iter().filter(|side| side["kind"] != "inner") {
                let (start, end) = (vector(&side["start"]), vector(&side["end"]));
                let part = [end[0] - start[0], end[1] - start[1]];
                sum = [sum[0] + part[0], sum[1] + part[1]];
                greatest = greatest.max(part[0].hypot(part[1]));
            }
            assert!(sum[0].hypot(sum[1]) <= 1e-10 * greatest, "{scene} {}: {sum:?}", polygon["title"]);
            assert!(greatest > 0.0, "{scene}: nothing is drawn");
        }
    }
}

#[test]
fn causes_sum_to_the_whole() {
    for scene in ["press.toml", "shaper.toml", "guide-shaper.toml", "conveyor.toml", "stephenson3.toml"] {
        let found = json(&["analyze", scene, "--by-cause"]);
        for position in found["positions"].as_array().unwrap() {
            let causes = position["reactions_by_cause"].as_object().unwrap();
            let whole = position["reactions"].as_object().unwrap();
            let forces = || whole.values().flat_map(|pair| pair.as_object().unwrap().values());
            let sizes = forces().filter_map(|force| force.as_array());
            let scale = sizes.flatten().map(|part| part.as_f64().unwrap().abs()).fold(1.0, f64::max);
            for (pair, reaction) in whole {
                for (link, force) in reaction.as_object().unwrap() {
                    let same = |cause: &'_ str| causes[cause][pair.as_str()][link.as_str()].clone();
                    let shares = causes.keys().map(|cause| same(cause));
                    if link == "moment" {
                        let sum: f64 = shares.map(|share| share.as_f64().unwrap()).sum();
                        assert!((sum - force.as_f64().unwrap()).abs() <= 1e-10 * scale, "{scene} {pair}");
                        continue;
                    }
                    let sum = shares.fold([0.0; 2], |sum: [f64; 2], share| {
                        let share = vector(&share);
                        [sum[0] + share[0], sum[1] + share[1]]
                    });
                    let force = vector(force);
                    let error = (sum[0] - force[0]).hypot(sum[1] - force[1]);
                    assert!(error <= 1e-10 * scale, "{scene} {pair} {link}: {error:e}");
                }
            }
            let shares = position["balancing_by_cause"].as_object().unwrap().values();
            let sum: f64 = shares.map(|share| share.as_f64().unwrap()).sum();
            assert!((sum - position["balancing"].as_f64().unwrap()).abs() <= 1e-10 * scale, "{scene}");
        }
    }
}

#[test]
fn extremes_are_those_of_the_positions() {
    let found = json(&["analyze", "shaper.toml", "--by-cause"]);
    let positions = found["positions"].as_array().unwrap();
    let extremes = found["reaction_extremes"].as_array().unwrap();
    assert_eq!(extremes.len(), found["hodographs"].as_array().unwrap().len());
    for (one, hodograph) in extremes.iter().zip(found["hodographs"].as_array().unwrap()) {
        let (joint, on) = (one["joint"].as_str().unwrap(), one["on"].as_str().unwrap());
        let forces: Vec<_> = positions.iter().map(|p| vector(&p["reactions"][joint][on])).collect();
        let sizes: Vec<_> = forces.iter().map(|f| f[0].hypot(f[1])).collect();
        let at = usize::try_from(one["index"].as_u64().unwrap()).unwrap();
        let greatest = one["greatest"].as_f64().unwrap();
        assert!(
            (greatest - sizes[at]).abs() < 1e-12 * greatest && sizes.iter().all(|size| *size <= greatest)
        );
        let mean = sizes.iter().map(|size| size * size).sum::<f64>() / sizes.len() as f64;
        assert!((one["rms"].as_f64().unwrap() - mean.sqrt()).abs() < 1e-12 * greatest);
        let points: Vec<_> = hodograph["points"].as_array().unwrap().iter().map(vector).collect();
        assert_eq!(points, forces);
    }
    assert!(json(&["analyze", "shaper.toml"]).get("hodographs").is_none());
}

#[test]
fn a_position_that_is_not_there_is_refused() {
    let output = assur(&["analyze", "press.toml", "--plans", "3,33"]);
    assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0));
    let words = String::from_utf8(output.stderr).unwrap();
    assert_eq!(words, "error: --plans 33: there is no such position; they are numbered 0 to 32\n");
    let csv = assur(&["analyze", "press.toml", "--by-cause", "--format", "csv", "-o", "never"]);
    assert_eq!(csv.status.code(), Some(2));
}

#[test]
fn causes_of_more_positions_than_are_kept_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join("fine.toml");
    let fine = assur_fixtures::scene("shaper").replace("positions = 48", "positions = 4097");
    std::fs::write(&scene, fine).unwrap();
    let output = assur(&["analyze", scene.to_str().unwrap(), "--by-cause"]);
    assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0));
    let words = String::from_utf8(output.stderr).unwrap();
    assert!(words.contains("at most 4096 positions of this scene, which has 4097"), "{words}");
}

#[test]
fn a_position_that_does_not_assemble_has_no_plans() {
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join("short.toml");
    let short = "[ground]\npoints = { O = [0, 0], C = [3, 0] }\n[link.crank]\npoints = { O = 0, A = 2 }\n\
        [link.coupler]\npoints = { A = 0, B = 1.5 }\n[link.rocker]\npoints = { C = 0, B = 1.5 }\n\
        [input]\nlink = \"crank\"\npositions = 6\n";
    std::fs::write(&scene, short).unwrap();
    let output = assur(&["analyze", scene.to_str().unwrap(), "--plans", "1,2", "--ascii"]);
    assert_eq!(output.status.code(), Some(1));
    let words = String::from_utf8(output.stderr).unwrap();
    assert!(words.contains("error: plans of position 2: ") && words.contains("no assembly"), "{words}");
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.is_ascii() && text.contains("Plans of position 1") && !text.contains("Plans of position 2"));
}

#[test]
fn several_reactions_are_drawn_together_with_their_values() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.svg");
    let draw = |more: &[&str]| {
        let output = path.to_str().unwrap();
        assur(&[&["draw", "shaper.toml", "--view", "forces", "-o", output], more].concat())
    };
    assert_eq!(draw(&["--show", "C on rocker, A"]).status.code(), Some(0));
    let drawn = std::fs::read_to_string(&path).unwrap();
    let found = json(&["analyze", "shaper.toml"]);
    for (pair, link) in [("C", "rocker"), ("A", "crank")] {
        let [x, y] = vector(&found["positions"][0]["reactions"][pair][link]);
        let key = format!("{pair} on {link} R reaction, N: {:.3}", x.hypot(y));
        assert!(drawn.contains(&key), "{key}");
    }
    for (more, problem) in [
        (&["--show", "C on rockr"][..], "`C on rockr` was not found; there are: C on rocker, "),
        (&["--show", "A,C", "--part", "hodograph"], "no part `hodograph` here; it has overview, curves"),
    ] {
        let output = draw(more);
        let told = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.code() == Some(2) && told.contains(problem), "{told}");
    }
}

#[test]
fn a_part_that_a_scene_does_not_have_is_an_error_and_no_other_picture() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.svg");
    for (view, part, has) in
        [("motion", "iteration", "overview"), ("motion", "course", "overview, reduction")]
    {
        let output =
            assur(&["draw", "shaper.toml", "--view", view, "--part", part, "-o", path.to_str().unwrap()]);
        let told = String::from_utf8(output.stderr).unwrap();
        let wanted = format!("this scene has no part `{part}` here; it has {has}");
        assert!(output.status.code() == Some(2) && told.contains(&wanted), "{told}");
        assert!(!path.exists());
    }
}

#[test]
fn the_numbers_of_causes_and_the_components_of_a_plan_are_explained_by_the_picture() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.svg");
    let draw = |more: &[&str]| {
        let output = assur(&[&["draw", "shaper.toml", "-o", path.to_str().unwrap()], more].concat());
        assert_eq!(output.status.code(), Some(0));
        std::fs::read_to_string(&path).unwrap()
    };
    let drawn = draw(&["--view", "forces", "--part", "causes", "--show", "O"]);
    let found = json(&["analyze", "shaper.toml", "--plans", "0"]);
    // The weights alone: what the plans of the position say of the same joint.
    let shares = found["plans"][0]["by_cause"]["shares"].as_array().unwrap().clone();
    for (number, share) in shares.iter().enumerate() {
        let here = share["reactions"]
            .as_array()
            .unwrap()
            .iter()
            .find(|of| of["joint"] == "O" && of["on"] == "crank");
        let [x, y] = vector(&here.unwrap()["force"]);
        let told = format!("{} {} ", number + 1, share["cause"].as_str().unwrap());
        let size = drawn.split_once(&told).map(|(_, rest)| {
            let digits =
                rest.trim_start().split(|letter: char| letter != '.' && !letter.is_ascii_digit()).next();
            digits.unwrap().parse::<f64>().unwrap()
        });
        assert_eq!(size.is_some(), x.hypot(y) > 0.0, "{told}");
        assert!(size.is_none_or(|size| (size - x.hypot(y)).abs() < 1e-4 * size), "{told}{size:?}");
    }
    let drawn = draw(&["--view", "plans", "--part", "accelerations"]);
    // Subscripts and superscripts have tags of their own.
    let drawn: String =
        drawn.split('<').map(|part| part.split_once('>').map_or(part, |(_, rest)| rest)).collect();
    for name in ["anAO", "atS3C", "acA2A3"] {
        assert!(drawn.contains(name), "{name}");
    }
}
