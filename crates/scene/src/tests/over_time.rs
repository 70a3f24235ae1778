//! Several inputs, and laws of motion over time.

#![expect(clippy::float_cmp, reason = "numbers that stand in the file are read to the last bit")]

use std::f64::consts::{PI, TAU};
use std::fmt::Write as _;

use assur_mechanism::{GROUND, InputPair, Mechanism, Motion, Range};

use super::faults::{faults, snapshot};
use super::{ARM, BOOM, FIVE_BAR};
use crate::{read, reading};

fn good(text: &str) -> Mechanism {
    read("scene.toml", text).unwrap_or_else(|errors| panic!("{errors}"))
}

fn labels(scene: &Mechanism) -> Vec<&str> {
    scene.input.drivers.iter().map(|driver| driver.label.as_str()).collect()
}

/// Coordinate, speed and acceleration of an input at a time.
fn at(scene: &Mechanism, driver: usize, time: f64) -> [f64; 3] {
    scene.input.drivers[driver].law.as_ref().unwrap().at(time)
}

fn close(found: [f64; 3], wanted: [f64; 3]) {
    assert!(found.iter().zip(wanted).all(|(one, other)| (one - other).abs() < 1e-13), "{found:?} {wanted:?}");
}

#[test]
fn two_cranks_move_over_time() {
    let scene = good(FIVE_BAR);
    assert!(scene.input.is_list && scene.input.kind().is_time());
    assert_eq!(labels(&scene), ["crank1", "crank2"]);
    assert_eq!((scene.input.from, scene.input.positions, scene.input.range), (0.0, 49, Range::To(4.0)));
    assert_eq!(scene.motion, Some(Motion::Prescribed { speed: 1.0, acceleration: 0.0 }));
    close(at(&scene, 0, 0.5), [PI / 9.0 + PI / 2.0, PI, 0.0]);
    // Periodic: at rest at its rows, between them the cubic from one to the other.
    close(at(&scene, 1, 2.0), [PI / 2.0, 0.0, 3.0 * PI]);
    close(at(&scene, 1, 3.0), [PI, 0.0, -3.0 * PI]);
    close(at(&scene, 1, 0.5), [0.75 * PI, 0.75 * PI, 0.0]);
}

#[test]
fn what_is_driven_is_named_as_the_scene_does() {
    let scene = good(ARM);
    let drivers = &scene.input.drivers;
    assert_eq!(labels(&scene), ["upper", "K", "hand/forearm"]);
    assert_eq!(scene.input.positions, 101);
    let driven: Vec<_> = drivers.iter().map(|driver| (driver.link, driver.on, driver.pair)).collect();
    assert_eq!(
        driven,
        [(1, GROUND, InputPair::Pin(0)), (2, 1, InputPair::Pin(1)), (3, 2, InputPair::Slide(0))]
    );
    close(at(&scene, 0, 0.0), [PI / 6.0, TAU / 9.0, 0.0]);
    close(at(&scene, 1, 2.0), [-0.2, -0.5, 0.0]);
    close(at(&scene, 2, 2.0), [0.32, 0.01, 0.0]);
    let twice = ARM
        .replace("points = { P = 0 }", "points = { K = 0, P = 0 }")
        .replace(
            "slide = \"hand/forearm\"\nfrom = \"300 mm\"\nrate = \"10 mm/s\"",
            "pin = \"K\"\nof = \"hand\"\non = \"upper\"",
        )
        .replace("[[slide]]\nlink = \"hand\"\non = \"forearm\"\n", "");
    assert_eq!(labels(&good(&twice)), ["upper", "K:forearm", "K:hand"]);
}

#[test]
fn a_list_without_a_motion_is_one_position_and_one_entry_is_a_list() {
    let scene = good(&ARM.replace("[motion]\nuntil = 2\n", ""));
    assert_eq!((scene.input.positions, scene.input.range, scene.motion.is_none()), (1, Range::To(0.0), true));
    let (before, _) = FIVE_BAR.split_once("[[input]]\nlink = \"crank2\"").unwrap();
    let scene = good(&format!("{before}[motion]\nuntil = 1"));
    assert!(scene.input.is_list && scene.input.sole().is_none());
}

