//! The study of a scene: figures in closed form, change points, JSON and text.

use std::ops::ControlFlow;

use assur_kinematics::Linkage;
use assur_mechanism::Mechanism;
use assur_words::{name, text};

use super::{studied, told};
use crate::stability::friction::friction;
use crate::stability::nearest::nearest;
use crate::stability::target::targets;
use crate::stability::{Comparison, DISTANCES, stability};

fn scene(text: &str) -> Mechanism {
    assur_scene::read("scene.toml", text).unwrap()
}

const CRANK_ROD: &str = r#"
    [ground]
    points = { O = [0, 0] }
    [link.crank]
    points = { O = 0, A = 0.25 }
    [link.rod]
    points = { A = 0, B = 1 }
    [link.slider]
    points = { B = 0 }
    [[slide]]
    link = "slider"
    on = "ground"
    [input]
    link = "crank"
"#;

fn parallelogram() -> Mechanism {
    scene(
        r#"
        [ground]
        points = { O = [0, 0], C = [1, 0] }
        [link.crank]
        points = { O = 0, A = 0.5 }
        [link.coupler]
        points = { A = 0, B = 1 }
        [link.rocker]
        points = { C = 0, B = 0.5 }
        [input]
        link = "crank"
        from = 1
        [assembly]
        B = [1.27, 0.42]
    "#,
    )
}

