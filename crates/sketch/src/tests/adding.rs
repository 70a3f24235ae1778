//! Every kind is added to scenes at random places.

use std::f64::consts::PI;

use assur_group::PairSort::{self, Any, Pin, Slide};
use assur_group::Pattern;
use assur_kinematics::decompose;

use super::{Random, drawn, read};
use crate::{
    Added, Addition, Fit, Names, Sketch, Start, Target, add, additions, closings, move_point, start,
};

/// Random targets of the outer pairs.
fn targets(random: &mut Random, sketch: &Sketch, addition: &Addition) -> Vec<Target> {
    let size = sketch.size();
    let links: Vec<String> = sketch.mechanism.links.iter().map(|link| link.name.to_string()).collect();
    let points: Vec<(String, [f64; 2])> = sketch.points().map(|(name, at)| (name.to_owned(), at)).collect();
    let mut used: Vec<String> = Vec::new();
    let mut all = Vec::new();
    for sort in addition.outer() {
        let near = random.pick(&points).1;
        let at = [near[0] + random.range(-size, size), near[1] + random.range(-size, size)];
        let link = random.pick(&links).clone();
        let free: Vec<_> = points.iter().filter(|(name, _)| !used.contains(name)).collect();
        all.push(if *sort == Slide {
            Target::Guide { link, through: at, angle: random.range(-PI, PI), point: None }
        } else if random.unit() < 0.5 && !free.is_empty() {
            let name = random.pick(&free).0.clone();
            used.push(name.clone());
            Target::Point(name)
        } else {
            Target::New { link, at }
        });
    }
    all
}

#[test]
fn every_kind_is_added_as_one_group_that_can_be_assembled_as_drawn() {
    let scenes = [
        assur_fixtures::scene("four-bar").to_owned(),
        assur_fixtures::scene("shaper").to_owned(),
        start(Start::CRANK),
        start(Start::SLIDE),
    ];
    let mut random = Random(7);
    for addition in additions().unwrap().iter().filter(|addition| addition.plugin.is_some()) {
        for (index, scene) in scenes.iter().enumerate() {
            let before = drawn(scene);
            for round in 0..2 {
                let targets = targets(&mut random, &before, addition);
                let what = format!("{} at scene {index}, round {round}: {targets:?}", addition.name);
                let added = add(scene, &before, addition, &targets, &Names::default()).unwrap();
                assert!(added.fit >= Fit::Here, "{what}\n{}", added.text);
                assert_eq!(kind_of(&added), Some(addition.name), "{what}\n{}", added.text);
                let numbers = assur_scene::reading("", &added.text).unwrap().numbers;
                for key in &added.fields {
                    assert!(
                        numbers.iter().any(|number| number.key == *key),
                        "{key} of {what}\n{}",
                        added.text
                    );
                }
            }
        }
    }
}

/// The kind of the group that the new links form.
fn kind_of(added: &Added) -> Option<&'static str> {
    let mechanism = read(&added.text);
    let structure = decompose(&mechanism).unwrap_or_else(|error| panic!("{error:?}\n{}", added.text));
    let mut links: Vec<usize> = added.links.iter().map(|link| mechanism.link(link).unwrap()).collect();
    links.sort_unstable();
    structure.groups.iter().find(|group| group.frame.links == links).map(|group| group.plugin.name)
}

#[test]
fn the_sort_of_a_pair_is_chosen_where_the_pattern_leaves_it_open() {
    const DYAD: Pattern = Pattern { links: 2, inner: &[([0, 1], Any)], outer: &[(0, Any), (1, Any)] };
    let scene = start(Start::CRANK);
    let before = drawn(&scene);
    let all = additions().unwrap();
    let mut dyad = Addition { pattern: DYAD, ..all.iter().find(|one| one.name == "rrr").unwrap().clone() };
    let guide =
        |angle: f64| Target::Guide { link: "ground".into(), through: [0.3, 0.05], angle, point: None };
    for (sorts, kind) in [
        ([Pin, Pin, Pin], "rrr"),
        ([Pin, Pin, Slide], "rrp"),
        ([Pin, Slide, Pin], "rrp"),
        ([Slide, Pin, Pin], "rpr"),
        ([Pin, Slide, Slide], "prp"),
        ([Slide, Pin, Slide], "rpp"),
    ] {
        dyad.sorts = sorts.to_vec();
        let target = |sort: &PairSort| match sort {
            Slide => guide(if sorts[1] == Slide { 0.2 } else { 1.1 }),
            _ => Target::New { link: "ground".into(), at: [0.25, -0.04] },
        };
        let mut targets: Vec<Target> = dyad.outer().iter().map(target).collect();
        if sorts[1] == Pin {
            targets[0] = Target::Point("A".into());
        }
        if sorts[1..] == [Slide, Slide] {
            targets[1] = guide(1.5);
        }
        let added = add(&scene, &before, &dyad, &targets, &Names::default()).unwrap();
        assert_eq!(
            (kind_of(&added), added.fit >= Fit::Here),
            (Some(kind), true),
            "{sorts:?}\n{}",
            added.text
        );
    }
}

