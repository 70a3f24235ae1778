//! A group that iterates starts from all that is known: the ground, the input link, `[assembly]` and its slides.

use assur_group::PairSort::{Pin, Slide};
use assur_group::{Order, Pattern, inventory};
use assur_kinematics::{Linkage, Position};
use assur_testkit::iterated;

inventory::submit! {
    iterated("triad-inner-slide", Pattern {
        links: 4,
        inner: &[([0, 1], Pin), ([0, 2], Pin), ([0, 3], Slide)],
        outer: &[(1, Pin), (2, Pin), (3, Pin)],
    })
}

inventory::submit! {
    iterated("triad-outer-slide", Pattern {
        links: 4,
        inner: &[([0, 1], Pin), ([0, 2], Pin), ([0, 3], Pin)],
        outer: &[(1, Pin), (2, Pin), (3, Slide)],
    })
}

const LINKS: &str = "[link.crank]\npoints = { O = 0, A = 0.05 }\n[link.rod]\npoints = { A = 0, B = 0.39 }\n\
    [link.strut]\npoints = { D = 0, E = 0.3 }\n[input]\nlink = \"crank\"\npositions = 12\n";

/// A plate on a rod and a strut; a sleeve pinned to the ground slides on it.
const INNER: &str = "[ground]\npoints = { O = [0, 0], D = [0.5, 0], Q = [0.4, 0.15] }\n\
    [link.plate]\npoints = { B = 0, E = [0.2, 0], F = [0.1, -0.1] }\n[link.sleeve]\npoints = { Q = 0 }\n\
    [[slide]]\nlink = \"sleeve\"\non = \"plate\"\nthrough = \"F\"\nangle = \"90 deg\"\n";

/// A plate on a rod and a strut; a slider pinned to it slides on the ground.
const OUTER: &str = "[ground]\npoints = { O = [0, 0], D = [0.5, 0] }\n\
    [link.plate]\npoints = { B = 0, E = [0.2, 0], F = [0, 0.15] }\n[link.slider]\npoints = { F = 0 }\n\
    [[slide]]\nlink = \"slider\"\non = \"ground\"\nthrough = [0, 0.45]\n";

/// The linkage at its first position, all of whose pins are closed, and which turns fully.
#[expect(clippy::unwrap_used, reason = "the scene of the test is valid")]
fn first(scene: &str, assembly: &str) -> (Linkage, Position) {
    let text = format!("{scene}{LINKS}[assembly]\n{assembly}");
    let linkage = Linkage::compile(assur_scene::read("triad", &text).unwrap()).unwrap();
    assert_eq!(linkage.structure.class(), 3);
    let mut position = linkage.position();
    linkage
        .solve_index(0, Order::Second, &mut position)
        .unwrap_or_else(|error| panic!("{assembly}: {error}"));
    for point in &linkage.mechanism.points {
        let places: Vec<_> = point.places.iter().map(|of| position.bodies[of.link].point(of.at)).collect();
        for place in &places[1..] {
            let gap = (place[0] - places[0][0]).hypot(place[1] - places[0][1]);
            assert!(gap < 1e-14, "{} is open by {gap:e} m", point.name);
        }
    }
    (linkage, position)
}

#[test]
fn the_assembly_near_the_natural_points_is_found() {
    for (scene, natural) in [
        (INNER, "B = [0.3, 0.3]\nE = [0.5, 0.3]\n"),
        (OUTER, "B = [0.3, 0.3]\nE = [0.5, 0.3]\nF = [0.3, 0.45]\n"),
        // The plate's direction is not given, and the place of F follows from that of the plate.
        (OUTER, "B = [0.3, 0.3]\n"),
    ] {
        let (linkage, position) = first(scene, natural);
        assert!(linkage.range.is_some_and(|range| range.full));
        for (name, wanted) in [("B", [0.3, 0.3]), ("E", [0.5, 0.3])] {
            let point = linkage.mechanism.points.iter().find(|point| point.name == name).unwrap();
            let found = position.bodies[point.places[0].link].point(point.places[0].at);
            let off = (found[0] - wanted[0]).hypot(found[1] - wanted[1]);
            // The scene is drawn to the centimeter; another assembly is decimeters away.
            assert!(off < 0.005, "{name} is {off} m from its place in {natural}");
        }
    }
}

#[test]
fn a_singular_start_is_left() {
    // The rod, the strut and the normal of the guide all start vertical: their lines are parallel.
    first(OUTER, "B = [0.05, 0.3]\nE = [0.5, 0.3]\n");
}
