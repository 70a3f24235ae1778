//! Tests of `mechanism`.

use assur_all as _;
use assur_group::Order;
use assur_kinematics::Linkage;

use super::{Drawing, hull};
use crate::model::{Ink, Item, Point};

#[test]
fn a_hull_drops_what_lies_inside_or_on_a_line() {
    assert_eq!(hull(&[[0.0, 0.0], [1.0, 0.0], [0.5, 0.0]]), [[0.0, 0.0], [1.0, 0.0]]);
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 0.5]];
    assert_eq!(hull(&square), square[..4]);
    assert!(hull(&[]).is_empty());
}

/// The items of a shipped scene in its first position.
fn items(name: &str) -> (Linkage, Vec<Item>) {
    let mechanism = assur_scene::read(name, assur_fixtures::scene(name)).unwrap();
    let linkage = Linkage::compile(mechanism).unwrap();
    let mut position = linkage.position();
    linkage.solve_index(0, Order::Second, &mut position).unwrap();
    let strokes: Vec<_> = (0..linkage.mechanism.slides.len())
        .map(|slide| linkage.slide_motion(slide, &position).pf0)
        .map(|at| [at, at])
        .collect();
    let items = Drawing { linkage: &linkage, strokes: &strokes, arcs: &[], marked: &[], hidden: &[] }
        .items(&position);
    (linkage, items)
}

fn distance(at: Point, [a, b]: [Point; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let part = (((at[0] - a[0]) * dx + (at[1] - a[1]) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
    (at[0] - a[0] - part * dx).hypot(at[1] - a[1] - part * dy)
}

#[test]
fn a_link_with_one_named_point_reaches_its_pairs() {
    let (linkage, items) = items("guide-shaper");
    let rocker = linkage.mechanism.link("rocker").unwrap();
    let bar = items.iter().find_map(|item| match item {
        Item::Line { points, ink: Ink::Link(link), .. } if *link == rocker => Some([points[0], points[1]]),
        _ => None,
    });
    let mut position = linkage.position();
    linkage.solve_index(0, Order::Place, &mut position).unwrap();
    for name in ["C", "A", "D"] {
        let at = linkage.point_motion(linkage.mechanism.point(name).unwrap(), &position).pf0;
        assert!(distance(at, bar.unwrap()) < 1e-9, "{name} is beside the rocker");
    }
}

#[test]
fn springs_are_drawn_between_their_ends() {
    let (linkage, items) = items("andrews");
    let springs = items.iter().filter(|item| matches!(item, Item::Spring { .. })).count();
    assert_eq!(springs, linkage.mechanism.loads.iter().filter_map(|load| load.kind.spring()).count());
}

/// The length of the gap that is drawn in a position, m.
fn gap(text: &str, index: usize) -> f64 {
    let linkage = Linkage::compile(assur_scene::read("scene.toml", text).unwrap()).unwrap();
    let mut position = linkage.position();
    let error = linkage.solve_index(index, Order::Place, &mut position).unwrap_err();
    let strokes = vec![[0.0; 2]; linkage.mechanism.slides.len()];
    let drawing = Drawing { linkage: &linkage, strokes: &strokes, arcs: &[], marked: &[], hidden: &[] };
    let items = drawing.gap(&position, None, error.group);
    let ends = items.iter().find_map(|item| match item {
        Item::Line { points, ink: Ink::Marked, .. } => Some([points[0], points[1]]),
        _ => None,
    });
    let [a, b] = ends.unwrap();
    (a[0] - b[0]).hypot(a[1] - b[1])
}

#[test]
fn a_gap_is_as_wide_as_the_lengths_miss() {
    // Crank 100 mm, frame 400 mm; at 180 degrees the ends of rod and rocker are 500 mm apart, at 0 degrees 300 mm.
    let four_bar = |rod: u32, rocker: u32| {
        format!(
            "[ground]\npoints = {{ O = [0, 0], C = [0.4, 0] }}\n[link.crank]\npoints = {{ O = 0, A = \"100 mm\" }}\n\
             [link.rod]\npoints = {{ A = 0, B = \"{rod} mm\" }}\n[link.rocker]\npoints = {{ C = 0, B = \"{rocker} mm\" }}\n\
             [input]\nlink = \"crank\"\npositions = 12\n"
        )
    };
    assert!((gap(&four_bar(200, 250), 6) - 0.050).abs() < 1e-12);
    assert!((gap(&four_bar(700, 250), 0) - 0.150).abs() < 1e-12);
    assert!((gap(&four_bar(150, 500), 0) - 0.050).abs() < 1e-12);
    // The guide is 200 mm above the crank's pin; at 270 degrees the end of the crank is 300 mm below it, the rod 250 mm long.
    let slider = "[ground]\npoints = { O = [0, 0], G = [0, 0.2] }\n[link.crank]\npoints = { O = 0, A = \"100 mm\" }\n\
                  [link.rod]\npoints = { A = 0, B = \"250 mm\" }\n[link.piston]\npoints = { B = 0 }\n\
                  [[slide]]\nlink = \"piston\"\non = \"ground\"\nthrough = \"G\"\nangle = 0\n\
                  [input]\nlink = \"crank\"\npositions = 4\n";
    assert!((gap(slider, 3) - 0.050).abs() < 1e-12);
}

#[test]
fn a_group_of_any_kind_shows_what_is_open() {
    // A slider on the turning guide (RPR): the pin of the crank comes nearer to the rocker's pin than the guide is away from it.
    let text = "[ground]\npoints = { O = [0, 0], C = [0.15, 0] }\n[link.crank]\npoints = { O = 0, A = \"100 mm\" }\n\
                [link.stone]\npoints = { A = 0 }\n[link.rocker]\npoints = { C = 0, G = [0, \"80 mm\"] }\n\
                [[slide]]\nlink = \"stone\"\non = \"rocker\"\nthrough = \"G\"\nangle = 0\n\
                [input]\nlink = \"crank\"\npositions = 12\nfrom = \"180 deg\"\n";
    let linkage = Linkage::compile(assur_scene::read("scene.toml", text).unwrap()).unwrap();
    let [mut there, mut here] = [linkage.position(), linkage.position()];
    linkage.solve_index(0, Order::Place, &mut there).unwrap();
    let error = linkage.solve_index(6, Order::Place, &mut here).unwrap_err();
    let drawing = Drawing { linkage: &linkage, strokes: &[[0.0; 2]], arcs: &[], marked: &[], hidden: &[] };
    assert!(drawing.gap(&here, None, error.group).is_empty(), "without another position nothing is known");
    let items = drawing.gap(&here, Some(&there), error.group);
    let gaps = items.iter().filter_map(|item| match item {
        Item::Line { points, ink: Ink::Marked, .. } => {
            Some((points[0][0] - points[1][0]).hypot(points[0][1] - points[1][1]))
        }
        _ => None,
    });
    // The pin of the crank was at -100 mm and is at 100 mm; the guide and the other pin are where they were.
    let gaps: Vec<f64> = gaps.collect();
    assert!(gaps.len() == 1 && (gaps[0] - 0.2).abs() < 1e-12, "{gaps:?}");
}
