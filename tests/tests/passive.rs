//! Passive links and pairs against closed forms and an assembly of all equations of equilibrium.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use std::f64::consts::{PI, TAU};

use assur_all as _;
use assur_analysis::results::Analysis;
use assur_analysis::{Calculation, Options, unwatched};
use assur_check::Coverage;
use assur_group::Order;
use assur_kinematics::{Linkage, decompose};
use nalgebra::{DMatrix, DVector};
use serde_json::Value;

/// Radius of the cranks, speed, gravity.
const R: f64 = 0.1;
const SPEED: f64 = 20.0;
const G: f64 = 9.81;
/// The pins of the cranks on the ground; those on the coupler lie alike.
const PIVOTS: [[f64; 2]; 3] = [[0.0, 0.0], [0.3, 0.0], [0.15, 0.1]];

/// A parallelogram with three cranks, which no line holds.
const CRANKS: &str = r#"
gravity = 9.81
[ground]
points = { O1 = [0, 0], O2 = [0.3, 0], O3 = [0.15, 0.1] }
[link.crank]
points = { O1 = 0, A = 0.1 }
[link.coupler]
points = { A = [0, 0], B = [0.3, 0], C = [0.15, 0.1] }
mass = 3
center = [0.12, 0.03]
inertia = 0.02
[link.crank2]
points = { O2 = 0, B = 0.1 }
[link.crank3]
points = { O3 = 0, C = 0.1 }
mass = 2
center = [0.05, 0]
inertia = 0.001
[assembly]
B = [0.398, 0.017]
[input]
link = "crank"
from = "10 deg"
[motion]
speed = 20
"#;

/// A slider-crank whose slider has two guides on one line.
const TWO_GUIDES: &str = r#"
gravity = 9.81
[ground]
points = { O = [0, 0] }
[link.crank]
points = { O = 0, A = 0.1 }
[link.rod]
points = { A = 0, B = 0.35 }
mass = 2
center = [0.1, 0]
[link.ram]
points = { B = 0, K = 0.2 }
mass = 5
center = [0.08, 0]
[assembly]
B = [0.45, 0.02]
[[slide]]
link = "ram"
on = "ground"
through = [0, 0.02]
point = "B"
name = "front"
[[slide]]
link = "ram"
on = "ground"
through = [0, 0.02]
point = "K"
name = "rear"
[input]
link = "crank"
from = "5 deg"
[motion]
speed = 10
"#;

fn analyzed(scene: &str, least_norm: bool) -> (Analysis, Value) {
    let mechanism = assur_scene::read("scene", scene).unwrap_or_else(|error| panic!("{error}"));
    let options = Options { least_norm, ..Options::default() };
    let study =
        Calculation::of(mechanism, &options, &mut unwatched).unwrap_or_else(|error| panic!("{error}"));
    let mut analysis = study.analyze(&mut unwatched).unwrap();
    analysis.add_checks(study.checks(Coverage::All, &mut unwatched).unwrap());
    let json = assur_report::json::analysis::to_json(&analysis, false).unwrap();
    (analysis, serde_json::from_str(&json).unwrap())
}

fn compiled(scene: &str) -> Linkage {
    let mechanism = assur_scene::read("scene", scene).unwrap_or_else(|error| panic!("{error}"));
    Linkage::compile(mechanism).unwrap_or_else(|error| panic!("{error}"))
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("no number: {value}"))
}

fn all_checks_hold(analysis: &Analysis) {
    assert!(!analysis.checks.is_empty());
    for check in &analysis.checks {
        assert!(
            check.finding.holds == Some(true),
            "{} {:e} > {:e}",
            check.name,
            check.finding.error,
            check.finding.bound
        );
    }
}

