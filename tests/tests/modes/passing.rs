//! Modes over a range: through meetings, to their ends, and from both sides of one mechanism.

use assur_analysis::{Calculation, Options, unwatched};
use assur_group::Order;
use assur_kinematics::{CourseEnd, Linkage, ModeMeeting, Position};

use super::linkage_of;

/// A coupler that two slides keep parallel, on two rods: it moves as a deltoid with the sides 0.3, 0.3, 0.2 and 0.2 does, whose
/// ways meet at 0 and at 180 degrees.
const PARALLEL: &str = r#"
[ground]
points = { O = [0, 0], C = [1, 0] }
[link.crank]
points = { O = 0, A = 0.3 }
[link.rod]
points = { A = 0, D = 0.3 }
[link.coupler]
points = { D = [-0.7, 0.1], B = [0.5, 0.1], P = [0.4, 0.5] }
[link.rocker]
points = { C = 0, B = 0.2 }
[link.cross]
points = { X = 0 }
[[slide]]
link = "cross"
on = "ground"
[[slide]]
link = "coupler"
on = "cross"
point = "P"
angle = "90 deg"
tilt = "-90 deg"
[input]
link = "crank"
from = 0.5
positions = 24
[assembly]
B = [1.1648, 0.1133]
"#;

/// The deltoid itself.
const DELTOID: &str = r#"
[ground]
points = { O = [1.2, 0], C = [1, 0] }
[link.crank]
points = { O = 0, A = 0.3 }
[link.rod]
points = { A = 0, B = 0.3 }
[link.rocker]
points = { C = 0, B = 0.2 }
[input]
link = "crank"
from = 0.5
positions = 24
[assembly]
B = [1.1648, 0.1133]
"#;

/// Place of a point in a position.
fn place_of(linkage: &Linkage, position: &Position, name: &str) -> [f64; 2] {
    let point = linkage.mechanism.points.iter().find(|point| point.name.as_str() == name).unwrap();
    position.bodies[point.places[0].link].point(point.places[0].at)
}

#[test]
fn a_triad_passes_meetings_of_its_modes_as_the_dyad_that_moves_alike() {
    let [triad, dyad] = [PARALLEL, DELTOID].map(|text| linkage_of(assur_scene::read("scene", text).unwrap()));
    let mut positions = [triad.position(), dyad.position()];
    for index in 0..24 {
        let mut places = [&triad, &dyad].into_iter().zip(&mut positions).map(|(linkage, position)| {
            linkage.solve_index(index, Order::Second, position).unwrap();
            place_of(linkage, position, "B")
        });
        let [[x, y], [u, v]] = [places.next().unwrap(), places.next().unwrap()];
        assert!((x - u).hypot(y - v) < 1e-10, "position {index}: {x} {y} {u} {v}");
    }
    assert_eq!(triad.change_points().count(), 2);
    for linkage in [&triad, &dyad] {
        let found = linkage.courses(0).unwrap();
        assert_eq!((found.circuits, found.branches, found.modes.len()), (Some(1), Some(2), 2));
        assert_eq!(found.counts.len(), 1, "{:?}", found.counts);
        let mut at: Vec<f64> = found.meetings.iter().map(|meeting| meeting.at.to_degrees()).collect();
        at.sort_by(f64::total_cmp);
        assert!(at.len() == 2 && (at[0] - 180.0).abs() < 1e-4 && (at[1] - 360.0).abs() < 1e-4, "{at:?}");
    }
}

