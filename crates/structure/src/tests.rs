use assur_all as _;

use crate::{Structure, StructureError};

fn structure(text: &str) -> Result<Structure, StructureError> {
    Structure::of(&assur_scene::read("test", text).unwrap())
}

const FOUR_BAR: &str = "[ground]\npoints = { O = [0, 0], C = [0.5, 0] }\n\
    [link.crank]\npoints = { O = 0, A = 0.1 }\n[link.coupler]\npoints = { A = 0, B = 0.4, E = [0.2, 0.1] }\n\
    [link.rocker]\npoints = { C = 0, B = 0.3 }\n[input]\nlink = \"crank\"\n";

#[test]
fn formulas_of_known_mechanisms() {
    let known = [
        ("shaper", "I(ground,crank) -> II3(stone2,rocker) -> II5(stone4,ram)", 5, 7),
        ("guide-shaper", "I(ground,crank) -> II3(stone2,rocker) -> II4(stone4,ram)", 5, 7),
        ("slider-crank", "I(ground,crank) -> II2(rod,piston)", 3, 4),
        ("conveyor", "I(ground,crank) -> II1(rod,rocker) -> II2(rod4,trough)", 5, 7),
        ("stephenson3", "I(ground,crank) -> II1(coupler,rocker) -> II2(rod,block)", 5, 7),
        ("andrews", "I(ground,K1) -> II1(K2,K3) -> II1(K4,K5) -> II1(K6,K7)", 7, 10),
        ("brake", "I(ground,disc)", 1, 1),
    ];
    for (scene, formula, moving, pairs) in known {
        let found = structure(assur_fixtures::scene(scene)).unwrap();
        assert_eq!(found.formula, formula, "{scene}");
        assert_eq!(
            (found.mobility.moving_links, found.mobility.pairs, found.mobility.value),
            (moving, pairs, 1)
        );
        assert_eq!(found.pairs.len(), pairs, "{scene}");
        assert_eq!(found.class(), if moving == 1 { 1 } else { 2 });
    }
}

#[test]
fn a_multiple_joint_does_not_tie_groups_together() {
    let found = structure(assur_fixtures::scene("n-four-bar-40")).unwrap();
    assert_eq!(found.groups.len(), 40);
    assert!(found.groups.iter().all(|group| group.plugin.kind == "RRR"));
}

#[test]
fn another_input_gives_other_groups() {
    // The shaper driven from its rocker, then from its ram: the same mechanism, taken apart from other ends.
    let text = assur_fixtures::scene("shaper");
    let from_rocker =
        structure(&text.replace("link = \"crank\"\npositions", "link = \"rocker\"\npositions")).unwrap();
    assert_eq!(from_rocker.formula, "I(ground,rocker) -> II2(crank,stone2) -> II5(stone4,ram)");
    let unloaded = &text[..text.find("[[force]]").unwrap()];
    let sliding = unloaded.replace("link = \"crank\"\npositions", "link = \"ram\"\nto = 0.1\npositions");
    let from_ram = structure(&sliding.replace("60 rpm", "1 m/s")).unwrap();
    assert_eq!(from_ram.formula, "I(ground,ram) -> II2(rocker,stone4) -> II2(crank,stone2)");
}

/// A ternary link on three rockers, one point of it driven by a crank: class III, order 3.
const TRIAD: &str = "[ground]\npoints = { O = [0, 0], P = [1, 0], Q = [0.5, 1] }\n\
    [link.crank]\npoints = { O = 0, A = 0.1 }\n[link.rod]\npoints = { A = 0, D = 0.5 }\n\
    [link.plate]\npoints = { D = 0, E = [0.3, 0], F = [0.1, 0.3] }\n[link.right]\npoints = { P = 0, E = 0.4 }\n\
    [link.top]\npoints = { Q = 0, F = 0.4 }\n[input]\nlink = \"crank\"\n";

#[test]
fn a_group_of_class_three_is_named() {
    let found = structure(TRIAD).unwrap();
    assert_eq!(found.formula, "I(ground,crank) -> III/3(rod,plate,right,top)");
    assert_eq!((found.class(), found.groups[0].plugin.kind), (3, "RR-RR-RR"));
    // The same mechanism driven from one of the rockers falls into dyads.
    let found = structure(&TRIAD.replace("link = \"crank\"", "link = \"right\"")).unwrap();
    assert_eq!(found.class(), 2);
    assert_eq!(found.formula, "I(ground,right) -> II1(plate,top) -> II1(crank,rod)");
}