/// Equilibrium of the crank, the coupler and both other cranks: twelve equations for the forces of six pins on the links that
/// stand later in the scene (of a pivot, on the crank) and the driving moment, divided by the size; the right sides.
fn equations(q: f64, size: f64) -> (DMatrix<f64>, DVector<f64>) {
    let e = [q.cos(), q.sin()];
    let (mut a, mut b) = (DMatrix::zeros(12, 13), DVector::zeros(12));
    // Rows of link k: 3 k; moments about the pivot of a crank, of the coupler about its origin, divided by the size.
    let mut add = |row: usize, column: usize, arm: [f64; 2], sign: f64| {
        for axis in 0..2 {
            a[(row + axis, column + axis)] += sign;
            let turn = if axis == 0 { -arm[1] } else { arm[0] };
            a[(row + 2, column + axis)] += sign * turn / size;
        }
    };
    let tip = [R * e[0], R * e[1]];
    let rows = [0, 6, 9];
    for k in 0..3 {
        add(rows[k], 4 * k, [0.0, 0.0], 1.0);
        // The pin on the coupler: its force on the coupler for the first crank, on the crank for the others.
        let sign = if k == 0 { 1.0 } else { -1.0 };
        add(3, 4 * k + 2, PIVOTS[k], sign);
        add(rows[k], 4 * k + 2, tip, -sign);
    }
    a[(2, 12)] = 1.0;
    let central = -SPEED * SPEED;
    let mut load = |row: usize, mass: f64, arm: [f64; 2], acceleration: [f64; 2]| {
        let force = [-mass * acceleration[0], -mass * acceleration[1] - mass * G];
        b[row] -= force[0];
        b[row + 1] -= force[1];
        b[row + 2] -= (arm[0] * force[1] - arm[1] * force[0]) / size;
    };
    load(3, 3.0, [0.12, 0.03], [central * tip[0], central * tip[1]]);
    load(9, 2.0, [0.05 * e[0], 0.05 * e[1]], [central * 0.05 * e[0], central * 0.05 * e[1]]);
    (a, b)
}

#[test]
fn the_last_of_three_cranks_is_passive_and_turns_as_the_others() {
    // Also 5 degrees before all links lie in line, where rounding is magnified in every link, the passive one too.
    let (analysis, json) = analyzed(&CRANKS.replace("[motion]", "positions = 24\n[motion]"), false);
    let passive = &analysis.structure.passive;
    assert_eq!(passive.len(), 1);
    assert_eq!((passive[0].what.to_string().as_str(), passive[0].fits()), ("link crank3", true));
    assert!(passive[0].misfit < 1e-14, "{:e}", passive[0].misfit);
    assert_eq!((analysis.structure.mobility, analysis.structure.mobility_by_rank), (0, Some(1)));
    for position in json["positions"].as_array().unwrap() {
        let q = number(&position["coordinate"]);
        let turn = (number(&position["links"]["crank3"]["pf0"]) - q) / TAU;
        assert!((turn - turn.round()).abs() < 1e-14, "{turn}");
        for (order, [x, y]) in
            [[q.cos(), q.sin()], [-q.sin(), q.cos()], [-q.cos(), -q.sin()]].iter().enumerate()
        {
            let at = &position["points"]["C"][format!("pf{order}")];
            let center = if order == 0 { PIVOTS[2] } else { [0.0; 2] };
            assert!((number(&at[0]) - center[0] - R * x).abs() < 1e-13);
            assert!((number(&at[1]) - center[1] - R * y).abs() < 1e-13);
        }
    }
    all_checks_hold(&analysis);
}

#[test]
fn undetermined_reactions_are_null_and_those_of_least_norm_come_from_a_pseudo_inverse() {
    let (plain, nulls) = analyzed(CRANKS, false);
    let (least, json) = analyzed(CRANKS, true);
    all_checks_hold(&least);
    assert_eq!(plain.positions.len(), 12);
    // The greatest distance between two joints of one link or of the ground.
    let size = 0.3;
    for (k, position) in json["positions"].as_array().unwrap().iter().enumerate() {
        let (a, b) = equations(number(&position["coordinate"]), size);
        let x = a.clone().pseudo_inverse(1e-10).unwrap() * &b;
        assert!((&a * &x - &b).norm() < 1e-10 * b.norm());
        let reactions = &position["reactions"];
        let wanted = [
            ("O1", "crank"),
            ("A", "coupler"),
            ("O2", "crank2"),
            ("B", "crank2"),
            ("O3", "crank3"),
            ("C", "crank3"),
        ];
        for (column, (pin, link)) in wanted.into_iter().enumerate() {
            for axis in 0..2 {
                let found = number(&reactions[pin][link][axis]);
                assert!((found - x[2 * column + axis]).abs() < 1e-9 * b.norm(), "{pin} {link}: {found}");
            }
            assert_eq!(nulls["positions"][k]["reactions"][pin][link], Value::Null);
        }
        // The moment is determined, least norm or not: no motion of the loads' powers depends on the stress inside.
        let balancing = number(&position["balancing"]);
        assert!((balancing - x[12] * size).abs() < 1e-10);
        assert!((balancing - number(&nulls["positions"][k]["balancing"])).abs() < 1e-12);
    }
}

