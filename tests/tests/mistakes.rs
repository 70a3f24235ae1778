//! What newcomers write by mistake and a scene allows: each is reported with its key, and no shipped scene has any.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use assur_all as _;
use assur_analysis::{Calculation, Options, unwatched};
use assur_mechanism::Warning;

/// A slider-crank without a fault.
const SCENE: &str = r#"
[ground]
points = { O = [0, 0] }
[link.crank]
points = { O = 0, A = "100 mm" }
mass = "4 kg"
center = "O"
inertia = "0.04 kg*m^2"
[link.rod]
points = { A = 0, B = "400 mm" }
mass = "2 kg"
center = ["150 mm", 0]
inertia = "0.03 kg*m^2"
[link.ram]
points = { B = 0 }
mass = "5 kg"
[[slide]]
link = "ram"
on = "ground"
angle = 0
[input]
link = "crank"
from = "10 deg"
positions = 12
[assembly]
B = ["500 mm", 0]
[motion]
speed = "60 rpm"
[[force]]
name = "cutting"
link = "ram"
at = "B"
angle = "180 deg"
value = "1 kN"
"#;

fn mistakes(scene: &str) -> Vec<Warning> {
    let mechanism = assur_scene::read("test.toml", scene).unwrap_or_else(|errors| panic!("{errors}"));
    let mut warnings = mechanism.warnings.clone();
    let study = Calculation::of(mechanism, &Options::default(), &mut unwatched);
    warnings.extend(study.unwrap_or_else(|error| panic!("{error}")).mistakes());
    assert!(warnings.iter().all(Warning::is_mistake));
    warnings
}