#[test]
fn a_loose_link_is_named() {
    let text = FOUR_BAR.replace("[input]", "[link.flap]\npoints = { E = 0, Z = 0.1 }\n[input]");
    let error = structure(&text).unwrap_err();
    assert_eq!(
        error.to_string(),
        "mobility 2 (3*4 - 2*5), but one input moves the mechanism: link `flap` can still move while the input is fixed; \
         join it to another link by one more pair, or remove what is loose there \
         (a point name used in two links makes a pin there; these points are in one link only: flap: Z)"
    );
}

#[test]
fn a_surplus_pair_is_named() {
    // A third rocker of a parallelogram: it moves, but Chebyshev counts 0.
    let text = FOUR_BAR
        .replace("C = [0.5, 0]", "C = [0.5, 0], D = [0.2, 0.1]")
        .replace("[input]", "[link.third]\npoints = { D = 0, E = 0.1 }\n[input]");
    let error = structure(&text).unwrap_err();
    let StructureError::Surplus { counted, pairs, links, .. } = &error else { panic!("{error}") };
    assert_eq!((counted.value, counted.formula().as_str()), (0, "3*4 - 2*6"));
    assert!(pairs.contains(&"D".to_owned()) && pairs.contains(&"E".to_owned()), "{pairs:?}");
    assert_eq!(links, &["coupler", "rocker", "third"]);
}

/// A crank whose pin moves in a slot of a rocker that drives a ram.
const SLOTTED: &str = "[ground]
points = { O = [0, 0], C = [0, -0.4] }
[link.crank]
points = { O = 0, A = 0.1 }
[link.rocker]
points = { C = 0, D = 0.7 }
[link.rod]
points = { D = 0, E = 0.2 }
[link.ram]
points = { E = 0 }
[[slide]]
link = \"crank\"
on = \"rocker\"
point = \"A\"
[[slide]]
link = \"ram\"
on = \"ground\"
through = [0, 0.35]
[input]
link = \"crank\"
";

#[test]
fn a_pin_in_a_slot_without_a_block_is_told_what_is_missing() {
    let error = structure(SLOTTED).unwrap_err();
    let StructureError::Surplus { block: Some(block), .. } = &error else { panic!("{error}") };
    let [link, on] = [&block.link, &block.on].map(ToString::to_string);
    assert_eq!((link.as_str(), on.as_str()), ("crank", "rocker"));
    assert!(error.to_string().contains("pinned to `crank` at `A` and slides on `rocker`"), "{error}");
    // With the block that it asks for there is nothing to refuse.
    let block = "[link.block]\npoints = { A = 0 }\n[[slide]]\nlink = \"block\"\non = \"rocker\"\n";
    let slide = "[[slide]]\nlink = \"crank\"\non = \"rocker\"\npoint = \"A\"\n";
    structure(&SLOTTED.replace(slide, block)).unwrap();
    // A surplus of pins has nothing to do with a block.
    let pins = FOUR_BAR
        .replace("C = [0.5, 0]", "C = [0.5, 0], D = [0.2, 0.1]")
        .replace("[input]", "[link.third]\npoints = { D = 0, E = 0.1 }\n[input]");
    assert!(matches!(structure(&pins), Err(StructureError::Surplus { block: None, .. })));
}

#[test]
fn loose_here_and_surplus_there_is_said_at_once() {
    let text = FOUR_BAR.replace("C = [0.5, 0]", "C = [0.5, 0], D = [0.2, 0.1]").replace(
        "[input]",
        "[link.third]\npoints = { D = 0, E = 0.1 }\n[link.flap]\npoints = { E = 0 }\n[input]",
    );
    let shown = structure(&text).unwrap_err().to_string();
    assert!(shown.contains("`flap`") && shown.contains("one constraint too many"), "{shown}");
}

/// A crank, and dyads RRR that each join the rocker of the one before to the ground; links and points are named in an
/// order that skips `stride` places (a number without a common factor with `count` takes each once).
fn ladder(count: usize, stride: usize) -> String {
    let pin = |k: usize| format!(", C{k} = [{k}, 0]");
    let ground: String = (0..count).map(pin).collect();
    let dyad = |k: usize| {
        let from = if k == 0 { "A".to_owned() } else { format!("B{}", k - 1) };
        format!(
            "[link.rocker{k}]\npoints = {{ C{k} = 0, B{k} = 0.6 }}\n[link.rod{k}]\npoints = {{ {from} = 0, B{k} = 1 }}\n"
        )
    };
    let links: String = (0..count).map(|k| dyad(k * stride % count)).collect();
    format!(
        "[ground]\npoints = {{ O = [9, 9]{ground} }}\n[link.crank]\npoints = {{ O = 0, A = 0.1 }}\n{links}[input]\nlink = \"crank\"\n"
    )
}