#[test]
fn modes_over_a_cycle_are_born_and_end_in_pairs_at_the_ends_of_ranges() {
    let longer = ("A = \"50 mm\", D = [\"-10 mm\", \"60 mm\"]", "A = 0.1, D = [-0.02, 0.12]");
    let text = assur_fixtures::scene("triad").replace(longer.0, longer.1);
    let linkage = linkage_of(assur_scene::read("triad", &text).unwrap());
    let range = linkage.range.unwrap();
    let found = linkage.courses(0).unwrap();
    let mut position = linkage.position();
    linkage.solve_index(0, Order::Place, &mut position).unwrap();
    let modes = linkage.modes(0, &position).unwrap().unwrap();
    assert_eq!(found.counts[0].modes, modes.all.len());
    // The present mode ends where the range does, together with another one.
    let course = &found.modes[modes.number(modes.present)];
    let CourseEnd::With(other) = course.ends else { panic!("{course:?}") };
    assert!((course.to - range.high).abs() < 1e-9, "{} {}", course.to, range.high);
    assert_eq!(found.modes[other].circuit, course.circuit);
    assert_ne!(found.modes[other].branch, course.branch);
    // The number changes by two at each birth and end; over a turn it comes back.
    let steps = found.counts.windows(2).map(|two| two[1].modes.abs_diff(two[0].modes));
    assert!(steps.eq(std::iter::repeat_n(2, found.counts.len() - 1)), "{:?}", found.counts);
    assert_eq!(found.counts.first().unwrap().modes, found.counts.last().unwrap().modes);
}

/// A triad of which two modes meet and vanish at two places; there they run apart by more than a thousandth within a millionth of
/// a radian.
const FAST: &str = r#"
[ground]
points = { O = [-0.49, -0.063], A2 = [-0.677, -0.533] }
[link.crank]
points = { O = 0, A0 = [0.192, 0.223], A1 = [0.077, 0.121] }
[link.l1]
points = { A0 = [0.625, 1.277], B0 = [0.074, 0.144] }
[link.plate]
points = { B0 = [0.05, 1.03], B1 = [-0.397, 0.201], B2 = [1.275, 0.458] }
[link.l3]
points = { A2 = [0.104, 0.193], B2 = [0.244, 0.265] }
[link.l2]
points = { A1 = [1.282, 0.061], B1 = [0.144, -0.148] }
[input]
link = "crank"
from = FROM
"#;

#[test]
fn modes_that_run_fast_before_they_vanish_end_together_and_not_at_infinity() {
    for from in ["0.897", "0.947", "1.177", "1.457"] {
        let text = FAST.replace("FROM", from);
        let found = linkage_of(assur_scene::read("fast", &text).unwrap()).courses(0).unwrap();
        assert_eq!((found.modes.len(), found.circuits), (4, Some(1)), "from {from}: {:?}", found.modes);
        let is_pair = |end| matches!(end, CourseEnd::With(_) | CourseEnd::Cycle);
        assert!(found.modes.iter().all(|course| is_pair(course.begins) && is_pair(course.ends)));
    }
}

#[test]
fn a_position_next_to_the_end_of_two_modes_is_noted_with_both() {
    let scene = |from: f64| format!("{}positions = 1\n", FAST.replace("FROM", &format!("{from:?}")));
    let courses = linkage_of(assur_scene::read("fast", &scene(0.897)).unwrap()).courses(0).unwrap();
    // The determinant falls with the root of the distance.
    for (before, is_noted) in [(1e-9, true), (1e-2, false)] {
        let json = results(&scene(courses.modes[0].to - before));
        assert_eq!(json["structure"]["groups"][0]["modes"].as_array().unwrap().len(), 2);
        let notes = json["notes"].as_array().unwrap();
        let note = notes.iter().find(|note| note["id"] == "analysis-nearly-singular-modes");
        assert_eq!(note.is_some(), is_noted, "{notes:?}");
        let condition = json["structure"]["groups"][0]["modes"][0]["condition"].as_f64().unwrap();
        assert_eq!(condition > 1e3, is_noted, "{condition}");
    }
}

