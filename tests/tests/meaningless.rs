//! Well-formed scenes that mean nothing, or little: what the program says of each, to be read by a person.

use std::fmt::Write as _;

use assur_all as _;
use assur_analysis::{Calculation, Options, unwatched};

const ENGINE: &str = include_str!("meaningless/engine.toml");

/// What is replaced in the engine, and by what.
type Case = (&'static str, &'static str);

/// What the program says of a scene, one fault a line.
fn answer(text: &str) -> String {
    let mechanism = match assur_scene::read("engine.toml", text) {
        Ok(mechanism) => mechanism,
        Err(errors) => {
            let line = |error: &assur_scene::SceneError| {
                let label =
                    if error.label.is_empty() { String::new() } else { format!(" ({})", error.label) };
                format!("line {}, column {}: {}{label}\n", error.line, error.column, error.message)
            };
            return errors.errors.iter().map(line).collect();
        }
    };
    let calculation = match Calculation::of(mechanism, &Options::default(), &mut unwatched) {
        Ok(calculation) => calculation,
        Err(error) => return format!("scene: {error}\n"),
    };
    let analysis = calculation.analyze(&mut unwatched).expect("nobody stops it");
    let failure = analysis.failures.first().map(|failure| format!("failure: {}\n", failure.message));
    let motion = analysis.no_motion.map(|why| format!("no motion: {why}\n"));
    let notes = analysis.warnings.iter().map(|note| format!("note: {note}\n"));
    let all: String = failure.into_iter().chain(motion).chain(notes).collect();
    if all.is_empty() { "calculated\n".to_owned() } else { all }
}

#[expect(clippy::unwrap_used, reason = "a string takes every text")]
fn answers(name: &str, cases: &[Case]) {
    let mut out = String::new();
    for (old, new) in cases {
        assert!(ENGINE.contains(old), "{old}");
        let answer = answer(&ENGINE.replacen(old, new, 1));
        // No number that is none, and nothing endless, in what a person reads.
        for line in answer.lines() {
            assert!(!line.contains("NaN") && line.len() < 800, "{old} -> {new}: {line}");
        }
        writeln!(out, "--- {old} -> {new}\n{answer}").unwrap();
    }
    let mut settings = insta::Settings::clone_current();
    settings.set_omit_expression(true);
    settings.set_prepend_module_to_snapshot(false);
    settings.bind(|| insta::assert_snapshot!(name, out));
}

#[test]
fn the_engine_itself_is_calculated() {
    // The gas drives an engine.
    assert!(answer(ENGINE).starts_with("note: Over the cycle the loads drive the mechanism"));
}

#[test]
fn links() {
    answers(
        "links",
        &[
            ("A = 0, S2 = \"80 mm\", B = \"240 mm\"", "A = 0, S2 = \"80 mm\", B = 0"),
            ("O = 0, A = \"60 mm\"", "O = 0, A = 0"),
            ("O = 0, A = \"60 mm\"", "O = 0, A = \"1e-20 mm\""),
            ("O = 0, A = \"60 mm\"", "O = 0, A = \"-60 mm\""),
            ("O = 0, A = \"60 mm\"", "O = 0, A = 60"),
            ("O = 0, A = \"60 mm\"", "O = 0, A = \"60 km\""),
            ("O = 0, A = \"60 mm\"", "O = 0, A = 1e30"),
            ("O = 0, A = \"60 mm\"", "O = 0, A = 1e-320"),
            ("O = 0, A = \"60 mm\"", "O = 0, A = \"60\""),
            ("O = 0, A = \"60 mm\"", "O = 0, A = \"60 mn\""),
            ("O = 0, A = \"60 mm\"", "O = 0, A = \"60,5 mm\""),
            ("O = 0, A = \"60 mm\"", "O = 0, A = [1, 2, 3]"),
            ("O = 0, A = \"60 mm\"", "O = 0"),
            ("O = 0, A = \"60 mm\"", "O = 0, K = \"60 mm\""),
            ("points = { O = 0, A = \"60 mm\" }\n", ""),
            ("points = { O = 0, A = \"60 mm\" }\n", "points = [0, 1]\n"),
            ("points = { O = 0, A = \"60 mm\" }", "points = { O = 0, А = \"60 mm\" }"),
            ("[link.piston]\npoints = { B = 0 }", "[link.piston]\npoints = { B = 0, T = 0 }\ncenter = \"B\""),
            ("[link.crank]", "[link.кривошип]"),
            ("[link.crank]", "[link.ground]"),
            ("[link.crank]", "[link.moment]"),
            ("[link.crank]", "[link.\"a.b\"]"),
            ("[link.crank]", "[link.\"\"]"),
            ("[link.crank]", "[link.\"cr\\u202eank\"]"),
            ("[link.crank]", "[link.\"cr\\u200bank\"]"),
            ("[link.rod]", "[link.crank]"),
            ("[link.rod]", "[rod]"),
            ("[link.rod]", "[links.rod]"),
            ("[link.piston]", "[link.spare]\npoints = { X = 0, Y = 1 }\n[link.piston]"),
            ("[link.piston]", "[link.spare]\npoints = { C = 0, S2 = \"200 mm\" }\n[link.piston]"),
            ("[ground]\npoints = { O = [0, 0], C = [0, \"-400 mm\"] }", "[ground]"),
            ("O = [0, 0], C", "O = [0, 0], A = [1, 0], C"),
            ("O = [0, 0], C", "C"),
            ("[ground]", "[grond]"),
        ],
    );
}