#[test]
fn a_long_ladder_is_taken_apart_in_any_order_of_the_scene() {
    const COUNT: usize = 800;
    for stride in [1, COUNT - 1, 487] {
        let mechanism = assur_scene::read("ladder", &ladder(COUNT, stride)).unwrap();
        let found = Structure::of(&mechanism).unwrap();
        assert_eq!(found.groups.len(), COUNT);
        assert!(found.groups.iter().all(|group| group.plugin.name == "rrr" && group.order == 2));
        // Each group is solved after the ones that its outer pairs lead to.
        let mut solved = vec![false; mechanism.links.len()];
        (solved[0], solved[mechanism.input.first().link]) = (true, true);
        for group in &found.groups {
            let outside =
                |pair: &assur_group::Pair| if group.frame.links.contains(&pair.a) { pair.b } else { pair.a };
            assert!(group.frame.outer.iter().all(|pair| solved[outside(pair)]));
            group.frame.links.iter().for_each(|&link| solved[link] = true);
        }
    }
}

/// Slider on the ground beside these points, so that the greatest distance is that of the points.
fn scale(points: &[[f64; 2]]) -> f64 {
    let named: Vec<_> =
        points.iter().enumerate().map(|(i, [x, y])| format!("P{i} = [{x:?}, {y:?}]")).collect();
    let text = format!(
        "[ground]\npoints = {{ {} }}\n[link.m]\npoints = {{ Q = 0 }}\n[[slide]]\nlink = \"m\"\non = \"ground\"\n\
         [input]\nlink = \"m\"\nfrom = 0\nto = 1\n",
        named.join(", ")
    );
    structure(&text).unwrap().scale
}

#[test]
fn the_typical_length_is_the_greatest_distance_of_two_points() {
    let circle = |i: u32| (0.1 * f64::from(i)).sin_cos();
    let figures: [Vec<[f64; 2]>; 4] = [
        (0..50).map(|i| [0.5 * f64::from(i), 0.0]).collect(),
        (0..63).map(|i| [circle(i).0, circle(i).1]).collect(),
        (0..49).map(|i| [f64::from(i % 7), f64::from(i / 7)]).collect(),
        vec![[0.0, 0.0], [1.0, 0.9], [0.9, 1.0], [0.5, 0.5]],
    ];
    for points in figures {
        let distances =
            points.iter().flat_map(|a| points.iter().map(move |b| (a[0] - b[0]).hypot(a[1] - b[1])));
        let longest = distances.fold(0.0, f64::max);
        assert!((scale(&points) - longest).abs() <= 1e-15 * longest, "{longest}");
    }
}

#[test]
fn any_number_of_surplus_pairs_is_refused_and_some_are_named() {
    let slide = |link: &str, i: usize| {
        format!("[[slide]]\nlink = \"{link}\"\non = \"ground\"\nname = \"{link}{i}\"\n")
    };
    // In the order of the scene. The rocker is fixed by its pins already: with each slide the part that can't move grows over the whole four-bar.
    let slides: String = (0..100_000).map(|i| slide("rocker", i)).collect();
    let Err(StructureError::Surplus { pairs, links, .. }) = structure(&format!("{FOUR_BAR}{slides}")) else {
        panic!("surplus")
    };
    assert_eq!(
        (pairs, links),
        (
            ["C", "A", "B", "rocker0"].map(str::to_owned).to_vec(),
            ["coupler", "rocker"].map(str::to_owned).to_vec()
        )
    );
    // A loose arm beside them: their list is part of the message, and shortened.
    let many = (0..50).fold(String::new(), |text, i| text + &format!(", P{i} = [0.{i:02}, 0]"));
    let doubled = FOUR_BAR
        .replace(", C = [0.5, 0]", &format!(", C = [0.5, 0]{many}"))
        .replace("points = { C = 0, B = 0.3 }", &format!("points = {{ C = 0, B = 0.3{many} }}"));
    let arm = |i: u32| format!("[link.arm{i}]\npoints = {{ E = 0, F{i} = 1 }}\n");
    let arms = (0..30).fold(String::new(), |text, i| text + &arm(i));
    let error = structure(&format!("{doubled}{arms}")).unwrap_err();
    assert!(error.to_string().contains("`arm23` ... (24 of 30 shown) can still move"), "{error}");
}
