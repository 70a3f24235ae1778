//! Tables that are made, change their sort, or have keys that exclude each other.

use assur_fixtures::scene;

use super::{key, of, read, reads, shaper, typing};
use crate::{Change, made, sections, table};

/// A table of a sort made as the value of a key.
fn make(text: &str, at: &str, sort: Option<&str>) -> Change {
    let field = of(text, at);
    let opening = field.opens.iter().find(|opening| opening.sort == sort);
    made(text, &field.key, opening.unwrap_or_else(|| panic!("{at}: {sort:?}")))
}

fn value(text: &str, at: &str) -> String {
    of(text, at).value.unwrap_or_default()
}

fn also(change: &Change) -> Vec<String> {
    change.also.iter().map(ToString::to_string).collect()
}

#[test]
fn a_force_becomes_a_table_and_keeps_its_number() {
    let boom = scene("boom");
    let stroke = reads(make(boom, "force[0].value", Some("stroke")));
    let made = "{ over = \"stroke\", axis = \"180 deg\", forward = [[0, \"2 kN\"], [1, \"2 kN\"]] }";
    assert_eq!(value(&stroke, "force[0].value"), made);
    // The coordinate of a boom is the length of its cylinder.
    let over = reads(make(&stroke, "force[0].value", Some("angle")));
    assert_eq!(
        value(&over, "force[0].value"),
        "{ over = \"angle\", table = [[0, \"2 kN\"], [\"100 mm\", \"2 kN\"]] }"
    );
    let time = reads(typing(&over, "force[0].value.over", "time"));
    assert_eq!(
        value(&time, "force[0].value"),
        "{ over = \"time\", table = [[0, \"2 kN\"], [\"1 s\", \"2 kN\"]] }"
    );
    let formula = reads(make(boom, "force[0].value", Some("formula")));
    assert_eq!(value(&formula, "force[0].value"), "{ formula = \"2000\" }");
    let speed = reads(make(&formula, "force[0].value", Some("speed")));
    assert!(value(&speed, "force[0].value").starts_with("{ over = \"speed\", table = [[0, "));
    let back = reads(typing(&speed, "force[0].value", "1500"));
    assert_eq!(value(&back, "force[0].value"), "1500");
}

#[test]
fn a_form_shows_the_keys_of_its_sort() {
    let labels = |text: &str, at: &str| -> Vec<String> {
        table(text, &key(at), &[]).fields.into_iter().map(|field| field.label).collect()
    };
    let value = "force[0].value";
    assert_eq!(labels(shaper(), value), ["over", "shape", "axis", "forward", "back"]);
    let angle = reads(make(shaper(), value, Some("angle")));
    assert_eq!(labels(&angle, value), ["over", "table", "shape", "repeat"]);
    let formula = reads(make(shaper(), value, Some("formula")));
    assert_eq!(labels(&formula, value), ["axis", "formula", "unit"]);
    let sorts: Vec<_> = table(shaper(), &key(value), &[])
        .sorts
        .into_iter()
        .map(|one| (one.sort.unwrap(), one.stands))
        .collect();
    assert_eq!(
        sorts,
        [("angle", false), ("time", false), ("speed", false), ("stroke", true), ("formula", false)]
    );
    let friction = scene("shaper-friction");
    assert_eq!(labels(friction, "friction[0]"), ["pair", "coefficient", "radius", "owner"]);
    assert_eq!(labels(friction, "friction[4]"), ["pair", "coefficient", "length", "middle", "offset"]);
    assert_eq!(labels(shaper(), "motion"), ["kind", "speed", "acceleration"]);
    assert_eq!(labels(scene("five-bar"), "motion"), ["kind", "until", "samples"]);
    // Of a table that does not stand yet, and of points.
    assert_eq!(labels(shaper(), "balance"), ["link", "at", "angle"]);
    assert_eq!(labels(shaper(), "link.rocker.points"), ["C", "S3", "D"]);
    assert_eq!(labels(shaper(), "assembly"), ["D", "A", "S3", "E", "K"]);
    assert!(labels(shaper(), "nothing").is_empty());
    // A key that belongs to another sort is shown, so that it can be removed.
    let odd = shaper().replace("over = \"stroke\"", "over = \"stroke\", repeat = true");
    assert!(labels(&odd, value).contains(&"repeat".to_owned()));
}

