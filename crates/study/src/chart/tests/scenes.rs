//! Charts of the shipped scenes.

use std::ops::ControlFlow;

use assur_all as _;
use assur_kinematics::Linkage;

use crate::chart::{ChartData, Clock, Options, Row, Stage, chart};

/// A clock that goes a fixed step each time it is read.
pub(super) struct Ticks(f64);

impl Clock for Ticks {
    fn seconds(&mut self) -> f64 {
        self.0 += 1e-3;
        self.0
    }
}

/// A shipped scene, compiled.
pub(super) fn shipped(name: &str) -> Linkage {
    let path = format!("{}/../../fixtures/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap();
    let mechanism = assur_scene::read(&path, &text).unwrap();
    Linkage::compile(mechanism).unwrap()
}

/// Every setting, each timed once.
pub(super) fn charted(name: &str) -> ChartData {
    let options = Options { rounds: 1, stage_seconds: 0.0, ..Options::THOROUGH };
    let mut go_on = |_| ControlFlow::Continue(());
    chart(&shipped(name), &mut Ticks(0.0), options, &mut go_on).unwrap()
}

pub(super) fn rows<'a>(data: &'a ChartData, stage: Stage, method: &str) -> Vec<&'a Row> {
    data.of(stage).filter(|row| row.method == method).collect()
}

#[test]
fn look() {
    for name in ["shaper", "press", "slider-crank", "n-four-bar-2", "andrews"] {
        let data = charted(name);
        println!("{}", crate::chart::text(&data, true));
    }
}