/// A triad with two slides, two modes of which pass through infinity twice in a turn.
const THROUGH_INFINITY: &str = r#"
[ground]
points = { O = [0.411, -0.369], A2 = [0.209, 1.041] }
[link.crank]
points = { O = 0, T = [0.1, 0.05] }
[link.plate]
points = { B0 = [-1.113, -0.063], B1 = [0.403, 0.82] }
[link.l1]
points = { S0 = [-0.242, -0.107], B0 = [0.078, -0.032] }
[link.l2]
points = { S1 = [0.817, 0.961], B1 = [-0.134, 0.59] }
[link.l3]
points = { A2 = [0.373, -0.384], S2 = [-0.201, -0.13] }
[[slide]]
link = "l1"
on = "ground"
through = [0.056, -0.884]
angle = -0.203
point = "S0"
tilt = 2.441
[[slide]]
link = "l2"
on = "crank"
through = [0.071, 0.077]
angle = 0.757
point = "S1"
tilt = -2.608
[[slide]]
link = "l3"
on = "plate"
through = [-0.645, 1.024]
angle = -2.361
point = "S2"
tilt = 4.086
[input]
link = "crank"
from = FROM
"#;

#[test]
fn modes_that_pass_through_infinity_end_there_wherever_the_turn_begins() {
    let found = ["0.201", "1.711", "2.973"].map(|from| {
        let text = THROUGH_INFINITY.replace("FROM", from);
        let found = linkage_of(assur_scene::read("infinity", &text).unwrap()).courses(0).unwrap();
        let ended = found.modes.iter().filter(|course| course.ends == CourseEnd::Infinity).count();
        (ended, found.circuits)
    });
    assert!(found[0].0 > 0 && found.iter().all(|one| *one == found[0]), "{found:?}");
}

/// A plate on a parallelogram: whatever the third leg does, two of its modes have the same angle.
const ON_A_PARALLELOGRAM: &str = r#"
[ground]
points = { O = [0, 0], C = [0.4, 0], G = [0.27, -0.25] }
[link.swing]
points = { G = 0, F = 0.05 }
[link.crank]
points = { O = 0, A = 0.1 }
[link.coupler]
points = { A = 0, B = 0.4, E = [0.15, 0.1] }
[link.rocker]
points = { C = 0, B = 0.1 }
[link.rod]
points = { E = 0, F = 0.35 }
[input]
link = "swing"
from = 0.3
positions = 48
[assembly]
A = [0.099672, 0.008088]
B = [0.499672, 0.008088]
E = [0.249672, 0.108088]
"#;

#[test]
fn two_modes_of_a_plate_on_a_parallelogram_are_told_apart_at_every_coordinate() {
    let linkage = linkage_of(assur_scene::read("parallelogram", ON_A_PARALLELOGRAM).unwrap());
    let mut position = linkage.position();
    for index in 0..48 {
        linkage.solve_index(index, Order::Place, &mut position).unwrap();
        // E runs on a circle about (0.15, 0.1), and on another one about F.
        let [from, to] = [[0.15, 0.1], place_of(&linkage, &position, "F")];
        let [x, y] = [to[0] - from[0], to[1] - from[1]];
        let distance = x.hypot(y);
        let along = (0.1 * 0.1 - 0.35 * 0.35 + distance * distance) / (2.0 * distance);
        let aside = (0.1 * 0.1 - along * along).sqrt();
        let both = [aside, -aside].map(|aside| {
            let [u, v] = [along / distance, aside / distance];
            [from[0] + u * x - v * y, from[1] + u * y + v * x]
        });
        let near = |one: [f64; 2], other: [f64; 2]| (one[0] - other[0]).hypot(one[1] - other[1]) < 1e-12;
        let found = place_of(&linkage, &position, "E");
        assert!(both.iter().any(|place| near(*place, found)), "position {index}: {found:?}, {both:?}");
        let modes = linkage.modes(0, &position).unwrap().unwrap();
        let flat: Vec<_> =
            modes.all.iter().flat_map(|mode| &mode.bodies).filter(|body| body.s.abs() < 1e-12).collect();
        let is_there = |place: [f64; 2]| {
            flat.iter().any(|body| near([body.x + 0.15 * body.c, body.y + 0.1 * body.c], place))
        };
        assert!(both.into_iter().all(is_there), "position {index}: {both:?}");
    }
}

