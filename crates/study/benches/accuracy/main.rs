//! Writes `docs/measured/accuracy.md` and `docs/measured/accuracy.svg`: speed versus accuracy of every method on every shipped scene.

mod chapter;
mod summary;
mod units;

use std::ops::ControlFlow;
use std::path::Path;
use std::time::Instant;

use assur_all as _;
use assur_figure::svg;
use assur_kinematics::Linkage;
use assur_study::chart::{ChartData, ChartOptions, chart, figure};
use assur_words::Language;

/// The scene whose chart is drawn, and width and height of the page, mm, as `assur chart -o` takes them.
const DRAWN: &str = "shaper";
const PAGE: [f64; 2] = [240.0, 200.0];

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
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/measured");
    let mut scenes = assur_fixtures::SCENES.to_vec();
    scenes.sort_unstable();
    let (mut charts, mut chapters) = (Vec::new(), String::new());
    for (name, text) in scenes {
        let data = charted(text, name)?;
        chapters += &chapter::chapter(&data, &format!("fixtures/{name}.toml"));
        if name == DRAWN {
            std::fs::write(docs.join("accuracy.svg"), svg::write(&figure(&data), PAGE, Language::english()))?;
        }
        charts.push(data);
    }
    std::fs::write(docs.join("accuracy.md"), summary::summary(&charts, &chapters))?;
    Ok(())
}