#[test]
fn a_law_of_one_input_makes_the_time_its_coordinate() {
    let scene = good(BOOM);
    assert!(!scene.input.is_list && scene.input.kind().is_time());
    assert_eq!((scene.input.positions, scene.input.coordinate(35)), (36, 3.5));
    close(at(&scene, 0, 1.0), [0.6, -0.05, 0.0]);
    let directed = good(&BOOM.replace("[input]", "[input]\ndirection = \"cw\"\nname = \"s\""));
    assert_eq!(directed.input.coordinate(35), 3.5);
    let repeated = BOOM.replace("\"700 mm\"", "\"400 mm\"").replace("3.5 s", "9 s");
    close(at(&good(&repeated), 0, 8.5), [0.5, 0.2, 0.0]);
}

#[test]
fn from_and_rate_are_set_by_the_name_of_their_input() {
    let reading = reading("scene.toml", ARM).unwrap();
    let mut scene = reading.mechanism.clone();
    for (key, value) in [("input.K.rate", 2.0), ("input.K.from", 1.0), ("input.hand/forearm.from", 0.5)] {
        let number = reading.numbers.iter().find(|number| number.key.to_string() == key);
        let number = number.filter(|number| number.is_free()).unwrap_or_else(|| panic!("{key}"));
        number.set(&mut scene, value);
        assert_eq!(crate::edit::ParsedText::of(ARM).place(&number.key).unwrap().start, {
            let own = &ARM[..number.span.start];
            own.rfind('\n').unwrap() + 1
        });
    }
    close(at(&scene, 1, 3.0), [7.0, 2.0, 0.0]);
    close(at(&scene, 2, 0.0), [0.5, 0.01, 0.0]);
    let until = reading.numbers.iter().find(|number| number.key.to_string() == "motion.until").unwrap();
    assert!(!until.is_free());
}

/// Every fault with what it must name, and its place; all texts are in a snapshot.
fn refused(scene: &str, cases: &[(&str, &str, &str, (usize, usize))]) -> String {
    let mut out = String::new();
    for (old, new, names, place) in cases {
        assert!(scene.contains(old), "{old}");
        let text = scene.replacen(old, new, 1);
        let told = faults(&text, &[*place]);
        assert!(told.lines().next().unwrap().contains(names), "{names}: {told}");
        writeln!(out, "--- {old:?} -> {new:?}\n{told}").unwrap();
    }
    out
}

#[test]
fn what_needs_one_input_is_refused_with_several() {
    let value = "{ over = \"time\", table = [[0, 40], [1, 0]] }";
    let contact = "[[contact]]\nlink = \"rod1\"\ncenter = \"T\"\nradius = 1\nforce = 1\n[assembly]";
    let told = refused(
        FIVE_BAR,
        &[
            (value, "{ formula = \"5*sin(q) + t\" }", "a formula of q needs one input", (38, 21)),
            (value, "{ formula = \"w*x\", axis = 0 }", "a formula of w, x", (38, 21)),
            (value, "{ over = \"angle\", table = [[0, 40], [1, 0]] }", "over = \"angle\"", (38, 18)),
            (value, "{ over = \"coordinate\", table = [[0, 40]] }", "over = \"coordinate\"", (38, 18)),
            (value, "{ over = \"speed\", table = [[0, 40]] }", "over = \"speed\"", (38, 18)),
            (value, "{ over = \"stroke\", axis = 0, forward = 3 }", "over = \"stroke\"", (38, 18)),
            ("mass = 1.5", "inertia = { formula = \"1 + 0.1*cos(q)\" }", "`inertia", (9, 11)),
            ("[assembly]", contact, "[[contact]]", (40, 1)),
            ("until = \"4 s\"", "until = \"4 s\"\nkind = \"transient\"", "`kind`", (32, 1)),
            ("until = \"4 s\"", "until = \"4 s\"\nspeed = 1", "`speed`", (32, 1)),
            ("until = \"4 s\"", "until = \"4 s\"\nacceleration = 1", "`acceleration`", (32, 1)),
            ("[assembly]", "[drive]\ntorque = 5\n[assembly]", "`[drive]`", (40, 1)),
            ("[assembly]", "[balance]\nlink = \"rod1\"\n[assembly]", "`[balance]`", (40, 1)),
        ],
    );
    let during = contact.replace("force = 1", "force = 1\nduring = [0, 1]");
    let both = faults(&FIVE_BAR.replace("[assembly]", &during), &[(40, 1), (45, 1)]);
    assert!(both.contains("`during` needs one input"), "{both}");
    snapshot("several_inputs", &told);
}