#[test]
fn another_kind_of_motion_has_its_own_keys() {
    let steady = typing(shaper(), "motion.kind", "steady");
    assert_eq!(also(&steady), ["motion.mean_speed", "motion.speed"]);
    let steady = reads(steady);
    assert_eq!(value(&steady, "motion.mean_speed"), "\"60 rpm\"");
    let transient = reads(typing(&steady, "motion.kind", "transient"));
    assert_eq!(
        (value(&transient, "motion.until"), value(&transient, "motion.mean_speed")),
        ("\"5 rev\"".to_owned(), String::new())
    );
    // A law of the input over time leaves the motion its end.
    let law = make(shaper(), "input.over_time", Some("table"));
    assert_eq!(also(&law), ["input.positions", "motion.speed", "motion.until"]);
    let law = reads(law);
    assert!(read(&law).input.drivers[0].law.is_some());
    let uniform = typing(&law, "input.over_time", "");
    assert_eq!(also(&uniform), ["motion.speed", "motion.until"]);
    reads(uniform);
}

#[test]
fn keys_that_exclude_each_other_take_turns() {
    let against = typing(shaper(), "force[0].against_motion", "true");
    assert_eq!(also(&against), ["force[0].angle"]);
    let against = reads(against);
    let by_angle = typing(&against, "force[0].angle", "30 deg");
    assert_eq!(also(&by_angle), ["force[0].against_motion"]);
    reads(by_angle);
    // What is the default excludes nothing.
    assert!(typing(shaper(), "force[0].against_motion", "false").also.is_empty());
    let pin = typing(shaper(), "input.pin", "O");
    assert_eq!(also(&pin), ["input.link", "input.of"]);
    assert_eq!(value(&reads(pin), "input.of"), "\"crank\"");
    let boom = reads(typing(scene("boom"), "input.cycle", "400 mm"));
    assert_eq!(value(&boom, "input.to"), "");
    let torque = reads(typing(scene("compressor-start"), "drive.torque", "balance"));
    assert_eq!(
        ["motor", "catalogue", "ratio", "max_motor_speed"].map(|at| value(&torque, &format!("drive.{at}"))),
        [""; 4]
    );
    let rated = reads(make(scene("compressor-start"), "drive.motor", None));
    assert!(value(&rated, "drive.motor").starts_with("{ power = \"1.1 kW\""));
    assert_eq!(value(&rated, "drive.catalogue"), "");
    // The friction of a pin has a radius, that of a slide has none.
    let slide = typing(scene("shaper-friction"), "friction[0].pair", "O");
    assert!(slide.also.is_empty());
    let loose = scene("shaper-friction").replace("pair = \"stone2/rocker\"", "pair = \"stone4/ram\"");
    let swapped = typing(&loose, "friction[0].pair", "stone2/rocker");
    assert_eq!(also(&swapped), ["friction[0].radius"]);
}

#[test]
fn sections_are_all_tables_of_a_scene() {
    let all = sections(shaper());
    let headers: Vec<_> = all.iter().map(|section| section.header).collect();
    assert_eq!(
        headers[..7],
        ["", "[ground]", "[link.NAME]", "[[slide]]", "[input]", "[[input]]", "[assembly]"]
    );
    let of = |header: &str| all.iter().find(|section| section.header == header).unwrap();
    let slides: Vec<_> =
        of("[[slide]]").instances.iter().map(|one| (one.key.to_string(), one.label.to_string())).collect();
    assert_eq!(slides[1], ("slide[1]".to_owned(), "stone4/ram".to_owned()));
    assert_eq!(of("[link.NAME]").instances.len(), 5);
    let can: Vec<_> = all.iter().filter(|section| section.can_add).map(|section| section.header).collect();
    assert_eq!(
        can,
        [
            "[[slide]]",
            "[[force]]",
            "[[moment]]",
            "[[spring]]",
            "[[contact]]",
            "[[brake]]",
            "[[friction]]",
            "[balance]",
            "[drive]",
            "[output]",
            "[labels]",
            "[note]",
            "[sheet]",
        ]
    );
    let five_bar = sections(scene("five-bar"));
    let inputs: Vec<_> = five_bar
        .iter()
        .filter(|one| one.header.contains("input"))
        .map(|one| (one.instances.len(), one.can_add))
        .collect();
    assert_eq!(inputs, [(0, false), (2, true)]);
    assert!(all.iter().skip(1).all(|section| !section.about.is_empty()));
}