/// What is written, in place of what; the key and the identity of what is reported, and a part of its text.
const MISTAKES: &[(&str, &str, &str, &str, &str)] = &[
    ("from = 30", "from = \"10 deg\"", "input.from", "scene-hardly-meant", "1718.87"),
    ("angle = 180", "angle = \"180 deg\"", "force.cutting.angle", "scene-hardly-meant", "\"180 deg\""),
    ("speed = 1500", "speed = \"60 rpm\"", "motion.speed", "scene-hardly-meant", "\"1500 rpm\""),
    ("O = 0, A = 100 }", "O = 0, A = \"100 mm\" }", "link.crank.points", "scene-far-longer", "100 m long"),
    (
        "O = 0, A = \"-100 mm\" }",
        "O = 0, A = \"100 mm\" }",
        "link.crank.points.A",
        "scene-negative-length",
        "write \"100 mm\", or [\"-100 mm\", 0]",
    ),
    ("inertia = 400", "inertia = \"0.04 kg*m^2\"", "link.crank.inertia", "scene-great-inertia", "10 m"),
    ("center = [150, 0]", "center = [\"150 mm\", 0]", "link.rod.center", "scene-far-center", "149.6 m"),
    ("", "[assembly]\nB = [\"500 mm\", 0]\n", "assembly", "analysis-any-way", "B was put at"),
    ("B = [\"300 mm\", 0]", "B = [\"500 mm\", 0]", "assembly.B", "analysis-place-missed", "198"),
    (
        "angle = \"90 deg\"\nvalue",
        "angle = \"180 deg\"\nvalue",
        "force[0]",
        "analysis-load-without-work",
        "cutting",
    ),
    ("value = 0", "value = \"1 kN\"", "force[0]", "analysis-load-idle", "cutting"),
    ("gravity = 9810\n[ground]", "[ground]", "gravity", "scene-odd-gravity", "9810 m/s²"),
    ("gravity = \"9.81 mm/s^2\"\n[ground]", "[ground]", "gravity", "scene-odd-gravity", "0.00981 m/s²"),
    ("mass = 2000", "mass = \"2 kg\"", "link.rod.mass", "scene-far-heavier", "2000 kg"),
    ("inertia = 3", "inertia = \"0.03 kg*m^2\"", "link.rod.inertia", "scene-great-inertia", "1.225 m"),
    ("inertia = 3e-7", "inertia = \"0.03 kg*m^2\"", "link.rod.inertia", "scene-small-inertia", "0.0003873 m"),
    ("speed = \"600000 rpm\"", "speed = \"60 rpm\"", "motion.speed", "scene-fast", "25130 m/s"),
    (
        "against_motion = true\nvalue = \"-1 kN\"",
        "angle = \"180 deg\"\nvalue = \"1 kN\"",
        "force.cutting.value",
        "scene-negative-against",
        "minus",
    ),
    (
        "value = { formula = \"1000*sin(90)*cos(q)\" }",
        "value = \"1 kN\"",
        "force.cutting.value.formula",
        "scene-degrees-in-formula",
        "`sin`",
    ),
    (
        "value = { formula = \"1000*cos(q*180/pi)\" }",
        "value = \"1 kN\"",
        "force.cutting.value.formula",
        "scene-degrees-in-formula",
        "`cos`",
    ),
    (
        "value = { over = \"angle\", table = [[0, 0], [\"180 deg\", 1000]] }",
        "value = \"1 kN\"",
        "force.cutting.value.table",
        "scene-table-ends",
        "360 deg",
    ),
    (
        "[[spring]]\nbetween = [\"O\", \"B\"]\nlength = \"300 mm\"\n[[force]]",
        "[[force]]",
        "spring[0].stiffness",
        "scene-spring-without-stiffness",
        "stiffness missing",
    ),
    (
        "kind = \"transient\"\nuntil = \"10 ms\"\n[drive]\nmotor = { power = 1100, synchronous_speed = \"60 rpm\", rated_speed = \
         \"58 rpm\", max_torque_ratio = 220 }",
        "speed = \"60 rpm\"",
        "drive.motor.max_torque_ratio",
        "scene-great-torque-ratio",
        "2.2",
    ),
    ("value = 1e9", "value = \"1 kN\"", "force[0].value", "scene-strong", "1000000000 N"),
    (
        "value = { over = \"time\", table = [[0, 0], [500, 1000]] }",
        "value = \"1 kN\"",
        "force[0].value.table",
        "scene-long-time",
        "500 s",
    ),
    (
        "[[spring]]\nbetween = [\"O\", \"B\"]\nstiffness = 100\nlength = 300\n[[force]]",
        "[[force]]",
        "spring[0].length",
        "scene-long-spring",
        "300 m",
    ),
    (
        "[[friction]]\npair = \"A\"\ncoefficient = 10\nradius = 0.015\n[[force]]",
        "[[force]]",
        "friction[0].coefficient",
        "scene-rough",
        "10",
    ),
    (
        "[[friction]]\npair = \"A\"\ncoefficient = 0.1\nradius = 15\n[[force]]",
        "[[force]]",
        "friction[0].radius",
        "scene-great-journal",
        "15 m",
    ),
    ("[output]\n[motion]", "[motion]", "output", "scene-empty-output", "names nothing"),
    ("gravity = [0, 9.81]\n[ground]", "[ground]", "gravity", "scene-gravity-up", "upward"),
    ("mass = \"2 g\"", "mass = \"2 kg\"", "link.rod.mass", "scene-far-lighter", "0.002 kg"),
    ("to = \"360 deg\"", "from = \"10 deg\"", "input.to", "scene-list-repeats", "positions = 13"),
    ("cycle = \"180 deg\"", "from = \"10 deg\"", "input.cycle", "scene-part-of-a-turn", "180 deg"),
    ("center = [\"1500 mm\", 0]", "center = [\"150 mm\", 0]", "link.rod.center", "scene-far-center", "1.1 m"),
    (
        "center = [\"150 mm\", 0]",
        "mass = \"2 kg\"\ncenter = [\"150 mm\", 0]",
        "link.rod.inertia",
        "scene-inertia-without-mass",
        "`mass`",
    ),
    (
        "direction = \"cw\"\n[assembly]\nB = [\"500 mm\", 0]\n[motion]\nspeed = \"-60 rpm\"",
        "[assembly]\nB = [\"500 mm\", 0]\n[motion]\nspeed = \"60 rpm\"",
        "motion.speed",
        "scene-turned-twice",
        "minus",
    ),
    (
        "O = 0, A = [\"98.4808 mm\", \"17.3648 mm\"]",
        "O = 0, A = \"100 mm\"",
        "input.from",
        "scene-counted-twice",
        "20 deg",
    ),
    (
        "kind = \"steady\"\nmean_speed = \"60 rpm\"\nunevenness = 0.05\n[drive]\ntorque = \"balance\"\nflywheel = 20",
        "speed = \"60 rpm\"",
        "motion.unevenness",
        "scene-unevenness-unused",
        "solve",
    ),
    // A place of a point that the crank alone carries chooses nothing.
    ("A = [\"98 mm\", \"17 mm\"]", "B = [\"500 mm\", 0]", "assembly", "analysis-any-way", "B was put at"),
];

