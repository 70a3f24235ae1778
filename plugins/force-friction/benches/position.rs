//! What friction in all pairs adds to a position of the shaper: positions with PF1 and PF2, loads and reactions, one by one and
//! eight at once. Medians of short rounds in turns.

#![expect(clippy::unwrap_used, reason = "a bench that can't run says so")]

use std::hint::black_box;
use std::time::Instant;

use assur_all as _;
use assur_force::{Kinetostatics, LaneKinetostatics, LoadState, Loads, find};
use assur_group::Order;
use assur_kinematics::Linkage;
use assur_number::Lanes;

const ROUNDS: usize = 2001;
const POSITIONS: usize = 64;

/// Seconds for a position, one by one or in lanes, each time it is called.
fn timed<'a>(
    linkage: &'a Linkage,
    loads: &'a Loads,
    (method, certificates): (&str, bool),
    lanes: bool,
) -> impl FnMut() -> f64 {
    let carrying = vec![true; linkage.groups().len()];
    let single = Kinetostatics::new(linkage, loads, find(method).unwrap().instance, &carrying);
    let mut single = if certificates { single } else { single.without_certificates() };
    let mut eight = LaneKinetostatics::new(single.clone());
    let (mut position, mut together) = (linkage.position(), linkage.lane_position());
    let coordinate = |index: usize| (index * 37 % POSITIONS) as f64 * 0.098;
    move || {
        let start = Instant::now();
        if lanes {
            for block in 0..POSITIONS / Lanes::WIDTH {
                let at = Lanes::of(|lane| coordinate(block * Lanes::WIDTH + lane));
                linkage.solve_lanes(at, Order::Second, &mut together).unwrap();
                let states = at.0.map(|q| LoadState::prescribed(&linkage.mechanism, q));
                eight.solve(&states, &together).unwrap();
                black_box(&eight.reactions.balancing);
            }
        } else {
            for q in (0..POSITIONS).map(coordinate) {
                linkage.solve(q, Order::Second, &mut position).unwrap();
                single.solve(&LoadState::prescribed(&linkage.mechanism, q), &position).unwrap();
                black_box(&single.reactions.balancing);
            }
        }
        start.elapsed().as_secs_f64() / POSITIONS as f64
    }
}

fn main() {
    let path = format!("{}/../../fixtures/shaper-friction.toml", env!("CARGO_MANIFEST_DIR"));
    let mut mechanism = assur_scene::read("shaper", &std::fs::read_to_string(path).unwrap()).unwrap();
    let with_friction = Linkage::compile(mechanism.clone()).unwrap();
    mechanism.frictions.clear();
    let ideal = Linkage::compile(mechanism).unwrap();
    let [rubbing, smooth] = [&with_friction, &ideal].map(|linkage| Loads::compile(linkage).unwrap());
    for lanes in [false, true] {
        let mut without = timed(&ideal, &smooth, ("groups", false), lanes);
        let mut with = [false, true]
            .map(|certificates| timed(&with_friction, &rubbing, ("coulomb", certificates), lanes));
        let mut times = [Vec::new(), Vec::new(), Vec::new()];
        for _ in 0..ROUNDS {
            times[0].push(without());
            times[1].push(with[0]());
            times[2].push(with[1]());
        }
        let [without, with, certified] = times.map(|mut all| {
            all.sort_by(f64::total_cmp);
            all[ROUNDS / 2] * 1e9
        });
        let how = if lanes { "eight at once" } else { "one by one" };
        println!(
            "{how}: {without:.0} ns without friction, {with:.0} ns with, {:.2} times; {certified:.0} ns with certificates, {:.2} times",
            with / without,
            certified / without
        );
    }
}
