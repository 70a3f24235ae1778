//! Loads and force analysis of the shaper, one position after the other.

use assur_all as _;
use assur_force::{ForceAnalyzer, Loads, Reactions, State};
use assur_force_groups::Groups;
use assur_group::{Order, Wrench};
use assur_kinematics::{Linkage, Position};
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

/// The shaper in its first position.
fn shaper() -> (Linkage, Loads, Position) {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/shaper.toml");
    let text = std::fs::read_to_string(path).expect("the fixture stands in the repository");
    let mechanism = assur_scene::read("shaper.toml", &text).expect("the fixture is a scene");
    let linkage = Linkage::compile(mechanism).expect("the fixture is a linkage");
    let loads = Loads::compile(&linkage).expect("the fixture has loads");
    let mut position = linkage.position();
    linkage.solve(0.4, Order::Second, &mut position).expect("the shaper turns");
    (linkage, loads, position)
}

#[divan::bench(sample_size = 1000)]
fn loads_alone(bencher: Bencher) {
    let (linkage, loads, position) = shaper();
    let state = State::prescribed(&linkage.mechanism, 0.4);
    let mut wrenches = vec![Wrench::ZERO; linkage.structure.links];
    bencher.bench_local(|| {
        loads.evaluate(black_box(&state), &position.bodies, &mut wrenches);
        wrenches[1]
    });
}

#[divan::bench(sample_size = 1000)]
fn loads_and_reactions(bencher: Bencher) {
    let (linkage, loads, position) = shaper();
    let state = State::prescribed(&linkage.mechanism, 0.4);
    let mut wrenches = vec![Wrench::ZERO; linkage.structure.links];
    let mut out = Reactions::new(&linkage);
    bencher.bench_local(|| {
        loads.evaluate(black_box(&state), &position.bodies, &mut wrenches);
        Groups.solve(&linkage, &position, &mut wrenches, &mut out).is_ok()
    });
}
