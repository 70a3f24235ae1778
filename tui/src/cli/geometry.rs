//! `assur geometry`.

use std::path::PathBuf;

use assur_mechanism::GROUND;
use assur_report::{csv, json, text as report};
use assur_words::{self as words, Describe, text};
use clap::Args;

use super::fault::{Fault, Status};
use super::options::Format;
use super::output::Output;
use super::scene;
use super::style::Style;
use crate::verdict::Verdict;

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
    let session = scene::open(path, style)?;
    let linkage = scene::linkage(&session)?;
    let against = match &args.against {
        None => GROUND,
        Some(name) => linkage.mechanism.link(name).ok_or_else(|| {
            let links = words::list(linkage.mechanism.links.iter().map(|link| (&link.name).into()));
            Fault::Other(text!("cli-no-such-link", link = words::name(name.clone()), links))
        })?,
    };
    let verdict = Verdict::of_positions(&linkage, &session);
    verdict.tell(style);
    let found = match assur_geometry::geometry(&linkage, against) {
        Ok(found) => found,
        Err(error) => {
            style.tell(session.in_file(error.describe()));
            return Ok(Status::Failed);
        }
    };
    let text = match args.format {
        Format::Text => report::geometry(&found, style.words()).map_err(Fault::told)?,
        Format::Json => json::to_json(&found, style.ascii).map_err(Fault::told)?,
        Format::Csv => csv::geometry(&found, style.ascii).map_err(Fault::told)?,
    };
    output.write(text, verdict.status()).map(|()| verdict.status())
}