#[test]
fn without_places_the_groups_are_assembled_as_the_passive_link_needs_them() {
    let bare = CRANKS.replace("[assembly]\nB = [0.398, 0.017]\n", "");
    for from in [40, 130, 220, 310] {
        let linkage = compiled(&bare.replace("\"10 deg\"", &format!("\"{from} deg\"")));
        let mut position = linkage.position();
        linkage.solve_index(0, Order::Place, &mut position).unwrap();
        let coupler = &position.bodies[2];
        assert!(coupler.s.abs() < 1e-14 && coupler.c > 0.0, "{from}: the coupler keeps its direction");
        assert!(linkage.misfits[0].misfit < 1e-14, "{from}: {:?}", linkage.misfits);
    }
}

/// Three wheels coupled by one rod. At 0 and at 180 degrees all pins lie on one line, a change point in which no place of a point tells
/// wheels that turn alike from wheels that turn against each other; with the latter none is passive.
#[test]
fn wheels_that_begin_in_a_change_point_turn_alike() {
    let wheels = "[ground]\npoints = { O1 = 0, O2 = 1.5, O3 = 3 }\n[link.wheel1]\npoints = { O1 = 0, A = 0.3 }\n\
        [link.wheel2]\npoints = { O2 = 0, B = 0.3 }\n[link.wheel3]\npoints = { O3 = 0, C = 0.3 }\n\
        [link.rod]\npoints = { A = 0, B = 1.5, C = 3 }\n[input]\nlink = \"wheel1\"\npositions = 12\n";
    let ends = [
        "",
        "[assembly]\nB = [1.8, 0]\n",
        "from = \"180 deg\"\n",
        "from = \"180 deg\"\ndirection = \"cw\"\n",
    ];
    for end in ends {
        let linkage = compiled(&format!("{wheels}{end}"));
        assert!(linkage.misfits[0].misfit < 1e-12, "{end}: {:?}", linkage.misfits);
        let mut position = linkage.position();
        for index in 0..12 {
            linkage.solve_index(index, Order::Second, &mut position).unwrap();
            let speeds = [1, 2, 3, 4].map(|link: usize| position.bodies[link].w1);
            let off = speeds.iter().zip([1.0, 1.0, 1.0, 0.0]).map(|(w1, wanted)| (w1 - wanted).abs());
            assert!(off.fold(0.0, f64::max) < 1e-9, "{end}: {speeds:?} in position {index}");
        }
    }
}

#[test]
fn a_crank_of_another_length_misses_by_the_difference_and_its_length_closes() {
    let linkage = compiled(&CRANKS.replace("O3 = 0, C = 0.1 ", "O3 = 0, C = 0.103 "));
    let [found] = &linkage.misfits[..] else { panic!("{:?}", linkage.misfits) };
    assert!((found.misfit - 0.003).abs() < 1e-14 && !found.fits(), "{found:?}");
    let closing = found.closes.as_ref().unwrap();
    assert!((closing.value - 0.1).abs() < 1e-12, "{closing:?}");
    let (analysis, json) = analyzed(&CRANKS.replace("O3 = 0, C = 0.1 ", "O3 = 0, C = 0.103 "), false);
    assert!(!analysis.structure.passive[0].fits());
    assert_eq!(json["structure"]["passive"][0]["closes"]["key"], "link.crank3.points.C");
}

#[test]
fn a_pivot_beside_its_place_misses_most_where_the_cranks_point_away_from_it() {
    // | |r e(q) + (d, 0)| - r | is greatest where e(q) lies along the shift: d.
    let (dx, dy) = (0.002, 0.0015);
    let shifted = CRANKS.replace("O3 = [0.15, 0.1]", "O3 = [0.152, 0.1015]");
    let linkage = compiled(&shifted);
    let [found] = &linkage.misfits[..] else { panic!("{:?}", linkage.misfits) };
    assert!((found.misfit - f64::hypot(dx, dy)).abs() < 1e-9, "{found:?}");
    let off = (found.at - f64::atan2(dy, dx)) / PI;
    assert!((off - off.round()).abs() < 1e-5, "{off}");
    // Both coordinates are wrong: no number alone closes.
    assert_eq!(found.closes, None);
}

