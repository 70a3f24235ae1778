//! `assur shaking`.

use std::path::PathBuf;

use assur_force::LoadError;
use assur_report::{csv, json, text};
use assur_shaking::ShakingError;
use clap::Args;

use super::fault::{Fault, Status};
use super::options::{Format, SceneArgs};
use super::output::Output;
use super::scene;
use super::style::Style;

/// Arguments of `shaking`.
#[derive(Debug, Clone, Args)]
pub(crate) struct ShakingArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// Form of the results; csv: the table over the positions
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub(crate) fn run(args: &ShakingArgs, style: Style) -> Result<Status, Fault> {
    let path = &args.scene.scene;
    let output = Output::of(args.output.as_deref(), path)?;
    let calculation = scene::whole_study(&args.scene, style)?;
    if let Some(error) = &calculation.no_motion {
        style.tell(&scene::fault(path, error, style).to_string());
        return Ok(Status::Failed);
    }
    let found = match assur_shaking::shaking(&calculation.linkage, &|q| calculation.state(q)) {
        Ok(found) => found,
        Err(error @ ShakingError::Position(_)) => {
            style.tell(&format!("error: {}: {error}", path.display()));
            return Ok(Status::Failed);
        }
        Err(ShakingError::Load(error)) => {
            // A formula without a finite value somewhere in the cycle is no fault in how the scene is written.
            let no_solution = matches!(error, LoadError::NotFinite { .. });
            let fault = scene::fault(path, &error.into(), style);
            if !no_solution {
                return Err(fault);
            }
            style.tell(&fault.to_string());
            return Ok(Status::Failed);
        }
        Err(error) => return Err(scene::in_file(path, &error.to_string())),
    };
    let text = match args.format {
        Format::Text => text::shaking(&found, style.ascii).map_err(Fault::other)?,
        Format::Json => json::to_json(&found, style.ascii).map_err(Fault::other)?,
        Format::Csv => csv::shaking(&found, style.ascii).map_err(Fault::other)?,
    };
    output.write(text, Status::Done).map(|()| Status::Done)
}
