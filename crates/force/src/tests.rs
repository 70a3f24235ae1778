mod breaks;
mod curve;
mod errors;
mod formulas;
mod inertia;
mod kinds;
mod phases;
mod reduction;
mod strokes;

use assur_all as _;
use assur_group::{Body, Order, Wrench};
use assur_kinematics::Linkage;

use crate::{Cause, LoadState, Loads};

fn fixture(name: &str) -> String {
    let path = format!("{}/../../fixtures/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).unwrap()
}

fn linkage(text: &str) -> Linkage {
    Linkage::compile(assur_scene::read("test.toml", text).unwrap()).unwrap()
}

fn compiled(text: &str) -> (Linkage, Loads) {
    let linkage = linkage(text);
    let loads = Loads::compile(&linkage).unwrap();
    (linkage, loads)
}

fn bodies(linkage: &Linkage, q: f64) -> Vec<Body<f64>> {
    let mut position = linkage.position();
    linkage.solve(q, Order::Second, &mut position).unwrap();
    position.bodies
}

fn at(coordinate: f64, speed: f64) -> LoadState {
    LoadState { coordinate, speed, ..LoadState::default() }
}

/// All loads without the inertia loads.
fn applied(loads: &Loads, state: &LoadState, bodies: &[Body<f64>]) -> Vec<Wrench<f64>> {
    let mut sums = vec![Wrench::ZERO; bodies.len()];
    loads.by_cause(state, bodies, &mut |cause, link, Wrench { fx, fy, m }| {
        if !matches!(cause, Cause::Inertia(_)) {
            sums[link].add_at([0.0, 0.0], [fx, fy], m);
        }
    });
    sums
}

fn near(found: f64, wanted: f64, size: f64) {
    assert!((found - wanted).abs() <= 1e-12 * size.abs().max(1e-3), "{found} instead of {wanted}");
}
