//! The mass of a link, split into two points that have the same mass, center and moment of inertia.

use super::*;

/// Turned about the center against the link's x axis, rad.
const ALONG: f64 = 0.6;

/// Two links that are pinned where the half masses are, each held by a massless rod from the ground. A link whose center is its
/// pin and that has no moment of inertia passes on nothing but the force of its mass, so that everything else must stay.
fn split(mechanism: &Mechanism, link: usize, place: [f64; 2]) -> Mechanism {
    let mut two = mechanism.clone();
    let whole = two.links[link].clone();
    let arm = (whole.inertia.constant() / whole.mass).sqrt();
    let along = turned([arm, 0.0], ALONG);
    (two.links[link].mass, two.links[link].inertia) = (0.0, Inertia::NONE);
    for (name, side) in [("one", 1.0), ("two", -1.0)] {
        let at = [whole.center[0] + side * along[0], whole.center[1] + side * along[1]];
        let half = two.links.len();
        let mass = 0.5 * whole.mass;
        two.links.push(Link { name: name.into(), mass, center: [0.0; 2], inertia: Inertia::NONE });
        two.links.push(Link {
            name: format!("{name} rod").into(),
            mass: 0.0,
            center: [0.0; 2],
            inertia: Inertia::NONE,
        });
        let mut pin = |name: String, a: (usize, [f64; 2]), b: (usize, [f64; 2])| {
            let places = [a, b].map(|(link, at)| Place { link, at }).to_vec();
            two.points.push(Point { name: name.into(), places });
        };
        pin(format!("{name} mass"), (link, at), (half, [0.0; 2]));
        // So long that they reach wherever the link goes.
        pin(format!("{name} joint"), (half, [60.0, 0.0]), (half + 1, [0.0; 2]));
        pin(format!("{name} ground"), (half + 1, [70.0, 0.0]), (GROUND, place));
    }
    two
}

/// Whether a link has a mass, and a moment of inertia that two points can have.
fn splits(mechanism: &Mechanism, link: usize) -> bool {
    mechanism.links[link].mass > 0.0 && mechanism.links[link].inertia.varying().is_none()
}

#[test]
fn splitting_a_mass_into_two_points_changes_nothing() {
    let mut tried = 0;
    for mechanism in specimens() {
        let before = solve(&mechanism);
        let links = mechanism.links.len();
        for link in (1..links).filter(|&link| splits(&mechanism, link)) {
            let after = solve(&split(&mechanism, link, [40.0, 50.0]));
            let turns: Vec<_> =
                after.turns.chunks(links + 3).flat_map(|all| all[..links - 1].to_vec()).collect();
            assert!(apart(&before.turns, &turns) < 1e-11, "{}", mechanism.title);
            assert!(differ(&before.balancing, &after.balancing) < 1e-9, "link {link}");
            assert!(apart(&before.reduced, &after.reduced) < 1e-9, "link {link}");
            // Forces in the pairs that were there, wherever they stand now.
            let count = before.balancing.len();
            let (old, new) = (before.forces.len() / count, after.forces.len() / count);
            let size = before.forces.iter().flatten().fold(1e-9_f64, |size, x| size.max(x.abs()));
            for (old, new) in before.forces.chunks(old).zip(after.forces.chunks(new)) {
                for force in old {
                    let miss = |other: &[f64; 2]| (other[0] - force[0]).hypot(other[1] - force[1]);
                    let near = new.iter().map(miss).fold(f64::INFINITY, f64::min);
                    assert!(near < 1e-9 * size, "link {link}: no force {force:?}, {near:e} of {size}");
                }
            }
            tried += 1;
        }
    }
    assert!(tried > 60, "{tried}");
}

/// Another moment of inertia is another mechanism: the test above can fail.
#[test]
fn a_split_with_another_moment_of_inertia_is_seen() {
    let mut seen = 0;
    for mechanism in specimens().take(12) {
        let before = solve(&mechanism);
        for link in (1..mechanism.links.len()).filter(|&link| splits(&mechanism, link)) {
            let mut other = mechanism.clone();
            other.links[link].inertia *= 1.0 + 1e-4;
            let after = solve(&split(&other, link, [40.0, 50.0]));
            seen += usize::from(apart(&before.reduced, &after.reduced) > 1e-9);
        }
    }
    assert!(seen > 12, "{seen}");
}
