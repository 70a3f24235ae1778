//! `assur draw` and `assur report`: the picture of a view, and the explanatory note with all of them, as files.

use std::io::Write;
use std::path::PathBuf;

use assur_analysis::Options;
use assur_note::Form;
use assur_picture::Results;
use assur_words::{Language, name, text};
use clap::Args;

use super::fault::{Fault, Status};
use super::options::SceneArgs;
use super::output::Output;
use super::scene;
use super::style::Style;
use crate::progress::ProgressLine;
use crate::session::Session;
use crate::still::{self, PictureArgs, StillError};
use crate::verdict::Verdict;

#[derive(Debug, Clone, Args)]
pub(crate) struct DrawArgs {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    request: PictureArgs,
    /// File to write; its ending chooses the form: .svg, .png, or .dxf (planes alone, 1 unit is 1 mm)
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

/// The results of a scene; what they lack, and what is probably not meant in it, is told.
pub(super) fn analyzed(
    session: &Session,
    options: &Options,
    checks: bool,
    style: Style,
) -> Result<(Results, Verdict), Fault> {
    let line = ProgressLine::new(style.language);
    let results = session.analyzed(options, checks, &mut line.watch()).map_err(Fault::Scene)?;
    drop(line);
    let mut verdict = Verdict::default();
    if let Some(found) = &results.found {
        scene::warn_of_motion(session, found.plans.calculation(), style)?;
        verdict = Verdict::of(&found.analysis, found.plans.calculation(), Some(session));
    }
    verdict.tell(style);
    Ok((results, verdict))
}

pub(crate) fn draw(args: &DrawArgs, style: Style) -> Result<Status, Fault> {
    let output = Output::of(Some(&args.output), &args.scene.scene)?;
    let options = scene::options(&args.scene.methods, false)?;
    let session = scene::open(&args.scene.scene, style)?;
    let (results, verdict) = analyzed(&session, &options, args.request.shows_checks(), style)?;
    match still::draw(&results, &args.request, &args.output, style.language) {
        Ok(content) => output.write(content, verdict.status()),
        Err(StillError::Nothing(why)) => {
            style.tell(text!("cli-nothing-to-draw", reason = why));
            Ok(Status::Failed)
        }
        Err(StillError::Request(problem)) => Err(Fault::Other(problem)),
    }
}

#[derive(Debug, Clone, Args)]
pub(crate) struct ReportArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// File to write; its ending chooses the form: .html, .pdf and .typ are one file with all figures in it, .md has its
    /// figures in a folder beside it
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

/// The note is in the language that is asked for, or else in that of the scene.
pub(crate) fn report(args: &ReportArgs, language: Option<&str>, style: Style) -> Result<Status, Fault> {
    let path = &args.scene.scene;
    let output = Output::of(Some(&args.output), path)?;
    let ending = args.output.extension().unwrap_or_default().to_string_lossy().into_owned();
    let form = Form::of(&ending);
    if form.is_none() && !ending.eq_ignore_ascii_case("pdf") {
        let file = name(args.output.display().to_string());
        return Err(Fault::Other(text!("cli-note-ending", file)));
    }
    let options = scene::options(&args.scene.methods, false)?;
    let session = scene::open(path, style)?;
    let mut note = session.note.clone();
    if let Some(language) = language.and_then(Language::find) {
        note.language = Some(language.code);
    }
    let (results, verdict) = analyzed(&session, &options, true, style)?;
    let status = verdict.proved();
    let stem = args.output.file_stem().unwrap_or_default().to_string_lossy();
    let figures = format!("{stem}-figures");
    let line = ProgressLine::new(style.language);
    let Some(form) = form else {
        let written = assur_note::pdf(&results, &note).map_err(Fault::Other)?;
        drop(line);
        return output.write(written, status);
    };
    let written = assur_note::write(&results, &note, form, &figures).map_err(Fault::Other)?;
    drop(line);
    if !written.figures.is_empty() {
        let folder = args.output.with_file_name(&figures);
        let names: Vec<&str> = written.figures.iter().map(|(name, _)| name.as_str()).collect();
        Output::of(Some(&folder), path)?.write_folder(status, &names, &names, |files| {
            let mut all = files.iter_mut().zip(&written.figures);
            all.try_for_each(|(file, (_, drawn))| file.write_all(drawn.as_bytes()))
        })?;
    }
    output.write(written.text, status)
}
