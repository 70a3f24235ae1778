//! `assur draw` and `assur report`: the picture of a view, and the explanatory note with all of them, as files.

use std::io::Write;
use std::path::PathBuf;
use std::sync::Arc;

use assur_analysis::Options;
use assur_note::{Form, NoteError, Written};
use assur_scene::Note;
use assur_words::{Describe, Language, Text, name, text};
use clap::Args;

use super::fault::{Fault, Status};
use super::options::SceneArgs;
use super::output::Output;
use super::scene;
use super::style::Style;
use crate::screen::state::State;
use crate::screen::still::{self, PictureArgs, StillError};
use crate::session::Session;
use crate::verdict::Verdict;

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

pub(crate) fn draw(args: &DrawArgs, style: Style) -> Result<Status, Fault> {
    let output = Output::of(Some(&args.output), &args.scene.scene)?;
    let options = scene::options(&args.scene.methods, false)?;
    let session = Arc::new(scene::open(&args.scene.scene, style)?);
    let mut state = still::analyzed(&session, options, args.request.shows_checks(), style.language)
        .map_err(Fault::Scene)?;
    scene::doubt_of_state(&state, &session, style)?;
    let verdict = Verdict::of_state(&state, &session);
    verdict.tell(style);
    match still::draw(&mut state, &args.request, &args.output) {
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
    /// File to write; its ending chooses the form: .html and .typ are one file with all figures in it, .md has its figures
    /// in a folder beside it
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

/// The note is in the language that is asked for, or else in that of the scene.
pub(crate) fn report(args: &ReportArgs, language: Option<&str>, style: Style) -> Result<Status, Fault> {
    let path = &args.scene.scene;
    let output = Output::of(Some(&args.output), path)?;
    let ending = args.output.extension().unwrap_or_default().to_string_lossy().into_owned();
    let form = Form::of(&ending)
        .ok_or_else(|| text!("cli-note-ending", file = name(args.output.display().to_string())))
        .map_err(Fault::Other)?;
    let options = scene::options(&args.scene.methods, false)?;
    let session = Arc::new(scene::open(path, style)?);
    let mut note = session.note.clone();
    if let Some(language) = language.and_then(Language::find) {
        note.language = language.code;
    }
    let language = Language::find(note.language).unwrap_or_else(Language::english);
    let state = still::analyzed(&session, options, true, language).map_err(Fault::Scene)?;
    scene::doubt_of_state(&state, &session, style)?;
    let verdict = Verdict::of_state(&state, &session);
    verdict.tell(style);
    let status = verdict.proved();
    let stem = args.output.file_stem().unwrap_or_default().to_string_lossy();
    let figures = format!("{stem}-figures");
    let written = note_of(&state, &note, form, &figures).map_err(Fault::Other)?;
    if !written.figures.is_empty() {
        let folder = args.output.with_file_name(&figures);
        let names: Vec<&str> = written.figures.iter().map(|(name, _)| name.as_str()).collect();
        Output::of(Some(&folder), path)?.write_folder(status, &names, &names, |files| {
            files
                .iter_mut()
                .zip(&written.figures)
                .try_for_each(|(file, (_, drawn))| file.write_all(drawn.as_bytes()))
        })?;
    }
    output.write(written.text, status)
}

/// The note of a scene that is open in the terminal UI, by these methods.
///
/// # Errors
///
/// Why there is no note; in words.
pub(crate) fn of_session(session: &Arc<Session>, options: Options) -> Result<String, Text> {
    let language = Language::find(session.note.language).unwrap_or_else(Language::english);
    let state = still::analyzed(session, options, true, language)?;
    note_of(&state, &session.note, Form::Html, "").map(|written| written.text)
}

fn note_of(state: &State, note: &Note, form: Form, folder: &str) -> Result<Written, Text> {
    let written = state.scene.as_ref().map(|scene| assur_note::write(scene, note, form, folder));
    written.unwrap_or(Err(NoteError::NoResults)).map_err(|error| error.describe())
}