#[test]
fn each_mistake_is_told_once_at_its_key() {
    assert_eq!(mistakes(SCENE), []);
    for &(wrong, right, key, id, part) in MISTAKES {
        assert!(SCENE.contains(right), "{right}");
        let found = mistakes(&SCENE.replacen(right, wrong, 1));
        // A wrong place of the first position, for one, has a wrong place of the assembly as its consequence.
        let mut told = found.iter().filter(|notice| notice.text.identity() == Some(id));
        let (Some(notice), None) = (told.next(), told.next()) else { panic!("{wrong}: {found:?}") };
        assert_eq!(notice.key.as_ref().map(ToString::to_string).as_deref(), Some(key), "{wrong}");
        assert!(notice.to_string().contains(part), "{wrong}: {notice}");
    }
}

/// A resistance of the speed with the sign of an input that turns the other way.
#[test]
fn a_moment_that_drives_an_input_clockwise_is_told() {
    let told = |formula: &str, direction: &str| {
        let input = format!("link = \"crank\"\ndirection = \"{direction}\"\n");
        let moment =
            format!("[[moment]]\nlink = \"crank\"\nvalue = {{ formula = \"{formula}\" }}\n[[force]]");
        let scene = SCENE.replacen("link = \"crank\"\n", &input, 1).replacen("[[force]]", &moment, 1);
        assert!(scene.contains(&input) && scene.contains(&moment));
        mistakes(&scene).iter().any(|notice| notice.text.identity() == Some("scene-drives-clockwise"))
    };
    for resisting in ["5*w", "0.1*w*abs(w)", "-5*w + 10", "-5*w*cos(q)", "-5*sign(w + 1)"] {
        assert!(!told(resisting, "cw"), "{resisting}");
    }
    for driving in ["-5*w", "-0.1*w*abs(w)", "w*(-5)", "-5*(2*w)^3"] {
        assert!(told(driving, "cw"), "{driving}");
        assert!(!told(driving, "ccw"), "{driving}");
    }
}

/// A guide across its crank: the ram stays where it is while the stone goes round.
#[test]
fn what_never_moves_is_told() {
    let scene = "[ground]\npoints = { O = 0 }\n[link.crank]\npoints = { O = 0 }\n[link.stone]\npoints = { P = 0 }\n\
        [link.ram]\npoints = { P = 0 }\n[[slide]]\nlink = 'stone'\non = 'crank'\n[[slide]]\nlink = 'ram'\non = 'ground'\n\
        [input]\nlink = 'crank'\nfrom = '15 deg'\npositions = 8\n";
    let found = mistakes(scene);
    let of = |id: &str| found.iter().filter(|notice| notice.text.identity() == Some(id)).count();
    assert_eq!((of("analysis-link-rests"), of("analysis-slide-rests")), (1, 1), "{found:?}");
}

#[test]
fn a_moment_of_inertia_that_others_have_is_missed() {
    let scene =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../fixtures/four-bar.toml")).unwrap();
    let told = |line: &str| {
        let found = mistakes(&scene.replace(line, ""));
        found
            .into_iter()
            .map(|one| (one.key.map_or_else(String::new, |key| key.to_string()), one.text.identity()))
            .collect::<Vec<_>>()
    };
    let id = Some("scene-mass-without-inertia");
    assert_eq!(told("inertia = \"0.019 kg*m^2\"\n"), [("link.coupler.mass".to_owned(), id)]);
    let zero = scene.replace("inertia = \"0.019 kg*m^2\"", "inertia = 0");
    assert_eq!(mistakes(&zero), []);
    assert_eq!(
        told("inertia = \"0.003 kg*m^2\"\n"),
        [],
        "that of the input link does nothing at a constant speed"
    );
}

/// A motion from rest that nothing drives stays there.
#[test]
fn a_motion_that_never_starts_is_told() {
    let scene = "[ground]\npoints = { O = 0 }\n[link.crank]\npoints = { O = 0 }\ninertia = 1\n\
        [input]\nlink = 'crank'\n[motion]\nkind = 'transient'\nuntil = '1 s'\n";
    let told =
        |scene: &str| mistakes(scene).iter().any(|one| one.text.identity() == Some("analysis-never-starts"));
    assert!(told(scene));
    assert!(!told(&scene.replace("until", "speed = 1\nuntil")));
}

