//! Random mechanisms, changed in ways after which the results must change exactly so.

use assur_force::{LoadState, Loads, Reactions, choose};
use assur_group::{Order, Wrench};
use assur_kinematics::Linkage;
use assur_mechanism::{GROUND, Inertia, Link, Mechanism, Motion, Place, Point, Range, Sense};
use assur_testkit::specimen::Recipe;

use assur_number::greater as worst;

mod split;

/// What must change as the mechanism does, over all positions of its scene.
struct Found {
    /// w1, w2 of every moving link.
    turns: Vec<[f64; 2]>,
    /// Forces in every pair, and moments.
    forces: Vec<[f64; 2]>,
    moments: Vec<f64>,
    balancing: Vec<f64>,
    /// Reduced inertia and moment.
    reduced: Vec<[f64; 2]>,
}

fn solve(mechanism: &Mechanism) -> Found {
    let linkage = Linkage::compile(mechanism.clone()).unwrap();
    let loads = Loads::compile(&linkage).unwrap();
    let (mut position, mut out) = (linkage.position(), Reactions::new(&linkage));
    let mut found = Found {
        turns: Vec::new(),
        forces: Vec::new(),
        moments: Vec::new(),
        balancing: Vec::new(),
        reduced: Vec::new(),
    };
    for index in 0..mechanism.input.positions {
        linkage.solve_index(index, Order::Second, &mut position).unwrap();
        let state = LoadState::prescribed(&linkage.mechanism, position.coordinate);
        let mut wrenches = vec![Wrench::ZERO; linkage.structure.links];
        loads.evaluate(&state, &position.bodies, &mut wrenches);
        choose(None, false, false)
            .unwrap()
            .instance
            .solve(&linkage, &position, &mut wrenches, &mut out)
            .unwrap();
        found.turns.extend(position.bodies.iter().skip(1).map(|body| [body.w1, body.w2]));
        found.forces.extend(out.pairs.iter().map(Wrench::force));
        found.moments.extend(out.pairs.iter().map(|pair| pair.m));
        found.balancing.push(out.balancing);
        let reduced = loads.reduced(&state, &position.bodies);
        found.reduced.push([reduced.inertia, reduced.moment]);
    }
    found
}

/// Random mechanisms under their weight, in motion.
fn specimens() -> impl Iterator<Item = Mechanism> {
    (0..40).filter_map(|seed| {
        let recipe = Recipe { groups: 1 + (seed % 4) as usize, only: None, loads: false };
        let mut mechanism = recipe.specimen(seed)?.mechanism;
        mechanism.gravity = Some([1.5, -9.0]);
        mechanism.motion = Some(Motion::Prescribed { speed: 5.0, acceleration: -30.0 });
        Some(mechanism)
    })
}

fn each_place(mechanism: &mut Mechanism, change: impl Fn(usize, [f64; 2]) -> [f64; 2]) {
    for place in mechanism.points.iter_mut().flat_map(|point| &mut point.places) {
        place.at = change(place.link, place.at);
    }
    for slide in &mut mechanism.slides {
        slide.point = change(slide.link, slide.point);
        slide.through = change(slide.on, slide.through);
    }
    for (id, link) in mechanism.links.iter_mut().enumerate() {
        link.center = change(id, link.center);
    }
}

