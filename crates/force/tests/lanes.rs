//! Loads, reduction and reactions in lanes are those of one position at a time, bit for bit.

use assur_all as _;
use assur_force::{Kinetostatics, LaneKinetostatics, LoadState, Loads, Side, analyzers};
use assur_group::{Order, Wrench};
use assur_kinematics::{LanePosition, Linkage, Position};
use assur_number::Lanes;
use assur_testkit::specimen::{Recipe, Rng};

type States = [LoadState; Lanes::WIDTH];

/// States beside each other, some at rest, held, on a jump, or close to a change point.
fn states(linkage: &Linkage, rng: &mut Rng) -> States {
    let mechanism = &linkage.mechanism;
    let from = mechanism.input.from;
    let mut marked = vec![from, from - 0.313_7, from + 0.271_9];
    marked.extend(linkage.change_points().map(|point| point.coordinate));
    std::array::from_fn(|_| {
        let coordinate = if rng.chance(0.3) {
            marked[rng.below(marked.len())] + if rng.chance(0.5) { 0.0 } else { rng.signed(0.0, 0.01) }
        } else {
            mechanism.input.coordinate(rng.below(2 * mechanism.input.positions))
        };
        if rng.chance(0.5) {
            return LoadState::prescribed(mechanism, coordinate);
        }
        let side = match rng.below(4) {
            0 => Side::Prescribed,
            1 => Side::Before,
            2 => Side::Held { upper: rng.unit() },
            _ => Side::After,
        };
        let mut some = |size: f64| if rng.chance(0.2) { 0.0 } else { rng.signed(0.0, size) };
        LoadState {
            coordinate,
            speed: some(9.0),
            acceleration: some(50.0),
            time: some(0.1).abs(),
            side,
            drive: None,
        }
    })
}

fn same(name: &str, all: f64, one: f64) {
    let alike = all.to_bits() == one.to_bits() || all.is_nan() && one.is_nan();
    assert!(alike, "{name}: {all:e} in lanes, {one:e} alone");
}

fn same_wrenches(name: &str, lane: usize, all: &[Wrench<Lanes>], one: &[Wrench<f64>]) {
    for (all, one) in all.iter().zip(one) {
        for (all, one) in [(all.fx, one.fx), (all.fy, one.fy), (all.m, one.m)] {
            same(name, all.0[lane], one);
        }
    }
}

/// Compares the lanes with a position at a time, and returns how many reactions are determined and how many are not.
fn compare(linkage: &Linkage, loads: &Loads, states: &States, block: &mut LanePosition) -> [usize; 2] {
    let coordinates = Lanes::of(|lane| states[lane].coordinate);
    let failed = linkage.solve_lanes(coordinates, Order::Second, block).err().unwrap_or_default();
    let is_placed = |lane: &usize| failed.iter().all(|(failed, _)| failed != lane);
    let placed: Vec<usize> = (0..Lanes::WIDTH).filter(is_placed).collect();
    let block = &*block;
    let copied = |lane| {
        let mut position: Position = linkage.position();
        block.copy_lane(lane, &mut position);
        position
    };
    let total = loads.total(states, &block.bodies);
    let reduced = loads.reduced(states, &block.bodies);
    let energy = loads.potential_energy(&block.bodies);
    for &lane in &placed {
        let (state, bodies) = (&states[lane], &copied(lane).bodies);
        same_wrenches("load", lane, &total, &loads.total(state, bodies));
        let one = loads.reduced(state, bodies);
        same("J", reduced.inertia.0[lane], one.inertia);
        same("J'", reduced.inertia_derivative.0[lane], one.inertia_derivative);
        same("Q", reduced.moment.0[lane], one.moment);
        same("energy", energy.0[lane], loads.potential_energy(bodies));
    }
    let mut counts = [0, 0];
    for plugin in analyzers().expect("a registry") {
        if plugin.instance.supports(linkage).is_err() {
            continue;
        }
        let carrying = vec![true; linkage.groups().len()];
        let mut single = Kinetostatics::new(linkage, loads, plugin.instance, &carrying);
        let mut lanes = LaneKinetostatics::new(single.clone());
        let failures = lanes.solve(states, block).err().unwrap_or_default();
        for &lane in &placed {
            let found = single.solve(&states[lane], &copied(lane)).err();
            let failure = failures.iter().find(|(failed, _)| *failed == lane).map(|(_, error)| error);
            assert_eq!(found.as_ref(), failure, "{}", plugin.name);
            counts[usize::from(found.is_some())] += 1;
            if found.is_none() {
                same_wrenches(plugin.name, lane, &lanes.reactions.pairs, &single.reactions.pairs);
                same("balancing", lanes.reactions.balancing.0[lane], single.reactions.balancing);
            }
        }
    }
    counts
}

fn compare_all(linkage: &Linkage, blocks: usize, rng: &mut Rng) -> [usize; 2] {
    let Ok(loads) = Loads::compile(linkage) else { return [0, 0] };
    let mut block = linkage.lane_position();
    let mut counts = [0, 0];
    for _ in 0..blocks {
        let [solved, failed] = compare(linkage, &loads, &states(linkage, rng), &mut block);
        counts = [counts[0] + solved, counts[1] + failed];
    }
    counts
}

#[test]
fn shipped_scenes() {
    let mut rng = Rng::new(1);
    for (name, text) in assur_fixtures::SCENES {
        let linkage = Linkage::compile(assur_scene::read(name, text).unwrap()).unwrap();
        compare_all(&linkage, 2, &mut rng);
    }
}

#[test]
fn random_mechanisms_with_all_kinds_of_loads() {
    let mut counts = [0, 0];
    for seed in 0..150 {
        let recipe = Recipe::of(1 + usize::try_from(seed).unwrap() % 4);
        let mechanism = recipe.specimen(seed).expect("a specimen").mechanism;
        let linkage = Linkage::compile(mechanism).expect("a linkage");
        let [solved, failed] = compare_all(&linkage, 3, &mut Rng::new(seed));
        counts = [counts[0] + solved, counts[1] + failed];
    }
    assert!(counts[0] > 5000, "{counts:?}");
}

#[test]
fn change_points() {
    let text = "gravity = 9.81\n[ground]\npoints = { O = [0, 0], C = [1, 0] }\n\
        [link.crank]\npoints = { O = 0, A = 0.5 }\nmass = 1\ncenter = 0.1\n\
        [link.coupler]\npoints = { A = 0, B = 1 }\nmass = 2\ncenter = 0.5\ninertia = 0.1\n\
        [link.rocker]\npoints = { B = 0, C = 0.5 }\nmass = 3\ncenter = 0.25\n\
        [input]\nlink = \"crank\"\nfrom = 1\npositions = 12\n[motion]\nspeed = 3\n";
    let linkage = Linkage::compile(assur_scene::read("parallelogram", text).unwrap()).unwrap();
    let mut rng = Rng::new(3);
    let [solved, failed] = compare_all(&linkage, 40, &mut rng);
    assert!(solved > 500 && failed > 20, "{solved} and {failed}");
}