/// A radian is a radian where nobody would take it for a degree: quarters of a turn in all digits, turns of an engine.
#[test]
fn what_is_right_is_not_doubted() {
    for (right, also) in [
        ("from = \"10 deg\"", "from = 0.17"),
        ("from = \"10 deg\"", "from = \"10 deg\"\ncycle = \"720 deg\""),
        ("from = \"10 deg\"", "from = \"10 deg\"\ncycle = 12.566370614359172"),
        ("angle = \"180 deg\"", "angle = 3.141592653589793"),
        ("speed = \"60 rpm\"", "speed = 600"),
        ("B = [\"500 mm\", 0]", "B = [\"480 mm\", \"10 mm\"]"),
        // Unusual, but right: on the moon, without weight, a heavy flywheel on the crank, a press, an engine.
        ("[ground]", "gravity = \"1.62 m/s^2\"\n[ground]"),
        ("[ground]", "gravity = 0\n[ground]"),
        ("mass = \"4 kg\"", "mass = \"200 kg\""),
        ("inertia = \"0.04 kg*m^2\"", "inertia = \"2 kg*m^2\""),
        ("mass = \"2 kg\"\ncenter = [\"150 mm\", 0]\ninertia = \"0.03 kg*m^2\"\n", ""),
        ("value = \"1 kN\"", "value = { formula = \"1000*(2 + sin(2*q + 3))\" }"),
        ("value = \"1 kN\"", "value = { formula = \"1000*cos(q - 30*pi/180)\" }"),
        ("value = \"1 kN\"", "value = { formula = \"1000*sin(12*q)\" }"),
        ("value = \"1 kN\"", "value = \"5 MN\""),
        ("value = \"1 kN\"", "value = { over = \"time\", table = [[0, 0], [5, 1000]] }"),
        ("speed = \"60 rpm\"", "speed = \"9000 rpm\""),
        // A table that ends inside the cycle as it begins, with a jump, with a row at the end, or with `repeat`.
        ("value = \"1 kN\"", "value = { over = \"angle\", table = [[0, 0], [1, 9], [2, 0]] }"),
        ("value = \"1 kN\"", "value = { over = \"angle\", table = [[0, 9], [2, 9], [2, 0]] }"),
        ("value = \"1 kN\"", "value = { over = \"angle\", table = [[0, 0], [2, 9], [\"360 deg\", 9]] }"),
        ("value = \"1 kN\"", "value = { over = \"angle\", table = [[0, 0], [2, 9]], repeat = true }"),
        ("[[force]]", "[[spring]]\nbetween = [\"O\", \"B\"]\ndamping = 9\n[[force]]"),
        ("[[force]]", "[[friction]]\npair = \"A\"\ncoefficient = 0.8\nradius = \"5 mm\"\n[[force]]"),
        ("[[force]]", "[[spring]]\nbetween = [\"O\", \"B\"]\nstiffness = 100\nlength = 1\n[[force]]"),
        ("points = { O = [0, 0] }", "points = { O = [0, 0], Far = [3, 0] }"),
        ("from = \"10 deg\"\npositions = 12", "to = \"360 deg\"\npositions = 13"),
        ("from = \"10 deg\"\npositions = 12", "from = \"-30 deg\"\nto = \"60 deg\"\npositions = 12"),
        ("positions = 12", "positions = 1"),
        ("positions = 12", "positions = 12\ndirection = \"cw\""),
        ("speed = \"60 rpm\"", "speed = \"-60 rpm\""),
        ("mass = \"4 kg\"\ncenter = \"O\"", "mass = \"4 kg\"\ncenter = [\"-200 mm\", 0]"),
        ("A = \"100 mm\" }", "A = \"100 mm\", K = \"-30 mm\" }"),
        ("mass = \"4 kg\"\n", ""),
        ("center = [\"150 mm\", 0]\ninertia = \"0.03 kg*m^2\"", "center = [\"150 mm\", 0]"),
        ("mass = \"2 kg\"", "mass = \"500 g\""),
        ("[ground]", "gravity = [9.81, 0]\n[ground]"),
    ] {
        assert!(SCENE.contains(right), "{right}");
        assert_eq!(mistakes(&SCENE.replacen(right, also, 1)), [], "{also}");
    }
}

