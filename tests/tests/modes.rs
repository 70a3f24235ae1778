//! Every mode of the groups that list theirs, against an elimination in 32 digits.
#![expect(clippy::unwrap_used, reason = "what a helper of a test lacks is a fault that the test finds")]

#[path = "modes/elimination.rs"]
mod elimination;
#[path = "modes/passing.rs"]
mod passing;

use assur_all as _;
use assur_check::checks;
use assur_group::{Body, GroupFrame, GroupPlugin, Order, Pair, PairGeometry, groups};
use assur_kinematics::{Linkage, Position};
use assur_mechanism::Mechanism;
use assur_testkit::specimen::Recipe;

use elimination::{Pose, poses, ternary};

/// Mechanisms of each kind.
const SEEDS: u64 = 1;

/// Coordinates between the ends of the range at which a mode is compared.
const STEPS: u32 = 16;

/// The end of a range is found to this, in units of the coordinate.
const NEAR_END: f64 = 1e-10;

/// Mechanisms of dyads and groups above class II.
const MIXED: u64 = 12;

fn linkage_of(mechanism: Mechanism) -> Linkage {
    Linkage::compile(mechanism).unwrap_or_else(|error| panic!("{error}"))
}

fn listing() -> Vec<&'static GroupPlugin> {
    let all = groups().unwrap_or_else(|error| panic!("{error}"));
    all.into_iter().filter(|plugin| plugin.pattern.is_some_and(|pattern| pattern.links == 4)).collect()
}

/// Pose of the plate relative to the base.
fn relative(frame: &GroupFrame, of: impl Fn(usize) -> Body<f64>) -> Pose {
    let (base, plate) = ternary(frame);
    let (base, plate) = (base.map_or_else(Body::ground, &of), of(plate));
    let back = |[x, y]: [f64; 2]| [base.c * x + base.s * y, base.c * y - base.s * x];
    [back([plate.x - base.x, plate.y - base.y]), back([plate.c, plate.s])]
}

fn apart(one: &Pose, other: &Pose) -> f64 {
    one.iter().zip(other).map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1])).fold(0.0, f64::max)
}

/// The nearest of the poses, with its distance.
fn nearest(all: &[Pose], to: &Pose) -> (usize, f64) {
    let found = all.iter().map(|pose| apart(pose, to)).enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
    found.unwrap_or((usize::MAX, f64::INFINITY))
}

/// Greatest violation of a pair, m or rad.
fn violation(frame: &GroupFrame, bodies: &[Body<f64>]) -> f64 {
    let of = |pair: &Pair| {
        let (a, b) = (&bodies[pair.a], &bodies[pair.b]);
        match pair.geometry {
            PairGeometry::Pin { at_a, at_b } => {
                let (p, q) = (a.point(at_a), b.point(at_b));
                (p[0] - q[0]).hypot(p[1] - q[1])
            }
            PairGeometry::Slide { point, through, angle, tilt } => {
                let (p, q) = (a.point(point), b.point(through));
                let [tx, ty] = b.turned([angle.cos(), angle.sin()]);
                let x = b.turned([(angle + tilt).cos(), (angle + tilt).sin()]);
                (tx * (p[1] - q[1]) - ty * (p[0] - q[0])).abs().max((x[0] - a.c).hypot(x[1] - a.s))
            }
        }
    };
    frame.pairs().map(of).fold(0.0, f64::max)
}

/// The greatest distance of a joint or an origin of a group, m: what its rounding is measured by.
fn size(frame: &GroupFrame, bodies: &[Body<f64>]) -> f64 {
    let places = frame.pairs().flat_map(Pair::places).map(|(link, at)| bodies[link].point(at));
    let far = places.chain(frame.links.iter().map(|&link| bodies[link].origin())).map(|[x, y]| x.hypot(y));
    far.fold(frame.scale, f64::max)
}

