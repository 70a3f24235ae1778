//! `assur geometry`.

use std::path::PathBuf;

use assur_mechanism::GROUND;
use assur_report::{csv, json, text};
use clap::Args;

use super::fault::{Fault, Status};
use super::options::Format;
use super::output::Output;
use super::scene;
use super::style::Style;
use super::verdict::Verdict;

/// Arguments of `geometry`.
#[derive(Debug, Clone, Args)]
pub(crate) struct GeometryArgs {
    /// Scene file
    scene: PathBuf,
    /// Link from which centers and centrodes are seen [default: the ground]
    #[arg(long, value_name = "LINK")]
    against: Option<String>,
    /// Form of the results; csv: the table over the positions
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub(crate) fn run(args: &GeometryArgs, style: Style) -> Result<Status, Fault> {
    let path = &args.scene;
    let output = Output::of(args.output.as_deref(), path)?;
    let linkage = scene::linkage(path, style)?;
    let against = match &args.against {
        None => GROUND,
        Some(name) => linkage.mechanism.link(name).ok_or_else(|| {
            let names: Vec<_> = linkage.mechanism.links.iter().map(|link| link.name.as_str()).collect();
            Fault::other(format!("`--against {name}`: the scene has no such link, only {}", names.join(", ")))
        })?,
    };
    let verdict = Verdict::of_positions(&linkage, path, style);
    verdict.tell(style);
    let found = match assur_geometry::geometry(&linkage, against) {
        Ok(found) => found,
        Err(error) => {
            style.tell(&format!("error: {}: {error}", path.display()));
            return Ok(Status::Failed);
        }
    };
    let text = match args.format {
        Format::Text => text::geometry(&found, style.words()).map_err(Fault::other)?,
        Format::Json => json::to_json(&found, style.ascii).map_err(Fault::other)?,
        Format::Csv => csv::geometry(&found, style.ascii).map_err(Fault::other)?,
    };
    output.write(text, verdict.status()).map(|()| verdict.status())
}
