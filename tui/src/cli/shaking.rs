//! `assur shaking`.

use std::path::PathBuf;

use assur_report::{csv, json, text};
use assur_words::Describe;
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
    let verdict = scene::verdict(&calculation, path, style)?;
    verdict.tell(style);
    if calculation.no_motion.is_some() {
        return Ok(verdict.status());
    }
    let found = match assur_shaking::shaking(&calculation.linkage, &|q| calculation.state(q)) {
        Ok(found) => found,
        Err(error) => {
            let key = error.key(&calculation.linkage.mechanism);
            let located = key.and_then(|key| scene::at_key(path, &key, &error.to_string()));
            let fault = located.unwrap_or_else(|| scene::in_file(path, error.describe()));
            if !error.is_no_solution() {
                return Err(fault);
            }
            style.tell(fault.describe());
            return Ok(Status::Failed);
        }
    };
    let text = match args.format {
        Format::Text => text::shaking(&found, style.words()).map_err(Fault::other)?,
        Format::Json => json::to_json(&found, style.ascii).map_err(Fault::other)?,
        Format::Csv => csv::shaking(&found, style.ascii).map_err(Fault::other)?,
    };
    output.write(text, verdict.status()).map(|()| verdict.status())
}
