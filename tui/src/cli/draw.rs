//! `assur draw`: the picture of a view as a file.

use std::path::PathBuf;

use assur_words::text;
use clap::Args;

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
    #[command(flatten)]
    request: Request,
    /// File to write; its ending chooses the form: .svg or .png
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

pub(crate) fn run(args: &DrawArgs, style: Style) -> Result<Status, Fault> {
    let output = Output::of(Some(&args.output), &args.scene.scene)?;
    scene::options(&args.scene.methods)?;
    let methods = [args.scene.methods.analyzer.clone(), args.scene.methods.integrator.clone()];
    let state = still::analyzed(
        still::open(args.scene.scene.clone())?,
        methods,
        args.request.shows_checks(),
        style.language,
    );
    let verdict = scene::verdict_of(&state, &args.scene, style)?;
    verdict.tell(style);
    match still::draw(state, &args.request, &args.output) {
        Ok(content) => output.write(content, verdict.status()).map(|()| verdict.status()),
        Err(StillError::Nothing(why)) => {
            style.tell(text!("cli-nothing-to-draw", reason = why));
            Ok(Status::Failed)
        }
        Err(StillError::Request(problem)) => Err(Fault::Other(problem)),
    }
}
