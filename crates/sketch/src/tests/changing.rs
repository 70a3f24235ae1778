//! Points and guides that are moved, lengths that close, inputs that are chosen.

use assur_mechanism::Key;

use super::{Random, drawn, read};
use crate::reach::reaches_all;
use crate::{Fit, Sketch, Start, closings, drive, drives, move_guide, move_point, start, turn_guide};

fn apart(one: [f64; 2], other: [f64; 2]) -> f64 {
    (one[0] - other[0]).hypot(one[1] - other[1])
}

/// Moves a point; the others that keep their places.
fn moved(text: &str, before: &Sketch, point: &str, to: [f64; 2]) -> (Sketch, Vec<String>) {
    let text = move_point(text, before, point, to).unwrap();
    let after = drawn(&text);
    let there = after.place(point).unwrap();
    assert!(apart(there, to) < 1e-5, "{point} is at {there:?}, not at {to:?}:\n{text}");
    let stays = |(name, at): (&str, [f64; 2])| {
        (apart(after.place(name).unwrap(), at) < 1e-5).then(|| name.to_owned())
    };
    let stay = before.points().filter_map(stays).collect();
    (after, stay)
}

#[test]
fn a_moved_point_is_where_it_was_put_and_others_stay() {
    let mut random = Random(3);
    for (scene, points) in
        [("four-bar", &["A", "B", "K", "E"][..]), ("jansen", &["A"]), ("triad", &["B", "E", "T", "F"])]
    {
        let text = assur_fixtures::scene(scene);
        let before = drawn(text);
        let all = before.points().count();
        for point in points {
            for _ in 0..4 {
                let [x, y] = before.place(point).unwrap();
                let to = [x + random.range(-0.02, 0.02), y + random.range(-0.02, 0.02)];
                let (_, stay) = moved(text, &before, point, to);
                assert_eq!(stay.len(), all - 1, "{scene} {point}: {stay:?} stay");
            }
        }
    }
}

#[test]
fn a_link_that_is_written_as_a_length_keeps_its_form_and_the_input_follows() {
    let text = start(Start::CRANK);
    let text = move_point(&text, &drawn(&text), "A", [0.0, 0.25]).unwrap();
    assert!(text.contains("A = \"250 mm\"") && text.contains("from = \"90 deg\""), "{text}");
    let text = move_point(&text, &drawn(&text), "O", [0.1, 0.05]).unwrap();
    assert!(text.contains("O = [\"100 mm\", \"50 mm\"]") && text.contains("A = \"250 mm\""), "{text}");
    let place = drawn(&text).place("A").unwrap();
    assert!(apart(place, [0.1, 0.3]) < 1e-9, "{place:?}");
}

#[test]
fn stones_go_with_their_points_where_they_can() {
    let shaper = assur_fixtures::scene("shaper");
    let before = drawn(shaper);
    // The crank pin: the rocker turns after it, so that the stone keeps its form.
    let text = move_point(shaper, &before, "A", [0.08, 0.03]).unwrap();
    assert!(text.contains("points = { A = 0 }"), "{text}");
    moved(shaper, &before, "A", [0.08, 0.03]);
    // The pin of a piston: along its guide the rod is longer; beside it the piston gets an offset.
    let compressor = assur_fixtures::scene("slider-crank");
    let before = drawn(compressor);
    let [x, y] = before.place("B").unwrap();
    let text = move_point(compressor, &before, "B", [x, y + 0.02]).unwrap();
    assert!(text.contains("points = { B = 0 }"), "{text}");
    let (after, _) = moved(compressor, &before, "B", [x + 0.01, y + 0.02]);
    assert_eq!(after.guide("piston/ground"), before.guide("piston/ground"));
    // The input that slides follows its point.
    let text = start(Start::SLIDE);
    let (after, _) = moved(&text, &drawn(&text), "A", [0.03, 0.0]);
    assert!((after.coordinate - 0.03).abs() < 1e-9);
}

#[test]
fn guides_turn_and_move() {
    let text = assur_fixtures::scene("shaper");
    for slide in ["ram/ground", "stone4/ram", "stone2/rocker"] {
        let (through, angle) = drawn(text).guide(slide).unwrap();
        let turned = drawn(&turn_guide(text, &drawn(text), slide, 0.1).unwrap());
        // The link that carries the guide may turn too: in its frame the guide has turned by this.
        let carrier = |sketch: &Sketch| match slide {
            "ram/ground" => 0.0,
            "stone4/ram" => sketch.pose("ram").unwrap().angle,
            _ => sketch.pose("rocker").unwrap().angle,
        };
        let off = turned.guide(slide).unwrap().1 - carrier(&turned) - (angle - carrier(&drawn(text))) - 0.1;
        assert!(off.abs() < 2e-6, "{slide}: {off}");
        if slide == "ram/ground" {
            let moved = drawn(&move_guide(text, &drawn(text), slide, [0.01, 0.02]).unwrap());
            assert!(apart(moved.guide(slide).unwrap().0, [through[0] + 0.01, through[1] + 0.02]) < 1e-9);
        }
    }
}