fn addition(name: &str) -> Addition {
    additions().unwrap().into_iter().find(|one| one.name == name).unwrap()
}

fn ground(x: f64, y: f64) -> Target {
    Target::New { link: "ground".into(), at: [x, y] }
}

#[test]
fn a_dyad_is_written_as_one_would_by_hand() {
    let scene = start(Start::CRANK);
    let targets = [Target::Point("A".into()), ground(0.0, -0.4)];
    let added = add(&scene, &drawn(&scene), &addition("rpr"), &targets, &Names::default()).unwrap();
    assert_eq!(
        (&added.links[..], &added.points[..]),
        (&["stone2".to_owned(), "rod3".into()][..], &["B".to_owned(), "C".into()][..])
    );
    assert!(added.text.contains("[link.stone2]\npoints = { A = 0 }\n"));
    assert!(
        added.text.contains("[[slide]]\nlink = \"stone2\"\non = \"rod3\"\nthrough = \"B\"\n\n"),
        "{}",
        added.text
    );
    let scene = start(Start::CRANK);
    let targets = [Target::Point("A".into()), ground(0.4, 0.0)];
    let added = add(&scene, &drawn(&scene), &addition("rrr"), &targets, &Names::default()).unwrap();
    let fields: Vec<String> = added.fields.iter().map(ToString::to_string).collect();
    assert_eq!(
        fields,
        ["link.rod2.points.B", "link.rod3.points.B", "ground.points.C[0]", "ground.points.C[1]"]
    );
    // The apex lies to the left of the way from A to C, the legs are 0.8 to 1 of that way where the crank then turns.
    let after = drawn(&added.text);
    let [x, y] = after.place("B").unwrap();
    assert!((x - 0.25).abs() < 0.003 && y > 0.2, "{x} {y}");
    assert_eq!(added.fit, Fit::Everywhere);
    let names =
        Names { links: vec!["coupler".into(), "rocker".into()], points: vec!["P".into(), String::new()] };
    let named = add(&scene, &drawn(&scene), &addition("rrr"), &targets, &names).unwrap();
    assert_eq!((named.links, named.points), (names.links.clone(), vec!["P".into(), "B".into()]));
    let taken = Names { links: vec!["crank".into()], ..Names::default() };
    assert!(add(&scene, &drawn(&scene), &addition("rrr"), &targets, &taken).is_err());
    assert!(add(&scene, &drawn(&scene), &addition("rrr"), &targets[..1], &names).is_err());
    let guide =
        Target::Guide { link: "ground".into(), through: [0.3, 0.0], angle: 0.0, point: Some("O".into()) };
    let added =
        add(&scene, &drawn(&scene), &addition("rrp"), &[targets[0].clone(), guide], &Names::default())
            .unwrap();
    assert!(added.text.contains("link = \"stone3\"\non = \"ground\"\nthrough = \"O\"\n\n"), "{}", added.text);
}

#[test]
fn a_group_on_one_link_alone_is_told_to_be_rigid_with_it() {
    let text = assur_fixtures::scene("shaper");
    let sketch = drawn(text);
    let added = |name: &str, targets: &[Target]| {
        add(text, &sketch, &addition(name), targets, &Names::default()).unwrap().rigid_with
    };
    let point = |name: &str| Target::Point(name.to_owned());
    // C is on the rocker and on the ground, D on the rocker and its stone, A on the crank and its stone.
    assert_eq!(added("rrr", &[point("C"), point("D")]).as_deref(), Some("rocker"));
    assert_eq!(added("rrr", &[point("A"), point("D")]), None);
    let on_crank = Target::New { link: "crank".to_owned(), at: [0.05, 0.05] };
    assert_eq!(added("rod", &[on_crank, point("A")]).as_deref(), Some("crank"));
    assert_eq!(added("rrr", &[point("C"), ground(0.3, 0.0)]).as_deref(), Some("ground"));
    assert_eq!(added("free-link", &[ground(0.0, 0.5), ground(0.3, 0.5)]), None);
}