/// The modes of a group in the present position: each satisfies its pairs, they are those of the elimination, in their order.
/// The links of each of them.
fn compared(linkage: &Linkage, group: usize, position: &Position, what: &str) -> Vec<Vec<Body<f64>>> {
    let found = &linkage.structure.groups[group];
    let (frame, plugin) = (&found.frame, found.plugin);
    let all = linkage.modes(group, position).unwrap().unwrap().all;
    let known = poses(frame, &position.bodies, plugin.ways.most);
    assert_eq!(all.len(), known.len(), "{what}: modes");
    let mut taken = vec![false; known.len()];
    let mut bodies = position.bodies.clone();
    let first = frame.links.iter().position(|&link| {
        let (base, plate) = ternary(frame);
        link == plate || Some(link) == base
    });
    let mut angles = Vec::new();
    for mode in &all {
        frame.links.iter().zip(&mode.bodies).for_each(|(&link, body)| bodies[link] = *body);
        let off = violation(frame, &bodies) / size(frame, &bodies);
        assert!(off < 1e-13, "{what}: a pair is open by {off:e} of the size");
        let (which, away) = nearest(&known, &relative(frame, |link| bodies[link]));
        assert!(away < 1e-10 * size(frame, &bodies).max(1.0), "{what}: {away:e} away");
        assert!(!std::mem::replace(&mut taken[which], true), "{what}: one mode twice");
        let body = &mode.bodies[first.unwrap()];
        angles.push(body.s.atan2(body.c));
    }
    let is_given = angles.iter().all(|angle| (angle - angles[0]).abs() < 1e-9);
    assert!(is_given || angles.is_sorted(), "{what}: order {angles:?}");
    all.into_iter().map(|mode| mode.bodies).collect()
}

/// The mechanism with the places of a group's own points in a mode in `[assembly]`, to three digits of their distance from the
/// nearest other one.
fn assembled(linkage: &Linkage, group: usize, mode: &[Body<f64>], near: f64) -> Mechanism {
    let frame = &linkage.structure.groups[group].frame;
    let mut mechanism = linkage.mechanism.clone();
    let own = |place: &assur_mechanism::Place| Some((frame.column(place.link)?, place.at));
    let placed = mechanism.points.iter().enumerate().filter_map(|(id, point)| {
        let inside: Vec<_> = point.places.iter().map(own).collect::<Option<_>>()?;
        let (column, at) = inside[0];
        Some((id, mode[column].point(at).map(|part| (part / near).round() * near)))
    });
    mechanism.assembly = placed.collect();
    mechanism
}

/// Follows a mode over the range of the scene beside the elimination: it stays on the same root, and the places are its.
fn followed(linkage: &Linkage, group: usize, what: &str) -> usize {
    let found = &linkage.structure.groups[group];
    let (frame, input) = (&found.frame, &linkage.mechanism.input);
    let end = input.coordinate(input.positions - 1);
    let mut position = linkage.position();
    let mut before: Option<Pose> = None;
    let mut count = 0;
    for step in 0..=STEPS {
        let q = input.from + (end - input.from) * f64::from(step) / f64::from(STEPS);
        if let Err(error) = linkage.solve(q, Order::Second, &mut position) {
            let (end, _) = linkage.barrier(q).unwrap_or_else(|| panic!("{what}: {error}"));
            let mut roots = |q: f64| {
                linkage.chain.set_input(q, &mut position.bodies);
                poses(frame, &position.bodies, found.plugin.ways.most).len()
            };
            let beside = NEAR_END * linkage.coordinate_unit() * (q - end).signum();
            assert_eq!(roots(end - beside), roots(end + beside) + 2, "{what}: the end at {end}");
            break;
        }
        let known = poses(frame, &position.bodies, found.plugin.ways.most);
        let here = relative(frame, |link| position.bodies[link]);
        let (_, away) = nearest(&known, &here);
        let lost = position.health[group].abs();
        let limit = 1e-10_f64.max(1e-14 / lost) * size(frame, &position.bodies).max(1.0);
        assert!(away < limit, "{what}: {away:e} away at {q}, determinant {lost:e}");
        let change = before.map_or(0.0, |before| apart(&before, &here));
        let scale = size(frame, &position.bodies).max(1.0);
        // Near a place where modes meet the motion is fast, and no jump can be told from it by the distance alone.
        assert!(change < 1.5 * scale || lost < 0.1, "{what}: jumps by {change} at {q}");
        before = Some(here);
        count += 1;
    }
    count
}

