//! Random mechanisms with changed lengths, at random coordinates and ever closer to where they end: whatever is asked, the
//! answer is finite, closed and in the branch that the motion leads to; or it says what fails, where, and by how much.

use assur_force::Reactions;
use assur_group::{Body, Order, PairGeometry, plane};
use assur_kinematics::{Linkage, Position};
use assur_mechanism::Mechanism;
use assur_testkit::specimen::{Recipe, Rng};

use super::{differences, healthiest, scales, studied, told, turns, walk_group};
use crate::stability::walk::{Walk, analyzers_of, test_loads};

/// Mechanisms with one point moved, by up to half of the size; many no longer turn fully.
fn changed(seed: u64) -> Option<Mechanism> {
    let recipe = Recipe { groups: 1 + (seed % 3) as usize, only: None, loads: false };
    let mut mechanism = recipe.specimen(seed)?.mechanism;
    let mut rng = Rng::new(seed);
    let point = rng.below(mechanism.points.len());
    let shift = [rng.signed(0.0, 0.5), rng.signed(0.0, 0.5)];
    let place = mechanism.points[point].places.last_mut()?;
    place.at = [place.at[0] + shift[0], place.at[1] + shift[1]];
    Some(mechanism)
}

fn finite(body: &Body<f64>) -> bool {
    let Body { x, y, c, s, x1, y1, w1, x2, y2, w2 } = *body;
    [x, y, c, s, x1, y1, w1, x2, y2, w2].iter().all(|number| number.is_finite())
}

/// Largest gap of a pair, in parts of the largest coordinate.
fn gap(linkage: &Linkage, position: &Position) -> f64 {
    let bodies = &position.bodies;
    let size = bodies.iter().fold(linkage.structure.scale, |size, body| size.max(body.x.hypot(body.y)));
    let gap = |pair: &assur_group::Pair| match pair.geometry {
        PairGeometry::Pin { at_a, at_b } => {
            let [x, y] = plane::minus(bodies[pair.a].point(at_a), bodies[pair.b].point(at_b));
            x.hypot(y) / size
        }
        PairGeometry::Slide { point, through, angle, .. } => {
            let line = bodies[pair.b].turned(plane::direction(angle));
            let apart = plane::minus(bodies[pair.a].point(point), bodies[pair.b].point(through));
            plane::cross(line, apart).abs() / size
        }
    };
    linkage.structure.pairs.iter().map(|named| gap(&named.pair)).fold(0.0, f64::max)
}

/// Solves and judges everything at one coordinate; whether there was a position.
fn judge(linkage: &Linkage, q: f64, position: &mut Position) -> bool {
    match linkage.solve(q, Order::Second, position) {
        Ok(()) => {
            assert!(position.bodies.iter().all(finite), "{q}: {:?}", position.bodies);
            assert!(position.health.iter().all(|health| health.is_finite()), "{q}");
            assert!(gap(linkage, position) < 1e-9, "{q}: {:e}", gap(linkage, position));
        }
        Err(error) => {
            let text = error.to_string();
            let amount = text.contains("misses by") || text.contains("determinant");
            assert!(text.starts_with("group ") && text.contains("coordinate ") && amount, "{text}");
            assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
            return false;
        }
    }
    for plugin in analyzers_of(linkage) {
        let (mut loads, mut out) = (test_loads(linkage), Reactions::new(linkage));
        match plugin.instance.solve(linkage, position, &mut loads, &mut out) {
            Ok(()) => {
                let numbers = out.pairs.iter().skip(1).flat_map(|pair| [pair.fx, pair.fy, pair.m]);
                assert!(numbers.chain([out.balancing]).all(f64::is_finite), "{q}: {}", plugin.name);
            }
            Err(error) => assert!(error.to_string().len() > 20, "{error}"),
        }
    }
    true
}

#[test]
fn every_answer_is_finite_and_closed_or_says_what_fails() {
    let (mut positions, mut refusals) = (0, 0);
    for seed in 0..150 {
        let Some(mechanism) = changed(seed) else { continue };
        let Ok(linkage) = Linkage::compile(mechanism) else { continue };
        let mut position = linkage.position();
        let mut rng = Rng::new(seed + 1000);
        let unit = linkage.coordinate_unit();
        let ends = linkage.range.filter(|range| !range.full).map(|range| [range.low, range.high]);
        let near = ends.into_iter().flatten().flat_map(|end| {
            (0..17).flat_map(move |k| [-1.0, 1.0].map(|side| end + side * unit * 10.0_f64.powi(-k)))
        });
        let anywhere: Vec<f64> = (0..30).map(|_| rng.signed(0.0, 7.0) * unit).collect();
        for q in near.chain(anywhere) {
            let solved = judge(&linkage, q, &mut position);
            positions += usize::from(solved);
            refusals += usize::from(!solved);
        }
    }
    assert!(positions > 2000 && refusals > 500, "{positions} positions, {refusals} refusals");
}

