use assur_all as _;
use assur_group::Order;
use serde_json::Value;

use crate::{Linkage, continuous_angle, mobility_in};

/// A scene of the fixtures, compiled.
fn linkage(name: &str) -> Linkage {
    let path = format!("{}/../../fixtures/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap();
    Linkage::compile(assur_scene::read(name, &text).unwrap()).unwrap()
}

/// Its results by an independent method.
fn expected(name: &str) -> Value {
    let path = format!("{}/../../fixtures/{name}.json", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(list) => list.iter().map(|v| v.as_f64().unwrap()).collect(),
        other => vec![other.as_f64().unwrap()],
    }
}

/// Largest deviation of each quantity, relative to its largest value over all positions.
#[derive(Default)]
struct Deviation {
    worst: std::collections::BTreeMap<String, (f64, f64)>,
}

impl Deviation {
    fn add(&mut self, quantity: &str, found: &[f64], wanted: &Value) {
        for (f, w) in found.iter().zip(numbers(wanted)) {
            let entry = self.worst.entry(quantity.to_owned()).or_insert((0.0, 0.0));
            entry.0 = entry.0.max((f - w).abs());
            entry.1 = entry.1.max(w.abs());
        }
    }

    fn assert_within(&self, scene: &str, limit: f64) {
        assert!(!self.worst.is_empty());
        for (quantity, (error, largest)) in &self.worst {
            // A quantity that is zero throughout is compared with 1.
            let scale = if *largest > 1e-9 { *largest } else { 1.0 };
            assert!(error / scale <= limit, "{scene}: {quantity} deviates by {error:e} of {largest:e}");
        }
    }
}

#[test]
fn positions_agree_with_the_independent_results() {
    for scene in ["shaper", "guide-shaper", "slider-crank", "conveyor", "stephenson3", "press"] {
        let linkage = linkage(scene);
        let mut position = linkage.position();
        let mut deviation = Deviation::default();
        let mut angles = vec![None; linkage.mechanism.links.len()];
        for (i, wanted) in expected(scene)["positions"].as_array().unwrap().iter().enumerate() {
            linkage.solve_index(i, Order::Second, &mut position).unwrap();
            deviation.add("coordinate", &[position.coordinate], &wanted["coordinate"]);
            for (id, point) in linkage.mechanism.points.iter().enumerate() {
                let (found, wanted) =
                    (linkage.point_motion(id, &position), &wanted["points"][point.name.as_str()]);
                deviation.add("points pf0", &found.pf0, &wanted["pf0"]);
                deviation.add("points pf1", &found.pf1, &wanted["pf1"]);
                deviation.add("points pf2", &found.pf2, &wanted["pf2"]);
            }
            for (id, link) in linkage.mechanism.links.iter().enumerate().skip(1) {
                let (found, wanted) =
                    (linkage.link_motion(id, &position), &wanted["links"][link.name.as_str()]);
                let angle = angles[id].map_or(found.pf0, |before| continuous_angle(found.pf0, before));
                angles[id] = Some(angle);
                deviation.add("links pf0", &[angle], &wanted["pf0"]);
                deviation.add("links pf1", &[found.pf1], &wanted["pf1"]);
                deviation.add("links pf2", &[found.pf2], &wanted["pf2"]);
            }
            for (id, slide) in linkage.mechanism.slides.iter().enumerate() {
                let found = linkage.slide_motion(id, &position);
                deviation.add("slides pf0", &[found.pf0], &wanted["slides"][slide.name.as_str()]["pf0"]);
            }
        }
        deviation.assert_within(scene, 1e-11);
    }
}

#[test]
fn slides_differentiate() {
    for scene in ["shaper", "guide-shaper", "stephenson3"] {
        let linkage = linkage(scene);
        let mut position = linkage.position();
        let mut at = |slide, q: f64| {
            linkage.solve(q, Order::Second, &mut position).unwrap();
            linkage.slide_motion(slide, &position)
        };
        let h = 1e-5;
        for slide in 0..linkage.mechanism.slides.len() {
            for i in 0..12 {
                let q = f64::from(i) * 0.5 + 0.1;
                let (before, now, after) = (at(slide, q - h), at(slide, q), at(slide, q + h));
                assert!((now.pf1 - (after.pf0 - before.pf0) / (2.0 * h)).abs() < 1e-8);
                assert!((now.pf2 - (after.pf1 - before.pf1) / (2.0 * h)).abs() < 1e-8);
            }
        }
    }
}

#[test]
fn parallelograms_stay_parallel_through_the_flat_positions() {
    for scene in ["n-four-bar-2", "n-four-bar-40"] {
        let linkage = linkage(scene);
        let mut position = linkage.position();
        // In a parallelogram every rocker has the angle of the input, every coupler the angle 0: exactly known.
        for i in -400..=400_i32 {
            let q = f64::from(i) * 0.017_453_292_519_943_295 * 0.9;
            linkage.solve(q, Order::Second, &mut position).unwrap();
            for (id, link) in linkage.mechanism.links.iter().enumerate().skip(1) {
                let found = linkage.link_motion(id, &position);
                let (angle, rate) = if link.name.starts_with("rocker") { (q, 1.0) } else { (0.0, 0.0) };
                let off = continuous_angle(found.pf0, angle) - angle;
                assert!(off.abs() < 1e-10, "{scene}: {} at {q}: {off:e}", link.name);
                assert!((found.pf1 - rate).abs() < 1e-8, "{scene}: {} at {q}: {}", link.name, found.pf1);
                assert!(found.pf2.abs() < 1e-6, "{scene}: {} at {q}: {}", link.name, found.pf2);
            }
        }
        // Flat at 0 and 180 degrees, in every group.
        assert_eq!(linkage.change_points().count(), 2 * linkage.structure.groups.len());
    }
}

#[test]
fn rank_agrees_with_chebyshev_on_ordinary_mechanisms() {
    for scene in ["shaper", "conveyor", "stephenson3", "andrews"] {
        let linkage = linkage(scene);
        let mut position = linkage.position();
        linkage.solve_index(0, Order::Place, &mut position).unwrap();
        assert_eq!(mobility_in(&linkage, &position), 1, "{scene}");
        assert_eq!(linkage.structure.mobility.value, 1, "{scene}");
    }
}

/// Parallelograms one after the other, each joined to the rocker before.
fn ladder(groups: usize) -> String {
    let each = |count: usize, text: &dyn Fn(usize) -> String| (0..count).map(text).collect::<String>();
    let ground = each(groups + 1, &|i| format!("A{i} = {i}.0, "));
    let rockers = each(groups + 1, &|i| format!("[link.rocker{i}]\npoints = {{ A{i} = 0, B{i} = 1 }}\n"));
    let couplers = each(groups, &|i| format!("[link.coupler{i}]\npoints = {{ B{i} = 0, B{} = 1 }}\n", i + 1));
    let places = each(groups, &|i| format!("B{} = [{}.0, 1]\n", i + 1, i + 1));
    format!(
        "[ground]\npoints = {{ {ground} }}\n{rockers}{couplers}\
         [input]\nlink = \"rocker0\"\nfrom = \"90 deg\"\n[assembly]\n{places}"
    )
}

#[test]
fn mobility_in_a_flat_row_of_parallelograms_is_one_more_for_each() {
    // Flat, every parallelogram may go on in either way: its own constraints coincide.
    let linkage = Linkage::compile(assur_scene::read("ladder", &ladder(5)).unwrap()).unwrap();
    let mut position = linkage.position();
    linkage.solve(1.0, Order::Place, &mut position).unwrap();
    assert_eq!(mobility_in(&linkage, &position), 1);
    for body in &mut position.bodies[1..] {
        (body.c, body.s) = (1.0, 0.0);
    }
    for i in 0..=5 {
        // The rocker and the coupler past it, both along the ground.
        (position.bodies[1 + i].x, position.bodies[1 + i].y) = (i as f64, 0.0);
        if i < 5 {
            (position.bodies[7 + i].x, position.bodies[7 + i].y) = (i as f64 + 1.0, 0.0);
        }
    }
    assert_eq!(mobility_in(&linkage, &position), 6);
}

#[test]
fn a_long_ladder_is_followed_through_all_its_change_points() {
    let linkage = Linkage::compile(assur_scene::read("ladder", &ladder(150)).unwrap()).unwrap();
    assert_eq!(linkage.change_points().count(), 300);
    let mut position = linkage.position();
    for q in [0.0, 0.3, 3.0, 3.13, 6.2] {
        linkage.solve(q, Order::First, &mut position).unwrap();
        for rocker in 1..=151 {
            let found = linkage.link_motion(rocker, &position);
            assert!((continuous_angle(found.pf0, q) - q).abs() < 1e-9 && (found.pf1 - 1.0).abs() < 1e-6);
        }
    }
    assert_eq!(mobility_in(&linkage, &position), 1);
}

#[test]
fn the_end_of_assembly_is_found_to_the_digit() {
    // Crank 2, ground 3, coupler 1.5, rocker 1.5: assembles while the pins are at most 3 apart, cos q >= 1/3.
    let text = "[ground]\npoints = { O = [0, 0], C = [3, 0] }\n\
        [link.crank]\npoints = { O = 0, A = 2 }\n[link.coupler]\npoints = { A = 0, B = 1.5 }\n\
        [link.rocker]\npoints = { C = 0, B = 1.5 }\n[input]\nlink = \"crank\"\nfrom = 0.3\n";
    let linkage = Linkage::compile(assur_scene::read("range", text).unwrap()).unwrap();
    let mut position = linkage.position();
    let error = linkage.solve_index(6, Order::Second, &mut position).unwrap_err();
    let end = (1.0_f64 / 3.0).acos();
    let [low, high] = error.range.unwrap();
    assert!((high - end).abs() < 1e-7 && (low + end).abs() < 1e-7, "{low} {high} {end}");
    let shown = error.to_string();
    assert!(
        shown.starts_with("group 1 (RRR coupler, rocker), position 6, coordinate 197.1887 deg: no assembly"),
        "{shown}"
    );
}

#[test]
fn a_position_allocates_nothing() {
    for scene in ["shaper", "guide-shaper", "conveyor", "andrews", "n-four-bar-2"] {
        let linkage = linkage(scene);
        let mut position = linkage.position();
        let counted = allocation_counter::measure(|| {
            for i in 0..48 {
                linkage.solve(f64::from(i) * 0.13, Order::Second, &mut position).unwrap();
            }
        });
        assert_eq!(counted.count_total, 0, "{scene}");
    }
}