#[test]
fn names_that_look_the_same_are_told() {
    // The rod's B is a Cyrillic letter: no pin, so that the mobility is wrong, and the mistake is named beside it.
    let scene = SCENE.replacen("A = 0, B = ", "A = 0, \"В\" = ", 1);
    let mechanism = assur_scene::read("test.toml", &scene).unwrap();
    assert_eq!(mechanism.warnings[0].text.identity(), Some("scene-same-appearance"));
    let error = Calculation::of(mechanism, &Options::default(), &mut unwatched).unwrap_err().to_string();
    assert!(error.contains("have similar names"), "{error}");
    let small = SCENE.replacen("A = 0, B = ", "A = 0, b = ", 1);
    let mechanism = assur_scene::read("test.toml", &small).unwrap();
    let error = Calculation::of(mechanism, &Options::default(), &mut unwatched).unwrap_err().to_string();
    assert!(error.contains("`b` and `B`"), "{error}");
}

/// What the reader refuses, and what it answers.
#[test]
fn what_newcomers_write_is_answered_with_what_to_write() {
    for (wrong, right, part) in [
        ("\u{201c}100 mm\u{201d}", "\"100 mm\"", "quotes of a word processor"),
        ("\u{2018}crank\u{2019}\nfrom", "\"crank\"\nfrom", "quotes of a word processor"),
        ("A = 100 mm }", "A = \"100 mm\" }", "is written in quotes: \"100 mm\""),
        ("from = 10\u{b0}", "from = \"10 deg\"", "is written in quotes: \"10\u{b0}\""),
        ("center = [0,15, 0]", "center = [\"150 mm\", 0]", "is the comma meant as a decimal separator?"),
        ("J = 0.04", "inertia = \"0.04 kg*m^2\"", "did you mean `inertia`?"),
        ("omega = 6.28", "speed = \"60 rpm\"", "did you mean `speed`?"),
        ("length = 0.4", "points = { A = 0, B = \"400 mm\" }", "did you mean `points`?"),
        ("start = \"10 deg\"", "from = \"10 deg\"", "did you mean `from`?"),
        ("direction = \"180 deg\"", "angle = \"180 deg\"", "did you mean `angle`?"),
        ("magnitude = \"1 kN\"", "value = \"1 kN\"", "did you mean `value`?"),
        ("positions = 12\nspeed = 6", "positions = 12", "it belongs in [motion]"),
        ("on = \"ground\"\nmass = 5", "on = \"ground\"", "it belongs in [link.NAME]"),
        ("kind = \"transient\"\nuntil = \"1 zz\"", "speed = \"60 rpm\"", "\"rest\" or \"turn\""),
        ("A = \"100 мм\"", "A = \"100 mm\"", "did you mean `mm`?"),
        ("speed = \"60 об/мин\"", "speed = \"60 rpm\"", "did you mean `rev/min`?"),
        ("from = \"10 degrees\"", "from = \"10 deg\"", "did you mean `deg`?"),
        ("value = \"1 000 N\"", "value = \"1 kN\"", "digits together"),
        ("mass = \"2 kg\" // rod", "mass = \"2 kg\"", "a comment begins with `#`"),
        ("center = \"15 mm, 0\"", "center = [\"150 mm\", 0]", "[\"15 mm\", 0]"),
        ("link = \"\u{441}rank\"\nfrom", "link = \"crank\"\nfrom", "letters of another alphabet: U+0441"),
        ("mass: \"2 kg\"", "mass = \"2 kg\"", "joined by `=`"),
        ("mass = \"2 kg\";", "mass = \"2 kg\"", "without `;`"),
        ("mass = 2,5", "mass = \"2 kg\"", "is the comma meant as a decimal separator?"),
        ("O = 0 A = \"100 mm\" }", "O = 0, A = \"100 mm\" }", "a comma is missing"),
        ("O = 0, A = \"100 mm\"", "O = 0, A = \"100 mm\" }", "has no closing one"),
        ("O = (0, 0)", "O = [0, 0]", "square brackets"),
        ("mass\u{a0}= \"2 kg\"", "mass = \"2 kg\"", "U+00A0"),
        ("on = \"ground\"\ngravity = 9.81", "on = \"ground\"", "at the top of the file"),
        (
            "value = { over = \"angle\", table = [[0, 0], [180, 9], [360, 0]] }",
            "value = \"1 kN\"",
            "write \"360 deg\"",
        ),
        ("value = { formula = \"sin(2q)\" }", "value = \"1 kN\"", "write `*`"),
        ("value = { formula = \"q**2\" }", "value = \"1 kN\"", "written with `^`"),
        ("value = { formula = \"sin(phi)\" }", "value = \"1 kN\"", "did you mean `q`?"),
        ("value = { formula = \"9*sin q\" }", "value = \"1 kN\"", "as in sin(q)"),
        ("value = { formula = \"1,5*q\" }", "value = \"1 kN\"", "is the comma meant as a decimal separator?"),
        ("value = { formula = \"9*(q > pi)\" }", "value = \"1 kN\"", "step(q - 3)"),
        ("formula = \"9*q\"", "value = \"1 kN\"", "it belongs in value = { ... }"),
        ("A = 0,1 }", "A = \"100 mm\" }", "is the comma meant as a decimal separator?"),
        ("positions = \"12\"", "positions = 12", "without quotes"),
        ("step = \"30 deg\"", "positions = 12", "did you mean `positions`?"),
        ("speed = \"60 1/min\"", "speed = \"60 rpm\"", "did you mean `rpm`?"),
        ("[input]\nlink = \"crank\"\n[input]", "[input]", "it is already in line 21"),
        ("value = { formula = \"sin(\u{445})\" }", "value = \"1 kN\"", "Latin letters"),
        (
            "value = { over = \"time\", table = [[0, 0]], repeat = true }",
            "value = \"1 kN\"",
            "another kind: angle",
        ),
    ] {
        assert!(SCENE.contains(right), "{right}");
        let errors =
            assur_scene::read("test.toml", &SCENE.replacen(right, wrong, 1)).unwrap_err().to_string();
        assert!(errors.contains(part), "{wrong}: {errors}");
    }
}

