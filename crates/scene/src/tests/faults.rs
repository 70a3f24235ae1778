//! Every fault: its line and column by hand, its whole text in a snapshot.

use std::fmt::Write as _;

use assur_words::Language;

use super::{BASE, steady};
use crate::{SceneErrors, read};

/// A case: what is replaced in the base scene, by what, and the (line, column) of each fault.
type Case = (&'static str, &'static str, &'static [(usize, usize)]);

/// The faults of a scene as text, checked for their places.
pub(super) fn faults(text: &str, places: &[(usize, usize)]) -> String {
    let errors = read("engine.toml", text).expect_err(text);
    let found: Vec<_> = errors.errors.iter().map(|error| (error.line, error.column)).collect();
    assert_eq!(found, places, "{errors}");
    assert_translated(text, &errors);
    errors.to_string()
}

/// In other languages only what the scene says, its keys and units, and the parser's own words have Latin letters: whatever is
/// no name of a text and not quoted is in the language, and a name is no sentence.
pub(super) fn assert_translated(scene: &str, errors: &SceneErrors) {
    for language in ["uk", "ru"].map(|code| Language::find(code).unwrap()) {
        for error in &errors.errors {
            for text in [Some(&error.message), Some(&error.label), error.help.as_ref()].into_iter().flatten()
            {
                let shown = text.render(language);
                let of_parser = shown.starts_with("не TOML: ");
                for name in text.names() {
                    let is_sentence = name.split(' ').filter(|word| is_word(word)).count() > 1;
                    let is_code = name.contains(['=', '[', '"', ',', '/']) || scene.contains(name);
                    assert!(!is_sentence || is_code || of_parser, "{name:?} in {shown:?}");
                }
                let named: Vec<&str> = text.names().into_iter().flat_map(words).collect();
                // Keys stand before a sign of equality; a unit with `*` is that of the file.
                let prose = unquoted(&shown).replace("kg*m^2", "");
                let prose = prose
                    .split(" =")
                    .map(|part| part.trim_end_matches(|c: char| c.is_ascii_lowercase() || c == '_'));
                let prose = prose.collect::<Vec<_>>().join(" ");
                let left = words(&prose).filter(|word| is_word(word) && !named.contains(word));
                assert_eq!(left.collect::<Vec<_>>(), [""; 0], "{shown:?}");
            }
        }
    }
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_alphanumeric())
}

/// A text without what stands in quotes and brackets.
fn unquoted(text: &str) -> String {
    let mut end = None;
    let outside = text.chars().filter(|&letter| {
        match (end, letter) {
            (Some(sign), _) if letter == sign => end = None,
            (None, '`' | '"') => end = Some(letter),
            (None, '[') => end = Some(']'),
            (None, _) => return true,
            (Some(_), _) => {}
        }
        false
    });
    outside.collect()
}

/// Whether it is a word in Latin letters.
fn is_word(word: &str) -> bool {
    word.len() > 1 && word.chars().all(|c| c.is_ascii_lowercase())
}

