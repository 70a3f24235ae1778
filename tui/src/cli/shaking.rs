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
    let options = scene::options(&args.scene.methods, true)?;
    let session = scene::open(path, style)?;
    let calculation = scene::calculation(&session, &options, style)?;
    let verdict = scene::verdict(&session, &calculation, style)?;
    verdict.tell(style);
    if calculation.no_motion.is_some() {
        return Ok(verdict.status());
    }
    let found = match assur_shaking::shaking(&calculation.linkage, &|q| calculation.state(q)) {
        Ok(found) => found,
        Err(error) => {
            let fault = session.fault_at(error.key(&session.mechanism), error.describe());
            if !error.is_no_solution() {
                return Err(Fault::Scene(fault));
            }
            style.tell(fault);
            return Ok(Status::Failed);
        }
    };
    let text = match args.format {
        Format::Text => text::shaking(&found, style.words()).map_err(Fault::told)?,
        Format::Json => json::to_json(&found, style.ascii).map_err(Fault::told)?,
        Format::Csv => csv::shaking(&found, style.ascii).map_err(Fault::told)?,
    };
    output.write(text, verdict.status()).map(|()| verdict.status())
}