#[test]
fn lengths_that_close_do_so_and_a_little_less_does_not() {
    let text = assur_fixtures::scene("four-bar").replace("B = \"210 mm\"", "B = \"120 mm\"");
    let keys = [
        "link.rocker.points.B",
        "link.coupler.points.B",
        "link.crank.points.A",
        "ground.points.C[0]",
        "ground.points.C[1]",
    ];
    let keys: Vec<Key> = keys.iter().map(|key| Key::parse(key).unwrap()).collect();
    let found = closings(&text, &keys);
    assert!(found.len() >= 2, "{found:?}");
    let reaches = |text: &str| {
        let linkage = assur_kinematics::Linkage::compile(read(text)).unwrap();
        linkage.range.is_some() && reaches_all(&linkage)
    };
    assert!(!reaches(&text));
    let everywhere = found.iter().filter(|closing| closing.fit == Fit::Everywhere);
    assert!(everywhere.clone().count() >= 2, "{found:?}");
    for closing in everywhere {
        let with = |toml: &str| assur_draft::set(&text, &closing.key, toml).unwrap();
        assert!(reaches(&with(&closing.toml)), "{closing:?}");
        let back = closing.to - 0.02 * closing.to.abs().copysign(closing.to - closing.from);
        assert!(!reaches(&with(&format!("\"{} mm\"", back * 1e3))), "{closing:?}");
    }
    let rocker = found.iter().find(|closing| closing.key == keys[0]).unwrap();
    // Grashof: the crank turns fully if 90 + longest <= sum of the other two; the ground has 322.5, the coupler 280.
    let least = 322.490_309_931_942_2 + 90.0 - 280.0;
    assert!((rocker.to * 1e3 / least - 1.01).abs() < 0.002, "{rocker:?}");
    assert!(closings(assur_fixtures::scene("four-bar"), &keys).is_empty());
}

#[test]
fn what_could_drive_drives_from_where_it_is() {
    for scene in ["four-bar", "shaper", "boom", "slider-crank"] {
        let text = assur_fixtures::scene(scene);
        // Not where the rod is as far to the side as it comes.
        let without = text.split("[motion]").next().unwrap().replace("positions = 24", "from = \"20 deg\"");
        let without = without.as_str();
        let before = drawn(without);
        let all = drives(&before.mechanism);
        assert!(all.iter().any(|drive| drive.on != 0), "{scene}");
        for one in &all {
            let present = one.coordinate(&before).unwrap();
            let text = drive(without, &before, one, present).unwrap();
            let driver = &read(&text).input.drivers[0];
            assert_eq!((driver.link, driver.on, driver.pair), (one.link, one.on, one.pair), "{text}");
            let after = drawn(&text);
            let off = one.coordinate(&after).unwrap() - present;
            let off = if one.is_angle() { crate::pose::reduced(off) } else { off };
            assert!(off.abs() < 1e-3, "{scene}: {present} {off}\n{text}");
            assert!(!one.words(&before.mechanism).is_empty());
        }
    }
}

/// A crank with its pin in polar form, a point at it, and a plate.
const PLATE: &str = r#"
[ground]
points = { O = 0, C = { r = "200 mm", angle = 0 } }
[link.crank]
points = { O = 0, A = { r = "50 mm", angle = "90 deg" }, E = { r = "20 mm", angle = 0, about = "A" } }
[link.rod]
points = { A = 0, B = "200 mm", P = { from = ["A", "B"], lengths = ["150 mm", "80 mm"] } }
[link.rocker]
points = { B = 0, C = "150 mm" }
[input]
link = "crank"
[assembly]
B = ["190 mm", "150 mm"]
"#;

#[test]
fn a_place_that_is_a_table_becomes_two_coordinates_where_its_point_is_moved() {
    let before = drawn(PLATE);
    // The pivot of the rocker, a point of interest, and the apex of the plate.
    let text = move_point(PLATE, &before, "C", [0.21, 0.01]).unwrap();
    assert_eq!(text, PLATE.replace("{ r = \"200 mm\", angle = 0 }", "[\"210 mm\", \"10 mm\"]"));
    let text = move_point(PLATE, &before, "E", [0.03, 0.06]).unwrap();
    let place = "{ r = \"20 mm\", angle = 0, about = \"A\" }";
    assert_eq!(text, PLATE.replace(place, "[\"30 mm\", \"60 mm\"]"));
    let [x, y] = before.place("P").unwrap();
    let (after, stay) = moved(PLATE, &before, "P", [x + 0.01, y]);
    assert_eq!(stay.len(), after.points().count() - 1);
    // What is given by a point follows it.
    let (after, _) = moved(PLATE, &before, "A", [0.0, 0.06]);
    assert!(apart(after.place("E").unwrap(), [0.02, 0.06]) < 1e-9);
    // A table below a header of its own, too.
    let place = "points = { O = 0, A = { r = \"50 mm\", angle = \"90 deg\" }, ";
    let header = "[link.crank.points.A]\nr = 0.05\nangle = \"90 deg\"\n[link.crank.points]\nO = 0\n";
    let own = PLATE.replace(&format!("[link.crank]\n{place}"), header).replace("\"A\" } }", "\"A\" }");
    moved(&own, &drawn(&own), "A", [0.0, 0.06]);
}

#[test]
fn a_point_is_not_moved_where_a_triangle_by_two_lengths_would_open() {
    let flat = PLATE.replace("\"80 mm\"] }", "\"51 mm\"] }");
    let before = drawn(&flat);
    let [x, y] = before.place("B").unwrap();
    let refused = move_point(&flat, &before, "B", [x + 0.05, y]).unwrap_err().to_string();
    assert!(refused.starts_with("the triangle of `P` has a gap of "), "{refused}");
}
