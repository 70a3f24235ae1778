//! Random mechanisms, changed in ways after which the results must change exactly so.

use assur_all as _;
use assur_force::{Loads, Reactions, State, find};
use assur_group::{Order, Wrench};
use assur_kinematics::Linkage;
use assur_mechanism::{GROUND, InputPair, Link, Mechanism, Place, Point, Range};
use assur_specimen::Recipe;

/// w1, w2 of every moving link, and the forces in every pair of the groups, at the first position.
struct Found {
    turns: Vec<[f64; 2]>,
    forces: Vec<[f64; 2]>,
    balancing: f64,
}

fn solve(mechanism: &Mechanism) -> Found {
    let linkage = Linkage::compile(mechanism.clone()).unwrap();
    let mut position = linkage.position();
    linkage.solve_index(0, Order::Second, &mut position).unwrap();
    let loads = Loads::compile(&linkage).unwrap();
    let state = State::prescribed(&linkage.mechanism, position.coordinate);
    let mut wrenches = vec![Wrench::ZERO; linkage.structure.links];
    loads.apply(&state, &position.bodies, &mut wrenches);
    let mut out = Reactions::new(&linkage);
    find("groups").unwrap().instance.solve(&linkage, &position, &mut wrenches, &mut out).unwrap();
    Found {
        turns: position.bodies.iter().skip(1).map(|body| [body.w1, body.w2]).collect(),
        forces: out.pairs.iter().map(Wrench::force).collect(),
        balancing: out.balancing,
    }
}

/// Random mechanisms under their weight.
fn specimens() -> impl Iterator<Item = Mechanism> {
    (0..40).filter_map(|seed| {
        let recipe = Recipe { groups: 1 + (seed % 4) as usize, only: None, loads: false };
        let mut mechanism = recipe.specimen(seed)?.mechanism;
        mechanism.gravity = Some([1.5, -9.0]);
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
    assert_eq!(a.len(), b.len());
    let size = a.iter().flatten().fold(1e-9_f64, |size, x| size.max(x.abs()));
    a.iter().flatten().zip(b.iter().flatten()).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max) / size
}

fn pinned(mechanism: &Mechanism) -> bool {
    matches!(mechanism.input.pair, InputPair::Pin(_))
}

/// A power of two rounds nothing: turns and forces stay bit for bit, moments grow with the lengths.
#[test]
fn scaling_by_powers_of_two_is_exact() {
    for mechanism in specimens().filter(pinned) {
        let before = solve(&mechanism);
        // From micrometers to kilometers.
        for power in [-20, 10] {
            let factor = 2.0_f64.powi(power);
            let mut scaled = mechanism.clone();
            each_place(&mut scaled, |_, at| at.map(|x| x * factor));
            scaled.assembly.iter_mut().for_each(|(_, at)| *at = at.map(|x| x * factor));
            let after = solve(&scaled);
            assert_eq!(before.turns, after.turns);
            assert_eq!(before.forces, after.forces);
            assert_eq!((before.balancing * factor).to_bits(), after.balancing.to_bits());
        }
    }
}

/// Masses from 1e-9 to 1e9: forces by the same power of two.
#[test]
fn scaling_masses_is_exact() {
    for mechanism in specimens() {
        let before = solve(&mechanism);
        for power in [-30, 30] {
            let factor = 2.0_f64.powi(power);
            let mut heavy = mechanism.clone();
            heavy.links.iter_mut().for_each(|link| link.mass *= factor);
            let after = solve(&heavy);
            let expected: Vec<_> = before.forces.iter().map(|force| force.map(|f| f * factor)).collect();
            assert_eq!(expected, after.forces);
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
        if let Range::To(to) = &mut mirror.input.range {
            *to = -*to;
        }
        let after = solve(&mirror);
        // The coordinate is mirrored too: w = d(-phi)/d(-q), e = d²(-phi)/dq².
        let expected: Vec<_> = before.turns.iter().map(|[w, e]| [*w, -e]).collect();
        assert!(apart(&expected, &after.turns) < 1e-10);
        let expected: Vec<_> = before.forces.iter().map(|[x, y]| [*x, -y]).collect();
        assert!(apart(&expected, &after.forces) < 1e-10);
        assert!((before.balancing + after.balancing).abs() <= 1e-10 * before.balancing.abs().max(1e-3));
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
            link.name = format!("other{id}");
        }
        let places = other.points.iter_mut().flat_map(|point| &mut point.places);
        places.for_each(|place| place.link = new(place.link));
        for slide in &mut other.slides {
            (slide.link, slide.on) = (new(slide.link), new(slide.on));
        }
        other.input.link = new(other.input.link);
        let mut after = solve(&other);
        after.turns.reverse();
        assert!(apart(&before.turns, &after.turns) < 1e-10);
        let near = (before.balancing - after.balancing).abs();
        assert!(near <= 1e-9 * before.balancing.abs().max(1e-2), "{near}");
    }
}

/// Two massless links more on the ground: everything else stays bit for bit, and they carry nothing.
#[test]
fn a_massless_group_changes_nothing() {
    for mechanism in specimens() {
        let before = solve(&mechanism);
        let mut more = mechanism.clone();
        let first = more.links.len();
        for name in ["idle1", "idle2"] {
            more.links.push(Link { name: name.to_owned(), mass: 0.0, center: [0.0; 2], inertia: 0.0 });
        }
        let mut pin = |name: &str, a: (usize, [f64; 2]), b: (usize, [f64; 2])| {
            let places = [a, b].map(|(link, at)| Place { link, at }).to_vec();
            more.points.push(Point { name: name.to_owned(), places });
        };
        pin("idleA", (GROUND, [5.0, 5.0]), (first, [0.0, 0.0]));
        pin("idleB", (GROUND, [6.0, 5.0]), (first + 1, [0.0, 0.0]));
        pin("idleC", (first, [0.8, 0.0]), (first + 1, [0.9, 0.0]));
        let after = solve(&more);
        let links = before.turns.len();
        assert!(apart(&before.turns, &after.turns[..links]) < 1e-12);
        assert!((before.balancing - after.balancing).abs() <= 1e-12 * before.balancing.abs().max(1e-3));
        assert!(after.turns[links..].iter().flatten().all(|turn| *turn == 0.0));
    }
}