fn turned([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (s, c) = angle.sin_cos();
    [c * x - s * y, s * x + c * y]
}

/// Largest deviation over the largest size.
fn apart(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    differ(a.as_flattened(), b.as_flattened())
}

fn differ(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let size = a.iter().fold(1e-9_f64, |size, x| size.max(x.abs()));
    let largest = a.iter().zip(b).map(|(x, y)| (x - y).abs()).fold(0.0, worst);
    largest / size
}

fn scaled(all: &[[f64; 2]], factor: f64) -> Vec<[f64; 2]> {
    all.iter().map(|pair| pair.map(|x| x * factor)).collect()
}

fn times(all: &[f64], factor: f64) -> Vec<f64> {
    all.iter().map(|x| x * factor).collect()
}

fn pinned(mechanism: &Mechanism) -> bool {
    mechanism.input.is_angle()
}

/// There are enough of them, and every kind of comparison sees a change of a millionth.
#[test]
fn a_small_change_is_seen() {
    let (mut count, mut heavier, mut farther) = (0, 0, 0);
    for mechanism in specimens() {
        let before = solve(&mechanism);
        count += 1;
        let mut heavy = mechanism.clone();
        heavy.links.iter_mut().skip(1).for_each(|link| link.mass *= 1.0 + 1e-6);
        let after = solve(&heavy);
        assert_eq!(before.turns, after.turns);
        heavier += usize::from(
            apart(&before.forces, &after.forces) > 1e-8 && apart(&before.reduced, &after.reduced) > 1e-9,
        );
        let mut far = mechanism.clone();
        each_place(&mut far, |link, at| if link == 1 { at.map(|x| x * (1.0 + 1e-6)) } else { at });
        farther += usize::from(apart(&before.turns, &solve(&far).turns) > 1e-9);
    }
    assert!(count >= 30, "{count} specimens");
    assert!(heavier > count / 2 && farther > count / 2, "{heavier} and {farther} of {count}");
}

/// A power of two rounds nothing: with weights growing as the lengths, turns stay bit for bit, forces grow with the lengths,
/// moments with their squares.
#[test]
fn scaling_by_powers_of_two_is_exact() {
    for mechanism in specimens().filter(pinned) {
        let before = solve(&mechanism);
        // From micrometers to kilometers.
        for power in [-20, 10] {
            let factor = 2.0_f64.powi(power);
            let mut larger = mechanism.clone();
            each_place(&mut larger, |_, at| at.map(|x| x * factor));
            larger.assembly.iter_mut().for_each(|(_, at)| *at = at.map(|x| x * factor));
            larger.gravity = larger.gravity.map(|g| g.map(|x| x * factor));
            larger.links.iter_mut().for_each(|link| link.inertia *= factor * factor);
            let after = solve(&larger);
            let square = factor * factor;
            assert_eq!(before.turns, after.turns);
            assert_eq!(scaled(&before.forces, factor), after.forces);
            assert_eq!(times(&before.moments, square), after.moments);
            assert_eq!(times(&before.balancing, square), after.balancing);
            assert_eq!(scaled(&before.reduced, square), after.reduced);
        }
    }
}

/// Masses from 1e-9 to 1e9: all forces by the same power of two.
#[test]
fn scaling_masses_is_exact() {
    for mechanism in specimens() {
        let before = solve(&mechanism);
        for power in [-30, 30] {
            let factor = 2.0_f64.powi(power);
            let mut heavy = mechanism.clone();
            for link in &mut heavy.links {
                link.mass *= factor;
                link.inertia *= factor;
            }
            let after = solve(&heavy);
            assert_eq!(scaled(&before.forces, factor), after.forces);
            assert_eq!(times(&before.moments, factor), after.moments);
            assert_eq!(times(&before.balancing, factor), after.balancing);
            assert_eq!(scaled(&before.reduced, factor), after.reduced);
        }
    }
}

#[test]
fn turning_and_moving_turns_the_forces() {
    const ANGLE: f64 = 0.8;
    for mechanism in specimens() {
        let before = solve(&mechanism);
        let mut moved = mechanism.clone();
        let shift = |at: [f64; 2]| {
            let [x, y] = turned(at, ANGLE);
            [x + 0.7, y - 0.3]
        };
        each_place(&mut moved, |link, at| if link == GROUND { shift(at) } else { at });
        moved.assembly.iter_mut().for_each(|(_, at)| *at = shift(*at));
        for slide in &mut moved.slides {
            slide.angle += if slide.on == GROUND { ANGLE } else { 0.0 };
            slide.tilt -= if slide.link == GROUND { ANGLE } else { 0.0 };
        }
        moved.gravity = moved.gravity.map(|g| turned(g, ANGLE));
        if pinned(&moved) {
            moved.input.from += ANGLE;
            moved.input.range = match moved.input.range {
                Range::To(to) => Range::To(to + ANGLE),
                cycle @ Range::Cycle(_) => cycle,
            };
        }
        let after = solve(&moved);
        assert!(apart(&before.turns, &after.turns) < 1e-10, "{}", mechanism.title);
        let expected: Vec<_> = before.forces.iter().map(|force| turned(*force, ANGLE)).collect();
        assert!(apart(&expected, &after.forces) < 1e-10);
        assert!(differ(&before.moments, &after.moments) < 1e-9);
        assert!(differ(&before.balancing, &after.balancing) < 1e-9);
        assert!(apart(&before.reduced, &after.reduced) < 1e-9);
    }
}

#[test]
fn mirroring_mirrors() {
    for mechanism in specimens().filter(pinned) {
        let before = solve(&mechanism);
        let mut mirror = mechanism.clone();
        each_place(&mut mirror, |_, [x, y]| [x, -y]);
        mirror.assembly.iter_mut().for_each(|(_, at)| at[1] = -at[1]);
        for slide in &mut mirror.slides {
            (slide.angle, slide.tilt) = (-slide.angle, -slide.tilt);
        }
        mirror.gravity = mirror.gravity.map(|[x, y]| [x, -y]);
        mirror.input.from = -mirror.input.from;
        mirror.motion = Some(Motion::Prescribed { speed: -5.0, acceleration: 30.0 });
        mirror.input.direction = match mirror.input.direction {
            Sense::Ccw => Sense::Cw,
            Sense::Cw => Sense::Ccw,
        };
        if let Range::To(to) = &mut mirror.input.range {
            *to = -*to;
        }
        let after = solve(&mirror);
        // The coordinate is mirrored too: w = d(-phi)/d(-q), e = d²(-phi)/dq².
        let expected: Vec<_> = before.turns.iter().map(|[w, e]| [*w, -e]).collect();
        assert!(apart(&expected, &after.turns) < 1e-10);
        let expected: Vec<_> = before.forces.iter().map(|[x, y]| [*x, -y]).collect();
        assert!(apart(&expected, &after.forces) < 1e-10);
        assert!(differ(&times(&before.moments, -1.0), &after.moments) < 1e-10);
        assert!(differ(&times(&before.balancing, -1.0), &after.balancing) < 1e-10);
        let expected: Vec<_> = before.reduced.iter().map(|[j, q]| [*j, -q]).collect();
        assert!(apart(&expected, &after.reduced) < 1e-10);
    }
}

/// Links in the opposite order, all with other names.
#[test]
fn reordering_and_renaming_links_changes_their_order_only() {
    for mechanism in specimens() {
        let before = solve(&mechanism);
        let count = mechanism.links.len();
        let new = |link: usize| if link == GROUND { GROUND } else { count - link };
        let mut other = mechanism.clone();
        other.links[1..].reverse();
        for (id, link) in other.links.iter_mut().enumerate().skip(1) {
            link.name = format!("other{id}").into();
        }
        let places = other.points.iter_mut().flat_map(|point| &mut point.places);
        places.for_each(|place| place.link = new(place.link));
        for slide in &mut other.slides {
            (slide.link, slide.on) = (new(slide.link), new(slide.on));
        }
        let driver = &mut other.input.drivers[0];
        driver.link = new(driver.link);
        let mut after = solve(&other);
        after.turns.chunks_mut(count - 1).for_each(<[_]>::reverse);
        assert!(apart(&before.turns, &after.turns) < 1e-10);
        assert!(differ(&before.balancing, &after.balancing) < 1e-9);
        assert!(apart(&before.reduced, &after.reduced) < 1e-9);
    }
}

/// Two massless links more on the ground: everything else stays within rounding, and they carry nothing.
#[test]
fn a_massless_group_changes_nothing() {
    for mechanism in specimens() {
        let before = solve(&mechanism);
        let mut more = mechanism.clone();
        let first = more.links.len();
        for name in ["idle1", "idle2"] {
            more.links.push(Link { name: name.into(), mass: 0.0, center: [0.0; 2], inertia: Inertia::NONE });
        }
        let mut pin = |name: &str, a: (usize, [f64; 2]), b: (usize, [f64; 2])| {
            let places = [a, b].map(|(link, at)| Place { link, at }).to_vec();
            more.points.push(Point { name: name.into(), places });
        };
        pin("idleA", (GROUND, [5.0, 5.0]), (first, [0.0, 0.0]));
        pin("idleB", (GROUND, [6.0, 5.0]), (first + 1, [0.0, 0.0]));
        pin("idleC", (first, [0.8, 0.0]), (first + 1, [0.9, 0.0]));
        let after = solve(&more);
        let (mut turns, mut idle) = (Vec::new(), Vec::new());
        for all in after.turns.chunks(first + 1) {
            turns.extend_from_slice(&all[..first - 1]);
            idle.extend_from_slice(&all[first - 1..]);
        }
        assert!(apart(&before.turns, &turns) < 1e-12);
        assert!(differ(&before.balancing, &after.balancing) < 1e-12);
        assert!(apart(&before.reduced, &after.reduced) < 1e-12);
        assert!(idle.iter().flatten().all(|turn| *turn == 0.0));
        // The three pairs of the idle group come last, or first, but carry nothing.
        let pairs = before.forces.len() / before.balancing.len();
        for all in after.forces.chunks(pairs + 3) {
            let idle = |force: &&[f64; 2]| force.iter().all(|x| *x == 0.0);
            assert!(all.iter().filter(idle).count() >= 3);
        }
    }
}
