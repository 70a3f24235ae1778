//! Points in polar form and by two lengths.

#![expect(clippy::float_cmp, reason = "quarters of a turn have no rounding, and one place is the same twice")]

use std::f64::consts::FRAC_1_SQRT_2;

use approx::assert_relative_eq as close;
use assur_mechanism::{GROUND, Key, Mechanism};

use super::faults::assert_translated;
use super::{BASE, PLACES};
use crate::edit::{ParsedText, replaced};
use crate::{Dimension, Reading, read, reading};

/// The base scene with other points of its crank.
fn with(points: &str) -> String {
    BASE.replace("{ O = 0, A = \"60 mm\" }", &format!("{{ {points} }}"))
}

fn good(text: &str) -> Mechanism {
    read("scene.toml", text).unwrap_or_else(|errors| panic!("{errors}"))
}

/// The place of a point on the crank.
fn at(points: &str, point: &str) -> [f64; 2] {
    on(&good(&with(points)), point, 1)
}

fn on(mechanism: &Mechanism, point: &str, link: usize) -> [f64; 2] {
    let id = mechanism.point(point).unwrap();
    mechanism.points[id].on(link).unwrap()
}

/// Where a place must be, to the rounding of a few operations.
fn is_at(found: [f64; 2], wanted: [f64; 2]) {
    for (found, wanted) in found.into_iter().zip(wanted) {
        close!(found, wanted, epsilon = 1e-15, max_relative = 1e-14);
    }
}

/// The message and the correction of the only fault of a scene with other points of its crank, and what they are about.
fn fault(points: &str) -> (String, String, String) {
    let text = with(points);
    let errors = read("scene.toml", &text).expect_err(points);
    assert_translated(&text, &errors);
    let [error] = &errors.errors[..] else { panic!("{errors}") };
    let of = text[error.span.clone()].to_owned();
    (error.message.to_string(), error.label.to_string(), of)
}

#[test]
fn a_polar_point_is_at_its_distance_and_angle() {
    let half = 3.0_f64.sqrt() / 2.0;
    is_at(at("O = 0, A = { r = \"3 in\", angle = \"30 deg\" }", "A"), [0.0762 * half, 0.0381]);
    is_at(at("O = 0, A = { r = 2, angle = \"-135 deg\" }", "A"), [-2.0 * FRAC_1_SQRT_2; 2]);
    // From a point of the link, the angle from the x axis of the link all the same.
    let about = "O = [1, 2], A = { r = 2, angle = \"60 deg\", about = \"O\" }";
    is_at(at(about, "A"), [2.0, 2.0 + 3.0_f64.sqrt()]);
    // Quarters of a turn have no rounding, so that points at one place are that.
    let quarters =
        [("90 deg", [0.0, 0.5]), ("180 deg", [-0.5, 0.0]), ("270 deg", [0.0, -0.5]), ("1 rev", [0.5, 0.0])];
    for (angle, place) in quarters {
        assert_eq!(at(&format!("O = 0, A = {{ r = 0.5, angle = \"{angle}\" }}"), "A"), place);
    }
    let ground = good(&BASE.replace("C = [0, \"-400 mm\"]", "C = { r = \"400 mm\", angle = \"-90 deg\" }"));
    assert_eq!(on(&ground, "C", GROUND), [0.0, -0.4]);
}

#[test]
fn a_point_by_two_lengths_closes_a_triangle_on_its_side() {
    let triangle = |side: &str| {
        format!(
            "O = 0, A = \"50 mm\", B = {{ from = [\"O\", \"A\"], lengths = [\"30 mm\", \"40 mm\"]{side} }}"
        )
    };
    // 3-4-5: the altitude on the hypotenuse is 12/5, its foot is 9/5 from the end of the leg of 3.
    is_at(at(&triangle(""), "B"), [0.018, 0.024]);
    is_at(at(&triangle(", side = \"left\""), "B"), [0.018, 0.024]);
    is_at(at(&triangle(", side = \"right\""), "B"), [0.018, -0.024]);
    // Left of the way from the second to the first is right of that from the first to the second.
    let back = triangle("").replace("[\"O\", \"A\"]", "[\"A\", \"O\"]");
    is_at(at(&back, "B"), [0.032, -0.024]);
    let upward = "O = [1, 1], A = [1, 6], B = { from = [\"O\", \"A\"], lengths = [3, 4] }";
    is_at(at(upward, "B"), [1.0 - 2.4, 2.8]);
    // With one angle wider than a right one the foot lies outside: the sides are 3, sqrt(34) and 2.
    let wide = "O = 0, A = 2, B = { from = [\"O\", \"A\"], lengths = [5.830951894845301, 5] }";
    let [x, y] = at(wide, "B");
    close!(x, (34.0 - 25.0 + 4.0) / 4.0, max_relative = 1e-14);
    close!(x.hypot(y), 34.0_f64.sqrt(), max_relative = 1e-14);
}