#[test]
fn faults_of_inputs_over_time() {
    let law =
        "{ table = [[0, \"400 mm\"], [\"1 s\", \"600 mm\"], [\"2 s\", \"550 mm\"], [\"4 s\", \"700 mm\"]] }";
    let mut told = refused(
        FIVE_BAR,
        &[
            ("rate = \"30 rpm\"", "to = 1", "`to`", (24, 1)),
            ("rate = \"30 rpm\"", "positions = 3", "`positions`", (24, 1)),
            ("rate = \"30 rpm\"", "cycle = 1", "`cycle`", (24, 1)),
            ("rate = \"30 rpm\"", "direction = \"cw\"", "`direction`", (24, 1)),
            ("rate = \"30 rpm\"", "rate = \"30 mm\"", "`rate`", (24, 8)),
            (
                "link = \"crank2\"\nover",
                "link = \"crank2\"\nrate = 1\nover",
                "`rate` and `over_time`",
                (28, 1),
            ),
            ("link = \"crank2\"\nover", "link = \"crank1\"\nover", "two inputs drive the pair O1", (26, 1)),
            ("until = \"4 s\"", "until = \"turn\"", "`until`", (31, 9)),
            ("until = \"4 s\"\n", "", "`until`", (30, 1)),
            ("[motion]\nuntil = \"4 s\"\nsamples = 48\n", "", "needs a motion", (35, 18)),
            ("samples = 48", "samples = 0", "`samples`", (32, 11)),
        ],
    );
    // Its load needs a motion, too.
    let still = BOOM.replace("[motion]\nuntil = \"3.5 s\"\nsamples = 35\n", "");
    told += &faults(&still, &[(21, 2), (30, 21)]);
    told += &refused(
        BOOM,
        &[
            ("until = \"3.5 s\"\n", "", "`until`", (25, 1)),
            ("until = \"3.5 s\"", "until = \"5 s\"", "`until` is 5 s, and the last row is at 4 s", (23, 23)),
            ("samples = 35", "speed = 1", "`speed`", (27, 1)),
            ("samples = 35", "kind = \"prescribed\"", "`kind`", (27, 1)),
            ("samples = 35", "tolerance = 1e-6", "`tolerance`", (27, 1)),
            ("[input]", "[input]\nfrom = 1", "`from` and `over_time`", (22, 1)),
            ("[input]", "[input]\npositions = 1", "`positions` and `over_time`", (22, 1)),
            ("[input]", "[input]\nto = 1", "`to` and `over_time`", (22, 1)),
            ("[input]", "[input]\ncycle = 1", "`cycle` and `over_time`", (22, 1)),
            ("\"3000 + 100*t\"", "\"3000*x\"", "a formula of x", (33, 21)),
            ("mass = \"120 kg\"", "inertia = { formula = \"2 + q\" }", "`inertia", (7, 11)),
            ("[motion]", "[[contact]]\n[motion]", "`[[contact]]`", (25, 1)),
            ("[motion]", "[drive]\ntorque = 5\n[motion]", "`[drive]`", (25, 1)),
            (law, "{ formula = \"0.4 + q*w*x\" }", "q, w, x", (23, 25)),
            (law, "{ formula = \"0.4 + 1/t\" }", "beyond all measure, at 0 s", (23, 13)),
            (law, "{ formula = \"0.4\", table = [[0, 0], [4, 1]] }", "`table` and `formula`", (23, 13)),
            (law, "{}", "`table`", (23, 13)),
            (law, "3", "`over_time`", (23, 13)),
            ("[\"4 s\", \"700 mm\"]]", "[4, 0.7]], shape = \"step\"", "`shape`", (23, 96)),
            ("[\"1 s\", \"600 mm\"]", "[\"1 s\", \"600 deg\"]", "`table`", (23, 47)),
            ("[0, \"400 mm\"]", "[0.5, \"400 mm\"]", "begins at time 0", (23, 23)),
            ("[\"2 s\", \"550 mm\"]", "[\"1 s\", \"550 mm\"]", "the times of the rows must grow", (23, 58)),
            ("[\"2 s\", \"550 mm\"]", "[\"0.5 s\", \"550 mm\"]", "must not decrease", (23, 58)),
            (law, "{ table = [[0, 1]] }", "needs two rows", (23, 23)),
        ],
    );
    told += &refused(
        ARM,
        &[(
            "[motion]\nuntil = 2",
            "[[friction]]\npair = \"K\"\ncoefficient = 0.1\nradius = 0.01",
            "[[friction]]",
            (34, 1),
        )],
    );
    snapshot("over_time", &told);
}