/// The pin of the crank runs through the pivot of the rocker, about which coupler and rocker can turn freely then.
const KITE: &str = r#"
[ground]
points = { O = [0, 0], C = [0.1, 0] }
[link.crank]
points = { O = 0, A = 0.1 }
[link.coupler]
points = { A = 0, B = 0.3 }
[link.rocker]
points = { C = 0, B = 0.3 }
[input]
link = "crank"
from = "FROM deg"
"#;

#[test]
fn modes_of_a_kite_go_on_through_the_place_where_it_turns_freely() {
    for from in ["50", "-3.37"] {
        let linkage = linkage_of(assur_scene::read("kite", &KITE.replace("FROM", from)).unwrap());
        let found = linkage.courses(0).unwrap();
        assert_eq!(
            (found.modes.len(), found.circuits, found.branches),
            (2, Some(1), Some(2)),
            "{:?}",
            found.modes
        );
        assert!(found.modes.iter().all(|course| [course.begins, course.ends] == [CourseEnd::Cycle; 2]));
        let [ModeMeeting { at, .. }] = found.meetings[..] else { panic!("{:?}", found.meetings) };
        assert!((at / std::f64::consts::TAU).fract().abs() < 1e-6, "{at}");
    }
}

/// A four-bar with a coupler point that moves a dyad; driven at `LINK`, its balancing moment on the crank.
const STEPHENSON_3: &str = r#"
gravity = "9.81 m/s^2"
[ground]
points = { O = [0, 0], C = [0.5, 0.05], G = [0.35, -0.3] }
[link.crank]
points = { O = 0, A = 0.12 }
mass = 3
center = [0.05, 0.01]
[link.coupler]
points = { A = 0, B = 0.45, E = [0.2, 0.15] }
mass = 4
center = [0.22, 0.05]
[link.rocker]
points = { C = 0, B = 0.35 }
mass = 3
center = 0.17
[link.rod]
points = { E = 0, F = 0.38 }
mass = 1.5
center = 0.19
[link.swing]
points = { G = 0, F = 0.3, T = [0.1, 0.1] }
mass = 2
center = "T"
[input]
link = "LINK"
from = FROM
positions = COUNT
[balance]
link = "crank"
[[force]]
link = "swing"
at = "T"
angle = "-60 deg"
frame = "link"
value = 300
[assembly]
PLACES
"#;

