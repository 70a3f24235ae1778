//! The list of values, other numbers in their place, and that nothing else is touched.

use assur_mechanism::Key;

use super::{ParsedText, SceneValue, replaced};
use crate::tests::{BASE, fixtures};

const SCENE: &str = r#"# A crank.
gravity = [0, "-9.81 m/s²"]   # down
[ground]
points = { O = [0, 0] }
[link.crank]
points = { O = 0, A = '100 mm' }
mass = 4_000.5
center = "O"
[input]
link = "crank"
positions = 12
[[force]]
name = "load"
link = "crank"
at = "A"
angle = "-90 deg"
value = { over = "angle", table = [[0, 0], ["180 deg", 40]] }
"#;

fn values(text: &str) -> Vec<SceneValue> {
    ParsedText::of(text).values()
}

fn value(text: &str, key: &str) -> SceneValue {
    let values = values(text);
    let all: Vec<_> = values.iter().map(|value| value.key.to_string()).collect();
    values.into_iter().find(|value| value.key.to_string() == key).unwrap_or_else(|| panic!("{key}: {all:?}"))
}

#[test]
fn every_number_is_listed_by_its_key_in_the_order_of_the_file() {
    let listed: Vec<_> =
        values(SCENE).into_iter().map(|value| format!("{} {}", value.key, value.written)).collect();
    assert_eq!(
        listed,
        [
            "gravity[0] 0",
            "gravity[1] \"-9.81 m/s²\"",
            "ground.points.O[0] 0",
            "ground.points.O[1] 0",
            "link.crank.points.O 0",
            "link.crank.points.A '100 mm'",
            "link.crank.mass 4_000.5",
            "input.positions 12",
            "force.load.angle \"-90 deg\"",
            "force.load.value.table[0][0] 0",
            "force.load.value.table[0][1] 0",
            "force.load.value.table[1][0] \"180 deg\"",
            "force.load.value.table[1][1] 40",
        ]
    );
}

#[test]
fn every_key_of_the_list_finds_its_value() {
    for (name, text) in fixtures().into_iter().chain([("base".to_owned(), BASE.to_owned())]) {
        let document = ParsedText::of(&text);
        let values = values(&text);
        assert!(values.len() > 5, "{name}");
        for value in values {
            let found = document.find(&value.key).unwrap();
            assert_eq!(found.len(), 1, "{name}: {}", value.key);
            assert_eq!(found[0].span, value.span, "{name}: {}", value.key);
            assert_eq!(text[value.span.clone()], value.written, "{name}: {}", value.key);
        }
    }
}

#[test]
fn a_key_names_a_cell_a_part_of_a_column_or_a_column_of_a_table() {
    let document = ParsedText::of(SCENE);
    let written = |key: &str| -> Result<Vec<&str>, assur_words::Text> {
        let found = document.find(&Key::parse(key)?)?;
        Ok(found.into_iter().map(|place| &SCENE[place.span]).collect())
    };
    assert_eq!(written("force.load.value.table[1][1]").unwrap(), ["40"]);
    assert_eq!(written("force.load.value.table[*][1]").unwrap(), ["0", "40"]);
    assert_eq!(written("force.load.value.table[*][0]").unwrap(), ["0", "\"180 deg\""]);
    assert_eq!(written("force.load.value.table[1..1][0]").unwrap(), ["\"180 deg\""]);
    assert_eq!(written("force.load.value.table[1][*]").unwrap(), ["\"180 deg\"", "40"]);
    assert_eq!(written("force[0].value.table[*][*]").unwrap().len(), 4);
    for (key, problem) in [
        ("force.load.value.table[0..9][1]", "`force.load.value.table` has 2 elements, from [0] to [1]"),
        ("force.load.value.table[1..0][1]", "`[1..0]` is not an element"),
        ("link.crank[*].mass", "`link.crank` is not a list"),
    ] {
        let found = written(key).unwrap_err();
        assert!(found.to_string().starts_with(problem), "{key}: {found}");
    }
}

