//! Inputs over time in the results: against the same mechanism with a prescribed motion, against closed forms and the recursive
//! equations of Newton and Euler, and with friction by the powers of everything that acts.

use std::fmt::Write;
use std::ops::ControlFlow;

use assur_all as _;
use assur_analysis::{Calculation, Options, Progress};
use assur_report::json::analysis::to_json;
use serde_json::Value;

mod laws;
mod turns;

/// The results of a scene.
fn results(text: &str) -> Value {
    let found = || -> Result<Value, Box<dyn std::error::Error>> {
        let mechanism = assur_scene::read("scene.toml", text).map_err(|faults| faults.to_string())?;
        let mut watch = |_: Progress| ControlFlow::Continue(());
        let found = Calculation::of(mechanism, &Options::default(), &mut watch);
        let analysis =
            found.map_err(|error| error.to_string())?.analyze(&mut watch).map_err(|_| "stopped")?;
        Ok(serde_json::from_str(&to_json(&analysis, false)?)?)
    };
    found().unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// The positions of a scene.
fn positions(text: &str) -> Vec<Value> {
    results(text)["positions"].as_array().cloned().unwrap_or_default()
}

fn number(value: &Value, path: &str) -> f64 {
    value.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("no {path} in {value}"))
}

fn vector(value: &Value, path: &str) -> [f64; 2] {
    [0, 1].map(|k| number(value, &format!("{path}/{k}")))
}

/// Two numbers that are equal to a part of a size.
fn close(what: &str, [found, expected]: [f64; 2], limit: f64) {
    assert!((found - expected).abs() < limit, "{what}: {found} is not {expected} to {limit:e}");
}

/// A mechanism of five links that two cranks drive; S: centers of mass.
const FIVE_BAR: &str = r#"
gravity = 9.81
[ground]
points = { O = [0, 0], Q = [0.4, 0] }
[link.left]
points = { O = 0, A = 0.15, S1 = 0.07 }
mass = 1.5
center = "S1"
inertia = 0.004
[link.right]
points = { Q = 0, B = 0.2, S2 = 0.09 }
mass = 2
center = "S2"
inertia = 0.008
[link.rod]
points = { A = 0, C = 0.35, S3 = 0.18 }
mass = 1
center = "S3"
inertia = 0.01
[link.bar]
points = { B = 0, C = 0.32, T = [0.4, 0.05], S4 = [0.16, 0.01] }
mass = 1.2
center = "S4"
inertia = 0.012
[[force]]
link = "bar"
at = "T"
angle = -1
value = 60
[assembly]
C = [0.1, 0.5]
[motion]
until = 1
samples = 8
"#;

const LEFT: &str = r#"
[[input]]
link = "left"
over_time = { formula = "1.9 + 0.5*sin(3*t + 0.1)" }
"#;

const RIGHT: &str = r#"
[[input]]
link = "right"
from = 1.2
rate = -0.7
"#;

/// Pins of the mechanism: coefficient times radius, the owner of the journal, the other link.
const JOURNALS: [(&str, f64, f64, &str, &str); 5] = [
    ("O", 0.2, 0.02, "ground", "left"),
    ("A", 0.15, 0.015, "left", "rod"),
    ("C", 0.3, 0.01, "rod", "bar"),
    ("B", 0.1, 0.02, "right", "bar"),
    ("Q", 0.2, 0.02, "ground", "right"),
];

/// Weights, the force and inertia in the motion at `rates`: velocities, or derivatives by a coordinate; with the sizes of all.
fn powers(at: &Value, point: impl Fn(&str) -> [f64; 2], link: impl Fn(&str) -> f64) -> [f64; 2] {
    let links = [
        ("left", "S1", 1.5, 0.004),
        ("right", "S2", 2.0, 0.008),
        ("rod", "S3", 1.0, 0.01),
        ("bar", "S4", 1.2, 0.012),
    ];
    let mut all = vec![60.0 * (1.0_f64.cos() * point("T")[0] - 1.0_f64.sin() * point("T")[1])];
    for (name, center, mass, inertia) in links {
        let [ax, ay] = vector(at, &format!("/accelerations/points/{center}"));
        let [x, y] = point(center);
        let turn = number(at, &format!("/accelerations/links/{name}"));
        all.extend([-mass * ax * x, -mass * (ay + 9.81) * y, -inertia * turn * link(name)]);
    }
    [all.iter().sum(), all.iter().map(|power| power.abs()).sum()]
}

