//! Reduction to the input link, what it takes beyond the position; and compiling loads with a stroke.

use assur_all as _;
use assur_force::{Loads, Side, State};
use assur_group::Order;
use assur_kinematics::Linkage;
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

const SCENES: [&str; 4] = ["andrews", "shaper", "slider-crank", "conveyor"];

fn compiled(name: &str) -> (Linkage, Loads) {
    let path = format!("{}/../../fixtures/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("a shipped scene");
    let linkage = Linkage::compile(assur_scene::read(name, &text).expect("a good scene")).expect("a linkage");
    let loads = Loads::compile(&linkage).expect("good loads");
    (linkage, loads)
}

const STATE: State =
    State { coordinate: 0.3, speed: 2.0, acceleration: 0.0, time: 0.1, side: Side::Prescribed };

#[divan::bench(args = SCENES)]
fn live(bencher: Bencher, name: &str) {
    let (linkage, loads) = compiled(name);
    let mut position = linkage.position();
    linkage.solve(STATE.coordinate, Order::Second, &mut position).expect("a position");
    bencher.bench_local(|| loads.reduced(black_box(&STATE), black_box(&position.bodies)));
}

#[divan::bench(args = SCENES)]
fn in_phase(bencher: Bencher, name: &str) {
    let (linkage, loads) = compiled(name);
    let mut position = linkage.position();
    linkage.solve(STATE.coordinate, Order::Second, &mut position).expect("a position");
    let mut phase = loads.phase();
    loads.enter(&STATE, &mut phase);
    bencher.bench_local(|| loads.reduced_in_phase(&phase, black_box(&STATE), black_box(&position.bodies)));
}

#[divan::bench(args = SCENES)]
fn compile(bencher: Bencher, name: &str) {
    let (linkage, _) = compiled(name);
    bencher.bench_local(|| Loads::compile(black_box(&linkage)));
}
