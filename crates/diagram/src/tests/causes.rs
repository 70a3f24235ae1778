use assur_force::{LoadState, Loads, analyzers};
use assur_mechanism::PairId;

use super::{analyzer, compile, fixture, reactions, solved, state};
use crate::sheet::joint_forces;
use crate::{Hodograph, ReactionExtreme, Sizes, split};

/// The polar diagram of the reaction in the pin on the arm in the positions of the scene.
fn hodograph(scene: &str, closed: bool) -> Hodograph {
    let linkage = compile(scene);
    let loads = Loads::compile(&linkage).unwrap();
    let input = &linkage.mechanism.input;
    let coordinates: Vec<_> = (0..input.positions).map(|index| input.coordinate(index)).collect();
    let force = |q: &f64| {
        let state = LoadState::prescribed(&linkage.mechanism, *q);
        let out = reactions(&linkage, &loads, &state, &solved(&linkage, *q)).unwrap();
        joint_forces(&linkage, &out).into_iter().find(|one| one.on == "arm").unwrap().force
    };
    let points = coordinates.iter().map(force).collect();
    let mechanism = &linkage.mechanism;
    let joint = mechanism.named_pair(PairId::Pin(mechanism.point("O").unwrap()));
    let on = mechanism.named_link(mechanism.link("arm").unwrap());
    Hodograph { joint, on, coordinates, points, closed }
}

#[test]
fn shares_sum_to_the_whole() {
    for name in super::SCENES {
        let linkage = compile(&fixture(name));
        let loads = Loads::compile(&linkage).unwrap();
        for index in (0..linkage.mechanism.input.positions).step_by(3) {
            let q = linkage.mechanism.input.coordinate(index);
            let (position, state) = (solved(&linkage, q), state(&linkage, q));
            let found = split(&linkage, &position, &loads, &state, analyzer("groups")).unwrap();
            assert!(found.residual < 1e-12, "{name} {index} {}", found.residual);
            let sum: f64 = found.shares.iter().map(|share| share.balancing).sum();
            let size: f64 = found.shares.iter().map(|share| share.balancing.abs()).sum();
            assert!((sum - found.whole.balancing).abs() <= 1e-12 * size + 1e-12);
            // The whole is what another method finds without any splitting.
            let whole = joint_forces(&linkage, &reactions(&linkage, &loads, &state, &position).unwrap());
            for (one, two) in found.whole.reactions.iter().zip(&whole) {
                let greatest = whole.iter().map(|one| crate::plan::length(one.force)).fold(0.0, f64::max);
                let off = [one.force[0] - two.force[0], one.force[1] - two.force[1]];
                assert!(crate::plan::length(off) < 1e-9 * greatest);
            }
        }
    }
}

#[test]
fn causes_are_named_weight_inertia_and_loads() {
    let linkage = compile(&fixture("four-bar"));
    let loads = Loads::compile(&linkage).unwrap();
    let found =
        split(&linkage, &solved(&linkage, 1.0), &loads, &state(&linkage, 1.0), analyzer("longitudinal"))
            .unwrap();
    let causes: Vec<_> = found.shares.iter().map(|share| share.cause.to_string()).collect();
    assert_eq!(causes, ["weight", "inertia", "stamp", "pull", "brake", "twist"]);
    // A moment on the rocker alone leaves no force on it but the couple of its two pins.
    let brake = &found.shares[4].reactions;
    let on_rocker = brake
        .iter()
        .filter(|one| one.on == "rocker")
        .fold([0.0; 2], |sum, one| [sum[0] + one.force[0], sum[1] + one.force[1]]);
    assert!(crate::plan::length(on_rocker) < 1e-10);
}

/// A crank that carries a point mass: the pin holds m w^2 r towards the center, the weight upward.
const ROTOR: &str = "gravity = 10\n[ground]\npoints = { O = 0 }\n[link.arm]\npoints = { O = 0, A = 0.5 }\nmass = 2\ncenter = 'A'\n\
    [input]\nlink = 'arm'\npositions = 8\n[motion]\nspeed = 3\n";

/// The extreme of a reaction in positions that are numbered from `first` on.
fn extreme(curve: &Hodograph, first: usize) -> ReactionExtreme {
    let mut sizes = Sizes::default();
    for (index, (coordinate, force)) in curve.coordinates.iter().zip(&curve.points).enumerate() {
        sizes.add(first + index, *coordinate, *force);
    }
    let coordinate = |index: usize| curve.coordinates[index - first];
    sizes.extreme(curve.joint.clone(), curve.on.clone(), (coordinate, curve.closed)).unwrap()
}

#[test]
fn greatest_and_root_mean_square_of_a_rotor() {
    let curve = hodograph(ROTOR, true);
    let found = extreme(&curve, 10);
    // Centripetal 2 * 9 * 0.5 = 9 N, weight 20 N: 29 N below (position 6, 270 degrees); mean square 20^2 + 9^2.
    assert!((found.greatest - 29.0).abs() < 1e-12 && found.index == 16);
    assert!((found.coordinate - 1.5 * std::f64::consts::PI).abs() < 1e-12);
    assert!((found.rms - 481.0_f64.sqrt()).abs() < 1e-12);
    // The hodograph is a circle of 9 N about (0, 20).
    assert!(curve.points.iter().all(|[x, y]| (x.hypot(y - 20.0) - 9.0).abs() < 1e-12));
}

#[test]
fn over_a_range_the_mean_is_by_trapezoids() {
    let curve = hodograph(&ROTOR.replace("positions = 8", "to = 2\npositions = 3"), false);
    let found = extreme(&curve, 0);
    // |R|^2 = 481 - 2 * 9 * 20 sin q at q = 0, 1, 2, weights 1/4, 1/2, 1/4.
    let square = |q: f64| 481.0 - 360.0 * q.sin();
    let wanted = 0.25 * square(0.0) + 0.5 * square(1.0) + 0.25 * square(2.0);
    assert!((found.rms - wanted.sqrt()).abs() < 1e-12);
}

#[test]
fn every_analyzer_gives_its_construction_or_none() {
    let linkage = compile(&fixture("press"));
    let position = solved(&linkage, -1.9);
    let loads = Loads::compile(&linkage).unwrap().acting(&state(&linkage, -1.9), &position.bodies);
    let drawn = analyzers()
        .unwrap()
        .into_iter()
        .filter(|plugin| plugin.instance.construction(&linkage, &position, &loads).unwrap().is_some());
    let names: Vec<_> = drawn.map(|plugin| plugin.name).collect();
    assert_eq!(names, ["longitudinal", "longitudinal-published", "virtual-power"]);
}