#[test]
fn a_guide_through_the_origin_and_pins_of_one_link_are_named() {
    let away =
        SCENE.replacen("O = [0, 0]", "O = [\"600 mm\", 0]", 1).replacen("angle = 0", "angle = \"90 deg\"", 1);
    let error = refused(&away);
    assert!(error.contains("`ram/ground` goes through the origin of `ground`"), "{error}");
    let loose = refused(&SCENE.replacen("B = \"400 mm\"", "Q = \"400 mm\"", 1).replacen(
        "[assembly]\nB",
        "[assembly]\nQ",
        1,
    ));
    assert!(loose.contains("in one link only: rod: Q, ram: B"), "{loose}");
}

#[test]
fn a_formula_in_place_of_a_number_is_sent_to_its_key() {
    let scene = SCENE.replacen("value = \"1 kN\"", "value = \"1000*sin(q)\"", 1);
    let errors = assur_scene::read("test.toml", &scene).unwrap_err().to_string();
    assert!(errors.contains("{ formula = \"1000*sin(q)\" }"), "{errors}");
}

#[test]
fn a_unit_is_suggested_from_its_own_kind_only() {
    let scene = SCENE.replacen("\"100 mm\"", "\"4 inn\"", 1);
    let errors = assur_scene::read("test.toml", &scene).unwrap_err().to_string();
    assert!(errors.contains("`in`") && !errors.contains("`min`"), "{errors}");
}

#[test]
fn no_shipped_scene_has_a_mistake() {
    for (name, text) in assur_fixtures::SCENES {
        assert_eq!(mistakes(text), [], "{name}");
    }
}

fn refused(scene: &str) -> String {
    let mechanism = assur_scene::read("test.toml", scene).unwrap();
    match Calculation::of(mechanism, &Options::default(), &mut unwatched) {
        Err(error) => error.to_string(),
        Ok(study) => study.analyze(&mut unwatched).unwrap().failures[0].message.to_string(),
    }
}

/// A crank, a coupler of two links, a rocker: a chain of five links, which two inputs move.
#[test]
fn two_degrees_of_freedom_are_told_as_such() {
    let error = refused(
        "[ground]\npoints = { O = 0, E = 0.5 }\n[link.a]\npoints = { O = 0, A = 0.1 }\n[link.b]\npoints = { A = 0, B = 0.3 }\n\
         [link.c]\npoints = { B = 0, C = 0.3 }\n[link.d]\npoints = { C = 0, E = 0.2 }\n[input]\nlink = 'a'\n",
    );
    assert!(error.contains("2 degrees of freedom (3*4 - 2*5), so it takes 2 inputs"), "{error}");
}

