//! Known values, closing, independent sums.

mod causes;
mod closing;
mod friction;
mod known;
mod press;
mod words;

use assur_all as _;
use assur_force::{ForceAnalyzer, LoadState, Loads, Reactions, find};
use assur_group::Order;
use assur_kinematics::{Linkage, Position};

pub(super) const SCENES: [&str; 7] =
    ["shaper", "guide-shaper", "conveyor", "stephenson3", "press", "slider-crank", "four-bar"];

pub(super) fn fixture(name: &str) -> String {
    let path = format!("{}/../../fixtures/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).unwrap()
}

pub(super) fn compile(scene: &str) -> Linkage {
    let mechanism = assur_scene::read("test.toml", scene).unwrap_or_else(|errors| panic!("{errors}"));
    Linkage::compile(mechanism).unwrap()
}

pub(super) fn analyzer(name: &str) -> &'static dyn ForceAnalyzer {
    find(name).unwrap().instance
}

/// A state that shows every part, whatever the motion of the scene.
pub(super) fn state(linkage: &Linkage, coordinate: f64) -> LoadState {
    LoadState { speed: 3.0, acceleration: -4.0, ..LoadState::prescribed(&linkage.mechanism, coordinate) }
}

pub(super) fn solved(linkage: &Linkage, coordinate: f64) -> Position {
    let mut position = linkage.position();
    linkage.solve(coordinate, Order::Second, &mut position).unwrap();
    position
}

pub(super) fn reactions(
    linkage: &Linkage,
    loads: &Loads,
    state: &LoadState,
    position: &Position,
) -> Option<Reactions> {
    let mut wrenches = loads.total(state, &position.bodies);
    let mut out = Reactions::new(linkage);
    analyzer("newton-euler").solve(linkage, position, &mut wrenches, &mut out).ok()?;
    Some(out)
}

/// Every fixture and some random mechanisms, each with the coordinates of its positions.
pub(super) fn all() -> Vec<(String, Linkage)> {
    let mut list: Vec<_> = SCENES.map(|name| (name.to_owned(), compile(&fixture(name)))).into();
    for seed in 0..30 {
        let groups = 1 + usize::try_from(seed % 4).unwrap();
        if let Some(specimen) = assur_testkit::specimen::Recipe::of(groups).specimen(seed) {
            list.push((format!("random {seed}"), Linkage::compile(specimen.mechanism).unwrap()));
        }
    }
    assert!(list.len() > 25);
    list
}
