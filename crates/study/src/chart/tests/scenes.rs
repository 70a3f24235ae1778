//! Charts of the shipped scenes, for the other tests.

use std::ops::ControlFlow;

use assur_all as _;
use assur_kinematics::Linkage;

use crate::chart::{ChartData, ChartOptions, Measurement, Stage, chart};

/// A clock that goes a fixed step each time it is read: it never matters but for how often a run is repeated.
pub(super) fn ticks() -> impl FnMut() -> f64 {
    let mut now = 0.0;
    move || {
        now += 1e-3;
        now
    }
}

/// A shipped scene, compiled.
pub(super) fn shipped(name: &str) -> Linkage {
    Linkage::compile(assur_scene::read(name, assur_fixtures::scene(name)).unwrap()).unwrap()
}

/// Every setting, each timed a little.
pub(super) fn charted(name: &str) -> ChartData {
    charted_of(&shipped(name))
}

/// The chart of a mechanism with every setting, each timed a little.
pub(super) fn charted_of(linkage: &Linkage) -> ChartData {
    let options = ChartOptions { rounds: 1, stage_seconds: 0.0, max_steps: 20_000, ..ChartOptions::THOROUGH };
    chart(linkage, &mut ticks(), options, &mut |_| ControlFlow::Continue(())).unwrap()
}

/// The rows of a method.
pub(super) fn rows<'a>(data: &'a ChartData, stage: Stage, method: &str) -> Vec<&'a Measurement> {
    data.of(stage).filter(|row| row.method == method).collect()
}
