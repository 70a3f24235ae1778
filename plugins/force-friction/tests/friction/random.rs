//! Random mechanisms of all kinds of two links, with friction in all pairs, by the two methods; and eight positions at once.

use assur_force::{ForceError, Kinetostatics, LaneKinetostatics, Loads, Reactions, State, find};
use assur_group::Order;
use assur_kinematics::Linkage;
use assur_number::Lanes;
use assur_testkit::specimen::Recipe;

use super::cases::{Dice, fixture, with_friction};

/// What a method finds at a coordinate.
fn by(linkage: &Linkage, loads: &Loads, method: &str, coordinate: f64) -> Result<Reactions, ForceError> {
    let carrying = vec![true; linkage.groups().len()];
    let mut forces = Kinetostatics::new(linkage, loads, find(method).unwrap().instance, &carrying);
    let mut position = linkage.position();
    linkage.solve(coordinate, Order::Second, &mut position).unwrap();
    forces.solve(&State::prescribed(&linkage.mechanism, coordinate), &position)?;
    Ok(forces.reactions)
}

/// How often there was one solution, were several, and none; and the greatest deviation of the two methods where there is one.
#[derive(Debug, Default)]
struct Count {
    one: usize,
    several: usize,
    none: usize,
    /// One method finds a solution, and the other neither one nor a proof that there is none.
    unknown: usize,
    apart: f64,
}

/// Compares the two methods on random mechanisms.
fn compare(seeds: std::ops::Range<u64>) -> Count {
    let mut count = Count::default();
    for seed in seeds {
        let recipe = Recipe { groups: 1 + (seed % 4) as usize, only: None, loads: true };
        let Some(specimen) = recipe.specimen(seed) else { continue };
        let mut dice = Dice(seed);
        let strength = [0.02, 0.1, 0.25][(seed % 3) as usize];
        let mut mechanism = with_friction(specimen.mechanism, strength, &mut dice);
        if seed % 2 == 0 {
            mechanism.balance = None;
        }
        let Ok(linkage) = Linkage::compile(mechanism) else { continue };
        let Ok(loads) = Loads::compile(&linkage) else { continue };
        let coordinate = linkage.mechanism.input.coordinate(1);
        let [own, whole] = ["coulomb", "newton-euler"].map(|method| by(&linkage, &loads, method, coordinate));
        match (own, whole) {
            (Ok(own), Ok(whole)) => judge(seed, &own, &whole, &mut count),
            (Err(ForceError::Jammed { .. }), Err(ForceError::Jammed { .. })) => count.none += 1,
            // Where a method does not find all it may find none.
            (Err(ForceError::Jammed { proved: false, .. }), Ok(_))
            | (Ok(_), Err(ForceError::Jammed { proved: false, .. })) => count.unknown += 1,
            (Err(ForceError::Jammed { .. }), Ok(_)) | (Ok(_), Err(ForceError::Jammed { .. })) => {
                panic!("{seed}: one method finds a solution")
            }
            _ => {}
        }
    }
    count
}

fn judge(seed: u64, own: &Reactions, whole: &Reactions, count: &mut Count) {
    let friction = own.friction.as_ref().unwrap();
    let other = whole.friction.as_ref().unwrap();
    let size = other.forces.iter().fold(whole.balancing.abs(), |most, force| most.max(force.abs()));
    let size = size.max(f64::MIN_POSITIVE);
    let apart = |balancing: f64, forces: &[f64]| {
        let each = forces.iter().zip(&other.forces).map(|(a, b)| (a - b).abs());
        each.fold((balancing - whole.balancing).abs(), f64::max) / size
    };
    match friction.doubts.first() {
        Some((_, doubt)) if doubt.solutions.len() > 1 => {
            count.several += 1;
            let near = doubt.solutions.iter().any(|one| apart(one.balancing, &one.forces) < 1e-7);
            assert!(near || !doubt.proved, "{seed}: the other method finds another solution");
        }
        _ => {
            let apart = apart(own.balancing, &friction.forces);
            // The conditions of the groups magnify rounding, and so does a certificate near 1.
            assert!(apart < 1e-8, "{seed}: {apart} {:?}", friction.certificates);
            count.apart = count.apart.max(apart);
            count.one += usize::from(apart < 1e-10);
        }
    }
}

#[test]
fn both_methods_agree_on_random_mechanisms() {
    let found = compare(0..60);
    assert!(found.one > 35 && found.none > 0, "{found:?}");
}

#[test]
#[ignore = "takes minutes"]
fn both_methods_agree_on_two_thousand_random_mechanisms() {
    let found = compare(100..2400);
    assert!(found.one + found.several + found.none > 2000 && found.unknown == 0, "{found:?}");
}

#[test]
fn eight_positions_at_once_have_the_bits_of_each() {
    let mut dice = Dice(23);
    for name in ["shaper", "guide-shaper", "conveyor"] {
        let linkage = Linkage::compile(with_friction(fixture(name), 0.02, &mut dice)).unwrap();
        let loads = Loads::compile(&linkage).unwrap();
        let analyzer = find("coulomb").unwrap().instance;
        let carrying = vec![true; linkage.groups().len()];
        let mut forces = Kinetostatics::new(&linkage, &loads, analyzer, &carrying);
        let mut lanes = LaneKinetostatics::new(forces.clone());
        let coordinates = Lanes::of(|lane| 0.3 + 0.7 * lane as f64);
        let states = coordinates.0.map(|q| State::prescribed(&linkage.mechanism, q));
        let mut eight = linkage.lane_position();
        linkage.solve_lanes(coordinates, Order::Second, &mut eight).unwrap();
        lanes.solve(&states, &eight).unwrap();
        let together = lanes.reactions.friction.as_ref().unwrap();
        let mut position = linkage.position();
        for (lane, state) in states.iter().enumerate() {
            linkage.solve(coordinates.0[lane], Order::Second, &mut position).unwrap();
            forces.solve(state, &position).unwrap();
            let alone = forces.reactions.friction.as_ref().unwrap();
            let of = |all: &[Lanes]| all.iter().map(|one| one.0[lane].to_bits()).collect::<Vec<_>>();
            let bits = |all: &[f64]| all.iter().map(|one| one.to_bits()).collect::<Vec<_>>();
            assert_eq!(of(&together.forces), bits(&alone.forces), "{name} {lane}");
            assert_eq!(of(&together.certificates), bits(&alone.certificates), "{name} {lane}");
            assert_eq!(lanes.reactions.balancing.0[lane].to_bits(), forces.reactions.balancing.to_bits());
        }
    }
}
