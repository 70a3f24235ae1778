//! `assur draw`: the picture of a view as a file.

use std::path::PathBuf;

use clap::Args;
use clap::builder::PossibleValuesParser;

use super::fault::{Fault, Status};
use super::options::SceneArgs;
use super::output::Output;
use super::scene;
use super::style::Style;
use crate::screen::still::{self, Request, StillError};

/// Arguments of `draw`.
#[derive(Debug, Clone, Args)]
pub(crate) struct DrawArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// View of the terminal UI that is drawn
    #[arg(long, value_name = "NAME", default_value = "mechanism",
          value_parser = PossibleValuesParser::new(still::views()))]
    view: String,
    /// Part of the view: forces, velocities, accelerations, construction (plans); overview, causes, curves, hodograph
    /// (forces); overview, course, iteration (motion); overview, curves, energy-mass, inertia, reduction (drive)
    #[arg(long, value_name = "NAME")]
    part: Option<String>,
    /// Quantity, pair or link that is shown, found as by `/` in the terminal UI
    #[arg(long, value_name = "NAME")]
    show: Option<String>,
    /// Position that is drawn
    #[arg(long, value_name = "N", default_value_t = 0)]
    position: usize,
    /// Width and height of the page in mm (png: 10 pixels a mm), for example 160x120
    #[arg(long, value_name = "WxH", value_parser = page)]
    size: Option<[f64; 2]>,
    /// Let the drawing move through all positions (svg)
    #[arg(long)]
    animate: bool,
    /// File to write; its ending chooses the form: .svg or .png
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

/// Sides of a page, mm.
const SIDES: std::ops::RangeInclusive<f64> = 20.0..=2000.0;

fn page(text: &str) -> Result<[f64; 2], String> {
    let side = |text: &str| text.parse().ok().filter(|side| SIDES.contains(side));
    let sides =
        text.split_once(['x', 'X', '×']).and_then(|(width, height)| Some([side(width)?, side(height)?]));
    sides.ok_or_else(|| {
        format!("a size is two numbers of {} to {} mm, as in 160x120", SIDES.start(), SIDES.end())
    })
}

pub(crate) fn run(args: &DrawArgs, style: Style) -> Result<Status, Fault> {
    let output = Output::of(Some(&args.output), &args.scene.scene)?;
    scene::options(&args.scene.methods)?;
    let request = Request {
        view: args.view.clone(),
        part: args.part.clone(),
        show: args.show.clone(),
        position: args.position,
        size: args.size,
        animate: args.animate,
        analyzer: args.scene.methods.analyzer.clone(),
        integrator: args.scene.methods.integrator.clone(),
    };
    match still::draw(args.scene.scene.clone(), &request, &args.output) {
        Ok(content) => output.write(content, Status::Done).map(|()| Status::Done),
        Err(StillError::Nothing(why)) => {
            style.tell(&format!("error: there is nothing to draw: {why}"));
            Ok(Status::Failed)
        }
        Err(StillError::Scene(error)) => Err(error.into()),
        Err(error @ StillError::Request(_)) => Err(Fault::Scene(error.to_string())),
    }
}
