//! Motion and drive through the program: published and closed-form results, failures, files.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use std::f64::consts::PI;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

const SCENES: [&str; 12] = [
    "brake",
    "run-up",
    "disc-case-2-speed",
    "disc-case-2-time",
    "disc-case-3",
    "disc-case-4",
    "disc-case-5",
    "flywheel",
    "shaper-drive",
    "andrews",
    "n-four-bar-2",
    "n-four-bar-40",
];

fn fixture(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures").join(name).with_extension("toml")
}

fn assur(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_assur")).args(arguments).env("LC_ALL", "C.UTF-8").output().unwrap()
}

fn err(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

fn analyzed_with(name: &str, more: &[&str]) -> Value {
    let path = fixture(name);
    let output = assur(&[&["analyze", path.to_str().unwrap(), "--format", "json"], more].concat());
    assert_eq!(output.status.code(), Some(0), "{name}: {}", err(&output));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn analyzed(name: &str) -> Value {
    analyzed_with(name, &[])
}

/// A variant of a fixture in a file of its own.
fn variant(name: &str, changes: &[(&str, &str)]) -> tempfile::NamedTempFile {
    let text = std::fs::read_to_string(fixture(name)).unwrap();
    let text = changes.iter().fold(text, |text, (from, to)| {
        assert!(text.contains(from), "{name} has no {from}");
        text.replace(from, to)
    });
    let file = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(file.path(), text).unwrap();
    file
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

fn near(found: &Value, wanted: f64, relative: f64) {
    let found = number(found);
    assert!((found - wanted).abs() <= relative * wanted.abs(), "{found} instead of {wanted}");
}

fn last(found: &Value) -> &Value {
    found["trajectory"].as_array().unwrap().last().unwrap()
}

#[test]
fn the_brake_stops_after_50_s_and_2500_rad() {
    let found = analyzed("brake");
    assert_eq!(found["trajectory"].as_array().unwrap().len(), 101);
    near(&last(&found)["time"], 50.0, 1e-9);
    near(&last(&found)["coordinate"], 2500.0, 1e-9);
    near(&last(&found)["links"]["disc"]["pf0"], 2500.0, 1e-9);
    assert_eq!(found["integration"]["case"], 1);
}

#[test]
fn the_run_up_of_example_1() {
    let found = analyzed("run-up");
    near(&last(&found)["speed"], (1000.0 * PI).sqrt(), 1e-9);
    near(&found["integration"]["energy"]["kinetic_end"], 50.0 * PI, 1e-9);
}

#[test]
fn the_flywheel_of_example_2() {
    let found = analyzed("flywheel");
    let dynamics = &found["dynamics"];
    near(&dynamics["torque"], -20.0, 1e-9);
    near(&dynamics["flywheel"], PI / 20.0, 1e-9);
    near(&dynamics["coordinate_at_min"], PI / 2.0, 1e-9);
    near(&dynamics["coordinate_at_max"], 1.5 * PI, 1e-9);
    near(&dynamics["excess_work"], 10.0 * PI, 1e-9);
    near(&dynamics["dynamic_unevenness"], 0.04 / PI, 1e-9);
    near(&dynamics["mean_speed"], 100.0, 1e-9);
    near(&dynamics["unevenness"], 0.02, 1e-9);
    // E eq. 10 is exact for a flywheel that is the only inertia, but for the variation of the speed (δ²/4).
    near(&dynamics["flywheel_by_method"]["excess-work"], PI / 20.0, 1e-4);
    // The flywheel takes what the moments leave: Mb = -20 - J e.
    for position in found["positions"].as_array().unwrap() {
        let inertia = PI / 20.0 * number(&position["acceleration"]);
        assert!((number(&position["balancing"]) + 20.0 + inertia).abs() < 1e-8, "{position}");
    }
}

#[test]
fn the_shaper_with_its_drive() {
    let found = analyzed("shaper-drive");
    let dynamics = &found["dynamics"];
    // An independent solution.
    near(&dynamics["flywheel"], 101.9001, 1e-6);
    near(&dynamics["ratio"], 24.33661, 1e-6);
    near(&dynamics["mean_speed"], 2.0 * PI, 1e-9);
    near(&dynamics["unevenness"], 0.05, 1e-9);
    // Work of 1500 N over 0.9 of the stroke of 0.35 m, through a reducer of 0.95, once a second.
    near(&dynamics["required_power"], 1500.0 * 0.9 * 0.35 / 0.95, 1e-3);
    let [low, high] = ["speed_min", "speed_max"].map(|key| number(&dynamics[key]));
    for position in found["positions"].as_array().unwrap() {
        let speed = number(&position["speed"]);
        assert!(low <= speed && speed <= high, "{low} {speed} {high}");
        assert!(position["reactions"]["A"]["crank"].is_array());
    }
    let warnings = dynamics["motor"]["warnings"].as_array().unwrap();
    assert!(warnings.iter().any(|warning| warning.as_str().unwrap().contains("starting torque")));
    let course = found["trajectory"].as_array().unwrap();
    near(&last(&found)["speed"], number(&course[0]["speed"]), 1e-12);
    near(&last(&found)["links"]["crank"]["pf0"], 2.0 * PI, 1e-12);
}

/// The acceleration is the derivative of the speed in the positions: w dw/dq by central differences of the course.
#[test]
fn accelerations_of_the_regime_belong_to_its_speeds() {
    let found = analyzed("flywheel");
    let course = found["trajectory"].as_array().unwrap();
    let step = 2.0 * PI / (course.len() - 1) as f64;
    for triple in course.windows(3) {
        let [before, now, after] = [0, 1, 2].map(|i| number(&triple[i]["speed"]));
        let coordinate = number(&triple[1]["coordinate"]);
        // The moment has kinks at 0 and 180 degrees.
        if (coordinate - PI).abs() > 1.5 * step {
            let wanted = now * (after - before) / (2.0 * step);
            assert!((number(&triple[1]["acceleration"]) - wanted).abs() < 0.05, "{coordinate}");
        }
    }
}

#[test]
fn andrews_benchmark() {
    let found = analyzed("andrews");
    assert_eq!(found["trajectory"].as_array().unwrap().len(), 5);
    near(&last(&found)["coordinate"], 15.810_771_195_153_71, 1e-8);
    near(&last(&found)["speed"], 1_139.920_302_259_106, 1e-8);
    for method in ["dop853", "dopri5", "radau5"] {
        let found = analyzed_with("andrews", &["--integrator", method]);
        assert_eq!(found["integration"]["method"], method);
        near(&last(&found)["coordinate"], 15.810_771_195_153_71, 1e-6);
    }
}

#[test]
fn parallelograms_keep_their_branch() {
    let found = analyzed("n-four-bar-2");
    let end = last(&found);
    let place = &end["points"]["B0"]["pf0"];
    // A published benchmark.
    assert!((number(&place[0]) - 0.328_458_111_540_815).abs() < 1e-6, "{place}");
    assert!((number(&place[1]) - 0.944_518_538_178_601).abs() < 1e-6, "{place}");
    for (point, shift) in [("B1", 1.0), ("B2", 2.0)] {
        let other = &end["points"][point]["pf0"];
        assert!((number(&other[0]) - number(&place[0]) - shift).abs() < 1e-9);
        assert!((number(&other[1]) - number(&place[1])).abs() < 1e-9);
    }
    assert!(number(&found["integration"]["energy"]["change"]) < 1e-7);
}

#[test]
fn forty_parallelograms_have_reactions_of_a_bearable_size() {
    let found = analyzed("n-four-bar-40");
    assert!(number(&found["integration"]["energy"]["change"]) < 1e-7);
    let mut largest = 0.0_f64;
    for row in found["trajectory"].as_array().unwrap() {
        let Some(reactions) = row.get("reactions") else { continue };
        for force in
            reactions.as_object().unwrap().values().flat_map(|pair| pair.as_object().unwrap().values())
        {
            largest = largest.max(number(&force[0]).hypot(number(&force[1])));
        }
    }
    // 81 links of 1 kg at some 4 rad/s: weights and inertia together are below 10 kN.
    assert!(largest > 10.0 && largest < 1e4, "{largest}");
}

#[test]
fn no_reactions_are_given_at_a_change_point() {
    // Prescribed motion through the flat positions 6 and 18 of 24.
    let scene = variant(
        "n-four-bar-2",
        &[("kind = \"transient\"", "kind = \"prescribed\""), ("until = \"10 s\"\nsamples = 400\n", "")],
    );
    let output = assur(&["analyze", scene.path().to_str().unwrap(), "--format", "json"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    assert_eq!(err(&output), "");
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    let notes: Vec<_> =
        found["notes"].as_array().unwrap().iter().map(|note| note["text"].as_str().unwrap()).collect();
    assert!(notes.iter().any(|note| note.starts_with("No reactions in positions 6, 18")), "{notes:?}");
    let without = |index: usize| found["positions"][index].get("reactions").is_none();
    assert_eq!((0..24).filter(|index| without(*index)).collect::<Vec<_>>(), [6, 18]);
    assert_eq!(assur(&["check", scene.path().to_str().unwrap()]).status.code(), Some(0));
}

/// D 3.22: 2500 rad are 398 turns; E example 1: five turns. A motion along the falling coordinate has negative turns.
#[test]
fn turns_of_a_motion_are_told() {
    near(&analyzed("brake")["integration"]["turns"], 1250.0 / PI, 1e-12);
    near(&analyzed("run-up")["integration"]["turns"], 5.0, 1e-12);
    let back = variant("brake", &[("speed = 100", "speed = -100")]);
    let output = assur(&["analyze", back.path().to_str().unwrap(), "--format", "json"]);
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    near(&found["integration"]["turns"], -1250.0 / PI, 1e-12);
}

#[test]
fn every_check_holds() {
    for scene in SCENES {
        let output = assur(&["check", fixture(scene).to_str().unwrap()]);
        let text = String::from_utf8(output.stdout.clone()).unwrap();
        assert_eq!(output.status.code(), Some(0), "{scene}\n{text}{}", err(&output));
        let motion = ["flywheel", "shaper-drive"].contains(&scene);
        assert!(
            text.contains(if motion { "cycle in time" } else { "work and kinetic energy" }),
            "{scene}\n{text}"
        );
    }
}

#[test]
fn an_integrator_that_cannot_do_a_scene_says_why() {
    let run_up = fixture("run-up");
    for command in ["analyze", "check", "explain"] {
        let output = assur(&[command, run_up.to_str().unwrap(), "--integrator", "closed-form"]);
        assert_eq!(output.status.code(), Some(2), "{command}");
        assert!(err(&output).contains("closed form needs J and M constant"), "{}", err(&output));
    }
    let output = assur(&["analyze", run_up.to_str().unwrap(), "--integrator", "magic"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(err(&output).contains("radau5"));
}

/// J = 1e-4 kg m² against -1000 N m s: 1e7 1/s, so an explicit method would need millions of steps.
#[test]
fn a_stiff_motion_goes_to_the_implicit_method() {
    let scene = variant(
        "run-up",
        &[
            ("inertia = 0.1", "inertia = 1e-4"),
            (
                "value = { over = \"angle\", table = [[0, 30], [\"5 rev\", 0]], repeat = false }",
                "value = { over = \"speed\", table = [[0, 1e5], [200, -1e5]] }",
            ),
            ("until = \"5 rev\"", "until = \"1 s\""),
            // Not of the speed alone, which would be one quadrature; at the end, 5.7 rad after 15 turns, it is 10 N m again.
            (
                "value = -10",
                "value = { over = \"angle\", table = [[0, -10], [1, -10], [2, -9], [3, -10], [\"1 rev\", -10]] }",
            ),
        ],
    );
    let path = scene.path().to_str().unwrap();
    let output = assur(&["analyze", path, "--format", "json"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(found["integration"]["method"], "radau5");
    assert!(found["integration"]["reason"].as_str().unwrap().contains("stiff"));
    // Where driving and 10 N m of resistance are equal: 1e5 - 1000 w = 10.
    near(&last(&found)["speed"], 99.99, 1e-9);
    let explicit = assur(&["analyze", path, "--integrator", "dop853"]);
    assert_eq!(explicit.status.code(), Some(1));
    assert!(err(&explicit).contains("radau5"), "{}", err(&explicit));
}

/// A shipped scene, what is replaced in it by what, and a word of the answer.
type Case<'a> = (&'a str, &'a [(&'a str, &'a str)], &'a str);

#[test]
fn what_has_no_solution_ends_with_1_and_words() {
    let given = [("ratio = \"solve\"", "ratio = 3"), ("flywheel = \"solve\"", "flywheel = 5")];
    let cases: [Case<'_>; 4] = [
        ("shaper-drive", &given, "comes to rest"),
        ("shaper-drive", &[("1500]", "15000]")], "too weak"),
        ("flywheel", &[("torque = \"balance\"", "torque = 5")], "no steady regime"),
        ("brake", &[("[input]", "[[moment]]\nlink = \"disc\"\nvalue = 1.6\n\n[input]")], "never reached"),
    ];
    for (name, changes, words) in cases {
        let scene = variant(name, changes);
        for command in ["analyze", "check"] {
            let output = assur(&[command, scene.path().to_str().unwrap()]);
            assert_eq!(output.status.code(), Some(1), "{name} {words}: {}", err(&output));
            assert!(err(&output).contains(words), "{name}: {}", err(&output));
        }
    }
}

#[test]
fn explain_tells_case_and_method() {
    let told = |name: &str| {
        let output = assur(&["explain", fixture(name).to_str().unwrap()]);
        assert_eq!(output.status.code(), Some(0));
        String::from_utf8(output.stdout).unwrap().split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let brake = told("brake");
    assert!(brake.contains("integrator `closed-form`, case 1 of D (J constant, M constant)"));
    // A closed form has no steps that stiffness could shorten.
    assert!(brake.contains("dJ/dq is exactly zero and not computed") && !brake.contains("stiff"), "{brake}");
    assert!(told("run-up").contains("case 2 of D"));
    assert!(told("andrews").contains("integrator `energy`, case 3 of D (J(q), M(q))"));
    let shaper = told("shaper-drive");
    assert!(
        shaper.contains("to be found: the gear ratio, the flywheel")
            && shaper.contains("case 5 of D (J(q), M(q, w)): shooting"),
        "{shaper}"
    );
    assert!(told("flywheel").contains("case 2 of D (J constant, M(q)): shooting"));
}

#[test]
fn the_report_tells_motion_and_drive() {
    let report = |name: &str| {
        let output = assur(&["analyze", fixture(name).to_str().unwrap(), "--ascii"]);
        assert!(output.stdout.is_ascii());
        let text = String::from_utf8(output.stdout).unwrap();
        assert!(text.lines().all(|line| line.len() <= 120), "{name}");
        text
    };
    let shaper = report("shaper-drive");
    for words in [
        "Steady regime",
        "Iteration to the periodic regime",
        "Trials of ratio and flywheel",
        "Drive and flywheel",
        "Mertsalov",
        "The two possible locations of the flywheel",
        "Warning: starting torque",
        "reduced to point A",
    ] {
        assert!(shaper.contains(words), "{words}");
    }
    let brake = report("brake");
    assert!(brake.contains("closed-form") && brake.contains("50 s, 2500 rad"), "{brake}");
}

#[test]
fn the_trajectory_is_written_as_csv() {
    let folder = tempfile::tempdir().unwrap();
    let target = folder.path().join("out");
    let path = fixture("andrews");
    let output =
        assur(&["analyze", path.to_str().unwrap(), "--format", "csv", "-o", target.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    let text = std::fs::read_to_string(target.join("trajectory.csv")).unwrap();
    let header: Vec<_> = text.lines().next().unwrap().split(',').collect();
    let names = ["time_s", "coordinate_rad", "K1_angle_rad", "E_x_m", "K3_w_rad_per_s", "O_K1_fx_N"];
    assert!(names.iter().all(|name| header.contains(name)), "{header:?}");
    let end: Vec<_> = text.lines().last().unwrap().split(',').collect();
    assert_eq!((text.lines().count(), end.len()), (6, header.len()));
    assert!((end[1].parse::<f64>().unwrap() - 15.810_771_195_153_71).abs() < 1e-7);
}

#[test]
fn the_scene_bounds_the_steps_of_its_motion() {
    let allowed = |steps: usize| {
        let change = format!("until = \"5 rev\"\nintegrator = \"dopri5\"\nmax_steps = {steps}");
        let scene = variant("run-up", &[("until = \"5 rev\"", &change)]);
        assur(&["analyze", scene.path().to_str().unwrap(), "--format", "json", "--checks", "none"])
    };
    let few = allowed(3);
    assert_eq!(few.status.code(), Some(1));
    assert!(err(&few).contains("in 3 steps") && err(&few).contains("`max_steps`"), "{}", err(&few));
    assert_eq!(allowed(10_000).status.code(), Some(0));
}
