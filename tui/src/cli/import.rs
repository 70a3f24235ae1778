//! `assur import`: a scene of a drawing of another program.

use std::path::{Path, PathBuf};

use assur_import::Source;
use assur_scene::{Dimension, quantity};
use assur_words::{Describe, joined, name, text};
use clap::Args;

use super::fault::{Fault, Status};
use super::output::Output;
use super::style::Style;
use crate::files;

#[derive(Debug, Clone, Args)]
pub(crate) struct ImportArgs {
    /// File of a drawing, or a link to one
    #[arg(value_name = "FILE_OR_LINK")]
    drawing: PathBuf,
    /// Format of the drawing, as `assur plugins` names its importer (default: told by its ending or beginning)
    #[arg(long, value_name = "NAME")]
    format: Option<String>,
    /// What one unit of the drawing's coordinates is, for example "1 mm" (default: as the format says)
    #[arg(long, value_name = "LENGTH")]
    unit: Option<String>,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// What could not be said is told; the scene is written all the same, but not over a file.
pub(crate) fn run(args: &ImportArgs, style: Style) -> Result<Status, Fault> {
    let output = Output::of(args.output.as_deref(), &args.drawing)?;
    let link = args
        .drawing
        .to_str()
        .filter(|link| link.contains("://") || !args.drawing.exists() && link.contains('?'));
    let bytes = match link {
        Some(link) => link.as_bytes().to_owned(),
        None => files::read_bytes(&args.drawing)?,
    };
    let unit = args.unit.as_deref().map(length).transpose()?;
    let file = args.drawing.file_name().filter(|_| link.is_none()).unwrap_or_default().to_string_lossy();
    let source = Source { file: &file, bytes: &bytes, unit };
    let shown = link.map_or_else(|| args.drawing.display().to_string(), shortened);
    let imported = assur_import::import(&source, args.format.as_deref(), style.language)
        .map_err(|problem| Fault::Scene(text!("cli-error-in", file = name(shown), problem)))?;
    let mut status = Status::Done;
    for lost in &imported.lost {
        style.tell(text!("cli-import-lost", what = lost));
        status = Status::Failed;
    }
    let target = args.output.as_deref().unwrap_or(Path::new("-")).display().to_string();
    if let Err(errors) = assur_scene::read(&target, &imported.scene) {
        style.tell(joined("\n", [text!("cli-import-unread"), errors.describe()]));
        status = Status::Failed;
    }
    output.write(&imported.scene, status)
}

/// The beginning of a link: the rest is of no use to a reader.
fn shortened(link: &str) -> String {
    const MOST: usize = 60;
    let mut shown: String = link.chars().take(MOST).collect();
    if shown.len() < link.len() {
        shown.push('…');
    }
    shown
}

fn length(text: &str) -> Result<f64, Fault> {
    let found = quantity(text, Dimension::Length).map_err(Fault::other)?;
    if found > 0.0 {
        Ok(found)
    } else {
        Err(Fault::Other(text!("cli-import-unit", unit = name(text.to_owned()))))
    }
}
