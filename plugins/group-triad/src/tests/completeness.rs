//! The modes are all there are: every root that Newton's method on the pairs finds from many starts is among them.

use assur_group::{Body, GroupFrame, GroupPlugin, Number, PairGeometry, groups, place_by_newton};
use assur_testkit::{Rng, random_groups};

/// Starts of Newton's method for each group.
const STARTS: usize = 120;

/// Groups of each kind.
const GROUPS: u64 = 5;

fn kinds() -> Vec<&'static GroupPlugin> {
    let all = groups().unwrap_or_else(|error| panic!("{error}"));
    all.into_iter().filter(|plugin| plugin.crate_name == env!("CARGO_PKG_NAME")).collect()
}

/// Greatest violation of a pair, m or as a sine.
fn violation(frame: &GroupFrame, bodies: &[Body<f64>]) -> f64 {
    let of = |pair: &assur_group::Pair| {
        let (a, b) = (&bodies[pair.a], &bodies[pair.b]);
        match pair.geometry {
            PairGeometry::Pin { at_a, at_b } => {
                let (p, q) = (a.point(at_a), b.point(at_b));
                (p[0] - q[0]).hypot(p[1] - q[1])
            }
            PairGeometry::Slide { point, through, angle, tilt } => {
                let (p, q) = (a.point(point), b.point(through));
                let t = b.turned([angle.cos(), angle.sin()]);
                let x = b.turned([(angle + tilt).cos(), (angle + tilt).sin()]);
                let off = t[0] * (p[1] - q[1]) - t[1] * (p[0] - q[0]);
                off.abs().max((x[0] - a.c).hypot(x[1] - a.s))
            }
        }
    };
    frame.pairs().map(of).fold(0.0, f64::max)
}

fn apart(one: &[Body<f64>], other: &[Body<f64>]) -> f64 {
    let off =
        |(a, b): (&Body<f64>, &Body<f64>)| (a.x - b.x).hypot(a.y - b.y).max((a.c - b.c).hypot(a.s - b.s));
    one.iter().zip(other).map(off).fold(0.0, f64::max)
}

fn own(frame: &GroupFrame, bodies: &[Body<f64>]) -> Vec<Body<f64>> {
    frame.links.iter().map(|&link| bodies[link]).collect()
}

/// A root of the equations of the pairs from a random start.
fn from_anywhere(frame: &GroupFrame, built: &[Body<f64>], rng: &mut Rng) -> Option<Vec<Body<f64>>> {
    let mut bodies = built.to_vec();
    for &link in &frame.links {
        let (s, c) = rng.angle().sin_cos();
        let body = &mut bodies[link];
        (body.c, body.s) = (c, s);
        (body.x, body.y) = (body.x + rng.range(-2.0, 2.0), body.y + rng.range(-2.0, 2.0));
    }
    let health = place_by_newton(frame, &mut bodies).ok()?;
    // A slide turned round by 180 degrees satisfies the sine of its angle and is no assembly; nor is what runs to infinity.
    (health > 1e-6 && violation(frame, &bodies) < 1e-9).then(|| own(frame, &bodies))
}

#[test]
fn no_mode_is_missing() {
    let mut most_seen = std::collections::BTreeMap::new();
    for plugin in kinds() {
        let pattern = plugin.pattern.unwrap();
        for (frame, built) in random_groups(&pattern, 0..GROUPS) {
            let kernel = f64::build(&plugin.builders, &frame).unwrap();
            let modes = kernel.modes(&built).unwrap().unwrap();
            assert!(modes.len() <= plugin.ways.most, "{}: {} modes", plugin.name, modes.len());
            let seen = most_seen.entry(plugin.name).or_insert(0);
            *seen = modes.len().max(*seen);
            let mut bodies = built.clone();
            for mode in &modes {
                frame.links.iter().zip(&mode.bodies).for_each(|(&link, body)| bodies[link] = *body);
                let off = violation(&frame, &bodies);
                assert!(off < 1e-13 / mode.health.min(1.0), "{}: open by {off:e}", plugin.name);
            }
            for (i, mode) in modes.iter().enumerate() {
                let nearest = modes[..i].iter().map(|other| apart(&mode.bodies, &other.bodies));
                assert!(nearest.fold(f64::INFINITY, f64::min) > 1e-6, "{}: twice", plugin.name);
            }
            let mut rng = Rng::new(99);
            let known = std::iter::once(own(&frame, &built));
            let found = (0..STARTS).filter_map(|_| from_anywhere(&frame, &built, &mut rng));
            for root in known.chain(found) {
                let nearest =
                    modes.iter().map(|mode| apart(&mode.bodies, &root)).fold(f64::INFINITY, f64::min);
                assert!(
                    nearest < 1e-6,
                    "{}: of {} modes the nearest is {nearest:e} away",
                    plugin.name,
                    modes.len()
                );
            }
        }
    }
    assert_eq!(most_seen.len(), 35);
    println!("{most_seen:?}");
}
