//! The library against the results that the shipped scenes carry of another program, and against itself by another way.

use assur_fixtures::scene;
use serde_json::Value;

use crate::prelude::*;

fn shipped(name: &str) -> Scene {
    Scene::parse(&format!("{name}.toml"), scene(name)).unwrap()
}

/// The independent results of the shaper.
fn reference() -> Value {
    serde_json::from_str(include_str!("../../../fixtures/shaper.json")).unwrap()
}

fn near(one: f64, other: f64, size: f64) -> bool {
    (one - other).abs() <= 1e-9 * size
}

#[test]
fn positions_in_a_loop_are_those_of_another_program() {
    let (scene, reference) = (shipped("shaper"), reference());
    let rows = reference["positions"].as_array().unwrap();
    assert!(!rows.is_empty());
    for row in rows {
        let position = scene.at(row["coordinate"].as_f64().unwrap()).unwrap();
        for (name, of) in row["points"].as_object().unwrap() {
            let found = position.transfer(name).unwrap();
            for (key, found) in ["pf0", "pf1", "pf2"].into_iter().zip(found) {
                for (axis, found) in found.into_iter().enumerate() {
                    assert!(near(found, of[key][axis].as_f64().unwrap(), 1.0), "{name} {key}");
                }
            }
        }
    }
}

#[test]
fn reactions_by_the_name_of_a_pair_are_those_of_another_program() {
    let (results, reference) = (shipped("shaper").analyze().unwrap(), reference());
    let rows = reference["positions"].as_array().unwrap();
    let mut compared = 0;
    for (row, number) in results.positions.numbers().iter().enumerate() {
        for (pair, sides) in rows[*number]["reactions"].as_object().unwrap() {
            let found = results.reaction(pair).unwrap();
            let Some(force) = sides[found.on].as_array() else { continue };
            assert!(near(found.x[row], force[0].as_f64().unwrap(), 1e4), "{pair} {number}");
            assert!(near(found.y[row], force[1].as_f64().unwrap(), 1e4), "{pair} {number}");
            compared += 1;
        }
    }
    assert!(compared > 100, "{compared}");
}

#[test]
fn columns_have_the_places_of_the_loop() {
    let scene = shipped("four-bar");
    let results = scene.analyze().unwrap();
    let [x, y] = ["B_x_m", "B_y_m"].map(|name| results.column(name).unwrap());
    for (row, coordinate) in scene.coordinates().enumerate() {
        let place = scene.at(coordinate).unwrap().point("B").unwrap();
        assert!(near(x[row], place[0], 1.0) && near(y[row], place[1], 1.0), "{row}");
    }
}

#[test]
fn very_many_positions_are_all_there() {
    let many = shipped("four-bar").with("input.positions", "300000").unwrap();
    let results = many.analyze().unwrap();
    assert_eq!(results.positions.len(), 300_000);
    let last = *results.positions.numbers().last().unwrap();
    let place = many.at(many.coordinates().last().unwrap()).unwrap().point("B").unwrap();
    assert!(near(results.column("B_x_m").unwrap()[last], place[0], 1.0));
}

#[test]
fn a_point_of_a_sweep_is_the_scene_with_its_value() {
    let scene = shipped("four-bar");
    let key = "link.crank.points.A";
    let rows = scene.sweep(&[&format!("{key}=50 mm..90 mm:3")], &["positions.points"]).unwrap();
    let lengths = rows.column(&format!("{key}_m")).unwrap();
    let greatest = rows.column("B_x_max_m").unwrap();
    for (row, length) in lengths.iter().enumerate() {
        let results = scene.with(key, &length.to_string()).unwrap().analyze().unwrap();
        let own = results.column("B_x_m").unwrap().iter().copied().fold(f64::MIN, f64::max);
        assert!(near(greatest[row], own, 1.0), "{length}: {} {own}", greatest[row]);
        assert_eq!(rows.statuses()[row], "ok");
    }
}

#[test]
fn rows_that_hold_a_condition_have_the_numbers_of_the_whole_sweep() {
    let (scene, key) = (shipped("four-bar"), "link.crank.points.A=50 mm..90 mm:21");
    let whole = scene.sweep(&[key], &["transmission"]).unwrap();
    let kept = scene.sweep_where(&[key], &["transmission"], &["transmission > 60 deg"]).unwrap();
    let angles = |rows: &SweepRows| rows.column("least_transmission_angle_rad").unwrap().to_vec();
    let of_whole = angles(&whole);
    let wanted: Vec<usize> =
        (0..of_whole.len()).filter(|point| of_whole[*point] > 60_f64.to_radians()).collect();
    assert!((1..21).contains(&wanted.len()), "{of_whole:?}");
    assert_eq!((whole.points().len(), kept.points()), (21, &wanted[..]));
    assert_eq!(angles(&kept), wanted.iter().map(|point| of_whole[*point]).collect::<Vec<_>>());
}

#[test]
fn an_error_has_its_place_and_key() {
    let text = scene("four-bar").replacen("mass = \"1.4 kg\"", "mass = \"4 mm\"", 1);
    let error = Scene::parse("a.toml", &text).unwrap_err();
    let line = 1 + text.lines().position(|line| line.starts_with("mass = \"4 mm\"")).unwrap();
    assert_eq!((error.file.as_deref(), error.line), (Some("a.toml"), Some(line)), "{error}");
    assert_eq!(error.key.as_deref(), Some("link.crank.mass"));
    assert!(error.message.contains("mm"), "{error}");
    let scene = shipped("four-bar");
    assert!(scene.at(0.0).unwrap().point("b").unwrap_err().to_string().contains("did you mean `B`"));
    assert!(Scene::read("no-such-file.toml").unwrap_err().message.contains("no-such-file.toml"));
}