/// The whole text of faults, in a file to be read by a person.
pub(super) fn snapshot(name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_omit_expression(true);
    settings.set_prepend_module_to_snapshot(false);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

fn all(base: &str, cases: &[Case]) -> String {
    let mut out = String::new();
    for (old, new, places) in cases {
        assert!(base.contains(old), "{old}");
        let text = base.replacen(old, new, 1);
        let shown = faults(&text, places);
        writeln!(out, "--- {old:?} -> {new:?}\n{shown}").unwrap();
    }
    out
}

#[test]
fn keys() {
    snapshot(
        "keys",
        &all(
            BASE,
            &[
                ("title = ", "titel = ", &[(1, 1)]),
                ("stiffness = \"4530 N/m\"", "lenght = 3", &[(47, 1)]),
                ("link = \"piston\"\non", "on", &[(22, 1)]),
                ("[assembly]", "[asembly]", &[(57, 2)]),
                ("[motion]", "[[motion]]", &[(31, 1)]),
                ("[[slide]]", "[slide]", &[(22, 1)]),
                ("[input]", "[input]\nx.y = 1", &[(28, 1)]),
                ("value = 700", "", &[(34, 1)]),
                ("mass = \"3 kg\"", "mass = \"3 kg\"\nmass = \"3 kg\"", &[(10, 1)]),
                ("mass = \"3 kg\"", "mass = ", &[(9, 8)]),
            ],
        ),
    );
}

#[test]
fn a_fault_of_the_syntax_is_told_by_what_stands_there() {
    snapshot(
        "syntax",
        &all(
            BASE,
            &[
                ("mass = \"3 kg\"", "mass = three", &[(9, 8)]),
                ("mass = \"3 kg\"", "mass = nano kg", &[(9, 8)]),
                ("mass = \"3 kg\"", "mass = .5", &[(9, 8)]),
                ("mass = \"3 kg\"", "mass = 5.", &[(9, 10)]),
                ("mass = \"3 kg\"", "mass = 05", &[(9, 8)]),
                ("mass = \"3 kg\"", "mass", &[(9, 5)]),
                ("[0, \"-400 mm\"]", "[0 1]", &[(5, 29)]),
                ("[0, \"-400 mm\"]", "[0, one]", &[(5, 32)]),
                ("[input]", "[input", &[(27, 7)]),
                ("[link.rod]", "[link.crank]", &[(13, 7)]),
                ("[link.rod]", "[link.\u{448}\u{430}\u{442}\u{443}\u{43d}]", &[(13, 7)]),
                ("mass = \"3 kg\"", "a.b = 1\na.b = 2", &[(10, 3)]),
            ],
        ),
    );
}

#[test]
fn what_follows_from_a_fault_is_no_second_one() {
    let steady = steady();
    let solved = steady.replace("[[force]]", "[drive]\nmotor = \"auto\"\nflywheel = \"solve\"\n\n[[force]]");
    let cases: &[Case] = &[
        ("link = \"crank\"\npositions", "link = \"crnk\"\npositions", &[(28, 8)]),
        ("unevenness = 0.05", "unevenness = -1", &[(34, 14)]),
        ("motor = \"auto\"", "motor = \"auto\"\nratio = -2", &[(38, 9)]),
    ];
    snapshot("once", &all(&solved, cases));
}

#[test]
fn units_and_numbers() {
    snapshot(
        "units_and_numbers",
        &all(
            BASE,
            &[
                ("\"3 kg\"", "\"3 mm\"", &[(9, 8)]),
                ("\"3 kg\"", "\"3 Kg\"", &[(9, 8)]),
                ("\"3 kg\"", "\"3\"", &[(9, 8)]),
                ("\"3 kg\"", "\"3,5 kg\"", &[(9, 8)]),
                ("\"3 kg\"", "nan", &[(9, 8)]),
                ("\"3 kg\"", "1e999", &[(9, 8)]),
                ("\"3 kg\"", "-3", &[(9, 8)]),
                ("\"3 kg\"", "\"-3 kg\"", &[(9, 8)]),
                ("\"3 kg\"", "true", &[(9, 8)]),
                ("\"3 kg\"", "[3]", &[(9, 8)]),
                ("\"60 mm\"", "\"60 deg\"", &[(8, 23)]),
                ("[0, \"-400 mm\"]", "[0, \"-400 mn\"]", &[(5, 32)]),
                ("[0, \"-400 mm\"]", "[0, 1, 2]", &[(5, 28)]),
                ("\"9.81 m/s^2\"", "\"9.81 m/s\"", &[(2, 11)]),
                ("\"9.81 m/s^2\"", "-9.81", &[(2, 11)]),
                ("\"900 rpm\"", "\"900 mm/s\"", &[(32, 9)]),
                ("positions = 24", "positions = 0", &[(29, 13)]),
                ("positions = 24", "positions = 2.5", &[(29, 13)]),
                ("\"4530 N/m\"", "\"4530 N*m\"", &[(47, 13)]),
            ],
        ),
    );
}

#[test]
fn names() {
    snapshot(
        "names",
        &all(
            BASE,
            &[
                ("link = \"piston\"", "link = \"pistno\"", &[(23, 8)]),
                ("link = \"piston\"", "link = \"ground\"", &[(23, 8)]),
                ("on = \"ground\"", "on = \"piston\"", &[(24, 6)]),
                ("at = \"B\"", "at = \"S2\"", &[(37, 6)]),
                ("at = \"B\"", "at = \"Z\"", &[(37, 6)]),
                ("center = \"S2\"", "center = \"S3\"", &[(16, 10)]),
                ("center = \"S2\"\n", "", &[(13, 1)]),
                ("[link.rod]", "[link.ground]", &[(13, 1), (51, 8)]),
                ("[link.rod]", "[link.\"r.d\"]", &[(13, 7), (51, 8)]),
                ("B = [0, 0.23]", "BB = [0, 0.23]", &[(58, 1)]),
                ("[\"C\", \"S2\"]", "[\"C\", \"rod.B2\"]", &[(46, 17)]),
                ("[\"C\", \"S2\"]", "[\"C\", \"piston.A\"]", &[(46, 17)]),
                ("[\"C\", \"S2\"]", "[\"C\", \"pistn.B\"]", &[(46, 17)]),
                ("[\"C\", \"S2\"]", "[\"A\", \"B\"]", &[(46, 11)]),
                ("[\"C\", \"S2\"]", "[\"C\"]", &[(46, 11)]),
                ("[[moment]]", "[[moment]]\nname = \"gas\"", &[(42, 8)]),
                ("[input]", "[[slide]]\nlink = \"piston\"\non = \"ground\"\n[input]", &[(27, 1)]),
            ],
        ),
    );
}

#[test]
fn the_input() {
    snapshot(
        "the_input",
        &all(
            BASE,
            &[
                ("\"crank\"\npositions", "\"rod\"\npositions", &[(28, 8)]),
                ("\"crank\"\npositions", "\"ground\"\npositions", &[(28, 8)]),
                ("points = { O = 0, A", "points = { O = 0, C = 3, A", &[(28, 8)]),
                ("positions = 24", "to = 1\ncycle = 2", &[(30, 9)]),
                ("positions = 24", "to = 0", &[(29, 6)]),
                ("positions = 24", "direction = \"ccv\"", &[(29, 13)]),
                ("positions = 24", "cycle = 0", &[(29, 9)]),
                ("positions = 24", "from = \"1 mm\"", &[(29, 8)]),
                ("[input]\nlink = \"crank\"\npositions = 24\n", "", &[(1, 1)]),
                (
                    "\"crank\"\npositions = 24",
                    "\"piston\"",
                    &[(27, 1), (31, 9), (42, 45), (54, 11), (54, 22)],
                ),
            ],
        ),
    );
}

#[test]
fn a_slide_by_its_links_in_the_other_order_is_told_by_its_name() {
    let text = format!("{BASE}\n[[friction]]\npair = \"ground/piston\"\ncoefficient = 0.1\n");
    let errors = read("engine.toml", &text).unwrap_err();
    assert!(errors.to_string().contains("did you mean `piston/ground`?"), "{errors}");
}

#[test]
fn a_moment_against_the_motion_needs_one_and_a_positive_value() {
    let moment = "\n[[moment]]\nlink = \"crank\"\nagainst_motion = true\nvalue = -5\n";
    let scene = read("engine.toml", &format!("{BASE}{moment}")).unwrap();
    let moment_of = |load: &assur_mechanism::Load| load.kind.moment().is_some_and(|one| one.against_motion);
    assert!(scene.loads.iter().any(moment_of));
    assert!(scene.warnings.iter().any(|one| one.text.to_string().contains("leave the minus sign out")));
    let still = format!("{}{moment}", BASE.replace("[motion]\nspeed = \"900 rpm\"", ""));
    let errors = read("engine.toml", &still).unwrap_err().to_string();
    assert!(errors.contains("against_motion"), "{errors}");
}

#[test]
fn loads() {
    snapshot(
        "loads",
        &all(
            BASE,
            &[
                ("[motion]\nspeed = \"900 rpm\"", "", &[(47, 11)]),
                ("angle = \"-90 deg\"\n", "", &[(34, 1)]),
                ("angle = \"-90 deg\"\n", "angle = 1\nagainst_motion = true\n", &[(38, 9)]),
                ("value = 700", "value = { table = [[0, 1]] }", &[(39, 9)]),
                ("value = 700", "value = { over = \"angel\", table = [[0, 1]] }", &[(39, 18)]),
                (
                    "value = 700",
                    "value = { over = \"time\", table = [], repeat = true }",
                    &[(39, 34), (39, 38)],
                ),
                ("value = 700", "value = { over = \"time\", table = [[1, 1], [0, 2]] }", &[(39, 43)]),
                ("value = 700", "value = { over = \"time\", table = [[1, 1, 1], 2] }", &[(39, 35), (39, 46)]),
                (
                    "value = 700",
                    "value = { over = \"angle\", table = [[0, 1], [\"2 rev\", 2]] }",
                    &[(39, 35)],
                ),
                (
                    "value = 700",
                    "value = { over = \"stroke\", forward = [[0, 1], [2, 3]] }",
                    &[(39, 9), (39, 38)],
                ),
                ("value = 700", "value = { over = \"stroke\", axis = 0 }", &[(39, 9)]),
                (
                    "over = \"angle\", table = [[0, 0], [\"180 deg\", 40]]",
                    "over = \"stroke\", axis = 0, back = 1",
                    &[(43, 18)],
                ),
                ("[\"-30 deg\", \"30 deg\"]", "[\"30 deg\", \"-30 deg\"]", &[(55, 10)]),
                ("radius = \"300 mm\"", "radius = -1", &[(53, 10)]),
                ("damping = 2", "damping = -2", &[(48, 11)]),
            ],
        ),
    );
}

#[test]
fn motions() {
    snapshot(
        "motions",
        &all(
            BASE,
            &[
                ("speed = \"900 rpm\"", "", &[(31, 1)]),
                ("speed = \"900 rpm\"", "kind = \"steddy\"", &[(32, 8)]),
                ("speed = \"900 rpm\"", "speed = 3\nuntil = 3", &[(33, 1)]),
                ("speed = \"900 rpm\"", "kind = \"transient\"", &[(31, 1)]),
                ("speed = \"900 rpm\"", "kind = \"transient\"\nuntil = \"5 mm\"", &[(33, 9)]),
                ("speed = \"900 rpm\"", "kind = \"transient\"\nuntil = \"stop\"", &[(33, 9)]),
                ("speed = \"900 rpm\"", "kind = \"transient\"\nuntil = \"5 sek\"", &[(33, 9)]),
                ("speed = \"900 rpm\"", "kind = \"transient\"\nuntil = \"-5 rev\"", &[(33, 9)]),
                ("speed = \"900 rpm\"", "kind = \"transient\"\nuntil = 1\ntolerance = 1", &[(34, 13)]),
                (
                    "speed = \"900 rpm\"",
                    "kind = \"steady\"\nmean_speed = -3\nunevenness = 2",
                    &[(33, 14), (34, 14)],
                ),
                ("[motion]", "[drive]\ntorque = 3\n[motion]", &[(31, 1)]),
                ("[motion]\nspeed = \"900 rpm\"", "[drive]\ntorque = 3", &[(31, 1), (48, 11)]),
            ],
        ),
    );
}

#[test]
fn drives() {
    let base = steady().replace("[[force]]", "[drive]\n#\n\n[[force]]");
    let rated = "motor = { power = 1, synchronous_speed = 3, rated_speed = 3, max_torque_ratio = 1 }\ncatalogue = \"4A\"";
    let smooth = base.replace("unevenness = 0.05", "#");
    let cases: &[Case] = &[
        ("#", "", &[(36, 1)]),
        ("#", "motor = \"4A\"\ntorque = 3", &[(38, 10)]),
        ("#", "torque = 3\nratio = \"solve\"\nefficiency = 0.9", &[(38, 1), (39, 1)]),
        ("#", "torque = \"balanced\"", &[(37, 10)]),
        ("#", "motor = \"auto\"\nefficiency = 95\nratio = \"sovle\"", &[(38, 14), (39, 9)]),
        ("#", "motor = \"auto\"\nmax_motor_speed = \"3 m/s\"", &[(38, 19)]),
        ("#", "motor = { power = \"1 kW\" }", &[(37, 9), (37, 9)]),
        ("#", rated, &[(37, 59), (37, 81), (38, 1)]),
        ("#", "torque = 3\nflywheel_on = \"motor\"", &[(38, 1), (38, 15)]),
    ];
    let needs: &[Case] = &[("#\n\n[[force]]", "flywheel = \"solve\"\n[[force]]", &[(37, 12)])];
    snapshot("drives", &(all(&base, cases) + &all(&smooth, needs)));
}

#[test]
fn wishes() {
    snapshot(
        "wishes",
        &all(
            BASE,
            &[
                ("[assembly]", "[balance]\nlink = \"rod\"\nat = \"B\"\n[assembly]", &[(57, 1)]),
                ("[assembly]", "[balance]\nlink = \"ground\"\n[assembly]", &[(58, 8)]),
                (
                    "[assembly]",
                    "[output]\npoints = [\"X\"]\nlinks = \"rod\"\n[assembly]",
                    &[(58, 11), (59, 9)],
                ),
                (
                    "[assembly]",
                    "[output]\nslides = [\"piston\"]\nreactions = [\"S2\", \"Q\"]\n[assembly]",
                    &[(58, 11), (59, 14), (59, 20)],
                ),
            ],
        ),
    );
}

#[test]
fn moments_of_inertia_by_formula() {
    let old = "inertia = \"0.008 kg*m^2\"";
    let disc = BASE.replace(old, "inertia = { formula = \"8 + cos(q)\", unit = \"kg*mm^2\" }");
    assert!(read("engine.toml", &disc).is_ok());
    snapshot(
        "inertia",
        &all(
            BASE,
            &[
                (old, "inertia = { formula = \"2 + 3*cos(q)\", unit = \"kg*m^2\" }", &[(11, 11)]),
                (old, "inertia = { formula = \"1e30 + 3*cos(q)\", unit = \"kg*m^2\" }", &[(11, 11)]),
                (old, "inertia = { formula = \"2 + w + t*x\", unit = \"kg*m^2\" }", &[(11, 23)]),
                (old, "inertia = { formula = \"2 + abs(q)\", unit = \"kg*m^2\" }", &[(11, 28)]),
                (old, "inertia = { formula = \"2 + \", unit = \"kg\" }", &[(11, 38)]),
                (old, "inertia = { unit = \"kg*m^2\", axis = 0 }", &[(11, 11), (11, 30)]),
                ("center = \"S2\"", "center = \"S2\"\ninertia = { formula = \"2\" }", &[(17, 23)]),
            ],
        ),
    );
}

#[test]
fn a_text_without_its_closing_quote_is_reported_where_it_begins() {
    let scene = |title: &str, length: &str| {
        format!(
            "title = {title}\n[ground]\npoints = {{ O = [0, 0] }}\n[link.crank]\npoints = {{ O = 0, A = {length} }}\n\
             mass = \"3 kg\"\ninertia = \"1 kg*m^2\"\n[input]\nlink = \"crank\"\n"
        )
    };
    for (text, place) in [
        (scene("\"a", "1"), (1, 9)),
        (scene("'a", "1"), (1, 9)),
        (scene("\"\"\"a", "1"), (1, 9)),
        (scene("'''a", "1"), (1, 9)),
        // In a table within braces the parser goes on over the end of the line.
        (scene("\"a\"", "\"100 mm"), (5, 23)),
        (scene("\"a\"", "'100 mm"), (5, 23)),
    ] {
        let errors = crate::read("scene.toml", &text).unwrap_err().errors;
        let found: Vec<_> = errors.iter().map(|error| (error.line, error.column)).collect();
        assert_eq!(found, [place], "{text}\n{errors:?}");
        assert!(errors[0].message.to_string().contains("no closing quote"), "{errors:?}");
    }
}
