//! `assur explain`.

use assur_analysis::methods;
use assur_plan::{Plan, explain};
use assur_structure::Structure;

use super::args::SceneArgs;
use super::fault::{Fault, Status};
use super::style::Style;
use super::{output, scene};

pub(crate) fn run(args: &SceneArgs, style: Style) -> Result<Status, Fault> {
    let options = scene::options(&args.methods)?;
    let mechanism = scene::read(&args.scene, style)?;
    let structure =
        Structure::of(&mechanism).map_err(|error| scene::in_file(&args.scene, &error.to_string()))?;
    let plan = Plan::of(&mechanism, &structure, &methods(&mechanism, &options));
    output::print(&style.text(&explain(&mechanism, &structure, &plan)))?;
    Ok(Status::Done)
}
