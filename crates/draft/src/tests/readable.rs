//! `readable`, `key_at`.

use assur_fixtures::scene;
use assur_scene::read;

use crate::{key_at, readable};

/// What is read of a shipped scene after a change, which has faults.
#[track_caller]
fn read_of(name: &str, old: &str, new: &str) -> String {
    let text = scene(name);
    assert!(text.contains(old), "{old}");
    let text = text.replacen(old, new, 1);
    let found = readable("x.toml", &text);
    assert_eq!(found.faults, read("x.toml", &text).unwrap_err().errors);
    assert!(read("", &found.text).is_ok(), "{}", found.text);
    found.text
}

#[test]
fn what_is_wrong_is_taken_out() {
    let boom = scene("boom");
    assert_eq!(readable("", boom).text, boom);
    // A value, which has a default.
    assert_eq!(
        read_of("boom", "angle = \"-90 deg\"", "angle = \"-90 mm\""),
        boom.replacen(
            "\n[[force]]\nlink = \"boom\"\nat = \"T\"\nangle = \"-90 deg\"\nvalue = \"2 kN\"\n",
            "",
            1
        )
    );
    assert_eq!(
        read_of("boom", "mass = \"120 kg\"", "mass = \"120 m\""),
        boom.replacen("mass = \"120 kg\"\n", "", 1)
    );
    // A key that is unknown.
    assert_eq!(
        read_of("boom", "mass = \"120 kg\"", "mas = \"120 kg\""),
        boom.replacen("mass = \"120 kg\"\n", "", 1)
    );
    // A point that is a pin.
    assert!(
        !read_of("boom", "C = [\"1200 mm\", \"150 mm\"]", "C = [\"1200 kg\", \"150 mm\"]").contains("1200")
    );
    // A list.
    let shaper = scene("shaper-friction");
    let rest = read_of("shaper-friction", "pair = \"stone2/rocker\"", "pair = \"stone2/rock\"");
    assert_eq!(rest, shaper.replacen("[[friction]]                  # pressed at one point\npair = \"stone2/rocker\"\ncoefficient = 0.12\n\n", "", 1));
    // Names that nothing has.
    let rest = read_of("rolling-press", "[link.rod]", "[link.rods]");
    assert!(
        rest.contains("[link.rods]") && !rest.contains("[[contact]]") && rest.contains("[[moment]]"),
        "{rest}"
    );
}

#[test]
fn faults_of_the_syntax_take_their_lines() {
    let boom = scene("boom");
    assert_eq!(
        read_of("boom", "mass = \"120 kg\"", "mass = 120 kg"),
        boom.replacen("mass = \"120 kg\"\n", "", 1)
    );
    assert_eq!(
        read_of("boom", "mass = \"120 kg\"", "mass = \"120 kg"),
        boom.replacen("mass = \"120 kg\"\n", "", 1)
    );
    assert_eq!(
        read_of("boom", "mass = \"120 kg\"", "mass = [120"),
        boom.replacen("mass = \"120 kg\"\n", "", 1)
    );
    assert_eq!(read_of("boom", "mass = \"120 kg\"", "mass"), boom.replacen("mass = \"120 kg\"\n", "", 1));
    assert_eq!(
        read_of("boom", "[motion]", "[motion"),
        boom.replacen("[motion]\nspeed = \"100 mm/s\"\n", "", 1)
    );
    let twice = "[motion]\nspeed = 1\n[[force]]";
    assert_eq!(read_of("boom", "[[force]]", twice), boom);
}

#[test]
fn a_text_without_an_input_has_a_provisional_one() {
    for name in ["shaper", "rolling-press", "slider-crank"] {
        let text = crate::remove(scene(name), &assur_mechanism::Key::of("input"));
        let found = readable("", &text);
        assert!(found.is_input_provisional, "{name}");
        assert_eq!(found.faults.len(), read("", &text).unwrap_err().errors.len());
        let mechanism = read("", &found.text).unwrap();
        assert_eq!(mechanism.links[mechanism.input.first().link].name, "crank");
        assert_eq!(mechanism.links.len(), read("", scene(name)).unwrap().links.len());
    }
    let slides = "[link.a]\npoints = { A = 0 }\n[[slide]]\nlink = \"a\"\non = \"ground\"\n";
    let found = readable("", slides);
    assert!(found.is_input_provisional && read("", &found.text).is_ok());
    for text in ["", "[link.a]\npoints = { A = 0 }\n", "x", "[motion]\nspeed = 1"] {
        let found = readable("", text);
        assert!(found.text.is_empty() && !found.is_input_provisional && !found.faults.is_empty());
    }
}

#[test]
fn a_place_has_a_key() {
    let text = scene("shaper-friction");
    let at = |piece: &str| key_at(text, text.find(piece).unwrap()).map(|key| key.to_string());
    let is = |piece: &str, key: &str| assert_eq!(at(piece).as_deref(), Some(key), "{piece}");
    is("title", "title");
    is("[ground]", "ground");
    is("-400 mm", "ground.points.C[1]");
    is("S3 =", "link.rocker.points.S3");
    is("S3\"\ninertia", "link.rocker.center");
    is("{ C = 0", "link.rocker.points");
    is("tone4\"\non", "slide.stone4/ram.link");
    is("[0.05, 1500]", "force.cutting.value.forward[1]");
    is("1500], [0.95", "force.cutting.value.forward[1][1]");
    is("stroke", "force.cutting.value.over");
    is("[[friction]]                  # pressed at", "friction.stone2/rocker");
    is("0.17", "assembly.D[0]");
    assert_eq!(at("# The shaper"), None);
    assert_eq!(at("\n[link.crank]"), None);
    assert_eq!(key_at(text, usize::MAX), None);
    let broken = "[link.a]\nmass = 1 kg\n[motion]\nspeed = 2\n";
    assert_eq!(key_at(broken, broken.find('2').unwrap()).unwrap().to_string(), "motion.speed");
}
