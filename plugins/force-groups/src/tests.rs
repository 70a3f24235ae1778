use assur_all as _;
use assur_force::{ForceAnalyzer, ForceError, LoadState, Loads, Reactions, joints, power};
use assur_group::{Order, Wrench};
use assur_kinematics::Linkage;
use serde_json::Value;

use crate::Groups;

fn scene(name: &str) -> String {
    let path = format!("{}/../../fixtures/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).unwrap()
}

fn compiled(text: &str) -> Linkage {
    Linkage::compile(assur_scene::read("test.toml", text).unwrap()).unwrap()
}

/// All loads and the reactions at one coordinate.
fn solve(
    linkage: &Linkage,
    q: f64,
) -> Result<(Reactions, Vec<Wrench<f64>>, assur_kinematics::Position), ForceError> {
    let loads = Loads::compile(linkage).unwrap();
    let mut position = linkage.position();
    linkage.solve(q, Order::Second, &mut position).unwrap();
    let state = LoadState::prescribed(&linkage.mechanism, q);
    let mut wrenches = vec![Wrench::ZERO; linkage.structure.links];
    loads.evaluate(&state, &position.bodies, &mut wrenches);
    let all = wrenches.clone();
    let mut out = Reactions::new(linkage);
    Groups.solve(linkage, &position, &mut wrenches, &mut out)?;
    Ok((out, all, position))
}

/// Largest deviation of each quantity, and its largest value.
#[derive(Default)]
struct Deviation(std::collections::BTreeMap<String, (f64, f64)>);

impl Deviation {
    fn add(&mut self, quantity: &str, found: &[f64], wanted: &Value) {
        let wanted = match wanted {
            Value::Array(list) => list.iter().map(|v| v.as_f64().unwrap()).collect(),
            other => vec![other.as_f64().unwrap()],
        };
        let entry = self.0.entry(quantity.to_owned()).or_insert((0.0, 0.0));
        for (f, w) in found.iter().zip(wanted) {
            *entry = (entry.0.max((f - w).abs()), entry.1.max(w.abs()));
        }
    }
}

#[test]
fn reactions_agree_with_the_independent_results() {
    for name in ["shaper", "guide-shaper", "slider-crank", "conveyor", "stephenson3", "press"] {
        let linkage = compiled(&scene(name));
        let path = format!("{}/../../fixtures/{name}.json", env!("CARGO_MANIFEST_DIR"));
        let wanted: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
        let mut deviation = Deviation::default();
        let mut largest = 0.0_f64;
        for (i, wanted) in wanted["positions"].as_array().unwrap().iter().enumerate() {
            let (out, ..) = solve(&linkage, linkage.mechanism.input.coordinate(i)).unwrap();
            deviation.add("balancing", &[out.balancing], &wanted["balancing"]);
            let joints = joints(&linkage.mechanism, &linkage.structure)
                .iter()
                .map(|joint| joint.reaction(&out.pairs))
                .collect::<Vec<_>>();
            assert_eq!(joints.len(), wanted["reactions"].as_object().unwrap().len());
            for joint in joints {
                let name = linkage.mechanism.pair_name(joint.joint);
                let wanted = &wanted["reactions"][name.as_str()];
                for (link, force) in &joint.forces {
                    largest = largest.max(force[0].hypot(force[1]));
                    let link = &linkage.mechanism.links[*link].name;
                    deviation.add(&format!("{name} on {link}"), force, &wanted[link.as_str()]);
                }
                if let Some(moment) = joint.moment {
                    deviation.add(&format!("{name} moment"), &[moment], &wanted["moment"]);
                }
            }
        }
        for (quantity, (error, size)) in deviation.0 {
            // A quantity that is zero throughout is compared with the largest force (at 1 m).
            let size = if size > 1e-9 * largest { size } else { largest };
            assert!(error <= 1e-10 * size, "{name}: {quantity} deviates by {error:e} of {size:e}");
        }
    }
}

#[test]
fn the_balancing_moment_is_minus_the_virtual_power_of_all_loads() {
    for name in ["shaper", "conveyor", "stephenson3", "press"] {
        let linkage = compiled(&scene(name));
        for i in 0..7 {
            let q = linkage.mechanism.input.coordinate(i);
            let (out, all, position) = solve(&linkage, q).unwrap();
            let each = all.iter().zip(&position.bodies).map(|(load, body)| power(load, body));
            let (sum, size) = each.fold((0.0, 0.0), |(sum, size): (f64, f64), p| (sum + p, size + p.abs()));
            assert!((out.balancing + sum).abs() <= 1e-12 * size, "{name}: {} and {sum}", out.balancing);
        }
    }
}

const SLIDER_CRANK: &str = r#"
[ground]
points = { O = 0 }
[link.crank]
points = { O = 0, A = 0.1 }
[link.rod]
points = { A = 0, B = 0.3 }
[link.piston]
points = { B = 0 }
[[slide]]
link = "piston"
on = "ground"
[[force]]
link = "piston"
at = "B"
angle = "180 deg"
value = 500
[assembly]
B = [0.35, 0]
"#;

#[test]
fn slider_crank_by_hand() {
    // Crank upright: sin psi = 1/3, the rod carries 500 / cos psi, the guide 500 tan psi, the crank 500 r.
    let linkage = compiled(&format!("{SLIDER_CRANK}\n[input]\nlink = \"crank\"\n"));
    let (out, ..) = solve(&linkage, std::f64::consts::FRAC_PI_2).unwrap();
    let tan = 1.0 / 8.0_f64.sqrt();
    assert!((out.balancing + 50.0).abs() < 1e-11, "{}", out.balancing);
    let joints = joints(&linkage.mechanism, &linkage.structure)
        .iter()
        .map(|joint| joint.reaction(&out.pairs))
        .collect::<Vec<_>>();
    let on = |joint: usize, link: &str| {
        let link = linkage.mechanism.link(link).unwrap();
        joints[joint].forces.iter().find(|(of, _)| *of == link).unwrap().1
    };
    // Points O, A, B, then the slide. The rod runs down from A to B and is pressed.
    for (found, wanted) in [
        (on(0, "crank"), [500.0, -500.0 * tan]),
        (on(1, "rod"), [500.0, -500.0 * tan]),
        (on(2, "piston"), [500.0, -500.0 * tan]),
        (on(3, "piston"), [0.0, 500.0 * tan]),
        (on(3, "ground"), [0.0, -500.0 * tan]),
    ] {
        assert!((found[0] - wanted[0]).abs() < 1e-10 && (found[1] - wanted[1]).abs() < 1e-10, "{found:?}");
    }
}

#[test]
fn balancing_force_on_the_piston_is_the_load_itself() {
    let balance = "[balance]\nlink = \"piston\"\nat = \"B\"\nangle = 0\n";
    let linkage = compiled(&format!("{SLIDER_CRANK}\n{balance}[input]\nlink = \"crank\"\n"));
    let (out, ..) = solve(&linkage, 1.0).unwrap();
    assert!((out.balancing - 500.0).abs() < 1e-9);
    // Nothing is left for the rest of the mechanism.
    assert!(out.pairs.iter().all(|r| r.fx.abs() < 1e-9 && r.fy.abs() < 1e-9), "{:?}", out.pairs);
}

#[test]
fn a_balancing_force_that_does_no_work_is_refused() {
    let balance = "[balance]\nlink = \"piston\"\nat = \"B\"\nangle = 0\n";
    let linkage = compiled(&format!("{SLIDER_CRANK}\n{balance}[input]\nlink = \"crank\"\n"));
    let error = solve(&linkage, 0.0).unwrap_err();
    assert_eq!(
        error.to_string(),
        "coordinate 0.000000000: the balancing force on `piston` does no work there (it moves 0 of a typical \
         displacement), so it can't keep the mechanism in its motion; let it act elsewhere, or leave `[balance]` out"
    );
}

#[test]
fn sliding_input_takes_a_force() {
    // The piston drives: it must push with 500 N against the load, or with F = M / (dx/dphi) against a moment of the crank.
    let moment = "[[moment]]\nlink = \"crank\"\nvalue = 30\n";
    let input = "[input]\nlink = \"piston\"\nfrom = 0.25\nto = 0.35\n";
    let text = SLIDER_CRANK.replace("B = [0.35, 0]", "A = [0, 0.1]");
    let linkage = compiled(&format!("{text}\n{moment}{input}"));
    // x = r cos f + l cos psi; upright at x = 0.1 sqrt 8: dx/df = -r.
    let (out, ..) = solve(&linkage, 0.1 * 8.0_f64.sqrt()).unwrap();
    assert!((out.balancing - (500.0 + 30.0 / 0.1)).abs() < 1e-9, "{}", out.balancing);
}

#[test]
fn nothing_is_allocated() {
    let balance = "[balance]\nlink = \"piston\"\nat = \"B\"\nangle = 0\n";
    let elsewhere = format!("{SLIDER_CRANK}\n{balance}[input]\nlink = \"crank\"\n");
    for text in [scene("shaper"), scene("conveyor"), elsewhere] {
        let linkage = compiled(&text);
        let (mut out, all, position) = solve(&linkage, 1.0).unwrap();
        let mut loads = all.clone();
        let counted = allocation_counter::measure(|| {
            loads.copy_from_slice(&all);
            assert!(Groups.solve(&linkage, &position, &mut loads, &mut out).is_ok());
        });
        assert_eq!(counted.count_total, 0);
    }
}
