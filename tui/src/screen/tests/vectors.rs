//! Vectors on the mechanism: what is drawn is what was calculated, in a position and at an instant.

use std::collections::BTreeMap;

use assur_analysis::results::{Column, Owner, Quantity};
use assur_analysis::{Options, unwatched};
use assur_figure::{Figure, Frame, Item, Sign};
use assur_group::plane::{length, minus, plus, scaled};
use assur_mechanism::PairId;
use assur_picture::{Arrows, Look, Results, mechanism, missing};
use assur_words::name;

use super::{opened, press, text};
use crate::session::{Session, Source};

pub(super) fn analyzed(name: &str) -> Results {
    let session = Session::open(Source::File(assur_fixtures::path(&format!("{name}.toml")))).unwrap();
    session.analyzed(&Options::default(), false, &mut unwatched).unwrap()
}

fn drawn(results: &Results, arrows: Arrows, position: usize, alone: bool) -> Figure {
    mechanism::figure(results, &Look { arrows, position, alone, ..Look::default() }, &[])
}

/// The arrows with their names: from where, and the vector in the unit of the last scale.
fn vectors(figure: &Figure) -> BTreeMap<String, ([f64; 2], [f64; 2])> {
    let panel = &figure.panels[0];
    let Frame::Plane { scales, .. } = &panel.frame else { panic!() };
    let size = scales.last().unwrap().size;
    let pairs = panel.items.windows(2).filter_map(|two| match two {
        [Item::Arrow { from, to, .. }, Item::Name { at, text, .. }] if length(minus(*at, *to)) <= 0.0 => {
            Some((text.to_string(), (*from, scaled(size, minus(*to, *from)))))
        }
        _ => None,
    });
    pairs.collect()
}

fn near(one: [f64; 2], other: [f64; 2], size: f64) -> bool {
    length(minus(one, other)) <= 1e-9 * size
}

#[test]
fn reactions_are_those_that_were_found_and_keep_the_loads_in_equilibrium() {
    for (scene, ground) in [
        ("slider-crank", ["R_O", "R_piston_ground"].as_slice()),
        ("shaper-drive", &["R_O", "R_C", "R_ram_ground"]),
    ] {
        let results = analyzed(scene);
        let found = results.found.as_ref().unwrap();
        for position in [0, 5, 17] {
            let reactions = vectors(&drawn(&results, Arrows::Reactions, position, true));
            let most = reactions.values().map(|(_, force)| length(*force)).fold(0.0, f64::max);
            for reaction in found.reactions.iter().filter(|reaction| reaction.of.is_some()) {
                let (pair, _) = reaction.of.as_ref().unwrap();
                let [x, y] = [0, 1].map(|axis| found.series[reaction.series[axis]].at(position));
                let (at, force) = reactions[&name("R").below(&pair.name).to_string()];
                assert!(near(force, [x, y], most), "{scene} {position} {pair}: {force:?}, not {x} {y}");
                if let PairId::Pin(point) = pair.id {
                    let place = results.linkage.point_motion(point, &results.pose(position, 0.0).unwrap());
                    assert!(near(at, place.pf0, 1.0));
                }
            }
            // All loads, inertia among them, and what the ground exerts.
            let loads = vectors(&drawn(&results, Arrows::Loads, position, true));
            let loads = loads.iter().filter(|(name, _)| name.starts_with('F'));
            let of_ground = ground.iter().map(|name| reactions[*name].1);
            let sum = loads.map(|(_, (_, force))| *force).chain(of_ground).fold([0.0; 2], plus);
            assert!(length(sum) < 1e-9 * most, "{scene} {position}: {sum:?} of {most}");
        }
    }
}

#[test]
fn forces_of_a_transient_motion_are_those_of_its_instants() {
    let results = analyzed("compressor-start");
    let table = &results.found.as_ref().unwrap().analysis.trajectory;
    for instant in [0, 5, 20] {
        let figure = drawn(&results, Arrows::Reactions, instant, true);
        assert!(figure.title.to_string().contains(&format!("instant {instant}, ")), "{}", figure.title);
        let reactions = vectors(&figure);
        let most = reactions.values().map(|(_, force)| length(*force)).fold(0.0, f64::max);
        let schema = table.schema();
        let mut count = 0;
        for (pair, link) in assur_book::catalogue::reactions(schema) {
            let of = Column::vector(Quantity::Force, Owner::PairOn(pair, link));
            let expected = of.map(|column| table.get(instant, column).unwrap());
            let pair = schema.named(Owner::Pair(pair)).unwrap();
            let own = reactions.get(&name("R").below(pair).to_string());
            let drawn = own.map_or([0.0; 2], |(_, force)| *force);
            assert!(near(drawn, expected, most), "{instant} {pair}: {drawn:?}, not {expected:?}");
            count += 1;
        }
        assert_eq!(count, 4);
    }
    // The brake turns against the motion, which is counter-clockwise: f F R = 0.2 * 40 N * 0.1 m, and the disc's inertia with it.
    let brake = drawn(&analyzed("brake"), Arrows::Loads, 5, true);
    let told: Vec<String> = brake.legend.iter().map(|key| key.text.to_string()).collect();
    assert_eq!(told[..2], ["M1 brake 1 on disc  -0.80000 N·m", "M2 inertia of disc  0.80000 N·m"]);
    // The head of the first arc points clockwise: at its end, 270 degrees clockwise from the right, to the right.
    let heads: Vec<_> = brake.panels[0]
        .items
        .iter()
        .filter_map(|item| match item {
            Item::Sign { at, along, sign: Sign::Head, .. } => Some((*at, *along)),
            _ => None,
        })
        .collect();
    assert_eq!(heads.len(), 2);
    for ((at, along), above) in heads.iter().zip([1.0, -1.0]) {
        assert!(at[1] * above > 0.0 && at[0].abs() < 1e-12 && along[0] > along[1].abs(), "{heads:?}");
    }
}