#[test]
fn every_kind_has_the_modes_of_the_elimination_and_reaches_each_by_its_places() {
    let (mut modes_seen, mut positions) = (0, 0);
    for plugin in listing() {
        for seed in 0..SEEDS {
            let recipe = Recipe { groups: 1, only: Some(plugin.name), loads: false };
            let Some(specimen) = recipe.specimen(1000 + seed) else { continue };
            let what = format!("{} seed {seed}", plugin.name);
            let linkage = linkage_of(specimen.mechanism);
            let mut position = linkage.position();
            linkage.solve_index(0, Order::Place, &mut position).unwrap();
            let all = compared(&linkage, 0, &position, &what);
            for (number, mode) in all.iter().enumerate() {
                let distance = |other: &Vec<Body<f64>>| {
                    let off = |(a, b): (&Body<f64>, &Body<f64>)| (a.x - b.x).hypot(a.y - b.y);
                    mode.iter().zip(other).map(off).fold(0.0, f64::max)
                };
                let others = all.iter().enumerate().filter(|(other, _)| *other != number);
                let gap = others.map(|(_, other)| distance(other)).fold(linkage.structure.scale, f64::min);
                let one = linkage_of(assembled(&linkage, 0, mode, 1e-3 * gap));
                let mut there = one.position();
                one.solve_index(0, Order::Place, &mut there).unwrap();
                for (&link, body) in one.structure.groups[0].frame.links.iter().zip(mode) {
                    let off = (there.bodies[link].x - body.x).hypot(there.bodies[link].y - body.y);
                    assert!(off < 1e-10, "{what}: mode {number} is missed by {off:e}");
                }
                let modes = one.modes(0, &there).unwrap().unwrap();
                assert_eq!(modes.number(modes.present), number, "{what}");
                positions += followed(&one, 0, &format!("{what} mode {number}"));
                modes_seen += 1;
            }
        }
    }
    assert!(modes_seen > 60 && positions > 800, "{modes_seen} modes, {positions} positions");
}

#[test]
fn mechanisms_of_all_classes_are_solved_in_every_group() {
    let many = std::env::var("ASSUR_MANY").ok().and_then(|many| many.parse().ok());
    let (mut higher, mut failed) = (0, Vec::new());
    for seed in 0..many.unwrap_or(MIXED) {
        let recipe = Recipe { groups: 2 + (seed % 3) as usize, only: None, loads: true };
        let Some(specimen) = recipe.mixed(seed) else { continue };
        let linkage = linkage_of(specimen.mechanism);
        let mut position = linkage.position();
        let input = linkage.mechanism.input.clone();
        for index in [0, input.positions / 2, input.positions - 1] {
            linkage.solve(input.coordinate(index), Order::Second, &mut position).unwrap();
            for (group, found) in linkage.structure.groups.iter().enumerate() {
                let what = format!("seed {seed}, group {group} ({}), position {index}", found.plugin.name);
                let off = violation(&found.frame, &position.bodies) / size(&found.frame, &position.bodies);
                assert!(off < 1e-13, "{what}: a pair is open by {off:e} of the size");
                if found.frame.links.len() == 4 {
                    compared(&linkage, group, &position, &what);
                    higher += 1;
                }
            }
        }
        failed.extend(checks(&linkage).iter().filter(|check| check.finding.holds != Some(true)).map(
            |check| {
                format!("seed {seed}: {} {:e} of {:e}", check.name, check.finding.error, check.finding.bound)
            },
        ));
    }
    assert!(failed.is_empty(), "{failed:#?}");
    assert!(higher > MIXED, "{higher}");
}
