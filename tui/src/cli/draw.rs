//! `assur draw`: the picture of a view as a file.

use std::path::PathBuf;
use std::sync::Arc;

use assur_words::text;
use clap::Args;

use super::fault::{Fault, Status};
use super::options::SceneArgs;
use super::output::Output;
use super::scene;
use super::style::Style;
use crate::screen::still::{self, PictureArgs, StillError};
use crate::verdict::Verdict;

/// Arguments of `draw`.
#[derive(Debug, Clone, Args)]
pub(crate) struct DrawArgs {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    request: PictureArgs,
    /// File to write; its ending chooses the form: .svg or .png
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

pub(crate) fn run(args: &DrawArgs, style: Style) -> Result<Status, Fault> {
    let output = Output::of(Some(&args.output), &args.scene.scene)?;
    let options = scene::options(&args.scene.methods, false)?;
    let session = Arc::new(scene::open(&args.scene.scene, style)?);
    let state = still::analyzed(&session, options, args.request.shows_checks(), style.language)
        .map_err(Fault::Scene)?;
    scene::doubt_of_state(&state, &session, style)?;
    let verdict = Verdict::of_state(&state, &session);
    verdict.tell(style);
    match still::draw(state, &args.request, &args.output) {
        Ok(content) => output.write(content, verdict.status()),
        Err(StillError::Nothing(why)) => {
            style.tell(text!("cli-nothing-to-draw", reason = why));
            Ok(Status::Failed)
        }
        Err(StillError::Request(problem)) => Err(Fault::Other(problem)),
    }
}