#[test]
fn friction_in_a_mechanism_with_two_drives_opposes_motion_and_takes_what_the_drives_give() {
    let mut text = format!("{FIVE_BAR}{LEFT}{RIGHT}");
    for (pin, coefficient, radius, ..) in JOURNALS {
        writeln!(text, "[[friction]]\npair = \"{pin}\"\ncoefficient = {coefficient}\nradius = {radius}")
            .unwrap();
    }
    let found = results(&text);
    let keys = ["efficiency", "self_braking", "dead_angles"];
    assert!(keys.iter().all(|key| found.get(key).is_none()), "drives may drive and be driven");
    let all = found["positions"].as_array().unwrap();
    assert_eq!(all.len(), 9);
    for at in all {
        let speed = |link: &str| {
            if link == "ground" { 0.0 } else { number(at, &format!("/velocities/links/{link}")) }
        };
        let mut lost = 0.0;
        let mut turning = [0.0; 2];
        for (pin, coefficient, radius, owner, link) in JOURNALS {
            let moment = number(at, &format!("/friction/{pin}/moment"));
            let [x, y] = vector(at, &format!("/reactions/{pin}/{link}"));
            let relative = speed(link) - speed(owner);
            let expected = -coefficient * radius * x.hypot(y) * relative.signum();
            close(pin, [moment, expected], 1e-12);
            let power = number(at, &format!("/friction/{pin}/power"));
            close(pin, [power, expected * relative], 1e-12);
            assert!(power < 0.0, "{pin}: {power}");
            lost += power;
            for (drive, sum) in ["left", "right"].into_iter().zip(&mut turning) {
                let by = |link: &str| {
                    if link == "ground" { 0.0 } else { number(at, &format!("/links/{link}/pf1/{drive}")) }
                };
                *sum += moment * (by(link) - by(owner));
            }
        }
        let point = |name: &str| vector(at, &format!("/velocities/points/{name}"));
        let [acting, size] = powers(at, point, speed);
        let given = |drive: &str| number(at, &format!("/balancing/{drive}"));
        let driving: f64 = ["left", "right"]
            .map(|drive| given(drive) * number(at, &format!("/speeds/{drive}")))
            .iter()
            .sum();
        close("power", [driving + acting + lost, 0.0], 1e-12 * size);
        for (drive, turning) in ["left", "right"].into_iter().zip(turning) {
            let point = |name: &str| vector(at, &format!("/points/{name}/pf1/{drive}"));
            let [acting, size] = powers(at, point, |link| number(at, &format!("/links/{link}/pf1/{drive}")));
            close(drive, [given(drive) + acting + turning, 0.0], 1e-12 * size);
        }
    }
}

#[test]
fn the_order_of_inputs_does_not_matter() {
    let [one, other] = [[LEFT, RIGHT], [RIGHT, LEFT]].map(|[a, b]| positions(&format!("{FIVE_BAR}{a}{b}")));
    assert_eq!(one.len(), 9);
    for (one, other) in one.iter().zip(&other) {
        laws::same(one, other, 1e-13, &[]);
    }
    let order = |at: &Value, of: &str| at[of].as_object().unwrap().keys().cloned().collect::<Vec<_>>();
    for of in ["coordinates", "speeds", "balancing"] {
        let mut sorted = order(&one[0], of);
        sorted.sort();
        assert_eq!(sorted, ["left", "right"], "{of}");
    }
}

/// Three links, each driven against the one before it. Lengths, distances of the centers of mass, masses, moments of inertia.
const LENGTHS: [f64; 3] = [0.5, 0.4, 0.25];
const CENTERS: [f64; 3] = [0.22, 0.17, 0.12];
const MASSES: [f64; 3] = [6.0, 3.5, 1.5];
const INERTIAS: [f64; 3] = [0.11, 0.05, 0.01];
const TIP: [f64; 2] = [25.0, -40.0];