#[test]
fn a_flat_triangle_is_closed_in_spite_of_rounding() {
    // As doubles, 0.1 + 0.2 is greater than 0.3, and 0.3 - 0.1 less than 0.2.
    let flat =
        |lengths: &str| format!("O = 0, A = 0.3, B = {{ from = [\"O\", \"A\"], lengths = {lengths} }}");
    is_at(at(&flat("[0.1, 0.2]"), "B"), [0.1, 0.0]);
    is_at(at(&flat("[0.2, 0.1]"), "B"), [0.2, 0.0]);
    is_at(at(&flat("[0.4, 0.1]"), "B"), [0.4, 0.0]);
    is_at(at(&flat("[0.1, 0.4]"), "B"), [-0.1, 0.0]);
    is_at(at(&flat("[0.3, 0]"), "B"), [0.3, 0.0]);
    // Nearly flat: 1e-6 more than the distance, the altitude is sqrt(2 * 1e-6 * 0.1 * 0.2 / 0.3) to the first order.
    let [_, y] = at(&flat("[0.1, 0.200001]"), "B");
    close!(y, (2e-6 * 0.02 / 0.3_f64).sqrt(), max_relative = 1e-4);
}

#[test]
fn points_may_be_named_before_they_stand() {
    let parts = [
        "O = 0",
        "A = { r = \"60 mm\", angle = 0 }",
        "B = { from = [\"O\", \"A\"], lengths = [\"50 mm\", \"50 mm\"] }",
        "D = { r = \"10 mm\", angle = \"90 deg\", about = \"B\" }",
    ];
    let [one, other] =
        [[0, 1, 2, 3], [3, 2, 1, 0]].map(|order| good(&with(&order.map(|at| parts[at]).join(", "))));
    for point in ["O", "A", "B", "D"] {
        assert_eq!(on(&one, point, 1), on(&other, point, 1), "{point}");
    }
    is_at(on(&one, "D", 1), [0.03, 0.05]);
}

#[test]
fn points_that_wait_for_each_other_are_named_once() {
    let polar = |name: &str, about: &str| format!("{name} = {{ r = 1, angle = 0, about = \"{about}\" }}");
    let circle = [polar("B", "D"), polar("D", "E"), polar("E", "B"), polar("F", "B")].join(", ");
    let (message, label, of) = fault(&format!("O = 0, A = 1, {circle}"));
    assert_eq!(message, "the place of `B` depends on itself: B -> D -> E -> B");
    assert_eq!(label, "give one of these points by [x, y]");
    assert!(of.contains("about = \"D\""), "{of}");
    let (message, ..) = fault(&format!("O = 0, A = 1, {}", polar("B", "B")));
    assert_eq!(message, "the place of `B` depends on itself: B -> B");
    // Of a point that only hangs on a circle nothing is said.
    let (message, ..) = fault(&format!("O = 0, A = 1, {}, {}", polar("F", "B"), polar("B", "B")));
    assert_eq!(message, "the place of `B` depends on itself: B -> B");
    let triangle =
        "B = { from = [\"O\", \"D\"], lengths = [1, 1] }, D = { from = [\"A\", \"B\"], lengths = [1, 1] }";
    let (message, ..) = fault(&format!("O = 0, A = 1, {triangle}"));
    assert_eq!(message, "the place of `B` depends on itself: B -> D -> B");
}

#[test]
fn a_long_chain_of_points_is_read() {
    let mut points = vec!["O = 0".to_owned(), "A = 1".to_owned()];
    points.extend((0..9_000).rev().map(|index| {
        let before = if index == 0 { "A".to_owned() } else { format!("P{}", index - 1) };
        format!("P{index} = {{ r = 0.5, angle = 0, about = \"{before}\" }}")
    }));
    is_at(at(&points.join(", "), "P8999"), [4_501.0, 0.0]);
}

