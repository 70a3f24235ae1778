//! Whole scenes.

use assur_all as _;
use assur_force::Loads;
use assur_kinematics::Linkage;
use assur_mechanism::Mechanism;

mod cases;
mod energy;
mod friction;
mod known;
mod loads;
mod settled;
mod steady;
mod steps;
mod switches;
mod transient;
mod unevenness;
mod unmet;
mod wishes;

pub(crate) fn read(text: &str) -> Mechanism {
    assur_scene::read("test.toml", text).unwrap()
}

pub(crate) fn compiled(text: &str) -> (Linkage, Loads) {
    let linkage = Linkage::compile(read(text)).unwrap();
    let loads = Loads::compile(&linkage).unwrap();
    (linkage, loads)
}