#[test]
fn a_study_that_is_stopped_ends_there() {
    let mut calls = Vec::new();
    let found = stability(scene(CRANK_ROD), &mut |done, total| {
        calls.push((done, total));
        if done == 2 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    assert!(found.is_break());
    // One group, to which one walk goes; then the lengths of crank and rod, and the offset of the slide.
    assert_eq!(calls, [(0, 4), (1, 4), (2, 4)]);
}

/// n = 4: the rod makes asin(1/4) with the guide at the worst, and the offset may grow to rod - crank.
#[test]
fn figures_of_a_slider_crank() {
    let found = studied(scene(CRANK_ROD)).unwrap();
    let group = &found.groups[0];
    assert!((group.angle - 0.25_f64.asin()).abs() < 1e-12);
    assert!((group.health - 0.9375_f64.sqrt()).abs() < 1e-12);
    let of = |start: &str| {
        found.lengths.iter().find(|margin| margin.length.to_string().starts_with(start)).unwrap()
    };
    assert!((of("rod").decrease.unwrap() - 0.75).abs() < 1e-6);
    assert!((of("slider").increase.unwrap() - 0.75).abs() < 1e-6);
    assert!(of("rod").increase.is_none());
    assert!(found.is_ok(), "{}", told(&found));
}

#[test]
fn margins_are_told_with_the_digits_that_are_right() {
    let text = told(&studied(scene(CRANK_ROD)).unwrap());
    for row in [
        ["rod: A to B", "1000 mm", "none up to 100000 mm", "750 mm"],
        ["crank: O to A", "250 mm", "750 mm", "none up to 249.99975 mm"],
    ] {
        let cells = |line: &str| line.split("  ").map(str::trim).filter(|cell| !cell.is_empty()).eq(row);
        assert!(text.lines().any(cells), "{row:?} in {text}");
    }
}

#[test]
fn ways_stay_where_they_no_longer_meet() {
    let linkage = Linkage::compile(parallelogram()).unwrap();
    assert_eq!(linkage.change_points().count(), 2);
    assert_eq!(linkage.ways.without(1.0, |_| false), linkage.ways);
    for from in [1.0, 4.0] {
        let alone = linkage.ways.without(from, |_| true);
        for q in [-2.0, 0.5, 2.0, 4.0, 7.0] {
            assert_eq!(alone.at(q), linkage.ways.at(from), "{from}, {q}");
        }
    }
}

/// A crank-rocker 1 : 3.5 : 3 : 4 (crank, coupler, rocker, ground) by Grashof's sums.
#[test]
fn margins_of_a_four_bar() {
    let found = studied(scene(
        r#"
        [ground]
        points = { O = [0, 0], C = [4, 0] }
        [link.crank]
        points = { O = 0, A = 1 }
        [link.coupler]
        points = { A = 0, B = 3.5 }
        [link.rocker]
        points = { C = 0, B = 3 }
        [input]
        link = "crank"
    "#,
    ))
    .unwrap();
    let of = |start: &str| {
        found.lengths.iter().find(|margin| margin.length.to_string().starts_with(start)).unwrap()
    };
    // Turns fully while 4 + 1 <= b + c and 4 - 1 >= |b - c|.
    assert!((of("coupler").decrease.unwrap() - 1.5).abs() < 1e-6);
    assert!((of("coupler").increase.unwrap() - 2.5).abs() < 1e-6);
    assert!((of("rocker").decrease.unwrap() - 1.5).abs() < 1e-6);
    assert!(found.is_ok(), "{}", told(&found));
}

/// The parallelogram goes through its change points as a parallelogram: the rocker is parallel to the crank, the coupler
/// to the ground, at every distance and on both sides.
#[test]
fn a_parallelogram_passes_its_change_points() {
    let linkage = Linkage::compile(parallelogram()).unwrap();
    let mut position = linkage.position();
    for center in [0.0, std::f64::consts::PI] {
        for distance in DISTANCES {
            for q in [center - distance, center + distance] {
                linkage.solve(q, assur_group::Order::Second, &mut position).unwrap();
                let (coupler, rocker) = (&position.bodies[2], &position.bodies[3]);
                assert!((rocker.c - q.cos()).abs() + (rocker.s - q.sin()).abs() < 1e-11, "{q}");
                assert!((rocker.w1 - 1.0).abs() + coupler.w1.abs() < 1e-9, "{q}");
                assert!(rocker.w2.abs() + coupler.w2.abs() < 1e-7, "{q}");
            }
        }
    }
}

#[test]
fn walks_over_a_change_point_keep_their_bounds() {
    let found = studied(parallelogram()).unwrap();
    assert!(found.rows.iter().any(|row| row.finding.place.to_string().ends_with("change point")));
    assert!(found.is_ok(), "{}", told(&found));
}

/// The published longitudinal reactions lose digits towards their pole at infinity; the stable form does not.
#[test]
fn the_published_pole_at_infinity_is_told() {
    let found =
        studied(scene(&CRANK_ROD.replace("on = \"ground\"", "on = \"ground\"\n    angle = \"90 deg\"")))
            .unwrap();
    let worst = |method: &str| {
        let rows = found.rows.iter().filter(|row| row.method == name(method.to_owned()));
        rows.filter_map(|row| row.finding.number()).fold(0.0, f64::max)
    };
    assert!(worst("longitudinal") < 1e-13 && worst("longitudinal-published") > 1e-10);
    assert!(found.is_ok(), "{}", told(&found));
}

#[test]
fn no_assembly_is_told() {
    let found = studied(scene(&CRANK_ROD.replace("A = 0.25", "A = 1.25"))).unwrap();
    assert!(!found.is_ok() && found.failure.unwrap().to_string().contains("no assembly"));
}

#[test]
fn json_has_the_keys_of_the_format() {
    let text = assur_report::json::to_json(&studied(scene(CRANK_ROD)).unwrap(), false).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    let row = json["rows"][0].as_object().unwrap();
    for key in ["where", "method", "quantity", "distance", "health", "error", "bound", "ok", "reason"] {
        assert!(row.contains_key(key), "{key}");
    }
}

/// A crank and `count` dyads, each rocker driving the next one: rockers of different lengths, upright in the first position.
fn ladder(count: u32) -> String {
    use std::fmt::Write;
    let (mut points, mut links, mut places) = ("O0 = [0, 0]".to_owned(), String::new(), String::new());
    let mut before = 1.0_f64;
    for k in 1..=count {
        let rocker = 1.0 + 0.02 * f64::from(k * 7919 % 13);
        let coupler = (rocker - before).hypot(2.0);
        let last = k - 1;
        write!(points, ", O{k} = [{}, 0]", 2 * k).unwrap();
        write!(
            links,
            "[link.c{k}]\npoints = {{ A{last} = 0, A{k} = {coupler:?} }}\n\
             [link.l{k}]\npoints = {{ O{k} = 0, A{k} = {rocker:?} }}\n"
        )
        .unwrap();
        writeln!(places, "A{k} = [{}, {rocker:?}]", 2 * k).unwrap();
        before = rocker;
    }
    format!(
        "[ground]\npoints = {{ {points} }}\n[link.l0]\npoints = {{ O0 = 0, A0 = 1 }}\n{links}\
         [input]\nlink = \"l0\"\nfrom = \"80 deg\"\nto = \"100 deg\"\n[assembly]\n{places}"
    )
}

/// Of very many places the worst are walked to, so that the walks cost as much as those of a smaller mechanism.
#[test]
fn a_mechanism_of_many_groups_is_walked_to_its_worst_places() {
    const GROUPS: u32 = 30;
    let linkage = Linkage::compile(scene(&ladder(GROUPS))).unwrap();
    let mut groups = nearest(&linkage).unwrap();
    // As if the least health of each group were somewhere else.
    for (k, group) in groups.iter_mut().enumerate() {
        group.coordinate = 1.4 + 0.01 * k as f64;
    }
    let (mut found, left_out) = targets(&linkage, &groups);
    found.retain(|target| target.words == text!("stability-least-health"));
    assert_eq!((found.len() + left_out, left_out), (30, 6));
    let walked: Vec<f64> = found.iter().map(|target| groups[target.groups[0]].health).collect();
    let worst = walked.iter().copied().fold(0.0, f64::max);
    let better = groups.iter().filter(|group| group.health > worst).count();
    assert!(better >= left_out, "{better} of {left_out} are healthier than {worst}");
}

/// Two guides across each other jam where the product of their coefficients is 1, wherever the input is.
#[test]
fn a_walk_to_jamming_ends_where_two_crossing_guides_jam() {
    let linkage = Linkage::compile(scene(assur_fixtures::scene("shaper-friction"))).unwrap();
    let mut rows = Vec::new();
    let ControlFlow::Continue(found) = friction(&linkage, &mut rows, &mut || ControlFlow::Continue(()))
    else {
        panic!("nothing stops it")
    };
    assert_eq!(found.len(), 2);
    let limit = 1.0 / f64::sqrt(0.12 * 0.1);
    for group in &found {
        assert!((group.jams_at.unwrap() / limit - 1.0).abs() < 1e-10, "{group:?}");
        assert!(group.radius > 0.0 && group.radius < 1.0, "{group:?}");
    }
    let judged = |row: &&Comparison| row.finding.number().is_some();
    assert!(
        rows.iter().filter(judged).count() > 20 && rows.iter().all(|row| !row.finding.failed()),
        "{rows:?}"
    );
    // Nearer than the rounding of the limit itself there may be no solution.
    assert!(
        rows.iter().filter(|row| row.distance > 1e-13).all(|row| row.finding.number().is_some()),
        "{rows:?}"
    );
}

/// A drawer has no group: its walk is that of the balancing load, which pulls beside the guide. It jams at the length over twice
/// the distance.
#[test]
fn a_walk_to_jamming_is_made_of_a_drawer_too() {
    let text = |pull: f64| {
        format!(
            r#"
            [ground]
            points = {{ O = 0 }}
            [link.drawer]
            points = {{ K = 0 }}
            [[slide]]
            link = "drawer"
            on = "ground"
            [input]
            link = "drawer"
            to = 0.2
            [[force]]
            link = "drawer"
            at = "K"
            angle = "180 deg"
            value = 100
            [balance]
            link = "drawer"
            at = [0, {pull}]
            angle = 0
            [[friction]]
            pair = "drawer/ground"
            coefficient = 0.1
            length = 0.3
            "#
        )
    };
    let found = studied(scene(&text(0.4))).unwrap();
    let [drawer] = &found.friction[..] else { panic!("{:?}", found.friction) };
    assert!((drawer.jams_at.unwrap() - 0.3 / (2.0 * 0.4) / 0.1).abs() < 1e-9, "{drawer:?}");
    assert!((drawer.radius - 0.1 / (0.3 / (2.0 * 0.4))).abs() < 1e-12, "{drawer:?}");
    assert!(found.is_ok() && found.rows.iter().any(|row| row.quantity == "friction"), "{:?}", found.rows);
    assert_eq!(studied(scene(&text(0.0))).unwrap().friction, []);
}