#[test]
fn what_is_no_group_stands_where_it_was_put() {
    let scene = start(Start::CRANK);
    let before = drawn(&scene);
    let link = add(
        &scene,
        &before,
        &addition("free-link"),
        &[ground(0.2, 0.3), ground(0.35, 0.1)],
        &Names::default(),
    )
    .unwrap();
    let sketch = drawn(&link.text);
    assert!(
        sketch.place("B").unwrap()[1] - 0.3 < 1e-9 && (sketch.place("C").unwrap()[0] - 0.35).abs() < 1e-9,
        "{}",
        link.text
    );
    assert_eq!((sketch.solved[1], sketch.solved[2]), (true, false));
    // Joined to the crank by a rod and to the ground by another, it is a part of a group of three legs less one, and still loose.
    let rod = add(
        &link.text,
        &sketch,
        &addition("rod"),
        &[Target::Point("A".into()), Target::Point("B".into())],
        &Names::default(),
    )
    .unwrap();
    let sketch = drawn(&rod.text);
    let ground_rod = add(
        &rod.text,
        &sketch,
        &addition("rod"),
        &[Target::Point("C".into()), ground(0.5, 0.0)],
        &Names::default(),
    )
    .unwrap();
    let sketch = drawn(&ground_rod.text);
    // A third leg holds it.
    let plate = [Target::New { link: link.links[0].clone(), at: [0.32, 0.27] }, ground(0.6, 0.3)];
    let held = add(&ground_rod.text, &sketch, &addition("rod"), &plate, &Names::default()).unwrap();
    let structure = decompose(&read(&held.text)).unwrap();
    assert_eq!(
        structure.groups.iter().map(|group| group.plugin.name).collect::<Vec<_>>(),
        ["rr-rr-rr"],
        "{}",
        held.text
    );
    let sketch = drawn(&held.text);
    assert!(sketch.is_assembled() && (sketch.place("B").unwrap()[0] - 0.2).abs() < 0.01, "{}", held.text);
    // A block stands on its guide where that was given.
    let guide = Target::Guide { link: "crank".into(), through: [0.05, 0.0], angle: 0.5, point: None };
    let block = add(&scene, &before, &addition("block"), &[guide], &Names::default()).unwrap();
    let pose = drawn(&block.text).pose(&block.links[0]).unwrap();
    assert!((pose.angle - 0.5).abs() < 1e-3 && (pose.at[0] - 0.05).abs() < 1e-9, "{}", block.text);
}

#[test]
fn a_point_more_leaves_the_center_of_mass_where_it_is() {
    let shaper = assur_fixtures::scene("shaper");
    let targets = [Target::New { link: "stone2".into(), at: [0.12, 0.02] }, ground(0.3, -0.2)];
    let added = add(shaper, &drawn(shaper), &addition("rrr"), &targets, &Names::default()).unwrap();
    let mass = |text: &str| read(text).links[2].center.map(f64::to_bits);
    assert_eq!(mass(&added.text), mass(shaper));
}

#[test]
fn whatever_is_built_step_by_step_can_be_read_and_drawn() {
    let all = additions().unwrap();
    let (few, mut random) = (all.iter().filter(|one| one.pattern.links <= 2).collect::<Vec<_>>(), Random(11));
    for round in 0..12 {
        let mut text = start(if round % 2 == 0 { Start::CRANK } else { Start::SLIDE });
        for _ in 0..4 {
            let before = drawn(&text);
            let addition = random.pick(&few);
            let targets = targets(&mut random, &before, addition);
            let added = add(&text, &before, addition, &targets, &Names::default()).unwrap();
            let after = drawn(&added.text);
            assert!(
                after.bodies.iter().all(Option::is_some),
                "{}: {targets:?}\n{}",
                addition.name,
                added.text
            );
            let point = random
                .pick(
                    &added
                        .points
                        .iter()
                        .chain(["A", "O"].map(String::from).iter())
                        .cloned()
                        .collect::<Vec<_>>(),
                )
                .clone();
            let [x, y] = after.place(&point).unwrap();
            text = move_point(&added.text, &after, &point, [x + 0.003, y - 0.002]).unwrap();
            closings(&text, &added.fields);
        }
    }
}