/// Newton's method on the constraints, each time from the place before, knows no ways: it follows the motion. Halving the
/// distance from the end again and again it comes as close as it can; the closed forms must stay beside it.
#[test]
fn no_branch_is_flipped_on_the_way_to_an_end() {
    let mut compared = 0;
    for seed in 0..150 {
        let Some(mechanism) = changed(seed) else { continue };
        let Ok(linkage) = Linkage::compile(mechanism) else { continue };
        let Some(range) = linkage.range.filter(|range| !range.full) else { continue };
        let Some(start) = healthiest(&linkage) else { continue };
        for end in [range.low, range.high] {
            // What runs through infinity comes back another way round; a note of the analysis tells.
            let between = |pole: &(f64, usize)| (pole.0 - start) * (pole.0 - end) < 0.0;
            if linkage.poles().iter().any(between) {
                continue;
            }
            compared += followed(&linkage, start, end);
        }
    }
    assert!(compared > 1000, "{compared}");
}

/// Number of places compared.
fn followed(linkage: &Linkage, start: f64, end: f64) -> usize {
    /// No link turns by more from one place to the next, rad, nor is more than this part of what is left gone.
    const MOST: f64 = 0.05;
    let (mut position, mut count, mut q) = (linkage.position(), 0, start);
    if linkage.solve(q, Order::First, &mut position).is_err() {
        return 0;
    }
    let mut bodies = position.bodies.clone();
    while (end - q).abs() > 1e-12 && count < 3000 {
        let fastest = position.bodies.iter().fold(1.0_f64, |most, body| most.max(body.w1.abs()));
        q += (end - q).signum() * (MOST * (end - q).abs()).min(MOST / fastest);
        linkage.chain.set_input(q, &mut bodies);
        let placed = linkage.groups().iter().all(|kernel| {
            let found = assur_group::place_by_newton(kernel.frame(), &mut bodies);
            found.is_ok_and(|health: f64| health.abs() > 1e-6)
        });
        if !placed || linkage.solve(q, Order::First, &mut position).is_err() {
            break;
        }
        let least = position.health.iter().fold(1.0_f64, |least, health| least.min(health.abs()));
        for (found, followed) in position.bodies.iter().zip(&bodies) {
            let apart = (found.c - followed.c).hypot(found.s - followed.s);
            assert!(apart < 0.1 * least + 1e-9, "{q} of {end}: {apart:e} at health {least:e}");
        }
        count += 1;
    }
    count
}

/// Every walk of random mechanisms: each row within its bound, or refused with a right.
#[test]
fn random_mechanisms_keep_every_bound() {
    let mut count = 0;
    for seed in 0..50 {
        let Some(mechanism) = changed(seed) else { continue };
        let Ok(found) = studied(mechanism.clone()) else { continue };
        let mut rows = found.rows;
        let linkage = Linkage::compile(mechanism).unwrap();
        for group in &linkage.structure.groups {
            rows.extend(walk_group::walk(group.plugin.kind, group));
        }
        if let (Some(walk), Some(q)) = (Walk::new(&linkage), healthiest(&linkage)) {
            rows.extend(turns::rows(&linkage, &walk, q));
            rows.extend(differences::rows(&linkage, q, "whole mechanism"));
            rows.extend(scales::rows(&linkage, q, "whole mechanism"));
        }
        if let Some(row) = rows.iter().find(|row| row.finding.failed()) {
            panic!("seed {seed}: {row:?}");
        }
        count += rows.len();
    }
    assert!(count > 15_000, "{count}");
}

/// A rocker that is longer by d leaves the parallelogram a full turn without a change point, however small d is above rounding.
#[test]
fn nearly_a_parallelogram_keeps_its_way() {
    let scene = |rocker: f64| {
        format!(
            "[ground]\npoints = {{ O = [0, 0], C = [1, 0] }}\n[link.crank]\npoints = {{ O = 0, A = 0.5 }}\n\
             [link.coupler]\npoints = {{ A = 0, B = 1 }}\n[link.rocker]\npoints = {{ C = 0, B = {rocker:?} }}\n\
             [input]\nlink = \"crank\"\nfrom = 1\n[assembly]\nB = [1.27, 0.42]\n"
        )
    };
    for exponent in 1..=12 {
        let text = scene(0.5 + 10.0_f64.powi(-exponent));
        let linkage = Linkage::compile(assur_scene::read("near.toml", &text).unwrap()).unwrap();
        assert!(linkage.range.unwrap().full && linkage.change_points().next().is_none(), "1e-{exponent}");
        // Its motion turns sharply within sqrt(d) of where the parallelogram would go through.
        if exponent % 4 == 0 {
            let found = studied(linkage.mechanism).unwrap();
            assert!(found.is_ok(), "1e-{exponent}: {}", told(&found));
        }
    }
    let exact = Linkage::compile(assur_scene::read("near.toml", &scene(0.5)).unwrap()).unwrap();
    assert_eq!(exact.change_points().count(), 2);
}