#[test]
fn masses() {
    answers(
        "masses",
        &[
            ("mass = \"3 kg\"", "mass = \"-3 kg\""),
            ("mass = \"3 kg\"", "mass = \"3 N\""),
            ("mass = \"3 kg\"", "mass = 3e20"),
            ("mass = \"3 kg\"", "mass = \"3kg\""),
            ("mass = \"3 kg\"", "mass = nan"),
            ("mass = \"3 kg\"", "mass = [3]"),
            ("mass = \"3 kg\"", "mass = true"),
            ("mass = \"3 kg\"\n", ""),
            ("mass = \"1.8 kg\"\ncenter = \"S2\"", "mass = \"1.8 kg\""),
            ("center = \"S2\"", "center = \"C\""),
            ("center = \"S2\"", "center = \"Q\""),
            ("center = \"S2\"", "center = 7e5"),
            ("inertia = \"0.008 kg*m^2\"", "inertia = \"0.008 kg*m\""),
            ("inertia = \"0.008 kg*m^2\"", "inertia = -1"),
            ("inertia = \"0.008 kg*m^2\"", "inertia = 1e29"),
            ("gravity = \"9.81 m/s^2\"", "gravity = 1e-320"),
            ("gravity = \"9.81 m/s^2\"", "gravity = -9.81"),
            ("gravity = \"9.81 m/s^2\"", "gravity = \"9.81 kg\""),
            ("gravity = \"9.81 m/s^2\"", "gravity = \"9.81\""),
            ("gravity = \"9.81 m/s^2\"", "gravity = [0, -9.81, 0]"),
        ],
    );
}

#[test]
fn slides() {
    answers(
        "slides",
        &[
            ("on = \"ground\"", "on = \"piston\""),
            ("on = \"ground\"", "on = \"rod\""),
            ("on = \"ground\"", "on = \"floor\""),
            ("on = \"ground\"\n", ""),
            ("link = \"piston\"\non", "link = \"ground\"\non"),
            ("angle = \"90 deg\"", "angle = \"90\""),
            ("angle = \"90 deg\"", "angle = 90"),
            ("angle = \"90 deg\"", "angle = 1e9"),
            ("angle = \"90 deg\"", "tilt = 1e9"),
            ("angle = \"90 deg\"", "angle = \"90 mm\""),
            ("angle = \"90 deg\"", "angle = \"0 deg\""),
            ("angle = \"90 deg\"", "name = \"B\""),
            ("angle = \"90 deg\"", "name = \"\""),
            ("angle = \"90 deg\"", "through = [0, \"500 mm\"]"),
            ("angle = \"90 deg\"", "point = \"A\""),
            ("[[slide]]", "[slide]"),
            ("[[slide]]", "[[slide]]\nlink = \"piston\"\non = \"ground\"\n[[slide]]"),
            ("[[slide]]\nlink = \"piston\"\non = \"ground\"\nangle = \"90 deg\"\n", ""),
        ],
    );
}

#[test]
fn input() {
    answers(
        "input",
        &[
            ("link = \"crank\"\npositions", "link = \"rod\"\npositions"),
            ("link = \"crank\"\npositions", "link = \"ground\"\npositions"),
            ("link = \"crank\"\npositions", "link = \"motor\"\npositions"),
            ("link = \"crank\"\npositions", "link = \"piston\"\npositions"),
            ("link = \"crank\"\npositions", "positions"),
            ("positions = 24", "positions = 0"),
            ("positions = 24", "positions = -1"),
            ("positions = 24", "positions = 2.5"),
            ("positions = 24", "positions = \"24\""),
            ("positions = 24", "positions = 99999999999999999999"),
            ("positions = 24", "positions = 24\nfrom = 1e15"),
            ("positions = 24", "positions = 24\nfrom = \"10 mm\""),
            ("positions = 24", "positions = 24\ncycle = 0"),
            ("positions = 24", "positions = 24\ncycle = \"-360 deg\""),
            ("positions = 24", "positions = 24\nto = 0"),
            ("positions = 24", "positions = 24\nto = 1\ncycle = 2"),
            ("positions = 24", "positions = 24\ndirection = \"left\""),
            ("positions = 24", "positions = 24\nspeed = 3"),
            ("[input]\nlink = \"crank\"\npositions = 24", ""),
            ("B = [0, 0.23]", "B = [0, 0.23]\nQ = [0, 0]"),
            ("B = [0, 0.23]", "B = 0.23"),
            ("B = [0, 0.23]", "B = [\"1 km\", \"1 deg\"]"),
        ],
    );
}

