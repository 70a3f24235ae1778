//! Whole scenes.

use assur_all as _;
use assur_force::Loads;
use assur_kinematics::Linkage;
use assur_mechanism::Mechanism;

mod energy;
mod loads;
mod settled;
mod steady;
mod transient;
mod wishes;

/// A scene of the folder of fixtures.
pub(crate) fn fixture(name: &str) -> String {
    let path = format!("{}/../../fixtures/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).unwrap()
}

pub(crate) fn read(text: &str) -> Mechanism {
    assur_scene::read("test.toml", text).unwrap()
}

pub(crate) fn compiled(text: &str) -> (Linkage, Loads) {
    let linkage = Linkage::compile(read(text)).unwrap();
    let loads = Loads::compile(&linkage).unwrap();
    (linkage, loads)
}
