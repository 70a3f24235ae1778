//! What is typed, what is wrong with it, and what holds without it.

use assur_fixtures::{SCENES, scene};

use super::{key, of, read, reads, shaper, typing};
use crate::{Choice, faults, field, put, table, typed};

#[test]
fn what_is_typed_becomes_toml() {
    let boom = scene("boom");
    let note = scene("rolling-press");
    for (text, at, entry, toml) in [
        (shaper(), "motion.speed", "90", "\"90 rpm\""),
        (shaper(), "motion.speed", "6.5 rad/s", "\"6.5 rad/s\""),
        (shaper(), "motion.speed", "12,5", "\"12.5 rpm\""),
        (shaper(), "motion.speed", "12,5rad/s", "\"12.5 rad/s\""),
        (shaper(), "motion.speed", "\"7 rpm\"", "\"7 rpm\""),
        (shaper(), "motion.speed", "fast", "\"fast\""),
        (boom, "force[0].value", "1500", "\"1500 kN\""),
        (boom, "force[0].at", "T", "\"T\""),
        (boom, "force[0].at", "[1, 0]", "[1, 0]"),
        (shaper(), "gravity", "\u{2212}9.81", "\"-9.81 m/s^2\""),
        (shaper(), "gravity", "0, -9,81 m/s^2", "[\"0 m/s^2\", \"-9.81 m/s^2\"]"),
        (shaper(), "slide[2].through", "12, 5 mm", "[\"12 mm\", \"5 mm\"]"),
        (shaper(), "slide[2].through", "12,5 mm", "\"12.5 mm\""),
        (shaper(), "link.ram.points.K", "0.3; 0", "[0.3, 0]"),
        (shaper(), "link.crank.points.A", "120", "\"120 mm\""),
        (shaper(), "assembly.D", "1, 2", "[1, 2]"),
        (shaper(), "force[0].scale", ".5", "0.5"),
        (shaper(), "force[0].value.back", "1500", "1500"),
        (shaper(), "force[0].value.forward[1][1]", "2 kN", "\"2 kN\""),
        (shaper(), "input.positions", "12", "12"),
        (shaper(), "input.direction", "cw", "\"cw\""),
        (shaper(), "title", "[1] \"new\"", "\"[1] \\\"new\\\"\""),
        (shaper(), "force[0].against_motion", "true", "true"),
        (note, "note.positions", "3, 7", "[3, 7]"),
        (note, "output.points", "A, N", "[\"A\", \"N\"]"),
        (note, "note.variant", "12", "\"12\""),
        (note, "contact[0].during", "-100, -80 deg", "[\"-100 deg\", \"-80 deg\"]"),
        (shaper(), "motion.speed", "  ", ""),
    ] {
        assert_eq!(typed(&of(text, at), entry), toml, "{at}: {entry}");
    }
}

/// What a field shows is what stands there: typed again, it changes nothing.
#[test]
fn what_is_shown_is_what_is_typed() {
    for (name, text) in SCENES.iter().step_by(3) {
        let mechanism = format!("{:?}", read(text));
        for section in crate::sections(text) {
            for instance in section.instances {
                let form = table(text, &instance.key, &[]);
                for field in form.fields.iter().filter(|field| field.value.is_some()) {
                    let change = put(text, field, &field.shown());
                    assert_eq!(format!("{:?}", read(&reads(change))), mechanism, "{name} {}", field.key);
                }
            }
        }
    }
}

#[test]
fn an_error_stands_at_the_key_that_is_typed() {
    for (at, entry, words) in [
        ("motion.speed", "60 mm", "`speed` wants a speed of rotation"),
        ("motion.speed", "fast", "`speed`"),
        ("motion.speed", "", "`speed`"),
        ("link.rocker.mass", "-1", "`mass` must not be negative"),
        ("force[0].at", "Q", "`at`"),
        ("slide[0].on", "rokcer", "`on`"),
        ("slide[0].on", "[0,", "not TOML"),
        ("force[0].value.forward[2][0]", "0.01", "must not decrease"),
        ("link.ram.points.K", "1 kg", "`K`"),
        ("motion.kind", "stedy", "`kind`"),
    ] {
        let change = typing(shaper(), at, entry);
        let here = change.here.unwrap_or_else(|| panic!("{at} = {entry}"));
        assert!(here.message.to_string().contains(words), "{at} = {entry}: {}", here.message);
        assert!(change.elsewhere.is_empty(), "{at} = {entry}: {:?}", change.elsewhere);
    }
    // It is at the place of the value in the text, so that a list of faults leads there.
    let faulty = shaper().replace("\"12 kg\"", "\"12 mm\"");
    let all = faults(&faulty);
    let keys: Vec<_> = all.iter().map(|fault| fault.key.clone().unwrap().to_string()).collect();
    assert_eq!(keys, ["link.rocker.mass"]);
    assert_eq!(field(&faulty, all[0].key.as_ref().unwrap(), &[]).unwrap().shown(), "12 mm");
}

#[test]
fn a_fault_elsewhere_is_told_and_an_old_one_is_not() {
    // The point at which the force acts.
    let change = typing(shaper(), "link.ram.points.K", "");
    assert!(change.here.is_none());
    let places: Vec<_> =
        change.elsewhere.iter().map(|fault| fault.key.clone().unwrap().to_string()).collect();
    assert_eq!(places, ["force[0].at"]);
    let moved = reads_later(&change.text, "force[0].at", "E");
    assert!(moved.contains("link = \"ram\"\nat = \"E\""));
    let faulty = shaper().replace("\"12 kg\"", "\"12 mm\"");
    let change = typing(&faulty, "motion.speed", "90");
    assert!(change.here.is_none() && change.elsewhere.is_empty());
    // A scene without an input has a fault that is not the form's.
    let unfinished = shaper().replace("[input]\nlink = \"crank\"\npositions = 48", "");
    let change = typing(&unfinished, "link.crank.mass", "5");
    assert!(change.here.is_none() && change.elsewhere.is_empty() && change.text.contains("mass = \"5 kg\""));
}