fn arm() -> String {
    let link = |k: usize| {
        let [own, next] = [k + 1, k + 2];
        format!(
            "[link.l{own}]\npoints = {{ J{own} = 0, J{next} = {:?} }}\nmass = {:?}\ncenter = {:?}\ninertia = {:?}\n",
            LENGTHS[k], MASSES[k], CENTERS[k], INERTIAS[k]
        )
    };
    let links = [0, 1, 2].map(link).concat();
    format!("gravity = 9.81\n[ground]\npoints = {{ J1 = [0.1, 0.2] }}\n{links}{DRIVES_OF_ARM}")
}

const DRIVES_OF_ARM: &str = r#"
[[input]]
link = "l1"
over_time = { formula = "0.4 + 0.8*sin(2*t)" }
[[input]]
pin = "J2"
of = "l2"
on = "l1"
from = -0.9
rate = 1.3
[[input]]
pin = "J3"
of = "l3"
over_time = { formula = "0.7 - 0.5*t^2" }
[motion]
until = 1.5
samples = 6
[[force]]
link = "l3"
at = "J4"
angle = 0
value = { formula = "25", unit = "N" }
[[force]]
link = "l3"
at = "J4"
angle = "-90 deg"
value = 40
"#;

/// Coordinates, speeds and accelerations of the drives of the arm.
fn of_arm(t: f64) -> [[f64; 3]; 3] {
    let first = [0.4 + 0.8 * (2.0 * t).sin(), 1.6 * (2.0 * t).cos(), -3.2 * (2.0 * t).sin()];
    let all = [first, [-0.9 + 1.3 * t, 1.3, 0.0], [0.7 - 0.5 * t * t, -t, -1.0]];
    [0, 1, 2].map(|order| all.map(|one| one[order]))
}

/// Running sums: the angle of each link, and its derivatives.
fn sums(of: [f64; 3]) -> [f64; 3] {
    [of[0], of[0] + of[1], of[0] + of[1] + of[2]]
}

#[test]
fn an_arm_of_three_links_moves_by_closed_forms_and_is_driven_as_newton_and_euler_say() {
    let all = positions(&arm());
    assert_eq!(all.len(), 7);
    for at in all {
        let time = number(&at, "/time");
        let [q, speeds, accelerations] = of_arm(time);
        let [angles, turns, spins] = [q, speeds, accelerations].map(sums);
        let along = angles.map(|angle| [angle.cos(), angle.sin()]);
        // Outward: the joints and centers with their accelerations.
        let mut joint = [0.1, 0.2];
        let (mut speed, mut acceleration) = ([0.0; 2], [0.0; 2]);
        let (mut joints, mut of_center) = (vec![joint], Vec::new());
        for k in 0..3 {
            let [c, s] = along[k];
            let moved = |length: f64| {
                [
                    acceleration[0] - length * (spins[k] * s + turns[k] * turns[k] * c),
                    acceleration[1] + length * (spins[k] * c - turns[k] * turns[k] * s),
                ]
            };
            of_center.push(moved(CENTERS[k]));
            acceleration = moved(LENGTHS[k]);
            speed = [speed[0] - LENGTHS[k] * turns[k] * s, speed[1] + LENGTHS[k] * turns[k] * c];
            joint = [joint[0] + LENGTHS[k] * c, joint[1] + LENGTHS[k] * s];
            joints.push(joint);
            let name = format!("J{}", k + 2);
            for axis in 0..2 {
                close(&name, [vector(&at, &format!("/points/{name}/pf0"))[axis], joint[axis]], 1e-14);
                close(&name, [vector(&at, &format!("/velocities/points/{name}"))[axis], speed[axis]], 1e-13);
                close(
                    &name,
                    [vector(&at, &format!("/accelerations/points/{name}"))[axis], acceleration[axis]],
                    1e-13,
                );
            }
        }
        // A joint turns all that is beyond it about itself.
        for (k, drive) in ["l1", "J2", "J3"].into_iter().enumerate() {
            let [x, y] = vector(&at, &format!("/points/J4/pf1/{drive}"));
            let expected = [joints[k][1] - joint[1], joint[0] - joints[k][0]];
            close(drive, [x, expected[0]], 1e-14);
            close(drive, [y, expected[1]], 1e-14);
            close(drive, [number(&at, &format!("/links/l3/pf1/{drive}")), 1.0], 1e-14);
            close(drive, [number(&at, &format!("/coordinates/{drive}")), q[k]], 1e-14);
            close(
                drive,
                [number(&at, &format!("/accelerations_of_inputs/{drive}")), accelerations[k]],
                1e-14,
            );
        }
        // Inward: the force and moment that each link asks of its joint.
        let (mut force, mut moment) = ([-TIP[0], -TIP[1]], 0.0);
        for k in (0..3).rev() {
            let [c, s] = along[k];
            let cross = |length: f64, [x, y]: [f64; 2]| length * (c * y - s * x);
            let inertia = [MASSES[k] * of_center[k][0], MASSES[k] * (of_center[k][1] + 9.81)];
            moment += INERTIAS[k] * spins[k] + cross(CENTERS[k], inertia) + cross(LENGTHS[k], force);
            force = [force[0] + inertia[0], force[1] + inertia[1]];
            let (drive, own) = (["l1", "J2", "J3"][k], k + 1);
            close(drive, [number(&at, &format!("/balancing/{drive}")), moment], 1e-11);
            let [x, y] = vector(&at, &format!("/reactions/J{own}/l{own}"));
            close(drive, [x, force[0]], 1e-11);
            close(drive, [y, force[1]], 1e-11);
        }
    }
}