#[test]
fn velocities_are_those_of_the_points_at_instants_too() {
    let results = analyzed("shaper-drive");
    let found = results.found.as_ref().unwrap();
    for arrows in [Arrows::Velocity, Arrows::Acceleration] {
        let figure = drawn(&results, arrows, 7, false);
        let of = if arrows == Arrows::Velocity {
            ("v", Quantity::Velocity)
        } else {
            ("a", Quantity::Acceleration)
        };
        let drawn = vectors(&figure);
        for (id, point) in results.linkage.mechanism.points.iter().enumerate() {
            let columns = Column::vector(of.1, Owner::Point(id));
            let parts = columns.map(|column| found.series.iter().find(|series| series.column == column));
            let [Some(x), Some(y)] = parts else { continue };
            let own = drawn.get(&format!("{}_{}", of.0, point.name));
            // Points of the ground have no arrow.
            let vector = own.map_or([0.0; 2], |(_, vector)| *vector);
            assert!(near(vector, [x.at(7), y.at(7)], 10.0), "{arrows:?} {}: {vector:?}", point.name);
        }
    }
    // At 1.5 s the disc turns at 100 - 2 t rad/s; R is 0.1 m from its center.
    let of_brake = vectors(&drawn(&analyzed("brake"), Arrows::Velocity, 3, true));
    assert!((length(of_brake["v_R"].1) - 9.7).abs() < 1e-9, "{of_brake:?}");
}

#[test]
fn all_positions_have_one_scale_but_for_one_that_is_drawn_alone() {
    let results = analyzed("six-links");
    let scale = |position, alone| match &drawn(&results, Arrows::Reactions, position, alone).panels[0].frame {
        Frame::Plane { scales, .. } => scales[1].size,
        Frame::Axes { .. } => panic!(),
    };
    assert!((scale(0, false) - scale(9, false)).abs() <= 0.0);
    // At the first position the reactions are ten times as great.
    assert!(scale(0, true) > 3.0 * scale(9, true));
    // Alone the longest is seen: at least an eighth of the height of the drawing.
    let figure = drawn(&results, Arrows::Reactions, 9, true);
    let lengths = figure.panels[0].items.iter().filter_map(|item| match item {
        Item::Arrow { from, to, .. } => Some(length(minus(*to, *from))),
        _ => None,
    });
    assert!(lengths.fold(0.0, f64::max) > results.outline.bounds.size()[1] / 8.0);
}

#[test]
fn a_contact_is_drawn_whatever_results_the_scene_asks_for() {
    for arrows in [Arrows::Velocity, Arrows::Loads, Arrows::Reactions] {
        let forces = vectors(&drawn(&analyzed("rolling-press"), arrows, 5, true));
        let [whole, normal, friction] = ["F", "F_c", "F_f"].map(|name| forces[name].1);
        // 20 kN, and a tenth of it across.
        assert!((length(normal) - 20e3).abs() < 1e-6 && (length(friction) - 2e3).abs() < 1e-6);
        assert!(near(whole, plus(normal, friction), 20e3));
    }
}

#[test]
fn a_scene_without_loads_says_so() {
    let none = analyzed("n-four-bar-2");
    let look = |arrows| Look { arrows, ..Look::default() };
    assert!(missing(&none, &look(Arrows::Velocity)).is_none());
    let has = none.found.as_ref().unwrap().plans.calculation().loads.is_some();
    for arrows in [Arrows::Loads, Arrows::Reactions] {
        let why = missing(&none, &look(arrows)).map(|why| why.to_string());
        assert_eq!(why.is_some_and(|why| why.contains("no loads")), !has, "{arrows:?}");
        assert!(missing(&analyzed("shaper-drive"), &look(arrows)).is_none());
    }
}

#[test]
fn the_key_of_arrows_goes_through_loads_and_reactions() {
    let mut state = opened("shaper-drive");
    state.position = 5;
    // The loads of the scene alone, before those with weights, inertia loads and the drive.
    press(&mut state, "v v v");
    let frame = text(&state, 110, 40);
    assert!(frame.contains("F6 cutting  1500.0 N") && !frame.contains("weight of ram"), "{frame}");
    press(&mut state, "v");
    let frame = text(&state, 110, 40);
    for told in ["F6 cutting  1500.0 N", "weight of ram", "M_d moment of the", "| 1000 N", "| 100 mm"] {
        assert!(frame.contains(told), "{told}: {frame}");
    }
    press(&mut state, "v");
    let frame = text(&state, 110, 40);
    for told in ["R_O O on crank  2391.0 N", "R_A A on crank", "R_C"] {
        assert!(frame.contains(told), "{told}: {frame}");
    }
    press(&mut state, "v");
    assert_eq!(state.arrows, Arrows::None);
}
