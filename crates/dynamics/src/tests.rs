//! Whole scenes.

use assur_all as _;
use assur_force::Loads;
use assur_integrator_closed_form as _;
use assur_integrator_dormand_prince as _;
use assur_integrator_energy as _;
use assur_integrator_radau as _;
use assur_integrator_runge_kutta as _;
use assur_integrator_uniform as _;
use assur_kinematics::Linkage;
use assur_mechanism::Mechanism;

mod steady;
mod transient;

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