/// The text with a further entry, after which it reads.
fn reads_later(text: &str, at: &str, entry: &str) -> String {
    let change = typing(text, at, entry);
    assert!(change.here.is_none());
    read(&change.text);
    change.text
}

#[test]
fn without_a_value_the_default_holds() {
    let text = reads(typing(shaper(), "slide[1].angle", ""));
    assert_eq!(read(&text).slides[1].angle.to_bits(), 0.0_f64.to_bits());
    let angle = of(&text, "slide[1].angle");
    assert_eq!((angle.value.clone(), angle.default_shown().to_string().as_str()), (None, "0 rad"));
    assert_eq!(angle.own_unit(), "rad");
    let text = reads(typing(shaper(), "input.positions", ""));
    assert_eq!(read(&text).input.positions, 12);
    assert_eq!(of(&text, "input.positions").default_shown().to_string(), "12");
    let text = reads(typing(shaper(), "gravity", ""));
    assert_eq!(read(&text).gravity, None);
    assert!(of(&text, "motion.speed").default_shown().is_empty());
    assert_eq!(of(&text, "input.direction").default_shown().to_string(), "ccw");
}

#[test]
fn a_field_says_what_its_value_may_be() {
    let mass = of(shaper(), "link.rocker.mass");
    assert_eq!((mass.label.as_str(), mass.unit, mass.shown().as_str()), ("mass", "kg", "12 kg"));
    assert_eq!(mass.values.to_string(), "a mass (kg, g, t, lb, slug)");
    assert_eq!(mass.limits.to_string(), "0 or greater");
    assert!(of(shaper(), "force[0].link").is_needed());
    // Of an input that turns, and of one that slides.
    assert_eq!(of(shaper(), "motion.speed").unit, "rad/s");
    let boom = of(scene("boom"), "motion.speed");
    assert_eq!((boom.unit, boom.own_unit().as_str()), ("m/s", "mm/s"));
    assert!(!boom.values.to_string().contains("rpm"));
    let heading = table(shaper(), &key("force[0]"), &[]).heading.to_string();
    assert_eq!(heading, "a force: cutting");
    assert_eq!(
        table(shaper(), &key("force[0].value"), &[]).heading.to_string(),
        "a table of a load: stroke: value"
    );
    // The same table by its name.
    assert_eq!(table(shaper(), &key("force.cutting"), &[]).at, key("force[0]"));
}

fn choices(text: &str, at: &str) -> Vec<String> {
    of(text, at).choices.into_iter().map(|choice| choice.toml).collect()
}

#[test]
fn names_and_words_are_chosen() {
    let shaper = shaper();
    assert_eq!(choices(shaper, "force[0].at"), ["\"E\"", "\"K\""]);
    assert_eq!(choices(shaper, "slide[0].through"), ["\"C\"", "\"S3\"", "\"D\""]);
    assert_eq!(choices(shaper, "slide[0].point"), ["\"A\""]);
    assert_eq!(choices(shaper, "link.rocker.center"), ["\"C\"", "\"S3\"", "\"D\""]);
    let links = ["\"crank\"", "\"stone2\"", "\"rocker\"", "\"stone4\"", "\"ram\""];
    assert_eq!(choices(shaper, "force[0].link"), links);
    assert_eq!(choices(shaper, "slide[0].on"), [&links[..], &["\"ground\""]].concat());
    let slides = ["\"stone2/rocker\"", "\"stone4/ram\"", "\"ram/ground\""];
    assert_eq!(choices(shaper, "input.slide"), slides);
    let friction = scene("shaper-friction");
    assert_eq!(
        choices(friction, "friction[0].pair"),
        [&["\"O\"", "\"C\"", "\"A\"", "\"D\""][..], &slides].concat()
    );
    assert_eq!(choices(friction, "friction[2].owner"), ["\"crank\"", "\"stone2\"", "\"ground\""]);
    assert_eq!(choices(shaper, "motion.kind"), ["\"prescribed\"", "\"transient\"", "\"steady\""]);
    assert_eq!(choices(shaper, "force[0].against_motion"), ["true", "false"]);
    // Only a force has a point whose stroke can be followed.
    let over = choices(scene("flywheel"), "moment[0].value.over");
    assert_eq!(over, ["\"angle\"", "\"coordinate\"", "\"time\"", "\"speed\""]);
}

#[test]
fn motors_are_offered_for_the_field_of_the_motor() {
    let motor =
        |name: &str, data: &'static str| Choice { label: assur_words::name(data), ..Choice::word(name) };
    let offers = [(
        "motor",
        vec![motor("4A100L4", "4A100L4 4 kW 1430 rpm"), motor("4A90L4", "4A90L4 2.2 kW 1425 rpm")],
    )];
    let text = scene("shaper-drive");
    let field = field(text, &key("drive.motor"), &offers).unwrap();
    assert_eq!(field.choices.len(), 3);
    let text = reads(put(text, &field, "4A90L4"));
    assert!(text.contains("motor = \"4A90L4\""));
}
