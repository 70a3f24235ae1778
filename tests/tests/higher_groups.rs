//! Groups above class II in mechanisms: random ones with every check, ends of their ranges, what their kind can't list.

use assur_all as _;
use assur_check::checks;
use assur_group::{Order, groups};
use assur_kinematics::{CompileError, Linkage};
use assur_testkit::specimen::Recipe;

/// Random mechanisms of each kind.
const SEEDS: u64 = 4;

fn compiled(name: &str, text: &str) -> Linkage {
    let mechanism = assur_scene::read(name, text).unwrap_or_else(|error| panic!("{error}"));
    Linkage::compile(mechanism).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn random_mechanisms_of_every_kind_are_solved_in_their_mode() {
    let mut count = 0;
    for plugin in groups().unwrap() {
        let is_higher = plugin.pattern.is_some_and(|pattern| pattern.links > 2);
        for seed in (0..SEEDS).filter(|_| is_higher) {
            let recipe = Recipe { groups: 1, only: Some(plugin.name), loads: true };
            let Some(specimen) = recipe.specimen(seed) else { continue };
            let poses = specimen.poses.clone();
            let linkage = Linkage::compile(specimen.mechanism).unwrap();
            let mut position = linkage.position();
            linkage.solve_index(0, Order::Second, &mut position).unwrap();
            for (body, [x, y, angle]) in position.bodies.iter().zip(poses) {
                let off =
                    (body.x - x).hypot(body.y - y).max((body.c - angle.cos()).hypot(body.s - angle.sin()));
                assert!(off < 1e-10, "{} seed {seed}: another mode, {off:e} away", plugin.name);
            }
            let modes = linkage.modes(linkage.groups().len() - 1, &position).unwrap().unwrap();
            assert!(modes.all.len() <= plugin.ways.most && !modes.all.is_empty());
            for check in checks(&linkage) {
                assert!(
                    check.finding.holds == Some(true),
                    "{} seed {seed}: {} {:e}",
                    plugin.name,
                    check.name,
                    check.finding.error
                );
            }
            count += 1;
        }
    }
    assert!(count > 100, "{count}");
}

#[test]
fn a_range_ends_where_two_modes_meet_and_vanish() {
    let longer = ("A = \"50 mm\", D = [\"-10 mm\", \"60 mm\"]", "A = 0.1, D = [-0.02, 0.12]");
    let linkage = compiled("triad", &assur_fixtures::scene("triad").replace(longer.0, longer.1));
    let range = linkage.range.unwrap();
    assert!(!range.full && range.high - range.low < std::f64::consts::TAU);
    let mut position = linkage.position();
    for (end, inside) in [(range.low, 1.0), (range.high, -1.0)] {
        linkage.solve(end, Order::Place, &mut position).unwrap();
        assert!(position.health[0].abs() < 1e-5, "{}", position.health[0]);
        let mut count = |q: f64| {
            linkage.chain.set_input(q, &mut position.bodies);
            linkage.modes(0, &position).map_or(0, |modes| modes.map_or(0, |modes| modes.all.len()))
        };
        assert_eq!(count(end + inside * 1e-6), count(end - inside * 1e-6) + 2);
        assert!(linkage.solve(end - inside * 1e-6, Order::Place, &mut position).is_err());
    }
}

#[test]
fn a_kind_that_lists_no_modes_asks_for_places() {
    let text = assur_fixtures::scene("six-links");
    let (before, after) = text.split_once("[assembly]").unwrap();
    let (_, after) = after.split_once("[motion]").unwrap();
    // The place of a point of the ground, O, says nothing new.
    for told in ["", "[assembly]\nO = [0, 0]\n"] {
        let mechanism = assur_scene::read("six", &format!("{before}{told}[motion]{after}")).unwrap();
        let error = Linkage::compile(mechanism).unwrap_err();
        let CompileError::NoStart { points, .. } = &error else { panic!("{error}") };
        assert_eq!(points[..], ["P", "S", "U", "W", "V"].map(String::from)[..]);
    }
    let linkage = compiled("six", text);
    let mut position = linkage.position();
    linkage.solve_index(0, Order::Place, &mut position).unwrap();
    assert!(linkage.modes(0, &position).unwrap().is_none());
}

#[test]
fn solving_depends_on_the_coordinate_alone() {
    for name in ["triad", "contour", "six-links"] {
        let linkage = compiled(name, assur_fixtures::scene(name));
        let mut one = linkage.position();
        let mut other = linkage.position();
        for q in [0.3, -0.2, 0.1, 0.3] {
            linkage.solve(q, Order::Second, &mut one).unwrap();
        }
        linkage.solve(0.3, Order::Second, &mut other).unwrap();
        assert_eq!(one.bodies, other.bodies, "{name}");
    }
}

/// An eight-bar whose group of six links has seven inner pins; two of them are reported.
const TWO_PLACES: &str = "
[ground]
points = { P0 = [0.11, -0.32], P1 = [0.12, 0.04] }
[link.crank]
points = { P0 = 0, P6 = [0, 0.07] }
[link.l1]
points = { P2 = [0.01, -0.03], P3 = [-0.2, 0.23] }
[link.l2]
points = { P4 = [-0.03, 0.01], P5 = [-0.21, 0.3] }
[link.l4]
points = { P6 = [-0.02, 0.03], P7 = [-0.21, 0.38], P8 = [-0.12, 0.3] }
[link.l5]
points = { P1 = [0, 0.03], P2 = [-0.29, -0.07], P4 = [0.29, -0.22], P9 = [0.1, -0.14] }
[link.l6]
points = { P7 = [0.01, -0.01], P9 = [0.18, -0.03] }
[link.l7]
points = { P3 = [-0.04, 0.02], P5 = [0, 0.05], P8 = [0.07, 0.16] }
[assembly]
P2 = [-0.12, -0.15]
P3 = [0.13, 0.07]
[input]
link = \"crank\"
from = -1.39
to = -1.38
positions = 2
";

#[test]
fn a_few_places_are_enough_for_the_assembly_that_has_them() {
    let linkage = compiled("eight", TWO_PLACES);
    let mut position = linkage.position();
    linkage.solve_index(0, Order::Place, &mut position).unwrap();
    // By Newton's method on the loops alone, in another program.
    let known = [
        ("P2", [-0.119_943_706_928_997_6, -0.151_120_426_708_322_57]),
        ("P5", [0.161_329_852_789_442_9, 0.031_407_013_067_478_77]),
        ("P9", [0.271_038_956_290_664_2, -0.086_835_459_090_219_84]),
    ];
    for (name, [x, y]) in known {
        let point = linkage.mechanism.points.iter().find(|point| &*point.name == name).unwrap();
        let [u, v] = position.bodies[point.places[0].link].point(point.places[0].at);
        assert!((u - x).hypot(v - y) < 1e-12, "{name}: {u} {v}");
    }
}