#[test]
fn cranks_of_general_lengths_are_no_mechanism_and_the_message_says_by_how_much() {
    let general = CRANKS.replace("O2 = 0, B = 0.1 ", "O2 = 0, B = 0.13 ").replace("C = 0.1 ", "C = 0.17 ");
    let mechanism = assur_scene::read("scene", &general).unwrap();
    let message = decompose(&mechanism).unwrap_err().to_string();
    assert!(message.starts_with("mobility 0 (3*4 - 2*6), must be 1"), "{message}");
    assert!(message.contains("deviates by") && message.contains("mm over the cycle"), "{message}");
}

#[test]
fn a_second_guide_is_passive_and_shares_force_and_moment_with_the_first() {
    let (analysis, json) = analyzed(TWO_GUIDES, true);
    all_checks_hold(&analysis);
    assert_eq!(analysis.structure.passive[0].what.to_string(), "pair rear of ram");
    assert_eq!((analysis.structure.mobility, analysis.structure.mobility_by_rank), (-1, Some(1)));
    let (_, nulls) = analyzed(TWO_GUIDES, false);
    let alone = TWO_GUIDES.replace(&TWO_GUIDES[TWO_GUIDES.rfind("[[slide]]").unwrap()..], "");
    let alone = alone + "[input]\nlink = \"crank\"\nfrom = \"5 deg\"\n[motion]\nspeed = 10\n";
    let (_, single) = analyzed(&alone, false);
    // The greatest distance between two joints of one link: the rod.
    let size = 0.35;
    for k in 0..12 {
        let [found, null, one] = [&json, &nulls, &single].map(|json| &json["positions"][k]["reactions"]);
        for pair in ["front", "rear"] {
            assert_eq!(null[pair]["ram"], Value::Null);
            assert_eq!(null[pair]["moment"], Value::Null);
        }
        // What one guide carries alone about B: force n and moment m, here shared by forces f1, f2 0.2 m apart and moments m1, m2.
        let (n, m) = (number(&one["front"]["ram"][1]), number(&one["front"]["moment"]));
        let a = DMatrix::from_row_slice(2, 4, &[1.0, 1.0, 0.0, 0.0, 0.0, 0.2 / size, 1.0, 1.0]);
        let x = a.pseudo_inverse(1e-12).unwrap() * DVector::from_row_slice(&[n, m / size]);
        let got = [
            number(&found["front"]["ram"][1]),
            number(&found["rear"]["ram"][1]),
            number(&found["front"]["moment"]) / size,
            number(&found["rear"]["moment"]) / size,
        ];
        for (got, wanted) in got.iter().zip(x.iter()) {
            assert!((got - wanted).abs() < 1e-10, "{got} {wanted}");
        }
        for pin in ["O", "A", "B"] {
            for (link, force) in one[pin].as_object().unwrap() {
                for axis in 0..2 {
                    assert!((number(&null[pin][link][axis]) - number(&force[axis])).abs() < 1e-10);
                }
            }
        }
    }
}

#[test]
fn several_passive_links_are_left_out_one_after_another() {
    let more = 4..9;
    let at = |k: i32| format!("[{}, {}]", 0.05 * f64::from(k), 0.02 * f64::from(k * k % 7));
    let points =
        |name: &str| more.clone().map(|k| format!(", {name}{k} = {}", at(k))).collect::<Vec<_>>().concat();
    let link = |k: i32| format!("[link.crank{k}]\npoints = {{ O{k} = 0, C{k} = 0.1 }}\n");
    let scene = CRANKS
        .replace("O3 = [0.15, 0.1]", &format!("O3 = [0.15, 0.1]{}", points("O")))
        .replace("C = [0.15, 0.1]", &format!("C = [0.15, 0.1]{}", points("C")))
        .replace("[assembly]", &(more.clone().map(link).collect::<Vec<_>>().concat() + "[assembly]"));
    let (analysis, _) = analyzed(&scene, false);
    let named: Vec<String> =
        analysis.structure.passive.iter().map(|passive| passive.what.to_string()).collect();
    assert_eq!(
        named,
        ["crank8", "crank7", "crank6", "crank5", "crank4", "crank3"].map(|link| format!("link {link}"))
    );
    assert!(analysis.structure.passive.iter().all(|passive| passive.misfit < 1e-14));
    all_checks_hold(&analysis);
}