#[test]
fn a_step_is_per_cent_of_the_file_and_leads_back_to_it() {
    let length = value(SCENE, "link.crank.points.A");
    let one = length.moved(&length.written, 1.0).unwrap();
    assert_eq!(one, "\"101 mm\"");
    let two = length.moved(&one, 1.0).unwrap();
    assert_eq!(two, "\"102 mm\"");
    assert_eq!(length.moved(&two, 0.1).unwrap(), "\"102.1 mm\"");
    assert_eq!(length.moved(&two, 10.0).unwrap(), "\"112 mm\"");
    let back = length.moved(&length.moved(&two, -1.0).unwrap(), -1.0).unwrap();
    assert_eq!(back, length.written, "with the quotes of the file");
    let mass = value(SCENE, "link.crank.mass");
    assert_eq!(mass.moved(&mass.written, 10.0).unwrap(), "4400.55");
    let angle = value(SCENE, "force.load.angle");
    assert_eq!(
        angle.moved(&angle.written, 1.0).unwrap(),
        "\"-89.1 deg\"",
        "up is up for a negative number too"
    );
}

#[test]
fn a_count_moves_by_whole_numbers_and_a_zero_not_at_all() {
    let count = value(SCENE, "input.positions");
    assert_eq!(count.moved("12", 1.0).unwrap(), "13");
    assert_eq!(count.moved("12", -0.1).unwrap(), "11");
    assert_eq!(count.moved("12", 50.0).unwrap(), "18");
    let many = value(&SCENE.replace("= 12", "= 1_200"), "input.positions");
    assert_eq!(many.moved("1_200", 0.1).unwrap(), "1201", "a count as TOML may write it");
    let forty = value(SCENE, "force.load.value.table[1][1]");
    assert_eq!(forty.moved("40", 1.0).unwrap(), "40.4", "an integer that is no count");
    assert_eq!(value(SCENE, "ground.points.O[0]").moved("0", 1.0), None);
}

#[test]
fn what_is_typed_takes_the_unit_of_the_file() {
    let length = value(SCENE, "link.crank.points.A");
    for (typed, toml) in [
        ("61", "\"61 mm\""),
        (" 6.1 cm ", "\"6.1 cm\""),
        ("100", "'100 mm'"),
        ("1e2 mm", "'100 mm'"),
        ("1e40", "\"1e40 mm\""),
        ("2.5e-9 m", "\"2.5e-9 m\""),
        ("solve", "\"solve\""),
        ("a\"b\\", r#""a\"b\\""#),
        ("nan", "\"nan\""),
    ] {
        assert_eq!(length.typed(typed), toml, "{typed}");
    }
    assert_eq!(value(SCENE, "link.crank.mass").typed("2.50"), "2.5");
    assert_eq!(value(SCENE, "link.crank.mass").typed("2 t"), "\"2 t\"");
    // From another unit, per cent are of the number that is there.
    assert_eq!(length.moved("\"50 cm\"", 1.0).unwrap(), "\"50.5 cm\"");
    assert_eq!(length.moved("\"solve\"", 1.0), None);
}

#[test]
fn only_the_values_differ_and_the_scene_reads_them() {
    let (length, mass) = (value(SCENE, "link.crank.points.A"), value(SCENE, "link.crank.mass"));
    let text = replaced(SCENE, [(&mass.span, "5"), (&length.span, "\"120 mm\"")]);
    assert_eq!(text, SCENE.replace("4_000.5", "5").replace("'100 mm'", "\"120 mm\""));
    let mechanism = crate::read("a.toml", &text).unwrap();
    assert_eq!(mechanism.links[1].mass.to_bits(), 5.0_f64.to_bits());
}

#[test]
fn a_text_that_is_no_toml_has_what_can_be_found() {
    for text in ["", "a = ", "\u{feff}x = 1", "x = [1, 2"] {
        let _ = ParsedText::of(text).find(&Key::of("x"));
    }
}
