//! One position of shipped mechanisms: PF0 alone, with PF1, with PF2; compiling; eight positions in lanes.

use assur_all as _;
use assur_group::Order;
use assur_kinematics::Linkage;
use assur_number::Lanes;

fn main() {
    divan::main();
}

fn scene(name: &str) -> assur_mechanism::Mechanism {
    let path = format!("{}/../../fixtures/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("a shipped scene");
    assur_scene::read(name, &text).expect("a good scene")
}

const SCENES: [&str; 4] = ["shaper", "slider-crank", "andrews", "conveyor"];

fn position(bencher: divan::Bencher, name: &str, order: Order) {
    let linkage = Linkage::compile(scene(name)).expect("a good mechanism");
    let mut position = linkage.position();
    let mut q = 0.3;
    bencher.bench_local(|| {
        q += 0.01;
        linkage.solve(divan::black_box(q), order, &mut position).is_ok()
    });
}

#[divan::bench(args = SCENES)]
fn pf0(bencher: divan::Bencher, name: &str) {
    position(bencher, name, Order::Place);
}

#[divan::bench(args = SCENES)]
fn pf0_pf1(bencher: divan::Bencher, name: &str) {
    position(bencher, name, Order::First);
}

#[divan::bench(args = SCENES)]
fn pf0_pf1_pf2(bencher: divan::Bencher, name: &str) {
    position(bencher, name, Order::Second);
}

#[divan::bench(args = SCENES)]
fn eight_in_lanes(bencher: divan::Bencher, name: &str) {
    let linkage = Linkage::compile(scene(name)).expect("a good mechanism");
    let mut position = linkage.lane_position();
    let mut q = 0.3;
    bencher.bench_local(|| {
        q += 0.08;
        let coordinates = Lanes::of(|lane| q + 0.01 * lane as f64);
        linkage.solve_lanes(divan::black_box(coordinates), Order::Second, &mut position).is_ok()
    });
}

#[divan::bench(args = SCENES)]
fn compile(bencher: divan::Bencher, name: &str) {
    let mechanism = scene(name);
    bencher.bench_local(|| Linkage::compile(mechanism.clone()).is_ok());
}
