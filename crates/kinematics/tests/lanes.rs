//! Positions in lanes are those of `Linkage::solve`, bit for bit, whatever the other lanes are.

use assur_all as _;
use assur_group::{Body, Order};
use assur_kinematics::{LanePosition, Linkage, Position};
use assur_number::Lanes;
use assur_testkit::specimen::{Recipe, Rng};

const ORDERS: [Order; 3] = [Order::Place, Order::First, Order::Second];

/// Blocks of coordinates over several turns, some of them close to or beyond change points and limits of the assembly.
fn blocks(linkage: &Linkage, rng: &mut Rng) -> Vec<Lanes> {
    let unit = linkage.coordinate_unit();
    let from = linkage.mechanism.input.from;
    let marked: Vec<f64> = {
        let ends = linkage.range.iter().filter(|range| !range.full).flat_map(|range| [range.low, range.high]);
        linkage.change_points().map(|point| point.coordinate).chain(ends).collect()
    };
    let mut coordinate = |spread: f64| {
        if !marked.is_empty() && rng.chance(0.3) {
            marked[rng.below(marked.len())] + rng.signed(0.0, 0.03) * unit
        } else {
            from + rng.signed(0.0, spread) * unit
        }
    };
    let mut blocks: Vec<Lanes> =
        [0.02, 0.5, 3.0, 9.0].iter().map(|&spread| Lanes::of(|_| coordinate(spread))).collect();
    // The same coordinates beside other neighbors.
    let moved = Lanes::of(|lane| blocks[2 + lane % 2].0[(3 * lane + 1) % Lanes::WIDTH]);
    let mut odd = blocks[1];
    (odd.0[2], odd.0[5]) = (f64::NAN, f64::INFINITY);
    blocks.extend([moved, odd]);
    blocks
}

fn bits(bodies: &[Body<f64>], health: &[f64]) -> Vec<u64> {
    // A NaN has many bit patterns, one meaning.
    let bits = |number: f64| if number.is_nan() { u64::MAX } else { number.to_bits() };
    bodies.iter().flat_map(Body::numbers).chain(health.iter().copied()).map(bits).collect()
}

/// Compares all lanes of a block with `solve`; returns the numbers of lanes with and without a position.
fn compare(
    linkage: &Linkage,
    (coordinates, order): (Lanes, Order),
    (block, scratch): (&mut LanePosition, &mut Position),
) -> [usize; 2] {
    let failures = linkage.solve_lanes(coordinates, order, block).err().unwrap_or_default();
    for (lane, coordinate) in coordinates.0.into_iter().enumerate() {
        let mut alone = linkage.position();
        let failure = failures.iter().find(|(failed, _)| *failed == lane).map(|(_, error)| error.to_string());
        let solved = linkage.solve(coordinate, order, &mut alone);
        assert_eq!(failure, solved.err().map(|error| error.to_string()), "{coordinate}");
        block.copy_lane(lane, scratch);
        if failure.is_none() {
            let (one, all) = (bits(&alone.bodies, &alone.health), bits(&scratch.bodies, &scratch.health));
            // Derivatives above the order keep what they were.
            let compared = |at: usize| match order {
                Order::Place => at % 10 < 4,
                Order::First => at % 10 < 7,
                Order::Second => true,
            };
            let links = 10 * alone.bodies.len();
            for at in (0..one.len()).filter(|&at| at >= links || compared(at)) {
                assert_eq!(one[at], all[at], "number {at} of lane {lane} at {coordinate}");
            }
        } else if failures.len() < Lanes::WIDTH && order == Order::Second {
            assert!(scratch.bodies.iter().flat_map(Body::numbers).all(f64::is_finite));
        }
    }
    [Lanes::WIDTH - failures.len(), failures.len()]
}

fn compare_all(linkage: &Linkage, seed: u64) -> [usize; 2] {
    let (mut block, mut scratch) = (linkage.lane_position(), linkage.position());
    let mut rng = Rng::new(seed);
    let mut counts = [0, 0];
    for order in ORDERS {
        for coordinates in blocks(linkage, &mut rng) {
            let [solved, failed] = compare(linkage, (coordinates, order), (&mut block, &mut scratch));
            counts = [counts[0] + solved, counts[1] + failed];
        }
    }
    counts
}

#[test]
fn shipped_scenes() {
    for (seed, (name, text)) in (0..).zip(assur_fixtures::SCENES) {
        let linkage = Linkage::compile(assur_scene::read(name, text).unwrap()).unwrap();
        let [solved, _] = compare_all(&linkage, seed);
        assert!(solved > 0, "{name}");
    }
}

#[test]
fn random_mechanisms_with_limits() {
    let mut counts = [0, 0];
    for seed in 0..60 {
        let recipe = Recipe { loads: false, ..Recipe::of(1 + usize::try_from(seed).unwrap() % 5) };
        let mut mechanism = recipe.specimen(seed).expect("a specimen").mechanism;
        let mut rng = Rng::new(seed);
        if rng.chance(0.5) {
            // A point is moved, so that many mechanisms no longer turn fully.
            let point = rng.below(mechanism.points.len());
            if let Some(place) = mechanism.points[point].places.last_mut() {
                place.at = place.at.map(|at| at + rng.signed(0.0, 0.5));
            }
        }
        let Ok(linkage) = Linkage::compile(mechanism) else { continue };
        let [solved, failed] = compare_all(&linkage, seed);
        counts = [counts[0] + solved, counts[1] + failed];
    }
    assert!(counts[0] > 2000 && counts[1] > 200, "{counts:?}");
}

/// Kites and parallelograms, in which two ways of a group meet.
#[test]
fn change_points() {
    for (crank, coupler) in [(0.5, 1.0), (1.0, 1.0), (0.8, 0.8)] {
        let text = format!(
            "[ground]\npoints = {{ O = [0, 0], C = [1, 0] }}\n[link.crank]\npoints = {{ O = 0, A = {crank} }}\n\
             [link.coupler]\npoints = {{ A = 0, B = {coupler} }}\n\
             [link.rocker]\npoints = {{ B = 0, C = {rocker} }}\n[input]\nlink = \"crank\"\nfrom = 1\npositions = 12\n",
            rocker = 1.0 + crank - coupler,
        );
        let linkage = Linkage::compile(assur_scene::read("four-bar", &text).unwrap()).unwrap();
        assert!(linkage.change_points().count() > 0, "{crank} {coupler}");
        for seed in 0..8 {
            let [solved, _] = compare_all(&linkage, seed);
            assert!(solved > 0);
        }
    }
}