#[test]
fn a_doubled_coupler_of_random_four_bars_moves_as_the_coupler_and_loads_the_rest_alike() {
    for seed in 0..12_u32 {
        let spread = |k: u32, low: f64, high: f64| {
            let part = f64::from((seed * 7919 + k * 104_729 + 13) % 9973) / 9973.0;
            low + part * (high - low)
        };
        // Grashof: the crank is far the shortest.
        let [crank, coupler, rocker, base] =
            [spread(1, 0.05, 0.1), spread(2, 0.3, 0.34), spread(3, 0.28, 0.34), spread(4, 0.3, 0.36)];
        let scene = |second: &str, mass: f64| {
            format!(
                "gravity = 9.81\n[ground]\npoints = {{ O = [0, 0], D = [{base}, 0] }}\n\
                 [link.crank]\npoints = {{ O = 0, A = {crank} }}\n\
                 [link.coupler]\npoints = {{ A = 0, B = {coupler} }}\nmass = {mass}\ncenter = [0.1, 0.01]\ninertia = 0.01\n\
                 [link.rocker]\npoints = {{ D = 0, B = {rocker} }}\nmass = 1\ncenter = [0.1, 0]\n{second}\
                 [assembly]\nB = [{base}, 0.3]\n[input]\nlink = \"crank\"\nfrom = 0.1\n[motion]\nspeed = 10\n"
            )
        };
        let second = format!(
            "[link.second]\npoints = {{ A = 0, B = {coupler} }}\nmass = 2\ncenter = [0.1, 0.01]\ninertia = 0.01\n"
        );
        let (doubled, json) = analyzed(&scene(&second, 2.0), false);
        all_checks_hold(&doubled);
        assert_eq!(doubled.structure.passive[0].what.to_string(), "link second");
        // The same body of twice the mass; its moment of inertia too.
        let (_, single) = analyzed(&scene("", 4.0).replace("inertia = 0.01", "inertia = 0.02"), false);
        for k in 0..12 {
            let [two, one] = [&json, &single].map(|json| &json["positions"][k]);
            for order in ["pf0", "pf1", "pf2"] {
                assert_eq!(two["links"]["coupler"][order], one["links"]["coupler"][order]);
                let [a, b] = ["second", "coupler"].map(|link| number(&two["links"][link][order]));
                assert!((a - b).abs() < 1e-12 * b.abs().max(1.0), "{order}: {a} {b}");
            }
            let same = |path: [&str; 2]| {
                let [two, one] = [two, one].map(|position| &position["reactions"][path[0]][path[1]]);
                (0..2).all(|axis| (number(&two[axis]) - number(&one[axis])).abs() < 1e-9)
            };
            assert!(
                same(["O", "crank"])
                    && same(["D", "rocker"])
                    && same(["A", "crank"])
                    && same(["B", "rocker"])
            );
            assert_eq!(two["reactions"]["A"]["second"], Value::Null);
            assert!((number(&two["balancing"]) - number(&one["balancing"])).abs() < 1e-9);
        }
    }
}

#[test]
fn a_stretched_parallelogram_has_no_passive_link() {
    // Flat in its first position, where the rank is smaller; elsewhere nothing repeats.
    let flat = CRANKS.replace(
        "[link.crank3]\npoints = { O3 = 0, C = 0.1 }\n",
        "[link.crank3]\npoints = { C = 0, Z = 0.1 }\n",
    );
    let mechanism = assur_scene::read("scene", &flat.replace("from = \"10 deg\"", "from = 0")).unwrap();
    assert!(decompose(&mechanism).is_err(), "a loose link is no passive one");
    let linkage = compiled(&CRANKS.replace("from = \"10 deg\"", "from = 0"));
    let mut position = linkage.position();
    linkage.solve(0.0, Order::Second, &mut position).unwrap();
    assert_eq!(assur_kinematics::mobility_in(&linkage, &position), 1, "the third crank holds the flat ones");
}
