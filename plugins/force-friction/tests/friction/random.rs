//! Random mechanisms of all kinds of two links, with friction in all pairs, by the two methods; and eight positions at once.

use assur_force::{ForceError, Kinetostatics, LaneKinetostatics, LoadState, Loads, Reactions, find};
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
    forces.solve(&LoadState::prescribed(&linkage.mechanism, coordinate), &position)?;
    Ok(forces.reactions)
}

/// How often there was one solution, were several, and none.
#[derive(Debug, Default)]
struct Count {
    one: usize,
    several: usize,
    none: usize,
    /// One method finds a solution, and the other neither one nor a proof that there is none.
    unknown: usize,
    /// Seeds of which the methods differ, and how.
    apart: Vec<(u64, String)>,
}

/// Compares the two methods on random mechanisms, one in five with groups of any kind.
fn compare(seeds: std::ops::Range<u64>) -> Count {
    let mut count = Count::default();
    for seed in seeds {
        let recipe = Recipe { groups: 1 + (seed % 4) as usize, only: None, loads: true };
        let specimen = if seed % 5 == 4 { recipe.mixed(seed) } else { recipe.specimen(seed) };
        let Some(specimen) = specimen else { continue };
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
                count.apart.push((seed, "one method finds a solution".to_owned()));
            }
            _ => {}
        }
    }
    count
}

/// The balancing load and the friction of each solution, and whether there are certainly no others.
fn solutions(found: &Reactions) -> (Vec<Vec<f64>>, bool) {
    let friction = found.friction.as_ref().unwrap();
    let numbers = |balancing: f64, forces: &[f64]| [&[balancing], forces].concat();
    friction.doubts.first().map_or_else(
        || (vec![numbers(found.balancing, &friction.forces)], true),
        |(_, doubt)| {
            let each = doubt.solutions.iter().map(|one| numbers(one.balancing, &one.forces));
            (each.collect(), doubt.proved)
        },
    )
}

fn judge(seed: u64, own: &Reactions, whole: &Reactions, count: &mut Count) {
    let pairs = whole.pairs.iter().map(|pair| pair.fx.hypot(pair.fy));
    let size = pairs.fold(f64::MIN_POSITIVE, f64::max);
    let ([own, whole], [all, all_too]) = {
        let (own, whole) = (solutions(own), solutions(whole));
        ([own.0, whole.0], [own.1, whole.1])
    };
    let near = |one: &[f64], other: &[f64]| {
        let size = one.iter().fold(size, |most, number| most.max(number.abs()));
        one.iter().zip(other).all(|(a, b)| (a - b).abs() <= 1e-10 * size)
    };
    let missing = |some: &[Vec<f64>], among: &[Vec<f64>]| {
        some.iter().find(|one| !among.iter().any(|other| near(one, other))).cloned()
    };
    // Who knows all solutions knows those of the other.
    for (knows, some, among) in [(all, &whole, &own), (all_too, &own, &whole)] {
        if let Some(one) = missing(some, among).filter(|_| knows) {
            count.apart.push((seed, format!("{one:?} is not among {among:?}")));
        }
    }
    let counted = if own.len() == 1 { &mut count.one } else { &mut count.several };
    *counted += 1;
}

#[test]
fn both_methods_agree_on_random_mechanisms() {
    let found = compare(0..60);
    assert!(found.apart.is_empty() && found.one > 30 && found.several > 5 && found.none > 5, "{found:?}");
}

#[test]
#[ignore = "takes minutes"]
fn both_methods_agree_on_two_thousand_random_mechanisms() {
    let found = compare(100..2400);
    assert!(found.apart.is_empty() && found.unknown == 0, "{found:?}");
    assert!(found.one + found.several + found.none > 2000, "{found:?}");
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
        let states = coordinates.0.map(|q| LoadState::prescribed(&linkage.mechanism, q));
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