#[test]
fn loads() {
    answers(
        "loads",
        &[
            ("angle = \"-90 deg\"\nvalue = 700", "value = 700"),
            ("angle = \"-90 deg\"\nvalue = 700", "angle = \"-90 deg\""),
            ("value = 700", "value = \"700 kg\""),
            ("value = 700", "value = 1e29"),
            ("value = 700", "value = { over = \"moon\", table = [[0, 0]] }"),
            ("value = 700", "value = { over = \"time\", table = [] }"),
            ("value = 700", "value = { over = \"time\", table = [[1, 0], [0, 1]] }"),
            ("value = 700", "value = { over = \"time\", table = [[1, 0, 3]] }"),
            ("value = 700", "value = { over = \"stroke\", axis = 0, forward = [[2, 0]] }"),
            ("value = 700", "value = { over = \"stroke\", axis = 0, forward = 5 }"),
            ("value = 700", "value = { over = \"angle\", table = [[0, 0], [\"900 deg\", 1]] }"),
            ("at = \"B\"\nangle", "at = \"A\"\nangle"),
            ("at = \"B\"\nangle", "at = \"Z\"\nangle"),
            ("link = \"piston\"\nat", "link = \"ground\"\nat"),
            ("name = \"gas\"", "name = \"moment 1 on crank\""),
            ("name = \"gas\"", "name = 3"),
            ("name = \"gas\"", "against_motion = true"),
            ("between = [\"C\", \"S2\"]", "between = [\"C\", \"C\"]"),
            ("between = [\"C\", \"S2\"]", "between = [\"A\", \"S2\"]"),
            ("between = [\"C\", \"S2\"]", "between = [\"C\"]"),
            ("between = [\"C\", \"S2\"]", "between = [\"C\", \"piston.S2\"]"),
            ("stiffness = \"4530 N/m\"", "stiffness = -1"),
            ("stiffness = \"4530 N/m\"", "length = -1"),
            ("radius = \"300 mm\"", "radius = -1"),
            ("during = [\"-30 deg\", \"30 deg\"]", "during = [1, 1]"),
            ("during = [\"-30 deg\", \"30 deg\"]", "during = [1, -1]"),
            ("during = [\"-30 deg\", \"30 deg\"]", "during = 3"),
        ],
    );
}

#[test]
fn motions() {
    answers(
        "motions",
        &[
            ("speed = \"900 rpm\"", ""),
            ("speed = \"900 rpm\"", "speed = \"900 m/s\""),
            ("speed = \"900 rpm\"", "speed = 1e12"),
            ("speed = \"900 rpm\"", "speed = 1\nuntil = 3"),
            ("speed = \"900 rpm\"", "kind = \"wild\""),
            ("speed = \"900 rpm\"", "kind = \"transient\""),
            ("speed = \"900 rpm\"", "kind = \"transient\"\nuntil = \"stop\""),
            ("speed = \"900 rpm\"", "kind = \"transient\"\nuntil = \"5 kg\""),
            ("speed = \"900 rpm\"", "kind = \"transient\"\nuntil = -1"),
            ("speed = \"900 rpm\"", "kind = \"transient\"\nuntil = \"5e9 rev\""),
            ("speed = \"900 rpm\"", "kind = \"transient\"\nuntil = \"1e-320 rev\""),
            ("speed = \"900 rpm\"", "kind = \"transient\"\nuntil = 1\ntolerance = 2"),
            ("speed = \"900 rpm\"", "kind = \"transient\"\nuntil = 1\nsamples = 0"),
            ("speed = \"900 rpm\"", "kind = \"steady\""),
            ("speed = \"900 rpm\"", "kind = \"steady\"\nmean_speed = 0"),
            ("speed = \"900 rpm\"", "kind = \"steady\"\nmean_speed = 9\nunevenness = 3"),
            ("[motion]\nspeed = \"900 rpm\"\n", "[drive]\nmotor = \"auto\"\n"),
            ("[motion]", "[drive]\n[motion]"),
            ("[motion]", "[drive]\ntorque = \"balance\"\n[motion]"),
            ("[motion]", "[balance]\nlink = \"ground\"\n[motion]"),
            ("[motion]", "[balance]\nlink = \"piston\"\nat = \"B\"\n[motion]"),
            ("[motion]", "[output]\npoints = [\"Z\"]\n[motion]"),
            ("[motion]", "[output]\nreactions = [\"S2\"]\n[motion]"),
            ("[motion]", "[[friction]]\npair = \"A\"\ncoefficient = 0.1\n[motion]"),
            ("[motion]", "[motion]\nspeed = 1\n[motion]"),
            ("title = \"Engine\"", "title = 3"),
            ("title = \"Engine\"", "title = \"Engine"),
        ],
    );
}
