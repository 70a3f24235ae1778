//! The library against the results that the shipped scenes carry of another program, and against itself by another way.

use std::num::NonZeroUsize;

use assur_fixtures::scene;
use serde_json::Value;

use crate::prelude::*;
use crate::{Numbering, PointTable};

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
    let conditions = vec!["transmission > 60 deg".to_owned()];
    let options =
        SweepOptions { measures: vec!["transmission".to_owned()], conditions, ..SweepOptions::default() };
    let kept = scene.sweep_with(&[key], &options, &mut || true).unwrap();
    let angles = |rows: &SweepRows| rows.column("least_transmission_angle_rad").unwrap().to_vec();
    let of_whole = angles(&whole);
    let wanted: Vec<usize> =
        (0..of_whole.len()).filter(|point| of_whole[*point] > 60_f64.to_radians()).collect();
    assert!((1..21).contains(&wanted.len()), "{of_whole:?}");
    assert_eq!((whole.points().len(), kept.points()), (21, &wanted[..]));
    assert_eq!(angles(&kept), wanted.iter().map(|point| of_whole[*point]).collect::<Vec<_>>());
}

#[test]
fn points_of_a_table_are_those_of_ranges() {
    let (scene, key) = (shipped("four-bar"), "link.crank.points.A");
    let whole = scene.sweep(&["link.crank.points.A=50 mm,70 mm,90 mm"], &["transmission"]).unwrap();
    let mut points = PointTable::new("table", Numbering::Rows, [key]);
    for (row, cell) in ["50 mm", "0.07", "9 cm"].into_iter().enumerate() {
        points.push(row, [cell]).unwrap();
    }
    let measures = vec!["transmission".to_owned()];
    let options = SweepOptions { measures, points: Some(points), ..SweepOptions::default() };
    let rows = scene.sweep_with(&[], &options, &mut || true).unwrap();
    let angles = |rows: &SweepRows| rows.column("least_transmission_angle_rad").unwrap().to_vec();
    assert_eq!((rows.len(), angles(&rows)), (3, angles(&whole)));
    assert!(scene.sweep_with(&["link.coupler.mass=1,2"], &options, &mut || true).is_err());
}

#[test]
fn columns_have_the_names_of_csv_and_no_others() {
    let results = shipped("shaper-friction").analyze().unwrap();
    let names = results.positions.names();
    let has_number = |name: &String| results.column(name).unwrap().iter().any(|number| number.is_finite());
    // What some rows lack may be lacked by all; here that is not so.
    assert!(names.iter().all(has_number), "{names:?}");
    let run_up = shipped("run-up").analyze().unwrap().motion;
    assert_eq!(run_up.names()[0], "time_s");
    assert!(!run_up.is_empty() && !run_up.names().iter().any(|name| name.starts_with("balancing")));
}

#[test]
fn a_reaction_is_an_error_where_nothing_is_known_of_it() {
    let still = "[ground]\npoints = { O = 0 }\n[link.crank]\npoints = { O = 0, A = 0.1 }\n[input]\nlink = \"crank\"\n";
    let error = Scene::parse("still.toml", still).unwrap().analyze().unwrap().reaction("O").unwrap_err();
    assert!(error.message.contains("no pair with a known force"), "{error}");
}

#[test]
fn a_sweep_follows_its_options() {
    let scene = shipped("four-bar");
    let vary = ["link.coupler.mass=2 kg..3 kg"];
    let options = SweepOptions {
        measures: vec!["distance".to_owned()],
        ties: vec!["link.rocker.mass=link.coupler.mass*0.5".to_owned()],
        targets: vec!["B=300 mm,100 mm".to_owned()],
        sample: NonZeroUsize::new(9),
        seed: 3,
        ..SweepOptions::default()
    };
    let whole = scene.sweep_with(&vary, &options, &mut || true).unwrap();
    let [masses, halves] =
        ["link.coupler.mass_kg", "link.rocker.mass_kg"].map(|name| whole.column(name).unwrap());
    assert_eq!(whole.len(), 9);
    assert!(masses.iter().zip(halves).all(|(mass, half)| near(*half, 0.5 * mass, 1.0)));
    assert!(whole.column("B_distance_1_least_m").unwrap().iter().all(|distance| *distance > 0.0));
    let parts = [1, 2].map(|part| {
        let part = NonZeroUsize::new(part).zip(NonZeroUsize::new(2));
        let one = NonZeroUsize::new(1);
        scene
            .sweep_with(&vary, &SweepOptions { part, threads: one, ..options.clone() }, &mut || true)
            .unwrap()
    });
    let both: Vec<f64> =
        parts.iter().flat_map(|part| part.column("link.coupler.mass_kg").unwrap()).copied().collect();
    assert_eq!(both, masses);
    assert!(whole.is_text("status").unwrap() && !whole.is_text("failed_positions").unwrap());
    assert!(whole.is_text("statu").unwrap_err().message.contains("did you mean `status`"));
    assert!(
        whole.column("status").is_err() && whole.texts("status").unwrap().iter().all(|text| text == "ok")
    );
}

#[test]
fn a_sweep_of_which_no_point_is_a_scene_is_an_error() {
    let error = shipped("four-bar").sweep(&["link.crank.mass=-2 kg..-1 kg:2"], &[]).unwrap_err();
    assert!(error.message.contains("link.crank.mass"), "{error}");
}

#[test]
fn long_work_ends_when_it_is_told_to() {
    let scene = shipped("four-bar").with("input.positions", "300000").unwrap();
    assert!(scene.analyze_while(&mut || false).is_err());
    let mut asked = 0;
    let mut twice = || {
        asked += 1;
        asked < 2
    };
    let vary = ["link.coupler.mass=2 kg..3 kg:1000"];
    assert!(shipped("four-bar").sweep_with(&vary, &SweepOptions::default(), &mut twice).is_err());
    assert_eq!(asked, 2);
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
