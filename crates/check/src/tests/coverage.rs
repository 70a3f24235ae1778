use assur_force::{Kinetostatics, LaneKinetostatics, LoadState, Loads, find};
use assur_group::{Order, Wrench};
use assur_number::Lanes;

use crate::{Chosen, Coverage, Notable, SAMPLE};

#[test]
fn up_to_the_size_of_a_sample_all_are_chosen() {
    for count in [0, 1, 48, SAMPLE] {
        let chosen = Coverage::Sample.choose(count, &[0]);
        assert_eq!(chosen, Chosen::all(count));
        assert_eq!((chosen.iter().collect::<Vec<_>>(), chosen.share()), ((0..count).collect(), None));
    }
}

#[test]
fn a_sample_is_spread_and_contains_what_is_notable() {
    for count in [SAMPLE + 1, 1000, 1_000_000] {
        let wanted = vec![0, 1, 2, count / 3 + 1, count - 1];
        let chosen = Coverage::Sample.choose(count, &wanted);
        let members: Vec<_> = chosen.iter().collect();
        assert_eq!((members.len(), chosen.count(), chosen.share()), (SAMPLE, SAMPLE, Some([SAMPLE, count])));
        assert!(wanted.iter().all(|one| members.contains(one)), "{count}");
        let widest = members.windows(2).map(|pair| pair[1] - pair[0]).max().unwrap();
        assert!(members.windows(2).all(|pair| pair[0] < pair[1]), "{count}: not increasing");
        // Three notable numbers side by side take the places of their neighbors.
        assert!(widest <= 3 * count.div_ceil(SAMPLE), "{count}: {widest}");
    }
}

#[test]
fn all_are_all_and_none_is_none() {
    let all = Coverage::All.choose(1000, &[0]);
    assert_eq!((all.iter().count(), all.share()), (1000, None));
    let none = Coverage::None.choose(1000, &[0]);
    assert_eq!((none.iter().count(), none.count()), (0, 0));
}

#[test]
fn the_worst_condition_and_the_greatest_values_are_notable() {
    let mut mechanism = assur_scene::read("shaper", assur_fixtures::scene("shaper")).unwrap();
    mechanism.input.positions = 500;
    let linkage = assur_kinematics::Linkage::compile(mechanism).unwrap();
    let loads = Loads::compile(&linkage).unwrap();
    let input = &linkage.mechanism.input;
    let states: Vec<_> =
        (0..500).map(|i| LoadState::prescribed(&linkage.mechanism, input.coordinate(i))).collect();
    let method = find("newton-euler").unwrap();
    let carrying = vec![true; linkage.groups().len()];
    let mut forces = LaneKinetostatics::new(Kinetostatics::new(&linkage, &loads, method.instance, &carrying));
    let (mut at, mut found) = (linkage.lane_position(), Notable::default());
    for first in (0..states.len()).step_by(Lanes::WIDTH) {
        let eight = std::array::from_fn(|lane| states[(first + lane).min(states.len() - 1)]);
        linkage.solve_lanes(Lanes(eight.map(|state| state.coordinate)), Order::Second, &mut at).unwrap();
        forces.solve(&eight, &at).unwrap();
        let lanes = std::array::from_fn(|lane| first + lane < states.len());
        let mut next = Notable::default();
        next.add(&linkage, first, (lanes, &at), Some((lanes, &forces.reactions)));
        found.append(&next);
    }
    let found = found.numbers();
    let mut greatest = [(0.0, 0); 3];
    let mut position = linkage.position();
    for (i, state) in states.iter().enumerate() {
        linkage.solve(state.coordinate, Order::Second, &mut position).unwrap();
        let condition: f64 = position.health.iter().map(|health| 1.0 / health.abs()).sum();
        let mut wrenches = loads.total(state, &position.bodies);
        let mut reactions = assur_force::Reactions::new(&linkage);
        method.instance.solve(&linkage, &position, &mut wrenches, &mut reactions).unwrap();
        let size = |r: &Wrench<f64>| r.fx.abs() + r.fy.abs() + r.m.abs() / linkage.structure.scale;
        let reaction = reactions.pairs.iter().map(size);
        let values = [condition, reactions.balancing.abs(), reaction.fold(0.0, f64::max)];
        for (most, value) in greatest.iter_mut().zip(values) {
            if value > most.0 {
                *most = (value, i);
            }
        }
    }
    for (value, index) in greatest {
        assert!(found.contains(&index), "{index} with {value} is not in {found:?}");
    }
}