fn results(text: &str) -> serde_json::Value {
    let mechanism = assur_scene::read("scene", text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let found = Calculation::of(mechanism, &Options::default(), &mut unwatched)
        .unwrap_or_else(|error| panic!("{error}"));
    let analysis = found.analyze(&mut unwatched).unwrap_or_else(|error| panic!("{error}"));
    serde_json::from_str(&assur_report::json::analysis::to_json(&analysis, true).unwrap()).unwrap()
}

/// The greatest difference of the numbers of two values, in which nothing else may differ.
fn difference(one: &serde_json::Value, other: &serde_json::Value) -> f64 {
    use serde_json::Value::{Array, Object};
    match (one, other) {
        (Array(a), Array(b)) => a.iter().zip(b).map(|(a, b)| difference(a, b)).fold(0.0, f64::max),
        (Object(a), Object(b)) => {
            assert!(a.keys().eq(b.keys()));
            a.values().zip(b.values()).map(|(a, b)| difference(a, b)).fold(0.0, f64::max)
        }
        _ => (one.as_f64().unwrap() - other.as_f64().unwrap()).abs(),
    }
}

#[test]
fn stephenson_3_has_the_same_places_and_reactions_driven_from_either_side() {
    let scene = |link: &str, from: f64, count: usize, places: &str| {
        let text = STEPHENSON_3.replace("LINK", link).replace("FROM", &format!("{from:?}"));
        results(&text.replace("COUNT", &count.to_string()).replace("PLACES", places))
    };
    let easy = scene("crank", 0.4, 12, "B = [0.43, 0.39]\nF = [0.55, -0.1]");
    assert_eq!(easy["structure"]["class"], 2);
    for at in easy["positions"].as_array().unwrap() {
        let place = |name: &str| {
            let [x, y] = [0, 1].map(|k| at["points"][name]["pf0"][k].as_f64().unwrap());
            format!("{name} = [{x:.4}, {y:.4}]\n")
        };
        let places: String = ["A", "B", "E"].map(place).concat();
        let hard = scene("swing", at["links"]["swing"]["pf0"].as_f64().unwrap(), 1, &places);
        assert_eq!(hard["structure"]["class"], 3);
        let there = &hard["positions"][0];
        for name in ["A", "B", "E", "F", "T"] {
            let off = difference(&at["points"][name]["pf0"], &there["points"][name]["pf0"]);
            assert!(off < 1e-10, "{name}: {off:e}");
        }
        // Sizes of some hundred newtons.
        let off = difference(&at["reactions"], &there["reactions"]) / 300.0;
        assert!(off < 1e-8, "reactions: {off:e}");
        let off = difference(&at["balancing"], &there["balancing"]);
        assert!(off < 1e-7, "balancing: {off:e}");
    }
}

/// A four-bar of which the crank does not turn fully, and a group after it that is the less healthy the nearer it comes to the end.
const ENDING: &str = r#"
[ground]
points = { O = 0, C = [0.3, 0], G = [GUIDE] }
[link.crank]
points = { O = 0, A = 0.2 }
[link.rod]
points = { A = 0, B = 0.25 }
[link.rocker]
points = { C = 0, B = 0.22, D = [0.1, -0.05] }
[link.stone]
points = { D = 0 }
[link.arm]
points = { G = 0 }
[[slide]]
link = "stone"
on = "arm"
through = [0, 0.03]
[input]
link = "crank"
from = FROM
"#;

/// The greatest coordinate of [`ENDING`], for coordinates of the first position that put it anywhere between two samples.
fn ends_of(guide: [f64; 2]) -> impl Iterator<Item = f64> {
    (0..12).map(move |step| {
        let from = format!("{:?}", 1.2 + 0.0008 * f64::from(step));
        let text = ENDING.replace("FROM", &from).replace("GUIDE", &format!("{:?}, {:?}", guide[0], guide[1]));
        linkage_of(assur_scene::read("ending", &text).unwrap()).range.unwrap().high
    })
}

#[test]
fn a_range_ends_with_its_first_group_whatever_comes_after_it() {
    // The pins A and C are as far apart as rod and rocker are long.
    let cosine = (0.2_f64.powi(2) + 0.3_f64.powi(2) - 0.47_f64.powi(2)) / (2.0 * 0.2 * 0.3);
    for end in ends_of([0.19726, 0.05353]) {
        assert!((end - cosine.acos()).abs() < 1e-9, "{end} for {}", cosine.acos());
    }
}

#[test]
fn a_range_ends_with_a_group_that_ends_shortly_before_the_one_before_it() {
    let guide = [0.198_138, 0.054_485];
    // The distance of D from the guide's pin, with the rocker above the line from A to C.
    let distance = |q: f64| {
        let [x, y] = [0.3 - 0.2 * q.cos(), -0.2 * q.sin()];
        let square = x * x + y * y;
        let along = (0.25_f64.powi(2) - 0.22_f64.powi(2) + square) / (2.0 * square);
        let aside = (0.25_f64.powi(2) / square - along * along).sqrt();
        let [u, v] = [-x + along * x - aside * y, -y + along * y + aside * x].map(|part| part / 0.22);
        (0.3 + 0.1 * u + 0.05 * v - guide[0]).hypot(0.1 * v - 0.05 * u - guide[1])
    };
    // It reaches the offset of the guide, where the stone can't get nearer.
    let [mut low, mut high] = [2.42, 2.4302];
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if distance(middle) > 0.03 { low = middle } else { high = middle }
    }
    for end in ends_of(guide) {
        assert!((end - low).abs() < 1e-9, "{end} for {low}");
    }
}