#[test]
fn parallel_guides_are_named() {
    let scene = "[ground]\npoints = { O = 0 }\n[link.crank]\npoints = { O = 0, A = 0.1 }\n[link.yoke]\npoints = { B = 0 }\n\
        [link.block]\npoints = { A = 0 }\n[[slide]]\nlink = 'yoke'\non = 'ground'\n[[slide]]\nlink = 'block'\non = 'yoke'\n\
        [input]\nlink = 'crank'\nfrom = 0.2\n";
    let error = refused(scene);
    assert!(error.contains("the guides of `yoke/ground` and `block/yoke` are parallel"), "{error}");
    let across = scene.replace("on = 'yoke'", "on = 'yoke'\nangle = '90 deg'");
    let mechanism = assur_scene::read("test.toml", &across).unwrap();
    let study = Calculation::of(mechanism, &Options::default(), &mut unwatched).unwrap();
    assert_eq!(study.analyze(&mut unwatched).unwrap().failures.len(), 0);
}

/// A ram that slides on the rod to which it is pinned leaves the rod loose; a shoe that is pinned to the ram and slides on it goes with
/// the ram, and its constraints repeat.
#[test]
fn a_slide_between_pinned_links_is_refused_where_it_is_not_passive() {
    let error = refused(&SCENE.replacen("on = \"ground\"", "on = \"rod\"", 1));
    assert!(error.contains("slide `ram/rod`: pin `B` joins the same two links"), "{error}");
    let shoe = SCENE.replacen(
        "points = { B = 0 }",
        "points = { B = 0, C = 0.05 }\n[link.shoe]\npoints = { C = 0 }",
        1,
    );
    let shoe = shoe.replacen("mass = \"5 kg\"\n", "", 1) + "[[slide]]\nlink = \"shoe\"\non = \"ram\"\n";
    let mechanism = assur_scene::read("test.toml", &shoe).unwrap();
    let study = Calculation::of(mechanism, &Options::default(), &mut unwatched).unwrap();
    let passive = study.analyze(&mut unwatched).unwrap().structure.passive;
    assert!(
        matches!(&passive[..], [one] if one.what.to_string() == "link shoe" && one.fits()),
        "{passive:?}"
    );
}

/// A wedge of 5 deg on the ground lifts a block in a vertical guide: the block's x axis lies along that guide, so 85 deg from the
/// wedge's face.
#[test]
fn slides_that_disagree_about_an_angle_are_told_with_the_tilt() {
    let scene = "[ground]\npoints = { O = 0 }\n[link.wedge]\npoints = { W = 0 }\n[link.block]\npoints = { B = 0 }\n\
        [[slide]]\nlink = 'wedge'\non = 'ground'\n[[slide]]\nlink = 'block'\non = 'ground'\nangle = '90 deg'\n\
        [[slide]]\nlink = 'block'\non = 'wedge'\nangle = '5 deg'\n[input]\nlink = 'wedge'\nto = 0.1\npositions = 3\n";
    let error = refused(scene);
    assert!(
        error.contains("`block/wedge` differs by 85 deg") && error.contains("tilt = \"85 deg\""),
        "{error}"
    );
    let right = scene.replace("angle = '5 deg'", "angle = '5 deg'\ntilt = '85 deg'");
    let mechanism = assur_scene::read("test.toml", &right).unwrap();
    let study = Calculation::of(mechanism, &Options::default(), &mut unwatched).unwrap();
    let analysis = study.analyze(&mut unwatched).unwrap();
    assert!(analysis.structure.passive.iter().all(assur_kinematics::Misfit::fits));
    // Turned round, the block carries the guide: there the tilt is what closes.
    let turned = scene.replace(
        "link = 'block'\non = 'wedge'\nangle = '5 deg'",
        "link = 'wedge'\non = 'block'\nangle = '-85 deg'",
    );
    let mechanism = assur_scene::read("test.toml", &turned).unwrap();
    let study = Calculation::of(mechanism, &Options::default(), &mut unwatched).unwrap();
    let passive = study.analyze(&mut unwatched).unwrap().structure.passive;
    let closes = passive[0].closes.as_ref().unwrap();
    assert_eq!(closes.key.to_string(), "slide.wedge/block.tilt");
    assert!((closes.value + 5.0_f64.to_radians()).abs() < 1e-9 && passive[0].angle.is_some());
}