#[test]
fn two_links_are_driven_in_one_pin() {
    let text = r#"
gravity = 9.81
[ground]
points = { O = 0 }
[link.crank]
points = { O = 0, K = 0.3 }
mass = 2
center = 0.1
[link.one]
points = { K = 0, E = 0.2 }
mass = 1
center = "E"
[link.two]
points = { K = 0, F = 0.4 }
mass = 3
center = "F"
[[input]]
link = "crank"
from = 0.3
[[input]]
pin = "K"
of = "one"
on = "crank"
from = 0.5
[[input]]
pin = "K"
of = "two"
on = "one"
from = -1.1
"#;
    let all = positions(text);
    let at = &all[0];
    assert_eq!(all.len(), 1);
    // At rest: moments of the weights beyond each joint about it.
    let (crank, one, two) = (0.3_f64.cos(), 0.8_f64.cos(), (-0.3_f64).cos());
    let second = 9.81 * 3.0 * 0.4 * two;
    let first = second + 9.81 * 0.2 * one;
    let root = first + 9.81 * (2.0 * 0.1 + 4.0 * 0.3) * crank;
    for (key, expected) in [("crank", root), ("K:one", first), ("K:two", second)] {
        close(key, [number(at, &format!("/balancing/{key}")), expected], 1e-12);
    }
    close("angle", [number(at, "/links/two/pf0"), -0.3], 1e-14);
    close("by one", [number(at, "/links/two/pf1/K:one"), 1.0], 1e-14);
    close("by two", [number(at, "/links/one/pf1/K:two"), 0.0], 1e-14);
    // The force of the pin on the crank is the weight of both.
    close("pin", [number(at, "/reactions/K/crank/1"), -9.81 * 4.0], 1e-12);
}

/// A ram whose guide slides along a carriage: both drives act on the carriage.
#[test]
fn a_carriage_that_two_drives_push_has_the_load_of_each() {
    let scene = |angle: &str| {
        format!(
            r#"
gravity = 9.81
[ground]
[link.carriage]
points = {{ C = 0 }}
mass = 5
[link.ram]
points = {{ R = 0 }}
mass = 2
[[slide]]
link = "carriage"
on = "ground"
[[slide]]
link = "carriage"
on = "ram"
angle = "{angle}"
tilt = "-{angle}"
[[input]]
link = "carriage"
over_time = {{ formula = "0.1 + 0.2*t^2" }}
[[input]]
slide = "carriage/ram"
over_time = {{ formula = "0.3 - 0.25*t^2" }}
[motion]
until = 1
samples = 2
"#
        )
    };
    // The ram moves back as the coordinate grows: its acceleration is that of the carriage and 0.5 along the guide.
    for (angle, carriage, ram) in
        [("90 deg", 0.4 * 7.0, -2.0 * (0.5 + 9.81)), ("0 deg", 0.4 * 7.0 + 2.0 * 0.5, -2.0 * 0.9)]
    {
        let all = positions(&scene(angle));
        assert_eq!(all.len(), 3);
        for at in all {
            close("carriage", [number(&at, "/balancing/carriage"), carriage], 1e-12);
            close("ram", [number(&at, "/balancing/carriage~1ram"), ram], 1e-12);
        }
    }
}
