//! Writes `docs/accuracy.md`: speed versus accuracy of every method on every shipped scene.

mod chapter;
mod summary;
mod units;

use std::ops::ControlFlow;
use std::time::Instant;

use assur_all as _;
use assur_kinematics::Linkage;
use assur_study::chart::{ChartData, ChartOptions, chart};

/// A thorough chart of a shipped scene, or why there is none.
fn charted(text: &str, name: &str) -> Result<ChartData, String> {
    let mechanism = assur_scene::read(name, text).map_err(|error| error.to_string())?;
    let linkage = Linkage::compile(mechanism).map_err(|error| error.to_string())?;
    let start = Instant::now();
    let go_on = &mut |_| ControlFlow::Continue(());
    chart(&linkage, &mut || start.elapsed().as_secs_f64(), ChartOptions::THOROUGH, go_on)
        .map_err(|error| error.to_string())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut scenes = assur_fixtures::SCENES.to_vec();
    scenes.sort_unstable();
    let (mut charts, mut chapters) = (Vec::new(), String::new());
    for (name, text) in scenes {
        let data = charted(text, name)?;
        chapters += &chapter::chapter(&data, &format!("fixtures/{name}.toml"));
        charts.push(data);
    }
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/accuracy.md");
    std::fs::write(path, summary::summary(&charts, &chapters))?;
    Ok(())
}
