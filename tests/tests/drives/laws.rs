//! One input by a law over time.

use serde_json::Value;

use super::{number, positions};

/// A law as a scene has it, and its value with both derivatives.
type Law = (&'static str, fn(f64) -> [f64; 3]);

fn sine([mean, rise, size, rate]: [f64; 4], t: f64) -> [f64; 3] {
    let (s, c) = (rate * t).sin_cos();
    [mean + rise * t + size * s, rise + size * rate * c, -size * rate * rate * s]
}

/// The natural cubic spline through 0.4, 1.6, 1.1 at 0, 0.6, 1.2: one equation for its middle bend, 4 h M = 6 (second difference) / h.
fn spline(t: f64) -> [f64; 3] {
    let (h, [a, b, c]) = (0.6, [0.4, 1.6, 1.1]);
    let bend = 1.5 * (c - 2.0 * b + a) / (h * h);
    let (u, from, slope, sign) =
        if t < h { (t, a, (b - a) / h, 1.0) } else { (2.0 * h - t, c, (c - b) / h, -1.0) };
    let rise = sign * slope - h * bend / 6.0;
    [from + rise * u + bend * u * u * u / (6.0 * h), sign * (rise + bend * u * u / (2.0 * h)), bend * u / h]
}

/// A shipped scene without its input and motion, and with loads that are the same at all times; what drives it, and by which law.
fn scenes() -> [(String, &'static str, Law); 5] {
    let scene = |name: &str| {
        let text = assur_fixtures::scene(name);
        let tables: Vec<&str> = text
            .split("\n[")
            .filter(|table| !["input]", "motion]"].iter().any(|head| table.starts_with(head)))
            .collect();
        tables.join("\n[")
    };
    let four_bar = scene("four-bar")
        .replace(r#"{ over = "angle", table = [[0, 150], ["180 deg", 600], ["360 deg", 150]] }"#, "400");
    let slider_crank = scene("slider-crank").replace("B = [0, 0.23]", "B = [0, 0.24]\nA = [0.05, 0.02]");
    let (before, law) = slider_crank.split_once("value = { over = \"stroke\"").unwrap_or_default();
    let slider_crank = format!("{before}value = 900{}", law.split_once('}').unwrap_or_default().1);
    [
        (
            four_bar.clone(),
            "link = \"crank\"",
            ("{ formula = \"0.3 + 2*t + sin(3*t)\" }", |t| sine([0.3, 2.0, 1.0, 3.0], t)),
        ),
        (
            four_bar,
            "link = \"crank\"",
            ("{ table = [[0, 0.4], [0.6, 1.6], [1.2, 1.1]], shape = \"smooth\" }", spline),
        ),
        (
            slider_crank,
            "link = \"piston\"",
            ("{ formula = \"0.24 + 0.03*sin(4*t)\" }", |t| sine([0.24, 0.0, 0.03, 4.0], t)),
        ),
        (
            scene("boom"),
            "slide = \"rod/barrel\"",
            ("{ formula = \"1.05 + 0.15*sin(2*t)\" }", |t| sine([1.05, 0.0, 0.15, 2.0], t)),
        ),
        (
            scene("leg"),
            "pin = \"K\"\nof = \"thigh\"",
            ("{ formula = \"1.3 - 0.5*sin(2*t)\" }", |t| sine([1.3, 0.0, -0.5, 2.0], t)),
        ),
    ]
}

/// A scene with loads over the coordinate and the speed of its input, by tables and by a formula.
fn of_coordinate((rest, driven, law): &(String, &'static str, Law)) -> [(String, &'static str, Law); 3] {
    let loads = [
        r#"{ over = "angle", table = [[0, 150], ["90 deg", 600], ["360 deg", 150]] }"#,
        // Even in the speed, which a plain input counts along its direction.
        r#"{ over = "speed", table = [[-10, 400], [0, 20], [10, 400]] }"#,
        r#"{ formula = "300*cos(q) + 20*w^2" }"#,
    ];
    loads.map(|load| {
        assert!(rest.contains("value = 400"), "{rest}");
        (rest.replace("value = 400", &format!("value = {load}")), *driven, *law)
    })
}

const MOTION: &str = "[motion]\nuntil = 1.2\nsamples = 9\n";

/// Compares all numbers of two results: to a part of the greatest of those that stand together. `but`: keys that are left out.
pub(super) fn same(one: &Value, other: &Value, limit: f64, but: &[&str]) {
    let size = greatest(one);
    match (one, other) {
        (Value::Object(one), Value::Object(other)) => {
            let keys = |of: &serde_json::Map<String, Value>| {
                let mut keys: Vec<_> =
                    of.keys().filter(|key| !but.contains(&key.as_str())).cloned().collect();
                keys.sort();
                keys
            };
            assert_eq!(keys(one), keys(other));
            for key in keys(one) {
                within(&key, [&one[&key], &other[&key]], limit);
            }
        }
        _ => within("", [one, other], limit * size),
    }
}

fn within(key: &str, [one, other]: [&Value; 2], limit: f64) {
    let limit = limit * greatest(one).max(1e-3);
    compare(key, [one, other], limit);
}

fn compare(key: &str, [one, other]: [&Value; 2], limit: f64) {
    match (one, other) {
        (Value::Object(one), Value::Object(other)) => {
            assert_eq!(one.len(), other.len(), "{key}");
            one.iter()
                .for_each(|(name, value)| compare(&format!("{key}/{name}"), [value, &other[name]], limit));
        }
        (Value::Array(one), Value::Array(other)) => {
            assert_eq!(one.len(), other.len(), "{key}");
            one.iter().zip(other).for_each(|(one, other)| compare(key, [one, other], limit));
        }
        (Value::Number(a), Value::Number(b)) => {
            let [a, b] = [a, b].map(|number| number.as_f64().unwrap_or(f64::NAN));
            assert!((a - b).abs() <= limit, "{key}: {a} and {b} differ by more than {limit:e}");
        }
        _ => assert_eq!(one, other, "{key}"),
    }
}

fn greatest(value: &Value) -> f64 {
    match value {
        Value::Object(all) => all.values().map(greatest).fold(0.0, f64::max),
        Value::Array(all) => all.iter().map(greatest).fold(0.0, f64::max),
        Value::Number(number) => number.as_f64().unwrap_or_default().abs(),
        _ => 0.0,
    }
}

#[test]
fn a_law_over_time_gives_at_each_instant_what_a_prescribed_motion_gives_there() {
    let [four_bar, ..] = scenes();
    let balanced = (format!("{}\n[balance]\nlink = \"rocker\"\n", four_bar.0), four_bar.1, four_bar.2);
    let rubbing = "[[friction]]\npair = \"A\"\ncoefficient = 0.2\nradius = 0.01\n[[friction]]\npair = \"C\"\ncoefficient = 0.1\nradius = 0.02\n";
    let rubbing = (format!("{}\n{rubbing}", four_bar.0), four_bar.1, four_bar.2);
    for (rest, driven, (text, law)) in
        scenes().into_iter().chain([balanced, rubbing]).chain(of_coordinate(&four_bar))
    {
        let over_time = positions(&format!("{rest}\n[input]\n{driven}\nover_time = {text}\n{MOTION}"));
        assert_eq!(over_time.len(), 10);
        for at in &over_time {
            let [q, speed, acceleration] = law(number(at, "/time"));
            let sign = if speed < 0.0 { -1.0 } else { 1.0 };
            let sense = if speed < 0.0 { "cw" } else { "ccw" };
            let plain = positions(&format!(
                "{rest}\n[input]\n{driven}\nfrom = {q:?}\nto = {q:?}\npositions = 1\ndirection = \"{sense}\"\n\
                 [motion]\nspeed = {:?}\nacceleration = {:?}\n",
                sign * speed,
                sign * acceleration
            ));
            assert!(at["balancing"].is_number() && at["reduced"].is_object(), "{driven}: {at}");
            same(at, &plain[0], 1e-11, &["index", "time"]);
        }
    }
}

#[test]
fn a_list_of_one_input_gives_the_numbers_of_that_input_alone() {
    for (rest, driven, (text, _)) in scenes() {
        let all = ["[input]", "[[input]]"]
            .map(|head| positions(&format!("{rest}\n{head}\n{driven}\nover_time = {text}\n{MOTION}")));
        for (alone, listed) in all[0].iter().zip(&all[1]) {
            let key = listed["coordinates"].as_object().unwrap().keys().next().unwrap();
            let of_drive = |of: &str| &listed[of][key];
            assert_eq!(
                [
                    of_drive("coordinates"),
                    of_drive("speeds"),
                    of_drive("accelerations_of_inputs"),
                    of_drive("balancing")
                ],
                [&alone["coordinate"], &alone["speed"], &alone["acceleration"], &alone["balancing"]]
            );
            for of in
                ["time", "velocities", "accelerations", "reactions", "inertia_loads", "shaking", "condition"]
            {
                assert_eq!(listed[of], alone[of], "{of}");
            }
            assert!(listed.get("reduced").is_none());
            for of in ["links", "points", "slides"] {
                for (name, one) in listed[of].as_object().unwrap() {
                    let pair = [&one["pf0"], &one["pf1"][key]];
                    assert_eq!(pair, [&alone[of][name]["pf0"], &alone[of][name]["pf1"]], "{of} {name}");
                }
            }
        }
    }
}

/// A single position has no way along which friction could work.
#[test]
fn friction_in_a_single_position_has_no_work_of_a_cycle() {
    let [(four_bar, ..), ..] = scenes();
    let friction = "[[friction]]\npair = \"A\"\ncoefficient = 0.2\nradius = 0.01\n";
    let input = "[input]\nlink = \"crank\"\nfrom = 1\nto = 1\npositions = 1\n[motion]\nspeed = 2\n";
    let json = super::results(&format!("{four_bar}\n{input}{friction}"));
    assert!(json["friction_work"]["A"].is_null(), "{}", json["friction_work"]);
    assert!(number(&json, "/positions/0/friction/A/power") < 0.0);
}

/// The range that is passed stands for the cycle: here it is a whole turn.
#[test]
fn loads_over_a_stroke_follow_the_point_that_a_law_moves() {
    let text = assur_fixtures::scene("slider-crank");
    let tables =
        text.split("\n[").filter(|table| !["input]", "motion]"].iter().any(|of| table.starts_with(of)));
    let rest = tables.collect::<Vec<_>>().join("\n[");
    let of = |what: &str| positions(&format!("{rest}\n{what}"));
    let by_law = of(
        "[input]\nlink = \"crank\"\nover_time = { formula = \"2*pi*t\" }\n[motion]\nuntil = 1\nsamples = 12\n",
    );
    let plain = of(&format!(
        "[input]\nlink = \"crank\"\npositions = 12\n[motion]\nspeed = {:?}\n",
        std::f64::consts::TAU
    ));
    let loads = |all: &[Value]| all.iter().map(|at| number(at, "/balancing")).collect::<Vec<_>>();
    let (by_law, plain) = (loads(&by_law), loads(&plain));
    let greatest = plain.iter().fold(0.0_f64, |most, load| most.max(load.abs()));
    assert!(greatest > 100.0 && by_law.len() == 13, "{plain:?}");
    for (one, other) in by_law.iter().zip(&plain) {
        assert!((one - other).abs() <= 1e-9 * greatest, "{one} {other}");
    }
}
