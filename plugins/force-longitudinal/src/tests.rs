//! Agreement with Newton-Euler and with the print, and the positions where the print fails.

mod agreement;
mod construction;
mod press;
mod presses;
mod print;
mod refusals;
mod working;

use assur_force::{ForceAnalyzer, ForceError, LoadState, Loads, Reactions};
use assur_group::Order;
use assur_group_rpr as _;
use assur_group_rrp as _;
use assur_group_rrr as _;
use assur_kinematics::{Linkage, Position};

pub(super) fn compile(scene: &str) -> Linkage {
    let mechanism = assur_scene::read("test.toml", scene).unwrap_or_else(|errors| panic!("{errors}"));
    Linkage::compile(mechanism).unwrap()
}

pub(super) fn fixture(name: &str) -> String {
    let path = format!("{}/../../fixtures/{name}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).unwrap()
}

/// A position with all loads and inertia loads.
pub(super) fn loaded(linkage: &Linkage, coordinate: f64) -> (Position, Vec<assur_group::Wrench<f64>>) {
    let loads = Loads::compile(linkage).unwrap();
    let mut position = linkage.position();
    linkage.solve(coordinate, Order::Second, &mut position).unwrap();
    let state = LoadState::prescribed(&linkage.mechanism, coordinate);
    let mut wrenches = vec![assur_group::Wrench::ZERO; linkage.structure.links];
    loads.evaluate(&state, &position.bodies, &mut wrenches);
    (position, wrenches)
}

pub(super) fn reactions(
    analyzer: &dyn ForceAnalyzer,
    linkage: &Linkage,
    coordinate: f64,
) -> Result<Reactions, ForceError> {
    let (position, mut wrenches) = loaded(linkage, coordinate);
    let mut out = Reactions::new(linkage);
    analyzer.solve(linkage, &position, &mut wrenches, &mut out)?;
    Ok(out)
}

/// Greatest difference of forces over the greatest force (moments per the typical length).
pub(super) fn difference(linkage: &Linkage, one: &Reactions, two: &Reactions) -> f64 {
    let length = linkage.structure.scale;
    let flat = |r: &Reactions| {
        let pairs = r.pairs.iter().flat_map(|w| [w.fx, w.fy, w.m / length]).collect::<Vec<_>>();
        [pairs, vec![r.balancing / length]].concat()
    };
    let (one, two) = (flat(one), flat(two));
    let greatest = two.iter().fold(1e-9_f64, |g, v| g.max(v.abs()));
    one.iter()
        .zip(&two)
        .map(|(a, b)| (a - b).abs() / greatest)
        .fold(0.0, |g, d| if d.is_nan() { d } else { g.max(d) })
}