#[test]
fn while_a_value_is_refused_nothing_else_changes() {
    let friction = scene("shaper-friction");
    let change = typing(friction, "friction[5].pair", "sto");
    assert!(change.here.is_some() && change.also.is_empty());
    assert_eq!(change.text, friction.replace("pair = \"stone4/ram\"", "pair = \"sto\""));
    let change = typing(shaper(), "input.pin", "Q");
    assert!(change.here.unwrap().message.to_string().contains("there is no point `Q`"));
    assert!(change.text.contains("link = \"crank\"") && change.text.contains("pin = \"Q\""));
}

#[test]
fn a_force_on_another_link_acts_at_a_point_of_it() {
    let change = typing(shaper(), "force[0].link", "crank");
    assert_eq!(also(&change), ["force[0].at"]);
    assert_eq!(value(&reads(change), "force[0].at"), "\"A\"");
    // What is right on both links stays.
    let on_rocker = shaper().replace("link = \"ram\"\nat = \"K\"", "link = \"rocker\"\nat = \"D\"");
    assert_eq!(value(&reads(typing(&on_rocker, "force[0].link", "stone4")), "force[0].at"), "\"D\"");
    let place = shaper().replace("at = \"K\"", "at = [0.25, -0.05]");
    assert_eq!(value(&reads(typing(&place, "force[0].link", "crank")), "force[0].at"), "[0.25, -0.05]");
}

#[test]
fn a_point_becomes_a_table_and_coordinates_again() {
    let at = "link.rocker.points.S3";
    let sorts: Vec<_> =
        of(shaper(), at).opens.into_iter().map(|one| (one.sort.unwrap(), one.stands)).collect();
    assert_eq!(sorts, [("r", false), ("from", false)]);
    assert!(of(shaper(), "link.rocker.points").opens.is_empty());
    let polar = reads(make(shaper(), at, Some("r")));
    assert_eq!(value(&polar, at), "{ r = \"3 in\", angle = \"30 deg\" }");
    let labels = |text: &str| -> Vec<String> {
        table(text, &key(at), &[]).fields.into_iter().map(|field| field.label).collect()
    };
    assert_eq!(labels(&polar), ["r", "angle", "about"]);
    // Only other points of the link can be named.
    let names =
        |at: &str| -> Vec<String> { of(&polar, at).choices.into_iter().map(|choice| choice.toml).collect() };
    assert_eq!(names("link.rocker.points.S3.about"), ["\"C\"", "\"D\""]);
    let about = reads(typing(&polar, "link.rocker.points.S3.about", "D"));
    assert_eq!(value(&about, at), "{ r = \"3 in\", angle = \"30 deg\", about = \"D\" }");
    // The rocker is 700 mm long.
    let triangle = reads(make(&about, at, Some("from")));
    assert_eq!(value(&triangle, at), "{ from = [\"C\", \"D\"], lengths = [\"1 m\", \"1 m\"] }");
    assert_eq!(labels(&triangle), ["from", "lengths", "side"]);
    let right = reads(typing(&triangle, "link.rocker.points.S3.side", "right"));
    assert!(value(&right, at).ends_with("side = \"right\" }"));
    let open = typing(&right, "link.rocker.points.S3.lengths", "100 mm, 200 mm");
    let message = open.here.unwrap().message.to_string();
    assert!(message.contains("has a gap of 400 mm"), "{message}");
    let again = reads(typing(&right, at, "250, 0 mm"));
    assert_eq!(value(&again, at), "[\"250 mm\", \"0 mm\"]");
}
