//! `assur sheet`: the drawing sheet as a file, or as many as it has sheets.

use std::path::{Path, PathBuf};

use assur_sheet::Form;
use assur_words::{Language, name, text};
use clap::Args;

use super::draw::analyzed;
use super::fault::{Fault, Status};
use super::options::SceneArgs;
use super::output::Output;
use super::scene;
use super::style::Style;

#[derive(Debug, Clone, Args)]
pub(crate) struct SheetArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// File to write; its ending chooses the form: .pdf has all sheets, .svg and .dxf one each, the second beside the first as
    /// NAME-2
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

/// The sheet is in the language that is asked for, or else in that of the scene.
pub(crate) fn sheet(args: &SheetArgs, language: Option<&str>, style: Style) -> Result<Status, Fault> {
    let path = &args.scene.scene;
    let ending = args.output.extension().unwrap_or_default().to_string_lossy().into_owned();
    let form = Form::of(&ending)
        .ok_or_else(|| text!("cli-sheet-ending", file = name(args.output.display().to_string())))
        .map_err(Fault::Other)?;
    let options = scene::options(&args.scene.methods, false)?;
    let session = scene::open(path, style)?;
    let (results, verdict) = analyzed(&session, &options, false, style)?;
    let note = &session.note;
    let language = language.or(note.language).and_then(Language::find).unwrap_or(style.language);
    let pages = assur_sheet::sheet(&results, note, language).map_err(Fault::Other)?;
    let files = form.write(&results.linkage.mechanism.title, &pages).map_err(Fault::Other)?;
    let names: Vec<PathBuf> = (0..files.len()).map(|number| numbered(&args.output, number)).collect();
    let outputs = names.iter().map(|name| Output::of(Some(name), path));
    let outputs = outputs.collect::<Result<Vec<_>, _>>()?;
    for (output, content) in outputs.into_iter().zip(files) {
        output.write(content, verdict.status())?;
    }
    Ok(verdict.status())
}

/// The file of a sheet, counted from 0: `sheet.svg`, `sheet-2.svg`.
fn numbered(path: &Path, sheet: usize) -> PathBuf {
    if sheet == 0 {
        return path.to_owned();
    }
    let [stem, ending] =
        [path.file_stem(), path.extension()].map(|part| part.unwrap_or_default().to_string_lossy());
    path.with_file_name(format!("{stem}-{}.{ending}", sheet + 1))
}