#[test]
fn a_triangle_that_is_open_tells_its_gap() {
    let open = |lengths: &str| {
        fault(&format!("O = 0, A = \"60 mm\", B = {{ from = [\"O\", \"A\"], lengths = {lengths} }}"))
    };
    let (message, label, of) = open("[\"20 mm\", \"25 mm\"]");
    assert_eq!(
        message,
        "the triangle of `B` has a gap of 15 mm: `O` and `A` are 60 mm apart, farther than both lengths together"
    );
    assert_eq!(label, "lengthen them by 15 mm together, or bring the points nearer");
    assert_eq!(of, "[\"20 mm\", \"25 mm\"]");
    let (message, label, _) = open("[\"20 mm\", \"82.5 mm\"]");
    assert_eq!(
        message,
        "the triangle of `B` has a gap of 2.5 mm: `O` and `A` are 60 mm apart, less than the lengths differ by"
    );
    assert_eq!(label, "shorten the longer or lengthen the shorter one by 2.5 mm, or move the points apart");
    for same in ["A = 0, B = { from = [\"O\", \"A\"]", "A = 1, B = { from = [\"O\", \"O\"]"] {
        let (message, label, _) = fault(&format!("O = 0, {same}, lengths = [1, 1] }}"));
        assert!(message.starts_with("`B` has no place: `O` and `") && message.ends_with("are at one place"));
        assert_eq!(label, "take two points that are apart, or give [x, y]");
    }
    // A point that hangs on it has no fault of its own.
    let more =
        "B = { from = [\"O\", \"A\"], lengths = [1, 4] }, D = { from = [\"A\", \"B\"], lengths = [1, 9] }";
    assert!(fault(&format!("O = 0, A = 1, {more}")).0.contains("triangle of `B`"));
}

#[test]
fn what_is_wrong_in_a_place_is_told_at_its_place() {
    let told = |place: &str, message: &str, label: &str, of: &str| {
        let found = fault(&format!("O = 0, A = 1, B = {{ {place} }}"));
        assert_eq!(found, (message.to_owned(), label.to_owned(), of.to_owned()), "{place}");
    };
    let such = "such as \"120 mm\", or a number in m";
    let negative = "`r` must not be negative, got \"-1 mm\"";
    told("r = \"-1 mm\", angle = 0", negative, such, "\"-1 mm\"");
    let negative = "`lengths` must not be negative, got -2";
    told("from = [\"O\", \"A\"], lengths = [1, -2]", negative, such, "-2");
    let mixed = "`r` and `from` exclude each other";
    let both = "r = 1, angle = 0, from = [\"O\", \"A\"], lengths = [1, 1]";
    told(both, mixed, "leave one out", &format!("{{ {both} }}"));
    let none = "the place of a point needs `r`";
    told("", none, "`r` and `angle`, or `from` and `lengths`", "{  }");
    told("r = 1", "the place of a point needs `angle`", "add `angle = ...`", "{ r = 1 }");
    let lengths = "the place of a point needs `lengths`";
    told("from = [\"O\", \"A\"]", lengths, "add `lengths = ...`", "{ from = [\"O\", \"A\"] }");
    let unknown = "`about`: link `crank` has no point `Q`";
    told("r = 1, angle = 0, about = \"Q\"", unknown, "its points: O, A, B", "\"Q\"");
    let near = "r = 1, angle = 0, about = \"a\"";
    assert!(fault(&format!("O = 0, A = 1, B = {{ {near} }}")).0.contains("has no point `a`"));
    // A point of another link is none of this one.
    let elsewhere = fault("O = 0, A = 1, B = { r = 1, angle = 0, about = \"S2\" }").0;
    assert_eq!(elsewhere, "`about`: link `crank` has no point `S2`");
    assert!(fault("O = 0, A = 1, B = { r = 1, angel = 0, angle = 1 }").0.contains("unknown key `angel`"));
    assert!(fault("O = 0, A = 1, B = { r = 1, angle = 0, side = \"left\" }").0.contains("exclude"));
    assert!(fault("O = 0, A = 1, B = { r = 1, angle = \"5 mm\" }").0.contains("wants an angle"));
    let side = fault("O = 0, A = 1, B = { from = [\"O\", \"A\"], lengths = [1, 1], side = \"up\" }");
    assert!(side.0.contains("left, right"), "{side:?}");
    let one = fault("O = 0, A = 1, B = { from = [\"O\"], lengths = [1, 1] }");
    assert!(one.0.contains("two points"), "{one:?}");
    let far = fault("O = 0, A = [1e6, 0], B = { r = 5e5, angle = 0, about = \"A\" }");
    assert_eq!(far.0, "`B` is too large: `1.500e6 m`, at most 1e6 m");
    // Elsewhere a place is no table.
    let center =
        read("a", &BASE.replace("center = \"S2\"\n", "center = { r = 1, angle = 0 }\n")).unwrap_err();
    assert!(center.to_string().contains("[x, y] or one length on the x axis"), "{center}");
}

/// The number of a key.
fn number<'r>(reading: &'r Reading, key: &str) -> &'r crate::SceneNumber {
    let found = reading.numbers.iter().find(|number| number.key.to_string() == key);
    found.unwrap_or_else(|| panic!("{key}"))
}

#[test]
fn every_number_of_a_place_is_told_and_can_be_written_anew() {
    let reading = reading("a", PLACES).unwrap();
    let number = |key: &str| number(&reading, key);
    let [r, angle] = ["r", "angle"].map(|key| number(&format!("link.crank.points.E.{key}")));
    let [first, second] = [0, 1].map(|index| number(&format!("link.crank.points.T.lengths[{index}]")));
    assert_eq!(&PLACES[r.span.clone()], "\"30 mm\"");
    assert_eq!(&PLACES[second.span.clone()], "\"70 mm\"");
    assert_eq!((&r.kinds[..], &angle.kinds[..]), (&[Dimension::Length][..], &[Dimension::Angle][..]));
    for length in [r, first, second] {
        assert!(length.admits(0.0) && !length.admits(-0.01) && !length.is_free());
    }
    assert!(angle.admits(-1.0) && !angle.admits(1e6) && !angle.is_free());
    // By `A` of the crank other points of it are given, so that it does not move alone; a pivot and the rocker are as they were.
    assert!(!number("link.crank.points.A").is_free() && !number("link.crank.points.O").is_free());
    assert!(number("link.rocker.points.C").is_free() && number("ground.points.O").is_free());
    for (key, written, point, place) in [
        ("link.crank.points.E.r", "\"20 mm\"", "E", [0.05, 0.02]),
        ("link.crank.points.E.angle", "\"180 deg\"", "E", [0.02, 0.0]),
        ("link.crank.points.A", "0.1", "E", [0.1, 0.03]),
        (
            "link.crank.points.T.lengths[1]",
            "\"60 mm\"",
            "T",
            [0.025, -(0.06_f64.powi(2) - 0.025_f64.powi(2)).sqrt()],
        ),
    ] {
        let found = ParsedText::of(PLACES).find(&Key::parse(key).unwrap()).unwrap();
        let text = replaced(PLACES, found.iter().map(|place| (&place.span, written)));
        is_at(on(&good(&text), point, 1), place);
    }
}

#[test]
fn a_point_that_others_name_has_its_place_there() {
    // The center of mass of the rod is by name at the apex of a triangle: 180, 150 and 80 mm.
    let scene = good(PLACES);
    let x = (0.18 * 0.18 + 0.15 * 0.15 - 0.08 * 0.08) / 0.36;
    is_at(scene.links[2].center, [x, (0.15_f64.powi(2) - x * x).sqrt()]);
    assert_eq!(scene.links[2].center, on(&scene, "P", 2));
    // A pin by its polar place: the pivot of the rocker.
    let angle = 10.0_f64.to_radians();
    is_at(on(&scene, "C", GROUND), [0.2032 * angle.cos(), 0.2032 * angle.sin()]);
}

#[test]
fn a_point_may_have_the_name_of_a_key() {
    let scene = with("O = 0, A = 1, r = { r = 2, angle = 0, about = \"angle\" }, angle = [0, 1]");
    is_at(on(&good(&scene), "r", 1), [2.0, 1.0]);
    let key = |key: &str| crate::reference::key_of(&Key::parse(key).unwrap()).map(|key| key.about);
    assert_eq!(key("link.crank.points.r.r"), Some("scene-key-place-r"));
    assert_eq!(key("link.crank.points.angle"), Some("scene-key-points"));
    assert_eq!(key("link.crank.points.T.lengths[1]"), Some("scene-key-place-lengths"));
    assert_eq!(key("ground.points.C.angle"), Some("scene-key-place-angle"));
}
